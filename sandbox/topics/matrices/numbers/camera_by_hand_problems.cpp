// Identifies a V or P entered by hand: the state's own, the matrix of another camera or lens, or a wrong one with a
// fault that explain_matrix.h names.
#include <cmath>

#include "frame/problems.h"
#include "frame/say.h"
#include "geometry/camera.h"
#include "text/numbers.h"
#include "topics/matrices/numbers/fault_words.h"
#include "topics/matrices/numbers/take_matrix.h"

namespace viewing {
namespace {

constexpr double shown = 5.1e-4;  // entries may be typed with the digits that the window shows

/// Returns the setting that fixes a matrix; if no fix is known, only the field's name, which clears the matrix entered
/// by hand.
std::string fix_of(const char* path, const glm::dmat4& matrix, const ExplainedMatrix& found) {
    const std::optional<glm::dmat4> fixed = fixed_matrix(matrix, found);
    return fixed ? setting_of(path, *fixed) : path;
}

bool is_flat(const glm::dmat4& matrix) {
    return !(std::abs(glm::determinant(matrix)) > 1e-12);
}

/// Reports a matrix that has no inverse, is another kind of matrix, or contains a known mistake; returns whether one of
/// these applies. `letter`: V or P, the kind that the matrix should be.
bool tell_fault(Sayer& tell, char letter, const char* path, const glm::dmat4& matrix, const ExplainedMatrix& found) {
    const std::string name(1, letter);
    if (is_flat(matrix)) {
        tell.broken(true,
                    sentence("by_hand.flat",
                             "{matrix} entered by hand has no inverse (det = 0): it flattens everything to a plane, a "
                             "line or a point",
                             "matrix"_a = name),
                    path);
        return true;
    }
    if (found.letter != 0 && found.letter != letter) {
        tell.broken(true,
                    sentence("by_hand.other_matrix", "{matrix} entered by hand is another matrix: {title}",
                             "matrix"_a = name, "title"_a = message(fmt::runtime(matrix_title(found.letter)))),
                    path);
        return true;
    }
    if (found.fault == MatrixFault::none || found.fault == MatrixFault::different ||
        found.fault == MatrixFault::unknown)
        return false;
    tell.broken(true,
                sentence("by_hand.wrong_camera", "{matrix} entered by hand is wrong: {fault}", "matrix"_a = name,
                         "fault"_a = message(fmt::runtime(fault_words(found).wrong))),
                fix_of(path, matrix, found));
    return true;
}

void tell_view(Sayer& tell, const Params& params, const Derived& derived, const glm::dmat4& v) {
    constexpr const char* path = "overrides.view_from_world";
    const ExplainedMatrix found = explain_matrix(v, 'V', params, derived.view_aspect, shown);
    if (tell_fault(tell, 'V', path, v, found)) return;
    tell(true, sentence("by_hand.view", "V is entered by hand: the camera's position and angles no longer change it"),
         path);
    if (found.fault == MatrixFault::none) return;
    if (found.fault == MatrixFault::different && found.camera) {
        const glm::dvec3 &eye = found.camera->eye, along = found.camera->center - eye;
        return tell(true, sentence("by_hand.other_camera",
                                   "V entered by hand is that of another camera: at {eye}, looking along {direction}",
                                   "eye"_a = figures_of({&eye.x, 3}, 3), "direction"_a = figures_of({&along.x, 3}, 3)));
    }
    const glm::dvec4 last = glm::transpose(v)[3];
    const bool has_one_w = glm::dvec3(last) == glm::dvec3(0.0);
    if (has_one_w && last.w > 0.0 && last.w != 1.0)
        return tell(true,
                    sentence("by_hand.view_scales",
                             "V entered by hand has the last row {row}: w is {w} for every point, as if the scene were "
                             "scaled about the eye by {scale}",
                             "row"_a = figures_of({&last.x, 4}, 3), "w"_a = figures(last.w, 3),
                             "scale"_a = figures(1.0 / last.w, 3)));
    tell.broken(!is_affine(v),
                sentence("by_hand.view_changes_w",
                         "V entered by hand has the last row {row} instead of (0, 0, 0, 1): w depends on the point, so "
                         "V already divides",
                         "row"_a = figures_of({&last.x, 4}, 3)),
                path);
    tell.broken(is_affine(v),
                sentence("by_hand.view_shears",
                         "V entered by hand has axes that are not perpendicular: it shears everything that the camera "
                         "sees"),
                path);
}

void tell_projection(Sayer& tell, const Params& params, const Derived& derived, const glm::dmat4& p) {
    constexpr const char* path = "overrides.clip_from_view";
    const ExplainedMatrix found = explain_matrix(p, 'P', params, derived.view_aspect, shown);
    if (tell_fault(tell, 'P', path, p, found)) return;
    tell(true,
         sentence("by_hand.projection",
                  "P is entered by hand: the angle, the aspect ratio, near and far no longer change it"),
         path);
    if (found.fault == MatrixFault::none) return;
    if (found.fault == MatrixFault::different && found.lens && derived.has_distances) {
        const FoundLens& lens = *found.lens;
        const std::string near = figures(lens.near, 3), far = std::isinf(lens.far) ? "∞" : figures(lens.far, 3);
        return tell(true, lens.orthographic
                              ? sentence("by_hand.other_lens",
                                         "P entered by hand is that of another projection: orthographic, height "
                                         "{height}, near {near}, far {far}",
                                         "height"_a = figures(lens.height, 3), "near"_a = near, "far"_a = far)
                              : sentence("by_hand.other_lens",
                                         "P entered by hand is that of another projection: fovy {fovy}°, near {near}, "
                                         "far {far}",
                                         "fovy"_a = figures(lens.fovy_deg, 3), "near"_a = near, "far"_a = far));
    }
    tell.broken(!params.lens_by_hand(),
                sentence("by_hand.no_lens",
                         "P entered by hand does not describe a lens: near and far have no meaning, and depths are not "
                         "distances"),
                path);
}

}  // namespace

void find_camera_by_hand_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived) {
    const CameraOverrides& by_hand = params.camera_overrides;
    Sayer tell_camera(problems, "camera"), tell_lens(problems, "projection");
    if (by_hand.view_from_world) tell_view(tell_camera, params, derived, *by_hand.view_from_world);
    if (by_hand.clip_from_view) tell_projection(tell_lens, params, derived, *by_hand.clip_from_view);
}

}  // namespace viewing
