#include "frame/explain/explain_matrix.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "frame/matrix_facts.h"
#include "frame/planes/lecture_code.h"
#include "geometry/camera.h"
#include "geometry/plane.h"
#include "geometry/projection.h"

namespace viewing {
namespace {

using glm::dmat3;
using glm::dmat4;
using glm::dvec3;
using glm::dvec4;

/// A matrix of the state.
struct Known {
    char letter;
    dmat4 right;
    std::size_t plane = 0, light = 0;
};

double entry(const dmat4& m, int row, int column) {
    return m[column][row];
}

bool is_near(double a, double b, double tolerance) {
    return std::abs(a - b) <= tolerance + 2e-6 * std::max(std::abs(a), std::abs(b));
}

bool is_same(const dmat4& a, const dmat4& b, double tolerance) {
    for (int i = 0; i < 16; ++i)
        if (!is_near(a[i / 4][i % 4], b[i / 4][i % 4], tolerance)) return false;
    return true;
}

/// Compares two matrices up to a factor that is not zero.
bool is_same_map(const dmat4& a, const dmat4& b, double tolerance) {
    const double size = largest_entry(b), own = largest_entry(a);
    return own > 0.0 &&
           largest_difference_up_to_scale(a, b) <= 2e-6 * size + tolerance * std::max(1.0, 2.0 * size / own);
}

bool is_same_direction(const dvec4& a, const dvec4& b, double tolerance) {
    const dvec4 unit_a = glm::normalize(a), unit_b = glm::normalize(b);
    return std::min(glm::length(unit_a - unit_b), glm::length(unit_a + unit_b)) <= 1e-5 + 4.0 * tolerance;
}

bool has_row(const dmat4& m, int row, const dvec4& values, double tolerance) {
    for (int column = 0; column < 4; ++column)
        if (!is_near(entry(m, row, column), values[column], tolerance)) return false;
    return true;
}

bool has_affine_row(const dmat4& m, double tolerance) {
    return has_row(m, 3, {0, 0, 0, 1}, tolerance);
}

dmat4 flipped(const dvec3& signs) {
    dmat4 flip(1.0);
    for (int axis = 0; axis < 3; ++axis) flip[axis][axis] = signs[axis];
    return flip;
}

/// Moves the translation from the last column to the last row.
dmat4 with_translation_in_row(const dmat4& m) {
    dmat4 moved = dmat4(dmat3(m));
    for (int axis = 0; axis < 3; ++axis) moved[axis][3] = m[3][axis];
    return moved;
}

/// The state without its mistakes: V, C, P, then S and R of each plane.
class State {
public:
    State(const Params& params, double aspect) : params_(params), aspect_(aspect) {
        params_.slips = {};
        const CameraParams& camera = params_.camera;
        camera_ = world_from_view(camera.position, camera.angles());
        known_ = {{'V', view_from_world(camera_)}, {'C', camera_}, {'P', projection(is_zero_to_one(), is_reversed())}};
        for (std::size_t plane = 0; plane < params_.planes.size(); ++plane) {
            const dvec4 unit = unit_plane(params_.planes[plane].equation);
            for (std::size_t light = 0; light < params_.lights.size(); ++light)
                known_.push_back({'S', shadow_matrix(unit, params_.lights[light].position), plane, light});
            known_.push_back({'R', mirror_matrix(unit), plane, 0});
        }
    }

    const std::vector<Known>& known() const { return known_; }
    const Known& first(char letter) const {
        return *std::find_if(known_.begin(), known_.end(), [&](const Known& one) { return one.letter == letter; });
    }
    const Params& params() const { return params_; }
    bool is_reversed() const { return params_.depth.mapping == DepthMapping::reversed; }
    bool is_zero_to_one() const { return is_reversed() && params_.depth.reversed_zero_to_one; }

    dmat4 projection(bool zero_to_one, bool reversed, bool degrees = false, bool inverse_aspect = false) const {
        Params other = params_;
        other.slips.degrees_as_radians = degrees;
        const Lens lens = other.lens();
        const double aspect = inverse_aspect ? 1.0 / shown_aspect() : shown_aspect();
        dmat4 p = reversed ? clip_from_view_reversed(lens, aspect) : clip_from_view(lens, aspect);
        if (reversed == zero_to_one) return p;  // reversed P is made for 0 … 1, the other one for −1 … 1
        for (int column = 0; column < 4; ++column)
            p[column][2] = zero_to_one ? 0.5 * (p[column][2] + p[column][3]) : 2.0 * p[column][2] - p[column][3];
        return p;
    }

private:
    double shown_aspect() const { return params_.projection.aspect > 0.0 ? params_.projection.aspect : aspect_; }

    Params params_;
    double aspect_;
    dmat4 camera_;
    std::vector<Known> known_;
};

struct Spoiled {
    MatrixFault fault;
    dmat4 matrix;
};

/// Returns what the common mistakes make of a matrix.
std::vector<Spoiled> spoiled(const State& state, const Known& one) {
    using enum MatrixFault;
    const dmat4& right = one.right;
    std::vector<Spoiled> all{{transposed, glm::transpose(right)}};
    switch (one.letter) {
        case 'V':
        case 'C':
            all.push_back({translation_in_row, with_translation_in_row(right)});
            all.push_back({left_handed, one.letter == 'V' ? flipped({1, 1, -1}) * right : right * flipped({1, 1, -1})});
            if (one.letter == 'V') all.push_back({looks_back, flipped({-1, 1, -1}) * right});
            break;
        case 'P': {
            const bool zero_to_one = state.is_zero_to_one(), reversed_now = state.is_reversed();
            const auto add = [&](MatrixFault fault, const dmat4& matrix) { all.push_back({fault, matrix}); };
            add(zero_to_one ? minus_one_to_one : MatrixFault::zero_to_one,
                state.projection(!zero_to_one, reversed_now));
            add(reversed, state.projection(zero_to_one, !reversed_now));
            add(reversed, state.projection(!zero_to_one, !reversed_now));
            if (state.params().projection.type == ProjectionType::perspective)
                add(degrees, state.projection(zero_to_one, reversed_now, true));
            add(inverse_aspect, state.projection(zero_to_one, reversed_now, false, true));
            add(left_handed, right * flipped({1, 1, -1}));
            break;
        }
        case 'R': {
            const dvec4& typed = state.params().planes[one.plane].equation;
            all.push_back({plus_2ab, mirror_matrix_as_typed(unit_plane(typed), true)});
            all.push_back({not_unit_normal, mirror_matrix_as_typed(typed, false)});
            break;
        }
        default:
            break;
    }
    return all;
}

// ---- structure ------------------------------------------------------------------------------------------------------

void describe_camera(ExplainedMatrix& found, const dmat4& world_from_view) {
    const dvec3 eye(world_from_view[3]);
    const dmat3 axes(world_from_view);
    found.angles = angles_from_rotation(axes);
    found.camera = look_at_of(eye, found.angles, 1.0);
}

/// Reads near and far from row 3 of P, whose entries are a z + b; `divides`: the result is divided by −z.
void read_depth(FoundLens& lens, double a, double b, bool divides) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double at_near = lens.zero_to_one ? 0.0 : -1.0;
    const auto distance_of = [&](double depth) {
        const double below = divides ? a + depth : a, above = divides ? b : b - depth;
        return std::abs(below) < 1e-12 ? infinity : above / below;
    };
    lens.near = distance_of(at_near);
    lens.far = distance_of(1.0);
}

}  // namespace

std::optional<FoundLens> read_lens(const dmat4& m, bool zero_to_one, double tolerance) {
    for (const auto& [row, column] : {std::pair(0, 1), {0, 3}, {1, 0}, {1, 3}, {2, 0}, {2, 1}}) {
        const bool may_shift = column == 3 && has_affine_row(m, tolerance);
        if (!may_shift && !is_near(entry(m, row, column), 0.0, tolerance)) return std::nullopt;
    }
    const double x = entry(m, 0, 0), y = entry(m, 1, 1);
    if (x == 0.0 || y == 0.0) return std::nullopt;
    FoundLens lens;
    lens.zero_to_one = zero_to_one;
    lens.aspect = std::abs(y / x);
    if (has_row(m, 3, {0, 0, -1, 0}, tolerance)) {
        lens.fovy_deg = glm::degrees(2.0 * std::atan(1.0 / y));
        lens.off_center = !is_near(entry(m, 0, 2), 0.0, tolerance) || !is_near(entry(m, 1, 2), 0.0, tolerance);
        read_depth(lens, entry(m, 2, 2), entry(m, 2, 3), true);
        const double n = std::min(lens.near, lens.far);
        lens.edges = {n * (entry(m, 0, 2) - 1.0) / x, n * (entry(m, 0, 2) + 1.0) / x, n * (entry(m, 1, 2) - 1.0) / y,
                      n * (entry(m, 1, 2) + 1.0) / y};
        return lens;
    }
    if (!has_affine_row(m, tolerance) || entry(m, 2, 2) == 0.0) return std::nullopt;
    if (!is_near(entry(m, 0, 2), 0.0, tolerance) || !is_near(entry(m, 1, 2), 0.0, tolerance)) return std::nullopt;
    lens.orthographic = true;
    lens.height = 2.0 / y;
    lens.edges = {(-1.0 - entry(m, 0, 3)) / x, (1.0 - entry(m, 0, 3)) / x, (-1.0 - entry(m, 1, 3)) / y,
                  (1.0 - entry(m, 1, 3)) / y};
    lens.off_center = !is_near(entry(m, 0, 3), 0.0, tolerance) || !is_near(entry(m, 1, 3), 0.0, tolerance);
    const double a = entry(m, 2, 2), b = entry(m, 2, 3);
    lens.near = (b - (zero_to_one ? 0.0 : -1.0)) / a;
    lens.far = (b - 1.0) / a;
    return lens;
}

namespace {

/// A matrix of rank 1 as column · rowᵀ; none if the rank is not 1.
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
    found.fault =
        is_near(squared, 1.0, 8.0 * tolerance + 1e-5) ? MatrixFault::other_plane : MatrixFault::not_unit_normal;
    return true;
}

/// Explains a shadow matrix: k I − S = L Πᵀ with k = tr S / 3.
bool explain_shadow(ExplainedMatrix& found, const dmat4& m, const State& state, double tolerance) {
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
bool explain_pose(ExplainedMatrix& found, const dmat4& m, char named, const State& state, double tolerance) {
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
    // V · scale has rows, scale · V columns that are not perpendicular, unless the scale is uniform.
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

bool explain_projection(ExplainedMatrix& found, const dmat4& m, char named, const State& state, double tolerance) {
    const bool looks_along_z = has_row(m, 3, {0, 0, 1, 0}, tolerance);  // w = z instead of −z
    const dmat4 p = looks_along_z ? m * flipped({1, 1, -1}) : m;
    const std::optional<FoundLens> lens = read_lens(p, state.is_zero_to_one(), tolerance);
    const bool is_expected = named == 'P' || state.params().projection.type == ProjectionType::orthographic;
    if (!lens || (lens->orthographic && !is_expected)) return false;
    found.letter = 'P';
    found.lens = lens;
    found.fault = looks_along_z ? MatrixFault::left_handed : MatrixFault::different;
    return true;
}

bool explain_structure(ExplainedMatrix& found, const dmat4& m, char named, const State& state, double tolerance) {
    if (named == 'S' && explain_shadow(found, m, state, tolerance))
        return true;  // diag(1, 0, 1, 1) is also half a mirror
    return explain_projection(found, m, named, state, tolerance) || explain_mirror(found, m, tolerance) ||
           explain_pose(found, m, named, state, tolerance) || explain_shadow(found, m, state, tolerance);
}

/// Fills in what the right matrix tells, for a matrix that was recognized by comparison.
void describe_right(ExplainedMatrix& found, const State& state) {
    if (found.letter == 'V' || found.letter == 'C') describe_camera(found, state.first('C').right);
    if (found.letter == 'P') found.lens = read_lens(*found.right, state.is_zero_to_one(), 1e-12);
    if (found.letter == 'S' || found.letter == 'R')
        found.found_plane = unit_plane(state.params().planes[found.plane].equation);
    if (found.letter == 'S') found.found_light = state.params().lights[found.light].position;
}

}  // namespace

ExplainedMatrix explain_matrix(const dmat4& pasted, char named, const Params& params, double aspect, double tolerance) {
    const State state(params, aspect);
    std::vector<Known> known = state.known();
    std::stable_partition(known.begin(), known.end(), [named](const Known& one) { return one.letter == named; });
    const auto equals = [&](const Known& one, const dmat4& matrix) {
        return one.letter == 'S' ? is_same_map(pasted, matrix, tolerance) : is_same(pasted, matrix, tolerance);
    };
    ExplainedMatrix found;
    const auto take = [&](const Known& one, MatrixFault fault) {
        found.letter = one.letter;
        found.fault = fault;
        found.plane = one.plane;
        found.light = one.light;
    };
    for (const Known& one : known) {
        if (found.letter == 0 && equals(one, one.right)) take(one, MatrixFault::none);
    }
    const bool swaps = (named == 'V' && found.letter == 'C') || (named == 'C' && found.letter == 'V');
    if (swaps) take(state.first(named), MatrixFault::inverse);
    for (const Known& one : known) {
        if (found.letter != 0) break;
        for (const Spoiled& wrong : spoiled(state, one)) {
            if (!equals(one, wrong.matrix)) continue;
            take(one, wrong.fault);
            break;
        }
    }
    const bool is_known = found.letter != 0;
    if (!is_known && !explain_structure(found, pasted, named, state, tolerance) &&
        explain_structure(found, glm::transpose(pasted), named, state, tolerance))
        found.fault = MatrixFault::transposed;
    if (found.letter == 0) return found;
    for (const Known& one : known)
        if (one.letter == found.letter && one.plane == found.plane && one.light == found.light) found.right = one.right;
    found.off = found.letter == 'S' ? largest_difference_up_to_scale(pasted, *found.right)
                                    : largest_entry(pasted - *found.right);
    if (is_known) describe_right(found, state);
    return found;
}

}  // namespace viewing
