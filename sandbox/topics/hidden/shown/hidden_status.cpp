#include "topics/hidden/shown/hidden_status.h"

#include "text/catalogue.h"
#include "topics/hidden/shown/polygon_names.h"
#include "ui/parts/view_window.h"

namespace viewing {

const std::shared_ptr<const HiddenResult>& shown_result(const HiddenStatus& hidden) {
    static const std::shared_ptr<const HiddenResult> none;
    return hidden.answer ? hidden.answer->camera : none;
}

std::optional<Problem> painter_problem(const HiddenAnswer& answer) {
    if (!answer.painter_fails) return std::nullopt;
    const WrongPair& wrong = *answer.painter_fails;
    const SceneSurface* surface = answer.camera->surface.get();
    const glm::ivec2 size_px = answer.question.camera.size_px;
    // The difference view counts these pixels at the picture's own size. Then the sentence shows the same share.
    const std::optional<HiddenRequest>& other = answer.question.other;
    const bool is_counted = other && other->visibility.method == reference_method && answer.compared_pixels > 0;
    const double share =
        is_counted ? static_cast<double>(answer.different_pixels) / static_cast<double>(answer.compared_pixels)
                   : static_cast<double>(wrong.all_pixels) / static_cast<double>(wrong.compared);
    return Problem{
        message("{drawn} is drawn after {seen}, which is nearer around pixel ({x}, {y}): about {share} of the "
                "picture is wrong",
                "drawn"_a = polygon_name(surface, wrong.drawn), "seen"_a = polygon_name(surface, wrong.seen),
                "x"_a = static_cast<int>(wrong.x * size_px.x), "y"_a = static_cast<int>(wrong.y * size_px.y),
                "share"_a = percent(share)),
        "visibility", ProblemKind::wrong, "visibility.method=newell"};
}

std::string progress_text(float fraction) {
    return std::to_string(static_cast<int>(100.0F * fraction)) + "%";
}

void tell_waiting(const HiddenStatus& hidden) {
    if (hidden.fraction)
        offer(say("Running the method: {percent}.", "percent"_a = progress_text(*hidden.fraction)).c_str());
    else
        offer("Running the method.");
}

}  // namespace viewing
