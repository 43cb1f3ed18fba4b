#include "topics/matrices/numbers/matrix_structure.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "frame/matrix_facts.h"
#include "geometry/camera.h"
#include "topics/matrices/numbers/near_matrices.h"

namespace viewing {

using glm::dmat3;
using glm::dmat4;
using glm::dvec3;
using glm::dvec4;

void describe_camera(ExplainedMatrix& found, const dmat4& world_from_view) {
    const dvec3 eye(world_from_view[3]);
    const dmat3 axes(world_from_view);
    found.angles = angles_from_rotation(axes);
    found.camera = look_at_of(eye, found.angles, 1.0);
}

std::optional<FoundLens> read_lens(const dmat4& m, bool zero_to_one, double tolerance) {
    if (!has_row(m, 3, {0, 0, -1, 0}, tolerance) && !has_affine_row(m, tolerance)) return std::nullopt;
    const std::optional<Lens> read = lens_of(m, zero_to_one ? 0.0 : -1.0, 1.0, tolerance);
    if (!read) return std::nullopt;
    FoundLens lens;
    lens.orthographic = read->orthographic;
    lens.near = read->near;
    lens.far = read->far;
    lens.zero_to_one = zero_to_one;
    lens.edges = *read->window;
    const double x = entry(m, 0, 0), y = entry(m, 1, 1);
    lens.aspect = std::abs(y / x);
    (lens.orthographic ? lens.height : lens.fovy_deg) =
        lens.orthographic ? 2.0 / y : glm::degrees(2.0 * std::atan(1.0 / y));
    const int middle = lens.orthographic ? 3 : 2;
    lens.off_center = !is_near(entry(m, 0, middle), 0.0, tolerance) || !is_near(entry(m, 1, middle), 0.0, tolerance);
    return lens;
}

namespace {

/// Returns whether the number may have been typed by hand: it has at most two significant digits.
bool is_round(double value) {
    if (value == 0.0) return true;
    const double digit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 1.0);
    return std::abs(value / digit - std::round(value / digit)) <= 5e-6 * std::abs(value / digit);
}

}  // namespace

bool is_for_zero_to_one(const dmat4& p, const Params& params, double tolerance) {
    const double a = entry(p, 2, 2);
    const bool is_orthographic = entry(p, 3, 3) != 0.0;
    if (is_orthographic ? a > 0.0 : a > -0.5) return (!is_orthographic && a < 1.0) || params.depth.reversed_zero_to_one;
    const std::optional<FoundLens> one = read_lens(p, true, tolerance), minus_one = read_lens(p, false, tolerance);
    if (!one || !minus_one) return false;
    const auto is_meant = [&](const FoundLens& lens) {
        return is_near(lens.near, params.projection.near, tolerance) || is_round(lens.near);
    };
    return is_meant(*one) && !is_meant(*minus_one);
}

dmat4 with_depth_signs(dmat4 p, const dmat4& right) {
    for (const int column : {2, 3}) p[column][2] = std::copysign(p[column][2], right[column][2]);
    return p;
}

namespace {

/// The factors of a matrix of rank 1, column · rowᵀ; none for another rank.
struct Outer {
    dvec4 column, row;
};
std::optional<Outer> outer_of(const dmat4& m, double tolerance) {
    int pivot_column = 0, pivot_row = 0;
    for (int i = 0; i < 16; ++i)
        if (std::abs(m[i / 4][i % 4]) > std::abs(m[pivot_column][pivot_row])) {
            pivot_column = i / 4;
            pivot_row = i % 4;
        }
    const double pivot = m[pivot_column][pivot_row];
    if (std::abs(pivot) <= 1e-6 + 10.0 * tolerance) return std::nullopt;
    const Outer outer{m[pivot_column] / pivot, glm::transpose(m)[pivot_row]};
    const double rest = largest_entry(m - glm::outerProduct(outer.column, outer.row));
    return rest <= 1e-5 * std::abs(pivot) + 8.0 * tolerance ? std::optional(outer) : std::nullopt;
}

bool is_zero(double value, const dvec4& beside, double tolerance) {
    return std::abs(value) <= (1e-6 + tolerance) * glm::length(beside);
}

/// Explains a mirror matrix: I − R = 2 (n, 0)(n, d)ᵀ.
bool explain_mirror(ExplainedMatrix& found, const dmat4& m, double tolerance) {
    const std::optional<Outer> outer = outer_of(dmat4(1.0) - m, tolerance);
    if (!outer || !is_zero(outer->column.w, outer->column, tolerance)) return false;
    const dvec3 along(outer->row), column(outer->column);
    const double size = glm::length(along);
    if (size <= 1e-9 || glm::length(glm::cross(glm::normalize(column), along / size)) > 1e-5 + 8.0 * tolerance)
        return false;
    // The trace of I − R is 2 |n|².
    const double squared = 0.5 * glm::dot(column, along);
    if (squared <= 0.0) return false;
    found.letter = 'R';
    found.found_plane = outer->row / size;
    const double rounding = 8.0 * tolerance + 1e-5;
    found.fault = is_near(squared, 1.0, rounding)   ? MatrixFault::other_plane
                  : is_near(squared, 0.5, rounding) ? MatrixFault::lost_factor
                                                    : MatrixFault::not_unit_normal;
    return true;
}

/// Explains a shadow matrix: k I − S = L Πᵀ with k = tr S / 3.
bool explain_shadow(ExplainedMatrix& found, const dmat4& m, const StateMatrices& state, double tolerance) {
    const double k = (m[0][0] + m[1][1] + m[2][2] + m[3][3]) / 3.0;
    if (std::abs(k) <= 1e-9 * largest_entry(m)) return false;
    const std::optional<Outer> outer = outer_of(dmat4(k) - m, tolerance);
    if (!outer) return false;
    const auto as_plane = [](const dvec4& v) { return v / glm::length(dvec3(v)); };
    if (glm::length(dvec3(outer->row)) <= 1e-9 * glm::length(outer->row)) return false;
    found.letter = 'S';
    found.found_plane = as_plane(outer->row);
    const dvec4& l = outer->column;
    const bool is_parallel = is_zero(l.w, l, tolerance);
    found.found_light =
        is_parallel ? dvec4(glm::normalize(dvec3(l)) * (glm::dot(l, outer->row) * k < 0.0 ? -1.0 : 1.0), 0.0) : l / l.w;
    found.fault = MatrixFault::different;
    for (const Known& one : state.known()) {
        if (one.letter != 'S') continue;
        const bool same_plane = is_same_direction(outer->row, state.params().planes[one.plane].equation, tolerance);
        const bool same_light = is_same_direction(l, state.params().lights[one.light].position, tolerance);
        if (!same_plane && !same_light) continue;
        found.fault = same_plane ? MatrixFault::other_light : MatrixFault::other_plane;
        found.plane = one.plane;
        found.light = one.light;
        break;
    }
    return true;
}

/// Explains an affine matrix whose axes are perpendicular: a V or C, perhaps scaled or left-handed.
bool explain_pose(ExplainedMatrix& found, const dmat4& m, char named, const StateMatrices& state, double tolerance) {
    if (!has_affine_row(m, tolerance)) return false;
    const dmat3 axes(m);
    const auto lengths = [](const dmat3& of) {
        return dvec3(glm::length(of[0]), glm::length(of[1]), glm::length(of[2]));
    };
    const auto is_perpendicular = [&](const dmat3& of) {
        const dvec3 size = lengths(of);
        if (std::min({size.x, size.y, size.z}) <= 1e-9) return false;
        for (int i = 0; i < 3; ++i)
            if (std::abs(glm::dot(of[i], of[(i + 1) % 3])) > (1e-5 + 4.0 * tolerance) * size[i] * size[(i + 1) % 3])
                return false;
        return true;
    };
    // Unless the scale is uniform, the rows of V · scale and the columns of scale · V are not perpendicular.
    const bool by_columns = is_perpendicular(axes), by_rows = is_perpendicular(glm::transpose(axes));
    if (!by_columns && !by_rows) return false;
    found.letter = named == 'C' ? 'C' : 'V';
    found.scale = lengths(by_columns ? axes : glm::transpose(axes));
    dmat3 unit = by_columns ? axes : glm::transpose(axes);
    for (int i = 0; i < 3; ++i) unit[i] /= found.scale[i];
    if (!by_columns) unit = glm::transpose(unit);
    const bool is_unit = is_near(found.scale.x, 1.0, 4.0 * tolerance + 1e-5) &&
                         is_near(found.scale.y, 1.0, 4.0 * tolerance + 1e-5) &&
                         is_near(found.scale.z, 1.0, 4.0 * tolerance + 1e-5);
    if (named == 0 && is_same(dmat4(unit), dmat4(dmat3(state.first('C').right)), 1e-5 + 4.0 * tolerance))
        found.letter = 'C';
    const bool is_left_handed = glm::determinant(unit) < 0.0;
    found.fault = is_left_handed ? MatrixFault::left_handed : is_unit ? MatrixFault::different : MatrixFault::scaled;
    if (is_left_handed) return true;
    const dvec3 eye = found.letter == 'C' ? dvec3(m[3]) : dvec3(-(glm::inverse(axes) * dvec3(m[3])));
    dmat4 world_from_view(found.letter == 'C' ? unit : glm::transpose(unit));
    world_from_view[3] = dvec4(eye, 1.0);
    describe_camera(found, world_from_view);
    return true;
}

/// Whether an affine matrix may be a P. A V has perpendicular axes, too, but they have length 1.
bool may_be_orthographic(const dmat4& m, char named, const StateMatrices& state, double tolerance) {
    if (named == 'P' || state.params().projection.type == ProjectionType::orthographic) return true;
    if (named != 0 || !(entry(m, 2, 2) < 0.0)) return false;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            if (row != column && !is_near(entry(m, row, column), 0.0, tolerance)) return false;
    return !is_near(entry(m, 2, 2), -1.0, 1e-5 + 4.0 * tolerance);
}

/// Whether the near or the far plane of a perspective lens is behind the eye.
bool is_behind_eye(const FoundLens& lens) {
    return !lens.orthographic && (lens.near <= 0.0 || lens.far <= 0.0);
}

bool explain_projection(ExplainedMatrix& found, const dmat4& m, char named, const StateMatrices& state,
                        double tolerance) {
    const bool looks_along_z = has_row(m, 3, {0, 0, 1, 0}, tolerance);  // w = z instead of −z
    if (looks_along_z && entry(m, 0, 0) < 0.0 && entry(m, 1, 1) < 0.0) {
        if (!explain_projection(found, -m, named, state, tolerance)) return false;
        if (found.fault == MatrixFault::different) found.fault = MatrixFault::negated;
        return true;
    }
    // A left-handed P has the other sign in its third row, too.
    const bool only_lost_sign = looks_along_z && entry(m, 2, 2) * entry(state.first('P').right, 2, 2) > 0.0;
    dmat4 p = only_lost_sign ? flipped({1, 1, 1, -1}) * m : looks_along_z ? m * flipped({1, 1, -1, 1}) : m;
    const bool mirrored_x = entry(p, 0, 0) < 0.0, mirrored_y = entry(p, 1, 1) < 0.0;
    p = flipped({mirrored_x ? -1 : 1, mirrored_y ? -1 : 1, 1, 1}) * p;
    // In a perspective P, both entries of the third row are negative or, if P reverses depth, positive.
    const bool has_depth_signs = entry(p, 3, 2) == 0.0 || entry(p, 2, 2) * entry(p, 2, 3) >= 0.0;
    if (!has_depth_signs) p = with_depth_signs(p, state.first('P').right);
    const bool zero_to_one = is_for_zero_to_one(p, state.params(), tolerance);
    std::optional<FoundLens> lens = read_lens(p, zero_to_one, tolerance);
    if (!lens || (lens->orthographic && !may_be_orthographic(p, named, state, tolerance))) return false;
    lens->mirrored_x = mirrored_x;
    lens->mirrored_y = mirrored_y;
    found.letter = 'P';
    found.lens = lens;
    found.fault = !has_depth_signs                        ? MatrixFault::depth_signs
                  : only_lost_sign                        ? MatrixFault::lost_sign
                  : looks_along_z                         ? MatrixFault::left_handed
                  : mirrored_x || mirrored_y              ? MatrixFault::mirrored
                  : is_behind_eye(*lens)                  ? MatrixFault::negative_depth
                  : zero_to_one && lens->near < lens->far ? MatrixFault::zero_to_one
                                                          : MatrixFault::different;
    return true;
}

}  // namespace

bool explain_structure(ExplainedMatrix& found, const dmat4& m, char named, const StateMatrices& state,
                       double tolerance) {
    if (named == 'S' && explain_shadow(found, m, state, tolerance))
        return true;  // diag(1, 0, 1, 1) also looks like a mirror whose normal is not a unit vector
    return explain_projection(found, m, named, state, tolerance) || explain_mirror(found, m, tolerance) ||
           explain_pose(found, m, named, state, tolerance) || explain_shadow(found, m, state, tolerance);
}

}  // namespace viewing
