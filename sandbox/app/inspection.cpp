#include "app/inspection.h"

#include "ui/views/lower_view.h"

namespace viewing {

Status Inspection::read(const ShownFrame& shown, const Session& session, const ViewState& views, bool at_once) {
    const Params& params = shown.params;
    DepthWishes wishes;
    const auto shows = [&](bool LowerView::*value) { return is_any_shown(params, value); };
    const bool tells_cells = shows(&LowerView::reads_cells), tells_why = shows(&LowerView::explains_pixel);
    if (shows(&LowerView::reads_pixel)) {
        wishes.pixel = shown.pinned.pixel;
        const bool is_pinned = params.view.pixel || params.view.pin;  // even if the pinned point is not visible
        if (const auto pointed = views.told_pixel; pointed && !is_pinned)
            wishes.pixel = glm::min(*pointed, shown.camera_px - 1);  // the view may have become smaller
        // If the block view was requested without a pixel, start at the center.
        if (!wishes.pixel && !is_pinned && tells_cells && params.view.cells) wishes.pixel = shown.camera_px / 2;
        if (wishes.pixel && !glm::all(glm::lessThan(*wishes.pixel, shown.camera_px))) wishes.pixel.reset();
    }
    wishes.fragments = shows(&LowerView::reads_fragments);
    wishes.calls = tells_cells;
    if (tells_cells && wishes.pixel) wishes.cells = views.cells;
    wishes.counts = shows(&LowerView::reads_histogram);
    Status done = inspector_.update(renderer_, shown.inspected, session.scene(), session.scene_version(), shown.derived,
                                    shown.camera_px, wishes, at_once);
    reads_ = inspector_.is_following();
    if (!tells_why || !inspector_.data().pixel)
        why_.reset();
    else if (!why_ || why_->chain.pixel != inspector_.data().pixel->pixel)
        explain(shown, session);
    return done;
}

void Inspection::explain(const ShownFrame& shown, const Session& session) {
    const PixelReport& pixel = *inspector_.data().pixel;
    const Shows shows = shown.params.view.shows;
    const bool is_read = shows == Shows::color || shows == Shows::facing || shows == Shows::shadow_w;
    const Viewport viewport = renderer_.viewport(shown.camera_px, shown.params.depth.format);
    why_ = std::make_shared<const Why>(viewing::why({shown.params,
                                                     shown.derived,
                                                     shown.plan,
                                                     inspector_.finder(session.scene(), session.scene_version()),
                                                     viewport,
                                                     shown.problems,
                                                     pixel.pixel,
                                                     is_read ? std::optional(pixel.color) : std::nullopt,
                                                     {}}));
}

DepthData Inspection::data(const ShownFrame& shown, const Session& session, bool at_once, bool is_held) {
    DepthData data = inspector_.data();
    tells_fighting_ = is_any_shown(shown.params, &LowerView::counts_fighting);
    if (tells_fighting_) {
        Params counted = session.params;  // without animations, which would start the count again in each frame
        counted.projection = shown.params.projection;
        data.fighting = fighting_.update(renderer_, counted, session.scene(), session.scene_version(), shown.camera_px,
                                         at_once, !is_held);
    }
    return data;
}

std::optional<PixelReport> Inspection::at(const ShownFrame& shown, const Session& session, glm::ivec2 size_px,
                                          glm::ivec2 pixel, bool at_once) {
    follows_ = false;
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= size_px.x || pixel.y >= size_px.y) return std::nullopt;
    if (at_once) {
        const auto report = inspector_.at(renderer_, shown.inspected, session.scene(), shown.derived, size_px, pixel);
        return report ? std::optional(*report) : std::nullopt;
    }
    const auto told = inspector_.follow(renderer_, shown.inspected, session.scene(), shown.derived, size_px, pixel);
    follows_ = inspector_.is_following();
    return told ? *told : std::nullopt;
}

}  // namespace viewing
