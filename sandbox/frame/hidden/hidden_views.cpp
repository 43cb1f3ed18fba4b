#include "frame/hidden/hidden_views.h"

#include "visibility/difference.h"

namespace viewing {
namespace {

bool has_image(const HiddenResult& result) {
    return !is_drawn_by_gl_alone(result.request.visibility.method);
}

/// What has been put in the place of R, or of the side that is mirrored, is no view that a method could take: GL draws
/// that image as it comes.
bool is_mirrored_by_gl_alone(const Params& params, const DerivedPlane& plane) {
    const ReflectionParams& reflection = params.reflection;
    const bool has_other_camera = reflection.mirrored == MirroredThing::camera && !reflection.same_projection;
    return plane.mirror_by_hand || reflection.printed_by_rows || !reflection.side_of_eye || has_other_camera;
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
    if (!gl_alone && visibility.step < 0 && params.reflection.enabled && params.reflection.bounces > 0 &&
        plane.eye_side != 0.0 && !is_mirrored_by_gl_alone(params, plane))
        question.mirrored = mirrored_request(params, derived, size_px);
    if (compares) {
        question.other = question.camera;
        question.other->visibility.method = visibility.compare_with;
        question.other->visibility.step = -1;
    }
    return question;
}

const std::string& HiddenAnswer::problem() const {
    for (const auto* result : {&mirrored, &other})
        if (*result && camera->problem.empty() && !(*result)->problem.empty()) return (*result)->problem;
    return camera->problem;
}

HiddenAnswer answer_hidden_question(HiddenSurfaceSolver& solver, const HiddenQuestion& question,
                                    WorkProgress* progress) {
    HiddenAnswer answer{.question = question, .camera = solver.solve(question.camera, progress)};
    answer.pictures.bounds_world = solver.surface()->scene.bounds_world;
    if (question.draws_camera)
        answer.pictures.camera = std::make_shared<const HiddenDrawing>(hidden_drawing(*answer.camera));
    if (question.mirrored) {
        answer.mirrored = solver.solve(*question.mirrored, progress);
        answer.pictures.mirrored = std::make_shared<const HiddenDrawing>(hidden_drawing(*answer.mirrored));
    }
    if (question.other) {
        answer.other = solver.solve(*question.other, progress);
        if (has_image(*answer.camera) && has_image(*answer.other))
            add_difference(answer, answer.camera->image, answer.other->image);
    }
    return answer;
}

void add_difference(HiddenAnswer& answer, const IdImage& camera, const IdImage& other) {
    DifferenceDrawing drawing;
    if (uses_exact_curves(answer.camera->request) || uses_exact_curves(answer.other->request)) {
        const std::vector<int> object_of_source = answer.camera->surface->object_of_source();
        drawing = difference_drawing(with_ids(other, object_of_source), with_ids(camera, object_of_source));
    } else {
        drawing = difference_drawing(other, camera);
    }
    answer.different_pixels = drawing.different;
    answer.compared_pixels = drawing.compared;
    answer.pictures.difference = std::make_shared<const DifferenceDrawing>(std::move(drawing));
}

FramePlan plan_polygon_ids(Params params, const Derived& derived, const HiddenResult& result) {
    params.visibility = result.request.visibility;
    params.view.shows = Shows::color;
    HiddenPictures pictures;
    pictures.camera = std::make_shared<const HiddenDrawing>(hidden_drawing(result));
    return plan(params, derived, pictures);
}

}  // namespace viewing
