// The codes of a depth buffer between near and far. See precision_view.h.
#include <algorithm>

#include "text/catalogue.h"
#include "topics/depth/numbers/depth_precision.h"
#include "topics/depth/shown/precision_view.h"
#include "ui/parts/look.h"
#include "ui/parts/view_window.h"
#include "widgets/depth.h"

namespace viewing {
namespace {

std::string tick_words(const DepthCodes& codes, const DepthPrecision& precision) {
    if (codes.codes_per_tick == 1) return tr("Every code has a tick.");
    const std::string count = grouped_number(codes.codes_per_tick);
    return precision.is_float ? say("One tick every {count} floats.", "count"_a = count)
                              : say("One tick every {count} codes.", "count"_a = count);
}

}  // namespace

void draw_codes_view(Session& session, const Derived& derived, const Rect& rect) {
    const ViewWindow view("codes view", rect);
    const DepthCoding coding = depth_coding(session.params, derived);
    const ImVec2 room = ImGui::GetContentRegionAvail();
    // Request no more ticks than the widget draws: one every 6 design pixels.
    const int most_ticks = static_cast<int>(std::clamp((room.x - px(28.0F)) / px(6.0F), 2.0F, 128.0F));
    const DepthCodes codes = depth_codes(coding.lens, coding.mapping, coding.precision, most_ticks);
    const std::string told =
        tick_words(codes, coding.precision) + " " + say(codes_sentence(coding.lens, coding.mapping, coding.precision));
    const float below = note_height(told.c_str()) + ImGui::GetStyle().ItemSpacing.y;

    const bool is_reversed = coding.mapping == DepthMapping::reversed;
    // An audience cannot scroll: when presenting, omit the sentence if it would be cut off.
    const bool has_note = room.y - below >= px(120.0F) || !widgets::HasPlainTitles();
    const float height = has_note ? std::max(room.y - below, px(120.0F)) : room.y;
    widgets::CodeTicks("codes", codes.eye_distances, coding.lens.near, coding.lens.shown_far(),
                       {.depth_title = coding.precision.is_float ? marked("floats: the same number per tick")
                                                                 : marked("codes: equal steps"),
                        .first_depth = is_reversed ? marked("depth 1") : marked("depth 0"),
                        .last_depth = is_reversed ? marked("depth 0") : marked("depth 1"),
                        .ends_at_far = !coding.lens.is_infinite(),
                        .codes = codes.codes,
                        .size = {room.x, height}});
    if (has_note) recorded_note(told);
}

}  // namespace viewing
