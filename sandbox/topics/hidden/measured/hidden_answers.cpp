#include "topics/hidden/measured/hidden_answers.h"

namespace viewing {
Result<IdImage> polygon_ids_drawn(Renderer& renderer, const Params& params, const Derived& derived, const Scene& scene,
                                  const HiddenResult& result) {
    if (draws_pixels(result.request.visibility)) return result.image;
    View view;
    return renderer.read_polygon_ids(plan_polygon_ids(params, derived, result), scene, result.request.size_px, view);
}

Status complete_difference(Renderer& renderer, const Params& params, const Derived& derived, const Scene& scene,
                           HiddenAnswer& answer) {
    if (!answer.other || answer.pictures.difference) return std::monostate{};
    const Result<IdImage> camera = polygon_ids_drawn(renderer, params, derived, scene, *answer.camera);
    if (!camera) return Error{camera.error()};
    const Result<IdImage> other = polygon_ids_drawn(renderer, params, derived, scene, *answer.other);
    if (!other) return Error{other.error()};
    add_difference(answer, *camera, *other);
    return std::monostate{};
}

Result<FramePlan> plan_at_once(Renderer& renderer, const Params& params, const Derived& derived, const Scene& scene,
                               glm::ivec2 size_px) {
    const std::optional<HiddenQuestion> question = hidden_question(params, derived, size_px);
    if (!question) return plan(params, derived);
    if (const Message why = beyond_hidden_budget(scene, *question); !why.empty()) return Error{say(why)};
    HiddenSurfaceSolver solver(scene);
    HiddenAnswer answer = answer_hidden_question(solver, *question);
    if (Status done = complete_difference(renderer, params, derived, scene, answer); !done) return Error{done.error()};
    return plan(params, derived, answer.pictures);
}

}  // namespace viewing
