#include "topics/depth/shown/depth_views.h"

#include <algorithm>
#include <cmath>

#include "frame/depth_colors.h"
#include "frame/plan/plan.h"
#include "text/catalogue.h"
#include "ui/parts/look.h"
#include "ui/parts/view_parts.h"
#include "widgets/depth.h"

namespace viewing {
namespace {

/// Draws a legend for the colors of the nearest depth, the farthest depth, and unwritten pixels.
void depth_legend(const Params& params, const glm::dvec2& range, const Rect& rect) {
    const std::string near = "z = " + number_text(range.x, 2), far = number_text(range.y, 2);
    const LegendEntry entries[] = {{near_color(params.view.depth_colors), near.c_str()},
                                   {far_color(params.view.depth_colors), far.c_str()},
                                   {ground_of(params.ui.theme).unwritten, tr("never written")}};
    draw_legend(ImGui::GetWindowDrawList(), rect, entries);
}

void tell_missing_depth(const Params& params, const Rect& rect) {
    const bool by_buffer = uses_gl_depth_test(params.visibility.method);
    if (by_buffer && params.depth.buffer) return;
    const char* const why = by_buffer ? tr("No depth to show: the window has no depth buffer.")
                                      : tr("This method turns GL's depth test off and writes no depth.");
    const std::string sentence = widgets::BrokenAtBlanks(why, rect.width() - px(20.0F));
    widgets::PlateText(ImGui::GetWindowDrawList(), {rect.min.x + px(10.0F), rect.min.y + px(8.0F)}, palette().text,
                       sentence.c_str());
}

}  // namespace

void depth_picture_legend(const Session& session, const Derived& derived, const Rect& rect) {
    depth_legend(session.params, contrast_range(session.params, derived, session.scene()), rect);
    tell_missing_depth(session.params, rect);
}

std::string depth_title(DepthFormat format, DepthMapping mapping) {
    const DepthPrecision precision = precision_of(format);
    switch (mapping) {
        case DepthMapping::standard:
            return precision.is_float ? say("{bits}-bit float", "bits"_a = precision.bits)
                                      : say("{bits}-bit", "bits"_a = precision.bits);
        case DepthMapping::reversed:
            return precision.is_float ? say("{bits}-bit float, reversed", "bits"_a = precision.bits)
                                      : say("{bits}-bit, reversed", "bits"_a = precision.bits);
        case DepthMapping::logarithmic:
            return precision.is_float ? say("{bits}-bit float, logarithmic", "bits"_a = precision.bits)
                                      : say("{bits}-bit, logarithmic", "bits"_a = precision.bits);
    }
    return "";
}

void depth_choices(Params& params, float right) {
    if (!widgets::Offers("control:view.depth_scale")) return;
    static constexpr const char* scales[] = {marked("window"), marked("linear")};
    static constexpr const char* scale_explanations[] = {
        marked("Window depth, 0 to 1, as stored."),
        marked("Eye distance from near to far on a linear scale, spaced as in the scene.")};
    static constexpr const char* colors[] = {marked("gray"), marked("bands")};
    static constexpr const char* color_explanations[] = {
        marked("Depth in gray: black is near, white is far."),
        marked("Depth as bands of color: dark is near, light is far.")};
    int scale = static_cast<int>(params.view.depth_scale), color = static_cast<int>(params.view.depth_colors);
    if (!have_room(scales, right)) return;  // the panel has both choices
    if (words("##scale", scale, scales, scale_explanations, 1, right))
        params.view.depth_scale = static_cast<DepthScale>(scale);
    ImGui::SameLine(0.0F, px(10.0F));
    if (!have_room(colors, right)) return ImGui::NewLine();
    if (words("##colors", color, colors, color_explanations, 0, right))
        params.view.depth_colors = static_cast<DepthColors>(color);
}

void draw_depth_picture(Session& session, const Derived& derived, const Rect& rect, ImTextureID picture) {
    depth_choices(session.params, rect.max.x);
    picture_item("lower view", rect, picture);
    depth_picture_legend(session, derived, rect);
}

void draw_histogram_view(Session& session, const Derived& derived, const DepthCounts& counts, const Rect& rect) {
    Params& params = session.params;
    const bool is_linear = params.view.depth_scale == DepthScale::linear;
    depth_choices(params, rect.max.x);
    const Lens lens = params.lens();
    const DepthMapping mapping = params.depth.mapping;
    const auto shown = [&](double distance) { return is_linear ? distance : window_depth(lens, mapping, distance); };
    const auto meant = [&](double value) { return is_linear ? value : distance_of_window_depth(lens, mapping, value); };
    const glm::dvec2 whole(lens.near, lens.shown_far());
    const glm::dvec2 distances = contrast_range(params, derived, session.scene());
    // Reversed depth decreases with distance, but the histogram's axis always runs from low to high window depth.
    const bool turns = !is_linear && mapping == DepthMapping::reversed;
    glm::dvec2 range(shown(distances.x), shown(distances.y));
    if (turns) std::swap(range.x, range.y);
    ImGui::SetCursorScreenPos(rect.min);
    const widgets::HistogramStyle style{.title = is_linear ? marked("eye distance z") : marked("window depth"),
                                        .logarithmic = true,
                                        .unwritten = counts.unwritten,
                                        .unwritten_name = tr("never written"),
                                        .size = {rect.width(), rect.height()}};
    if (!widgets::Histogram("histogram", counts.counts, counts.min, counts.max, range, style)) return;
    glm::dvec2 edited(meant(range.x), meant(range.y));
    if (turns) std::swap(edited.x, edited.y);
    edited = glm::clamp(edited, whole.x, whole.y);
    if (edited.x < edited.y) params.view.depth_range = edited;
}

}  // namespace viewing
