#include "topics/hidden/numbers/hidden_views.h"

#include <algorithm>

#include "topics/hidden/numbers/hidden_method.h"

namespace viewing {
namespace {

/// Returns whether only GL can draw the mirror image, in scene order, because a setting or a mistake changes R, the
/// mirrored side or the mirrored camera's projection.
bool is_mirrored_by_gl_alone(const Params& params, const DerivedPlane& plane) {
    const ReflectionParams& reflection = params.reflection;
    const bool has_other_camera = (reflection.mirrored == MirroredThing::camera && !reflection.same_projection) ||
                                  params.mirror_picture_scale() != 1.0;
    return plane.mirror_by_hand || plane.mirror_has_slip || reflection.printed_by_rows || !reflection.side_of_eye ||
           has_other_camera || (params.slips.oblique_in_world && reflection.clip == MirrorClip::oblique);
}

/// Returns the worst error of the painter's algorithm. Looks for it in a small picture, which takes little time
/// compared with the view's picture.
std::optional<WrongPair> painter_failure(HiddenSurfaceSolver& solver, HiddenRequest request, WorkProgress* progress) {
    constexpr int widest_px = 160;
    constexpr std::size_t most_polygons = 20'000;
    const bool is_whole = hidden_method(request.visibility.method).sorts_by_key && request.visibility.step < 0;
    if (!is_whole || solver.surface()->polygons.size() > most_polygons) return std::nullopt;
    if (request.size_px.x > widest_px)
        request.size_px = {widest_px, std::max(request.size_px.y * widest_px / request.size_px.x, 1)};
    const auto painted = solver.solve(request, progress);
    request.visibility.method = reference_method;
    request.visibility.exact_curves = false;
    const auto seen = solver.solve(request, progress);
    if (is_canceled(progress)) return std::nullopt;
    return worst_pair(seen->image, painted->image);
}

}  // namespace

std::optional<HiddenQuestion> hidden_question(const Params& params, const Derived& derived, glm::ivec2 size_px) {
    const VisibilityParams& visibility = params.visibility;
    const bool gl_alone = is_drawn_by_gl_alone(visibility.method);
    const bool compares = params.view.shows == Shows::difference;
    if (gl_alone && visibility.step < 0 && !compares && !visibility.numbers) return std::nullopt;

    HiddenQuestion question{.camera = hidden_request(params, derived, size_px)};
    question.draws_camera = !gl_alone || visibility.step >= 0;
    const DerivedPlane& plane = derived.planes.front();
    if (!gl_alone && !is_taken_apart(visibility) && params.reflection.enabled && params.reflection.bounces > 0 &&
        plane.eye_side != 0.0 && !is_mirrored_by_gl_alone(params, plane))
        question.mirrored = mirrored_request(params, derived, size_px);
    if (compares) {
        question.other = question.camera;
        question.other->visibility.method = visibility.compare_with;
        question.other->visibility.step = -1;
    }
    return question;
}

Message HiddenAnswer::problem() const {
    for (const auto* drawing : {&pictures.camera, &pictures.mirrored})
        if (*drawing && (*drawing)->is_cut) return sentence_of_canceled();
    for (const auto* result : {&mirrored, &other})
        if (*result && camera->problem.empty() && !(*result)->problem.empty()) return (*result)->problem;
    return camera->problem;
}

Message beyond_hidden_budget(const Scene& scene, const HiddenQuestion& question) {
    const auto builds = [](const HiddenRequest& request) { return hidden_method(request.visibility.method).has_tree; };
    return beyond_hidden_budget(scene, builds(question.camera) || (question.other && builds(*question.other)));
}

HiddenAnswer answer_hidden_question(HiddenSurfaceSolver& solver, const HiddenQuestion& question,
                                    WorkProgress* progress) {
    HiddenAnswer answer{.question = question, .camera = solver.solve(question.camera, progress)};
    answer.pictures.bounds_world = solver.surface()->scene.bounds_world;
    if (question.draws_camera)
        answer.pictures.camera = std::make_shared<const HiddenDrawing>(hidden_drawing(*answer.camera, progress));
    answer.painter_fails = painter_failure(solver, question.camera, progress);
    if (question.mirrored) {
        answer.mirrored = solver.solve(*question.mirrored, progress);
        answer.pictures.mirrored = std::make_shared<const HiddenDrawing>(hidden_drawing(*answer.mirrored, progress));
    }
    if (question.other) {
        answer.other = solver.solve(*question.other, progress);
        // Otherwise, GL draws polygons, and rounds the positions of their corners.
        if (draws_pixels(question.camera.visibility) && draws_pixels(question.other->visibility))
            add_difference(answer, answer.camera->image, answer.other->image);
    }
    return answer;
}

void add_difference(HiddenAnswer& answer, const IdImage& camera, const IdImage& other) {
    const bool has_curves = uses_exact_curves(answer.camera->request) || uses_exact_curves(answer.other->request);
    const std::vector<int> object_of_source =
        has_curves ? answer.camera->surface->object_of_source() : std::vector<int>();
    const HiddenResult& drawn = draws_pixels(answer.camera->request.visibility) ? *answer.other : *answer.camera;
    DifferenceDrawing drawing = difference_drawing(
        has_curves ? difference(with_ids(other, object_of_source), with_ids(camera, object_of_source))
                   : difference_from_drawn(other, camera, drawn),
        {camera.width, camera.height});
    drawing.share = answer.camera->request.share;
    answer.different_pixels = drawing.different;
    answer.compared_pixels = drawing.compared;
    answer.pictures.difference = std::make_shared<const DifferenceDrawing>(std::move(drawing));
}

FramePlan plan_polygon_ids(Params params, const Derived& derived, const HiddenResult& result) {
    params.visibility = result.request.visibility;
    params.view.shows = Shows::color;
    Derived part = derived;
    part.clip_from_view = part_from_view(result.request.share) * derived.clip_from_view;
    part.clip_from_world = part.clip_from_view * derived.view_from_world;
    HiddenPictures pictures;
    pictures.camera = std::make_shared<const HiddenDrawing>(hidden_drawing(result));
    return plan(params, part, pictures);
}

}  // namespace viewing
