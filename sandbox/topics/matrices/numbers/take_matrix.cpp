#include "topics/matrices/numbers/take_matrix.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/camera.h"
#include "state/fields.h"
#include "text/numbers.h"
#include "topics/matrices/numbers/matrix_structure.h"

namespace viewing {
namespace {

using glm::dmat4;

dmat4 negated(const dmat4& m, int row) {
    dmat4 made = m;
    for (int column = 0; column < 4; ++column) made[column][row] = -made[column][row];
    return made;
}

/// Replaces each entry of the third row with a function of it and of the entry below it.
dmat4 with_depth_row(dmat4 p, double (*mapped)(double z, double w)) {
    for (int column = 0; column < 4; ++column) p[column][2] = mapped(p[column][2], p[column][3]);
    return p;
}

dmat4 with_translation_in_column(const dmat4& m) {
    dmat4 made = dmat4(glm::dmat3(m));
    for (int axis = 0; axis < 3; ++axis) made[3][axis] = m[axis][3];
    return made;
}

void take_camera(Params& params, const dmat4& world_from_view) {
    CameraParams& camera = params.camera;
    const double depth = glm::distance(camera.position, camera.target);
    camera.position = glm::dvec3(world_from_view[3]);
    const Angles angles = angles_from_rotation(glm::dmat3(world_from_view));
    camera.yaw = angles.yaw_deg;
    camera.pitch = angles.pitch_deg;
    camera.roll = angles.roll_deg;
    camera.target = camera.position - depth * glm::dvec3(world_from_view[2]);
    params.slips.swapped_order = params.slips.camera_as_view = false;
    params.camera_overrides.view_from_world.reset();
}

/// Writes near, far and the depth mapping; returns whether a state may have that range.
bool take_range(Params& params, const FoundLens& lens, bool is_reversed) {
    ProjectionParams& projection = params.projection;
    projection.near = is_reversed ? lens.far : lens.near;
    projection.far = is_reversed ? lens.near : lens.far;
    if (projection.far > field("projection.far").max) projection.far = std::numeric_limits<double>::infinity();
    DepthMapping& mapping = params.depth.mapping;
    if (is_reversed)
        mapping = DepthMapping::reversed;
    else if (mapping == DepthMapping::reversed || std::isinf(projection.far))
        mapping = DepthMapping::standard;
    return projection.near < projection.far;
}

bool take_projection(Params& params, const dmat4& p, double view_aspect, double tolerance) {
    const bool is_orthographic = p[2][3] == 0.0;
    const bool is_reversed = is_orthographic ? p[2][2] > 0.0 : p[2][2] > -0.5;
    if (is_reversed) params.depth.reversed_zero_to_one = is_for_zero_to_one(p, params, tolerance);
    const std::optional<FoundLens> lens =
        read_lens(p, is_reversed && params.depth.reversed_zero_to_one, std::max(tolerance, 1e-9));
    if (!lens || !take_range(params, *lens, is_reversed)) return false;
    ProjectionParams& projection = params.projection;
    params.slips.degrees_as_radians = false;
    params.camera_overrides.clip_from_view.reset();
    const auto is_within = [](const char* path, double value) {
        return value >= field(path).min && value <= field(path).max;
    };
    const bool has_size =
        is_orthographic ? is_within("projection.height", lens->height) : is_within("projection.fovy", lens->fovy_deg);
    const bool is_upright = p[0][0] > 0.0 && p[1][1] > 0.0;
    const bool has_window =
        lens->off_center || !has_size || !is_within("projection.aspect", lens->aspect) || lens->aspect < min_aspect;
    projection.set_type(is_orthographic, has_window);
    if (has_window) {
        projection.set_window(lens->edges);
    } else {
        (is_orthographic ? projection.height : projection.fovy) = is_orthographic ? lens->height : lens->fovy_deg;
        const double rounding = tolerance > 1e-9 ? 4.0 * tolerance : 1e-12;
        projection.aspect = std::abs(lens->aspect / view_aspect - 1.0) <= rounding ? 0.0 : lens->aspect;
    }
    return is_upright;
}

}  // namespace

bool is_takeable(const ExplainedMatrix& found) {
    switch (found.fault) {
        case MatrixFault::none:
        case MatrixFault::different:
            return found.letter != 0;
        case MatrixFault::reversed:
            return true;
        case MatrixFault::other_light:
        case MatrixFault::other_plane:
            return found.letter == 'S' || found.letter == 'R';
        default:
            return false;
    }
}

bool is_misnamed(char named, const ExplainedMatrix& found) {
    return named != 0 && named != found.letter && is_takeable(found);
}

std::optional<dmat4> fixed_matrix(const dmat4& pasted, const ExplainedMatrix& found) {
    if (found.fault == MatrixFault::negated) return -pasted;
    if (found.letter != 'V' && found.letter != 'C' && found.letter != 'P') return std::nullopt;
    switch (found.fault) {
        case MatrixFault::inverse:
            return glm::inverse(pasted);
        case MatrixFault::transposed:
            return glm::transpose(pasted);
        case MatrixFault::translation_in_row:
            return with_translation_in_column(pasted);
        case MatrixFault::scaled: {
            if (!found.camera) return std::nullopt;
            const dmat4 pose = world_from_view(found.camera->eye, found.angles);
            return found.letter == 'C' ? pose : view_from_world(pose);
        }
        case MatrixFault::left_handed:
            // An axis is negated: a row of V, a column of C, or the third column of P.
            return found.letter == 'V' ? negated(pasted, found.negated_axis)
                                       : glm::transpose(negated(glm::transpose(pasted), found.negated_axis));
        case MatrixFault::mirrored: {
            const dmat4 upright = found.lens->mirrored_x ? negated(pasted, 0) : pasted;
            return found.lens->mirrored_y ? negated(upright, 1) : upright;
        }
        case MatrixFault::lost_sign:
            return negated(pasted, 3);
        case MatrixFault::looks_back:
            return negated(negated(pasted, 0), 2);
        case MatrixFault::zero_to_one:
            return with_depth_row(pasted, [](double z, double w) { return 2.0 * z - w; });
        case MatrixFault::minus_one_to_one:
            return with_depth_row(pasted, [](double z, double w) { return 0.5 * (z + w); });
        case MatrixFault::depth_signs:
            return with_depth_signs(pasted, *found.right);
        case MatrixFault::degrees:
        case MatrixFault::inverse_aspect:
        case MatrixFault::eye_not_negated:
        case MatrixFault::wrong_order:
            return found.right;
        default:
            return std::nullopt;
    }
}

namespace {

/// Adopts a changed state if all its values are in range; returns whether they are.
bool take_if_legal(Params& params, Params&& taken) {
    Params legal = taken;
    clamp_to_ranges(legal);
    if (legal != taken) return false;
    params = std::move(taken);
    return true;
}

}  // namespace

bool take_matrix(Params& params, char letter, const dmat4& matrix, double view_aspect, double tolerance) {
    if (letter == 'S' || letter == 'R') return enter_by_hand(params, letter, matrix);
    Params taken = params;
    if (letter == 'V')
        take_camera(taken, view_from_world(matrix));  // view_from_world() inverts any rigid matrix, V as well as C
    if (letter == 'C') take_camera(taken, matrix);
    if (letter == 'P' && !take_projection(taken, matrix, view_aspect, tolerance)) return false;
    return take_if_legal(params, std::move(taken));
}

std::string setting_of(const char* path, const glm::dmat4& matrix) {
    std::string text = std::string(path) + "=[";
    for (int row = 0; row < 4; ++row) {
        text += row == 0 ? "[" : ", [";
        for (int column = 0; column < 4; ++column)
            text += (column == 0 ? "" : ", ") + plain_number(matrix[column][row] + 0.0);
        text += "]";
    }
    return text + "]";
}

bool enter_by_hand(Params& params, char letter, const dmat4& matrix) {
    Params taken = params;
    const Choice chosen = params.chosen();
    PlaneOverrides& of_plane = taken.overrides[chosen.plane];
    if (letter == 'C' && glm::determinant(matrix) == 0.0) return false;
    if (letter == 'V' || letter == 'C')
        taken.camera_overrides.view_from_world = letter == 'C' ? glm::inverse(matrix) : matrix;
    if (letter == 'P') taken.camera_overrides.clip_from_view = matrix;
    if (letter == 'S') of_plane.shadowed_world_from_world[chosen.light] = matrix;
    if (letter == 'R') of_plane.mirrored_world_from_world = matrix;
    return take_if_legal(params, std::move(taken));
}

}  // namespace viewing
