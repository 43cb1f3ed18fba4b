// Projection matrices, and the path from eye depth to a stored code. Read ray.h next.
#include "geometry/projection.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <initializer_list>
#include <limits>

namespace viewing {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Returns |d(window depth) / d(eye distance)|.
double depth_slope(const Lens& lens, DepthMapping mapping, double distance) {
    if (mapping == DepthMapping::logarithmic) {
        return 1.0 / (distance * std::log(lens.logarithmic_far() / lens.logarithmic_near()));
    }
    if (lens.orthographic) {
        return 1.0 / (lens.far - lens.near);
    }
    return lens.depth_per_inverse_distance() / (distance * distance);
}

/// Replaces P's third row, so that clip z = a · eye z + b.
glm::dmat4 with_depth_row(glm::dmat4 p, double a, double b) {
    p[2][2] = a;
    p[3][2] = b;
    return p;
}

/// Returns the lens with an arbitrary finite far, for the entries of P that do not depend on far.
Lens with_finite_far(Lens lens) {
    lens.far = 2.0 * lens.near;
    return lens;
}

/// Returns the gap between a float32 in (0, 1] and the next one toward 0.
double float_gap(double depth) {
    const float stored = static_cast<float>(std::clamp(depth, 0.0, 1.0));
    const float smallest = std::numeric_limits<float>::denorm_min();
    return std::max(stored - std::nextafter(stored, 0.0F), smallest);
}

}  // namespace

Edges Lens::edges_at(double distance, double aspect) const {
    if (window) return orthographic ? *window : window->scaled(distance / near);
    const double y = orthographic ? height / 2.0 : std::tan(glm::radians(0.5 * fovy_deg)) * distance, x = y * aspect;
    return {-x, x, -y, y};
}

glm::dmat4 clip_from_view(const Lens& lens, double aspect) {
    if (lens.is_infinite())
        return with_depth_row(clip_from_view(with_finite_far(lens), aspect), -1.0, -2.0 * lens.near);
    const double n = lens.near, f = lens.far;
    if (lens.orthographic) {
        const Edges edges = lens.edges_at(n, aspect);
        return glm::orthoRH_NO(edges.left, edges.right, edges.bottom, edges.top, n, f);
    }
    if (const auto& own = lens.window) return glm::frustumRH_NO(own->left, own->right, own->bottom, own->top, n, f);
    return glm::perspectiveRH_NO(glm::radians(lens.fovy_deg), aspect, lens.near, lens.far);
}

glm::dmat4 clip_from_view_reversed(const Lens& lens, double aspect) {
    if (lens.is_infinite())
        return with_depth_row(clip_from_view_reversed(with_finite_far(lens), aspect), 0.0, lens.near);
    const double n = lens.near, f = lens.far;
    if (lens.orthographic) {
        const Edges edges = lens.edges_at(n, aspect);
        return glm::orthoRH_ZO(edges.left, edges.right, edges.bottom, edges.top, f, n);
    }
    if (const auto& own = lens.window) {
        // glFrustum takes the window to be at the first of its two depths, which is far once near and far are swapped.
        const glm::dmat4 standard = glm::frustumRH_ZO(own->left, own->right, own->bottom, own->top, n, f);
        return with_depth_row(standard, n / (f - n), f * n / (f - n));
    }
    return glm::perspectiveRH_ZO(glm::radians(lens.fovy_deg), aspect, lens.far, lens.near);
}

std::optional<Lens> lens_of(const glm::dmat4& clip_from_view, double ndc_near, double ndc_far, double tolerance) {
    const glm::dvec4 w = glm::transpose(clip_from_view)[3];
    Lens lens;
    lens.orthographic = std::abs(w.w) > std::abs(w.z);
    const double factor = lens.orthographic ? w.w : -w.z;
    if (!(factor > 0.0)) return std::nullopt;
    const glm::dmat4 rows = glm::transpose(clip_from_view / factor);
    const auto are_zero = [&](std::initializer_list<double> entries) {
        return std::all_of(entries.begin(), entries.end(), [&](double entry) { return std::abs(entry) <= tolerance; });
    };
    const glm::dvec4 &x = rows[0], &y = rows[1], &z = rows[2];
    // The window's middle is shifted by the entry that multiplies z or, without a division, by the one that multiplies
    // 1; the other entry is 0.
    const int middle = lens.orthographic ? 3 : 2, other = 5 - middle;
    if (!are_zero({x.y, x[other], y.x, y[other], z.x, z.y, rows[3].x, rows[3].y, rows[3][other]}) || x.x == 0.0 ||
        y.y == 0.0)
        return std::nullopt;
    // z ÷ w is z.w ÷ distance − z.z or, if orthographic, z.w − z.z · distance.
    const auto distance_of = [&](double ndc) {
        if (lens.orthographic) return (z.w - ndc) / z.z;
        return std::abs(z.z + ndc) < 1e-12 ? std::numeric_limits<double>::infinity() : z.w / (z.z + ndc);
    };
    lens.near = distance_of(ndc_near);
    lens.far = distance_of(ndc_far);
    if (std::isnan(lens.near) || std::isnan(lens.far)) return std::nullopt;
    const double nearer = std::min(lens.near, lens.far), size = lens.orthographic ? 1.0 : nearer;
    const double moved = lens.orthographic ? -1.0 : 1.0;
    lens.window = Edges{(moved * x[middle] - 1.0) / x.x, (moved * x[middle] + 1.0) / x.x,
                        (moved * y[middle] - 1.0) / y.y, (moved * y[middle] + 1.0) / y.y}
                      .scaled(size);
    return lens;
}

std::optional<glm::dvec4> eye_of(const glm::dmat4& clip_from_world, bool reversed) {
    const glm::dmat4 rows = glm::transpose(clip_from_world);
    // The minors of three rows form a vector perpendicular to each of them: the eye.
    glm::dvec4 eye(0.0);
    for (int axis = 0; axis < 4; ++axis) {
        glm::dmat3 minor(0.0);
        for (int column = 0, left = 0; column < 4; ++column)
            if (column != axis) minor[left++] = {rows[0][column], rows[1][column], rows[3][column]};
        eye[axis] = (axis % 2 == 0 ? 1.0 : -1.0) * glm::determinant(minor);
    }
    const double size = glm::length(eye);
    const double largest = glm::length(rows[0]) * glm::length(rows[1]) * glm::length(rows[3]);
    if (!(size > 1e-12 * largest)) return std::nullopt;
    eye /= size;
    if (std::abs(eye.w) > 1e-9) return eye / eye.w;
    const glm::dvec3 direction = glm::normalize(glm::dvec3(eye));
    const bool points_away = (glm::dot(glm::dvec3(rows[2]), direction) > 0.0) != reversed;
    return glm::dvec4(points_away ? -direction : direction, 0.0);
}

double window_depth(const Lens& lens, DepthMapping mapping, double distance) {
    const double n = lens.near, f = lens.far, z = distance;
    const bool linear = lens.orthographic && mapping != DepthMapping::logarithmic;
    if (z <= 0.0 && !linear) {
        return mapping == DepthMapping::reversed ? infinity : -infinity;
    }
    if (lens.is_infinite() && mapping != DepthMapping::logarithmic)
        return mapping == DepthMapping::reversed ? n / z : 1.0 - n / z;
    switch (mapping) {
        case DepthMapping::standard:
            return linear ? (z - n) / (f - n) : f * (z - n) / ((f - n) * z);
        case DepthMapping::reversed:
            return linear ? (f - z) / (f - n) : n * (f - z) / ((f - n) * z);
        case DepthMapping::logarithmic:
            break;
    }
    const double start = lens.logarithmic_near();
    return std::log(z / start) / std::log(lens.logarithmic_far() / start);
}

double distance_of_window_depth(const Lens& lens, DepthMapping mapping, double depth) {
    const double n = lens.near, f = lens.far, d = depth;
    const bool linear = lens.orthographic;
    if (lens.is_infinite() && mapping != DepthMapping::logarithmic)
        return n / (mapping == DepthMapping::reversed ? d : 1.0 - d);
    switch (mapping) {
        case DepthMapping::standard:
            return linear ? n + d * (f - n) : f * n / (f - d * (f - n));
        case DepthMapping::reversed:
            return linear ? f - d * (f - n) : f * n / (n + d * (f - n));
        case DepthMapping::logarithmic:
            break;
    }
    return lens.logarithmic_near() * std::pow(lens.logarithmic_far() / lens.logarithmic_near(), d);
}

double code_width(const DepthPrecision& precision, double window_depth) {
    return precision.is_float ? float_gap(window_depth) : 1.0 / precision.greatest_code();
}

double depth_step(const Lens& lens, DepthMapping mapping, const DepthPrecision& precision, double distance) {
    const double stored_distance = std::max(distance, lens.near);
    return code_width(precision, window_depth(lens, mapping, stored_distance)) /
           depth_slope(lens, mapping, stored_distance);
}

double resolvable_depth_step(const Lens& lens, DepthMapping mapping, const DepthPrecision& precision, double distance) {
    const double stored = depth_step(lens, mapping, precision, distance);
    if (!precision.is_float) {
        return stored;
    }
    const auto eye_depth = static_cast<float>(std::max(distance, lens.near));
    const double unit =
        static_cast<double>(std::nextafter(eye_depth, std::numeric_limits<float>::infinity())) - eye_depth;
    return std::max(stored, unit / 2.0);
}

double widened_fovy(double fovy_deg, double aspect, double least_aspect) {
    if (aspect >= least_aspect) return fovy_deg;
    return glm::degrees(2.0 * std::atan(std::tan(glm::radians(0.5 * fovy_deg)) * least_aspect / aspect));
}

}  // namespace viewing
