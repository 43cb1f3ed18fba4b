// Intersects rays with quadrics by solving a quadratic without cancellation, and with the torus by cutting a quartic
// into monotone pieces. Read ray_cast.cpp next.
#include "topics/hidden/methods/curved.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace viewing {
namespace {

constexpr double ring_radius = 0.9, tube_radius = 0.34;

/// The part of a ray within some region, from `enter` to `leave`; empty if enter ≥ leave.
struct Interval {
    double enter, leave;
    bool empty() const { return !(enter < leave); }
};

constexpr double infinity = 1e300;

/// Returns the roots of a t² + 2 b t + c, the lower one first; empty if there are fewer than two. `a` must not be 0.
Interval quadratic_roots(double a, double b, double c) {
    const double discriminant = b * b - a * c;
    if (!(discriminant > 0.0)) return {0.0, 0.0};
    // Compute both roots from q, the sum that does not cancel: q / a and c / q.
    const double q = -(b + std::copysign(std::sqrt(discriminant), b));
    const double first = q / a, second = c / q;
    return {std::min(first, second), std::max(first, second)};
}

/// Returns the part of the ray between y = −1 and y = 1.
Interval within_slab(const Ray& ray) {
    if (ray.direction.y == 0.0) {
        return std::abs(ray.origin.y) < 1.0 ? Interval{-infinity, infinity} : Interval{0.0, 0.0};
    }
    const double a = (-1.0 - ray.origin.y) / ray.direction.y, b = (1.0 - ray.origin.y) / ray.direction.y;
    return {std::min(a, b), std::max(a, b)};
}

void add_interval(CurvedHits& hits, const Interval& inside) {
    if (inside.empty()) return;
    hits.add(inside.enter);
    hits.add(inside.leave);
}

Interval common(const Interval& a, const Interval& b) {
    return {std::max(a.enter, b.enter), std::min(a.leave, b.leave)};
}

CurvedHits intersect_sphere(const Ray& ray) {
    CurvedHits hits;
    const glm::dvec3 &o = ray.origin, &d = ray.direction;
    add_interval(hits, quadratic_roots(glm::dot(d, d), glm::dot(o, d), glm::dot(o, o) - 1.0));
    return hits;
}

CurvedHits intersect_cylinder(const Ray& ray) {
    CurvedHits hits;
    const glm::dvec3 &o = ray.origin, &d = ray.direction;
    const double a = d.x * d.x + d.z * d.z, c = o.x * o.x + o.z * o.z - 1.0;
    Interval inside = within_slab(ray);
    if (a > 0.0) {
        inside = common(inside, quadratic_roots(a, o.x * d.x + o.z * d.z, c));
    } else if (c >= 0.0) {
        return hits;
    }
    add_interval(hits, inside);
    return hits;
}

/// The inside of the double cone with its tip at y = 1 is x² + z² < ((1 − y) / 2)²; the slab keeps the lower half.
CurvedHits intersect_cone(const Ray& ray) {
    CurvedHits hits;
    const glm::dvec3 &o = ray.origin, &d = ray.direction;
    const double below_tip = (1.0 - o.y) * 0.5, sinks = -d.y * 0.5;  // cone radius along the ray: below_tip + t · sinks
    const double a = d.x * d.x + d.z * d.z - sinks * sinks;
    const double b = o.x * d.x + o.z * d.z - below_tip * sinks;
    const double c = o.x * o.x + o.z * o.z - below_tip * below_tip;
    const Interval slab = within_slab(ray);
    if (slab.empty()) return hits;
    if (a == 0.0) {  // the ray is parallel to a line on the side: it crosses once, at −c / 2b; 2 b t + c < 0 inside
        if (b != 0.0) {
            const double crossing = -c / (2.0 * b);
            add_interval(hits, common(slab, b > 0.0 ? Interval{-infinity, crossing} : Interval{crossing, infinity}));
        }
        return hits;
    }
    const Interval roots = quadratic_roots(a, b, c);
    if (a > 0.0) {
        add_interval(hits, common(slab, roots));
    } else if (roots.empty()) {  // the ray is steeper than the side and passes through the tip or next to it
        add_interval(hits, slab);
    } else {  // the ray is inside before and after the roots; one of these parts is in the slab
        add_interval(hits, common(slab, {-infinity, roots.enter}));
        add_interval(hits, common(slab, {roots.leave, infinity}));
    }
    return hits;
}

/// Finds the zero of a function that changes sign once between two arguments, with Newton's method inside a shrinking
/// bracket.
template <typename Function, typename Derivative>
double bracketed_zero(double low, double high, Function f, Derivative derivative) {
    const bool rises = f(low) < 0.0;
    double t = 0.5 * (low + high);
    for (int i = 0; i < 100; ++i) {
        const double value = f(t);
        if (value == 0.0) return t;
        ((value < 0.0) == rises ? low : high) = t;
        const double slope = derivative(t);
        double next = slope != 0.0 ? t - value / slope : low;
        if (!(next > low && next < high)) next = 0.5 * (low + high);
        if (std::abs(next - t) <= 1e-16 * (1.0 + std::abs(t))) return next;
        t = next;
    }
    return t;
}

/// A quartic t⁴ + p t² + q t + r: the form that any quartic takes when it is divided by its leading coefficient and its
/// argument is shifted by the mean of its zeros.
struct DepressedQuartic {
    double p, q, r;
    double value(double t) const { return ((t * t + p) * t + q) * t + r; }
    double slope(double t) const { return (4.0 * t * t + 2.0 * p) * t + q; }
    double curvature(double t) const { return 12.0 * t * t + 2.0 * p; }
};

/// Calls `found` with each zero between −limit and limit where the sign changes, in order. Between two neighboring
/// zeros of the derivative there is at most one such zero. The derivative's zeros are found in the same way, from the
/// zeros of the second derivative.
template <typename Found>
void for_each_zero(const DepressedQuartic& quartic, double limit, Found found) {
    const auto value = [&](double t) { return quartic.value(t); };
    const auto slope = [&](double t) { return quartic.slope(t); };
    const auto curvature = [&](double t) { return quartic.curvature(t); };
    std::array<double, 5> turns{-limit};
    std::size_t turn_count = 1;
    const double bend = quartic.p < 0.0 ? std::min(std::sqrt(-quartic.p / 6.0), limit) : 0.0;
    const std::array<double, 4> bends{-limit, -bend, bend, limit};
    for (std::size_t i = 0; i + 1 < bends.size(); ++i) {
        if ((slope(bends[i]) < 0.0) != (slope(bends[i + 1]) < 0.0)) {
            turns[turn_count++] = bracketed_zero(bends[i], bends[i + 1], slope, curvature);
        }
    }
    turns[turn_count++] = limit;
    for (std::size_t i = 0; i + 1 < turn_count; ++i) {
        if ((value(turns[i]) < 0.0) != (value(turns[i + 1]) < 0.0)) {
            found(bracketed_zero(turns[i], turns[i + 1], value, slope));
        }
    }
}

/// With a unit direction, and with t measured from the ray's point nearest to the center, the torus gives a quartic
/// that has no cubic term and whose zeros are inside the bounding sphere. All its coefficients are therefore of the
/// order of the torus's size, however far away the ray starts.
CurvedHits intersect_torus(const Ray& ray) {
    CurvedHits hits;
    const double length = glm::length(ray.direction);
    const glm::dvec3 d = ray.direction / length;
    const double to_nearest = -glm::dot(ray.origin, d);
    const glm::dvec3 o = ray.origin + to_nearest * d;
    constexpr double outer = ring_radius + tube_radius;
    const double oo = glm::dot(o, o);
    if (oo >= outer * outer) return hits;
    const double limit = std::sqrt(outer * outer - oo) + 1e-3;  // slightly outside, where the quartic is positive

    constexpr double ring_squared = ring_radius * ring_radius;
    const double m = oo + ring_squared - tube_radius * tube_radius;
    const DepressedQuartic quartic{2.0 * m - 4.0 * ring_squared * (d.x * d.x + d.z * d.z),
                                   -8.0 * ring_squared * (o.x * d.x + o.z * d.z),
                                   m * m - 4.0 * ring_squared * (o.x * o.x + o.z * o.z)};
    for_each_zero(quartic, limit, [&](double t) { hits.add((t + to_nearest) / length); });
    return hits;
}

}  // namespace

void CurvedHits::add(double t) {
    if (!(t >= 0.0) || count_ == t_.size()) return;
    std::size_t place = count_++;
    for (; place > 0 && t_[place - 1] > t; --place) t_[place] = t_[place - 1];
    t_[place] = t;
}

CurvedHits intersect_curved(CurvedKind kind, const Ray& ray_in_model) {
    if (ray_in_model.direction == glm::dvec3(0.0)) return {};
    switch (kind) {
        case CurvedKind::sphere:
            return intersect_sphere(ray_in_model);
        case CurvedKind::cylinder:
            return intersect_cylinder(ray_in_model);
        case CurvedKind::cone:
            return intersect_cone(ray_in_model);
        case CurvedKind::torus:
            return intersect_torus(ray_in_model);
    }
    return {};
}

glm::dvec3 normal_of_curved(CurvedKind kind, const glm::dvec3& p) {
    const glm::dvec3 outward(p.x, 0.0, p.z);
    const double radius = glm::length(outward);
    const glm::dvec3 up(0.0, 1.0, 0.0);
    switch (kind) {
        case CurvedKind::sphere:
            return glm::normalize(p);
        case CurvedKind::cylinder:
            if (std::abs(p.y) - 1.0 > radius - 1.0) return std::copysign(1.0, p.y) * up;
            return outward / radius;
        case CurvedKind::cone: {
            const double out_of_side = (radius - (1.0 - p.y) * 0.5) * 2.0 / std::sqrt(5.0);
            if (-1.0 - p.y > out_of_side) return -up;
            return radius > 0.0 ? glm::normalize(2.0 * outward / radius + up) : up;
        }
        case CurvedKind::torus:
            return glm::normalize(p - ring_radius * outward / radius);
    }
    return up;
}

}  // namespace viewing
