// Traces rays through the hierarchy, as many at a time as fit in a register, and visits the nearer child first. Tests
// boxes in single precision, slightly enlarged, and triangles in double precision. Read curved.cpp next. Source: Wald,
// Slusallek, Benthin and Wagner 2001; Ize 2013 for box tests that never miss a box because of rounding errors.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "topics/hidden/methods/bvh.h"

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#define VIEWING_INLINE inline __attribute__((always_inline))  // functions with register arguments must be inlined

namespace viewing {
namespace {

/// The number of rays that are traced together: one float for each of them fills one register, and one double for each
/// fills two.
struct FourLanes {
    using Float __attribute__((vector_size(16))) = float;
    using Double __attribute__((vector_size(16))) = double;
    static constexpr std::size_t count = 4, half = 2;
};
struct EightLanes {
    using Float __attribute__((vector_size(32))) = float;
    using Double __attribute__((vector_size(32))) = double;
    static constexpr std::size_t count = 8, half = 4;
};

/// Returns one bit per lane of a comparison's result.
template <typename Mask>
VIEWING_INLINE unsigned bits_of(const Mask& mask) {
    constexpr std::size_t lanes = sizeof(mask) / sizeof(mask[0]);
#ifdef __SSE2__
    if constexpr (lanes == 8) {
        const auto low = __builtin_shufflevector(mask, mask, 0, 1, 2, 3),
                   high = __builtin_shufflevector(mask, mask, 4, 5, 6, 7);
        return bits_of(low) | bits_of(high) << 4;
    } else if constexpr (sizeof(mask) == 32) {
        return bits_of(__builtin_shufflevector(mask, mask, 0, 1)) | bits_of(__builtin_shufflevector(mask, mask, 2, 3))
                                                                        << 2;
    } else if constexpr (lanes == 4) {
        return static_cast<unsigned>(_mm_movemask_ps(std::bit_cast<__m128>(mask)));
    } else {
        return static_cast<unsigned>(_mm_movemask_pd(std::bit_cast<__m128d>(mask)));
    }
#else
    unsigned bits = 0;
    for (std::size_t lane = 0; lane < lanes; ++lane) bits |= (mask[lane] != 0 ? 1U : 0U) << lane;
    return bits;
#endif
}

/// The three components of a vector, each with one value per lane.
template <typename Number>
using Three = std::array<Number, 3>;

// cross() and dot() compute the same sums as glm's, so that a ray has the same hits alone and in a group.
template <typename A, typename B>
VIEWING_INLINE auto cross(const A& a, const B& b) {
    return Three<std::decay_t<decltype(a[1] * b[2])>>{a[1] * b[2] - b[1] * a[2], a[2] * b[0] - b[2] * a[0],
                                                      a[0] * b[1] - b[0] * a[1]};
}
template <typename A, typename B>
VIEWING_INLINE auto dot(const A& a, const B& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace

template <typename Lanes>
struct Bvh::Together {
    using Float = typename Lanes::Float;
    using Double = typename Lanes::Double;
    static constexpr std::size_t count = Lanes::count, half = Lanes::half;

    // In the nodes' units, as if the direction were a unit vector.
    Three<Float> near_origin, far_origin;  ///< shifted so that boxes appear slightly enlarged
    Three<Float> inverse;
    Float limit;
    Three<std::size_t> near_corner;  ///< per axis, the corner that the rays pass first

    // In world units, as given.
    std::array<Three<Double>, 2> origin, direction;
    std::array<Double, 2> max_t;
    std::array<double, count> unit_t;  ///< t times this is in the nodes' units

    /// Takes 1 to `count` rays. Returns false if the signs of their directions differ along an axis: such rays cannot
    /// be traced together.
    VIEWING_INLINE bool take(const Bvh& bvh, std::span<const BoundedRay> rays) {
        for (std::size_t lane = 0; lane < count; ++lane) {
            const BoundedRay& ray = rays[lane < rays.size() ? lane : 0];
            for (std::size_t axis = 0; axis < 3; ++axis) {
                origin[lane / half][axis][lane % half] = ray.ray.origin[static_cast<int>(axis)];
                direction[lane / half][axis][lane % half] = ray.ray.direction[static_cast<int>(axis)];
            }
            max_t[lane / half][lane % half] = lane < rays.size() ? ray.max_t : -1.0;
        }
        bool go_together = true;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const unsigned below = bits_of(direction[0][axis] < 0.0) | bits_of(direction[1][axis] < 0.0) << half;
            near_corner[axis] = below & 1U;
            go_together = go_together && (below == 0 || below == (1U << count) - 1);
        }
        for (std::size_t part = 0; part < 2; ++part) take_half(bvh, part);
        return go_together;
    }

    VIEWING_INLINE void take_half(const Bvh& bvh, std::size_t part) {
        const Double squared = dot(direction[part], direction[part]);
        Double length{}, away = Double{} + 1.0;
        for (std::size_t lane = 0; lane < half; ++lane) length[lane] = std::sqrt(squared[lane]);
        Three<Double> from_middle;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            from_middle[axis] = (origin[part][axis] - bvh.middle_[static_cast<int>(axis)]) / bvh.half_diagonal_;
            const Double size = from_middle[axis] < 0.0 ? -from_middle[axis] : from_middle[axis];
            away = size > away ? size : away;
        }
        // The room is sixteen times the rounding error of single precision at the distance `away`, and twice the
        // largest total error of the steps below.
        const Double room = away * 0x1p-20;
        const auto put = [part](Float& to, const Double& from) {
            for (std::size_t lane = 0; lane < half; ++lane) to[part * half + lane] = static_cast<float>(from[lane]);
        };
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Double along = direction[part][axis];
            // The inverse is large instead of infinite, so that for a ray on the face of a box, 0 times the inverse is
            // 0 and not NaN.
            const Double slow = length * 1e-30;
            const Double one = along < 0.0 ? Double{} - 1.0 : Double{} + 1.0;
            put(inverse[axis], length / (one * along > slow ? along : one * slow));
            put(near_origin[axis], from_middle[axis] + one * room);
            put(far_origin[axis], from_middle[axis] - one * room);
        }
        const Double units = length / bvh.half_diagonal_;
        for (std::size_t lane = 0; lane < half; ++lane) {
            unit_t[part * half + lane] = units[lane];
            limit[part * half + lane] = in_units(part * half + lane, max_t[part][lane]);
        }
    }

    float in_units(std::size_t lane, double t) const { return static_cast<float>(std::min(t * unit_t[lane], 1e38)); }

    /// Ignores all hits beyond t from now on.
    void end_at(std::size_t lane, double t) {
        max_t[lane / half][lane % half] = t;
        limit[lane] = in_units(lane, t);
    }

    /// Returns, as bits, which rays in one half of the group hit the triangle, and stores their t. Computes the hits
    /// like intersect_triangle in geometry/.
    VIEWING_INLINE unsigned meet(const Triangle& triangle, std::size_t part, Double& t) const {
        const Three<Double>& d = direction[part];
        const Three<double> ab{triangle.ab.x, triangle.ab.y, triangle.ab.z},
            ac{triangle.ac.x, triangle.ac.y, triangle.ac.z};
        const auto across = cross(d, ac);
        const Double inverse_volume = 1.0 / dot(ab, across);  // not finite if seen edge-on: then every test below fails
        const Three<Double> from_a{origin[part][0] - triangle.a.x, origin[part][1] - triangle.a.y,
                                   origin[part][2] - triangle.a.z};
        const Double b = dot(from_a, across) * inverse_volume;
        // The tests choose values because g++ compiles a & of comparisons lane by lane.
        const Double missed = Double{} - 1.0;
        const Double b_if_beside = b <= 1.0 ? b : missed;
        if (bits_of(b_if_beside >= 0.0) == 0) return 0;
        const auto around = cross(from_a, ab);
        const Double c = dot(d, around) * inverse_volume;
        t = dot(ac, around) * inverse_volume;
        Double t_if_met = b_if_beside >= 0.0 ? t : missed;
        t_if_met = c >= 0.0 ? t_if_met : missed;
        t_if_met = b + c <= 1.0 ? t_if_met : missed;
        t_if_met = t <= max_t[part] ? t_if_met : missed;
        return bits_of(t_if_met >= 0.0);
    }

    /// Calls visit(triangles, lanes as bits) for every leaf whose box some of the rays hit before they end; the lanes
    /// say which rays. visit may make rays end earlier.
    template <typename Visit>
    VIEWING_INLINE void go_down(const Bvh& bvh, RayCounters& counters, Visit visit) const {
        if (bvh.nodes_.empty()) return;
        struct Waiting {
            int node, rays;
        };
        std::array<Waiting, deepest_bvh + 2> stack;
        std::int64_t box_tests = 0, triangle_tests = 0;
        std::size_t waiting = 0;
        for (Waiting next{0, std::popcount(bits_of(limit >= 0.0F))};;) {
            const BvhNode& node = bvh.nodes_[next.node];
            box_tests += next.rays;
            Float enter = Float{}, leave = limit;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const int i = static_cast<int>(axis);
                const Float in = (node.corners[near_corner[axis]][i] - near_origin[axis]) * inverse[axis];
                const Float out = (node.corners[1 - near_corner[axis]][i] - far_origin[axis]) * inverse[axis];
                enter = in > enter ? in : enter;
                leave = out < leave ? out : leave;
            }
            const unsigned lanes = bits_of(enter <= leave);
            const int rays = std::popcount(lanes);
            if (lanes != 0 && !node.is_leaf()) {
                const int near = static_cast<int>(near_corner[node.axis()]);
                stack[waiting++] = {node.first + 1 - near, rays};
                next = {node.first + near, rays};
                continue;
            }
            if (lanes != 0) {
                triangle_tests += std::int64_t{rays} * node.content;
                visit(std::span(bvh.triangles_)
                          .subspan(static_cast<std::size_t>(node.first), static_cast<std::size_t>(node.content)),
                      lanes);
            }
            if (waiting == 0) break;
            next = stack[--waiting];
        }
        counters.box_tests += box_tests;
        counters.triangle_tests += triangle_tests;
    }
};

template <typename Lanes>
VIEWING_INLINE void Bvh::nearest_in(std::span<const BoundedRay> rays, std::span<RayHit> hits,
                                    RayCounters& counters) const {
    const auto go = [&](std::span<const BoundedRay> some, RayHit * of_some) __attribute__((always_inline)) {
        Together<Lanes> together;
        if (!together.take(*this, some)) return false;
        std::fill_n(of_some, some.size(), RayHit{});
        const double same_in_units = same_t_ / half_diagonal_;
        together.go_down(
            *this, counters, [&](std::span<const Triangle> leaf, unsigned lanes) __attribute__((always_inline)) {
                for (const Triangle& triangle : leaf) {
                    for (std::size_t part = 0; part < 2; ++part) {
                        if ((lanes >> part * Lanes::half & ((1U << Lanes::half) - 1)) == 0) continue;
                        typename Lanes::Double t;
                        unsigned met = together.meet(triangle, part, t);
                        for (; met != 0; met &= met - 1) {
                            const std::size_t in_half = static_cast<std::size_t>(std::countr_zero(met)),
                                              lane = part * Lanes::half + in_half;
                            RayHit& best = of_some[lane];
                            const double same_t = same_in_units / together.unit_t[lane];
                            const bool is_tie = best.is_hit() && std::abs(t[in_half] - best.t) <= same_t;
                            if (is_tie ? triangle.source >= best.source : t[in_half] >= best.t) continue;
                            best = {t[in_half], triangle.polygon, triangle.source};
                            together.end_at(lane, std::min(some[lane].max_t, best.t + same_t));
                        }
                    }
                }
            });
        return true;
    };
    for (std::size_t first = 0; first < rays.size(); first += Lanes::count) {
        const std::span<const BoundedRay> some = rays.subspan(first, std::min(Lanes::count, rays.size() - first));
        if (go(some, &hits[first])) continue;
        for (std::size_t i = 0; i < some.size(); ++i) go(some.subspan(i, 1), &hits[first + i]);
    }
    counters.rays += static_cast<std::int64_t>(rays.size());
}

#ifdef __x86_64__
__attribute__((target("avx2,popcnt"))) void Bvh::nearest_with_avx2(std::span<const BoundedRay> rays,
                                                                   std::span<RayHit> hits,
                                                                   RayCounters& counters) const {
    nearest_in<EightLanes>(rays, hits, counters);
}
#endif

void Bvh::nearest(std::span<const BoundedRay> rays, std::span<RayHit> hits, RayCounters& counters) const {
#ifdef __x86_64__
    static const bool has_avx2 = __builtin_cpu_supports("avx2") != 0;
    if (has_avx2 && rays.size() > FourLanes::count) return nearest_with_avx2(rays, hits, counters);
#endif
    nearest_in<FourLanes>(rays, hits, counters);
}

RayHit Bvh::nearest(const Ray& ray, double max_t, RayCounters& counters) const {
    const BoundedRay only{ray, max_t};
    RayHit hit;
    nearest(std::span(&only, 1), std::span(&hit, 1), counters);
    return hit;
}

std::vector<RayHit> Bvh::all(const Ray& ray, double max_t, RayCounters& counters) const {
    ++counters.rays;
    std::vector<RayHit> hits;
    Together<FourLanes> alone;
    const BoundedRay only{ray, max_t};
    alone.take(*this, std::span(&only, 1));
    alone.go_down(*this, counters, [&](std::span<const Triangle> leaf, unsigned) {
        for (const Triangle& triangle : leaf) {
            FourLanes::Double t;
            if ((alone.meet(triangle, 0, t) & 1U) != 0) hits.push_back({t[0], triangle.polygon, triangle.source});
        }
    });
    // On the edge between two triangles of a polygon's fan, the ray hits both.
    std::sort(hits.begin(), hits.end(),
              [](const RayHit& a, const RayHit& b) { return std::pair(a.polygon, a.t) < std::pair(b.polygon, b.t); });
    hits.erase(
        std::unique(hits.begin(), hits.end(), [](const auto& a, const auto& b) { return a.polygon == b.polygon; }),
        hits.end());
    std::sort(hits.begin(), hits.end(),
              [](const RayHit& a, const RayHit& b) { return std::pair(a.t, a.source) < std::pair(b.t, b.source); });
    return hits;
}

}  // namespace viewing
