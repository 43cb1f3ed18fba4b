// A histogram with a draggable range.
#include <algorithm>
#include <cmath>
#include <string>

#include "text/catalogue.h"
#include "text/numbers.h"
#include "widgets/area.h"
#include "widgets/depth.h"
#include "widgets/depth/depth_inner.h"

namespace widgets {

namespace {

using inner::Px;
using inner::Shown;

/// The rectangle of the bars and its scales.
struct Plot {
    ImVec2 min, max;
    double low, high;  ///< values at the left and right ends
    double tallest;    ///< height of a bar that reaches the top

    float X(double value) const {
        return static_cast<float>(min.x + std::clamp((value - low) / (high - low), 0.0, 1.0) * (max.x - min.x));
    }
    double Value(double x) const { return low + std::clamp((x - min.x) / (max.x - min.x), 0.0, 1.0) * (high - low); }
};

double HeightOf(std::uint64_t count, const HistogramStyle& style) {
    return style.logarithmic ? std::log1p(static_cast<double>(count)) : static_cast<double>(count);
}

std::uint32_t HighestOf(std::span<const std::uint32_t> counts) {
    return counts.empty() ? 0U : *std::max_element(counts.begin(), counts.end());
}

/// Returns the range from the first bar with counts to the end of the last one; the full range if there are no counts.
glm::dvec2 Fitted(std::span<const std::uint32_t> counts, double min, double max) {
    const auto has_counts = [](std::uint32_t count) { return count > 0; };
    const auto first = std::find_if(counts.begin(), counts.end(), has_counts);
    if (first == counts.end()) return {min, max};
    const auto last = std::find_if(counts.rbegin(), counts.rend(), has_counts);
    const double bar = (max - min) / static_cast<double>(counts.size());
    const auto begin = static_cast<double>(first - counts.begin()),
               behind = static_cast<double>(last - counts.rbegin());
    return {min + begin * bar, max - behind * bar};
}

/// Returns the range, clamped to min…max; the full range if `range` is invalid.
glm::dvec2 SensibleRange(const glm::dvec2& range, double min, double max) {
    const bool is_range = range.x < range.y && range.x < max && range.y > min;
    return is_range ? glm::clamp(range, glm::dvec2(min), glm::dvec2(max)) : glm::dvec2(min, max);
}

void DrawBars(ImDrawList* draw, const Plot& plot, std::span<const std::uint32_t> counts, const glm::dvec2& range,
              const HistogramStyle& style) {
    const Palette& palette = CurrentContext().palette;
    const float width = plot.max.x - plot.min.x;
    const std::size_t count = counts.size();
    // Merge bars that would be narrower than a design pixel; the highest count sets the height of a merged bar.
    const std::size_t drawn = std::clamp<std::size_t>(static_cast<std::size_t>(width / Px(1)), 1, count);
    const float step = width / static_cast<float>(drawn), gap = step >= Px(4) ? Px(1) : 0.0F;
    const ImU32 inside = Shown(palette.accent);
    const ImU32 outside = Shown(inner::Mix(palette.view_ground, palette.quiet, 0.6F));
    for (std::size_t i = 0; i < drawn; ++i) {
        const std::size_t begin = i * count / drawn, end = (i + 1) * count / drawn;
        const std::uint32_t highest = HighestOf(counts.subspan(begin, end - begin));
        if (highest == 0) continue;
        const auto share = static_cast<float>(HeightOf(highest, style) / plot.tallest);
        const float height = std::max(share * (plot.max.y - plot.min.y), Px(1));
        const float left = plot.min.x + static_cast<float>(i) * step;
        const double middle = plot.Value(left + 0.5F * step);
        draw->AddRectFilled(ImVec2(left, plot.max.y - height), ImVec2(left + step - gap, plot.max.y),
                            middle >= range.x && middle <= range.y ? inside : outside);
    }
    draw->AddLine(ImVec2(plot.min.x, plot.max.y), ImVec2(plot.max.x, plot.max.y), Shown(palette.quiet),
                  Px(1) * palette.stroke);
}

/// Draws the extra bar of unwritten values. If it is higher than all others, it is cut off, and two slanted lines mark
/// the cut.
void DrawUnwritten(ImDrawList* draw, const Plot& plot, float left, float right, const HistogramStyle& style) {
    const Palette& palette = CurrentContext().palette;
    const double height = HeightOf(style.unwritten, style);
    const bool is_cut = height > plot.tallest;
    const auto share = static_cast<float>(plot.tallest > 0.0 ? std::min(height / plot.tallest, 1.0) : 1.0);
    const float top = plot.max.y - std::max(share * (plot.max.y - plot.min.y), Px(1));
    const ImVec2 min(left, top), max(right, plot.max.y);
    draw->AddRectFilled(min, max, Shown(inner::Mix(palette.view_ground, palette.quiet, 0.6F)));
    draw->AddRect(min, max, Shown(palette.quiet), 0.0F, 0, Px(1) * palette.stroke);
    if (is_cut) {
        const float y = top + 0.22F * (max.y - top);
        for (const float dy : {0.0F, Px(5)}) {
            draw->AddLine(ImVec2(left - Px(2), y + dy + Px(4)), ImVec2(right + Px(2), y + dy),
                          Shown(palette.view_ground), Px(2.5F));
        }
    }
    inner::RecordRect("unwritten", min, max, std::to_string(style.unwritten));
}

/// Labels the ends of the range below its lines; if the lines are close, the labels are side by side. Also labels the
/// ends of the full range if there is space.
void DrawEnds(ImDrawList* draw, const Plot& plot, const glm::dvec2& range) {
    const Palette& palette = CurrentContext().palette;
    const inner::Face face = inner::FaceOf(CurrentContext().fonts.note);
    const float y = plot.max.y + Px(5), gap = Px(10);
    const std::string low = viewing::steady_figures(range.x), high = viewing::steady_figures(range.y);
    const float low_width = face.Measure(low).x, high_width = face.Measure(high).x;
    float low_x = std::max(plot.X(range.x) - 0.5F * low_width, plot.min.x);
    float high_x = std::min(plot.X(range.y) - 0.5F * high_width, plot.max.x - high_width);
    const float lacking = low_x + low_width + gap - high_x;
    if (lacking > 0.0F) {
        low_x = std::max(low_x - 0.5F * lacking, plot.min.x);
        high_x = low_x + low_width + gap;
        const float over = high_x + high_width - plot.max.x;
        if (over > 0.0F) {
            low_x -= over;
            high_x -= over;
        }
    }
    const auto draw_text = [&](float x, ImU32 color, const std::string& text) {
        face.Draw(draw, ImVec2(std::floor(x), y), Shown(color), text);
    };
    draw_text(low_x, palette.text, low);
    draw_text(high_x, palette.text, high);
    const std::string first = viewing::steady_figures(plot.low), last = viewing::steady_figures(plot.high);
    const float first_end = plot.min.x + face.Measure(first).x, last_x = plot.max.x - face.Measure(last).x;
    if (first_end + gap <= low_x) draw_text(plot.min.x, palette.quiet, first);
    if (last_x - gap >= high_x + high_width) draw_text(last_x, palette.quiet, last);
}

/// Returns the range after this frame's dragging.
glm::dvec2 UseRange(const Plot& plot, const glm::dvec2& range, inner::DragLinesUse& use) {
    constexpr const char* tip = viewing::marked(
        "Drag to change the range; hold Alt for finer steps. Right-click to select everything; double-click away from "
        "the lines to fit the range to the data.");
    const double apart = 1e-3 * (plot.high - plot.low);
    use = inner::UseLines(
        {.id = "from", .x = plot.X(range.x), .text = viewing::steady_figures(range.x), .tip_title = "From", .tip = tip},
        {.id = "to", .x = plot.X(range.y), .text = viewing::steady_figures(range.y), .tip_title = "To", .tip = tip},
        plot.min.y, plot.max.y);
    glm::dvec2 edited = range;
    if (use.low.x) edited.x = std::max(std::min(plot.Value(*use.low.x), range.y - apart), plot.low);
    if (use.high.x) edited.y = std::min(std::max(plot.Value(*use.high.x), range.x + apart), plot.high);
    return edited.x < edited.y ? edited : range;
}

std::string Counted(std::uint64_t count, const HistogramStyle& style) {
    return say("{count} {things}", "count"_a = viewing::grouped_number(static_cast<std::int64_t>(count)),
               "things"_a = tr(style.counted));
}

void DrawReadout(ImDrawList* draw, const inner::Box& area, const Plot& plot, ImVec2 pointer,
                 std::span<const std::uint32_t> counts, const HistogramStyle& style) {
    if (pointer.y < plot.min.y || pointer.y > plot.max.y || pointer.x < plot.min.x) return;
    if (pointer.x > plot.max.x) {
        if (style.unwritten > 0) {
            inner::DrawReadoutBox(draw, area, pointer, Counted(style.unwritten, style), {{style.unwritten_name}});
        }
        return;
    }
    const double bar = (plot.high - plot.low) / static_cast<double>(counts.size());
    const auto index = std::min(static_cast<std::size_t>((plot.Value(pointer.x) - plot.low) / bar), counts.size() - 1);
    const double begin = plot.low + static_cast<double>(index) * bar;
    const std::string lines[] = {say("{first} to {last}", "first"_a = viewing::steady_figures(begin),
                                     "last"_a = viewing::steady_figures(begin + bar))};
    inner::DrawReadoutBox(draw, area, pointer, Counted(counts[index], style), lines);
}

struct ButtonUse {
    bool clicked = false, hovered = false;
};

/// Draws the title at the left and the button at the right.
ButtonUse TitleAndFit(ImDrawList* draw, ImVec2 min, ImVec2 max, bool has_counts, const HistogramStyle& style) {
    const inner::Face face = inner::FaceOf(CurrentContext().fonts.note);
    const float button = ImGui::CalcTextSize(tr("Fit")).x + Px(16), height = ImGui::GetFontSize() + Px(4);
    const ImVec2 at(min.x + Px(6), std::floor(min.y + Px(4) + 0.5F * (height - face.size)));
    const float room = max.x - button - Px(10) - at.x;
    std::string title = tr(style.title);
    if (style.logarithmic) {
        const std::string whole = say("{title}, logarithmic heights", "title"_a = title);
        if (face.Measure(whole).x <= room) title = whole;
    }
    {
        const inner::FontScope font(CurrentContext().fonts.note);
        face.Draw(draw, at, Shown(CurrentContext().palette.quiet), Shortened(title, room));
    }
    ImGui::SetCursorScreenPos(ImVec2(max.x - button - Px(4), min.y + Px(4)));
    const bool clicked = SmallButton("Fit", has_counts, "Nothing has been counted.");
    const bool hovered = ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled);
    if (has_counts) Tooltip("Fit", "Fits the range to the values that occur. A double-click does the same.");
    return {clicked, hovered};
}

}  // namespace

bool Histogram(const char* id, std::span<const std::uint32_t> counts, double min_value, double max_value,
               glm::dvec2& range, const HistogramStyle& style) {
    const ImVec2 size = inner::AreaSize(style.size, ImVec2(200, 120));
    const Group group(id);
    const ImVec2 min = ImGui::GetCursorScreenPos(), max(min.x + size.x, min.y + size.y);
    const Palette& palette = CurrentContext().palette;
    const inner::Face face = inner::FaceOf(CurrentContext().fonts.note);
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->PushClipRect(min, max, true);
    draw->AddRectFilled(min, max, Shown(palette.view_ground), Px(4));

    const bool is_usable = !counts.empty() && std::isfinite(max_value - min_value) && min_value < max_value;
    const std::uint32_t highest = HighestOf(counts);
    const float unwritten = style.unwritten > 0 ? std::max(face.Measure(style.unwritten_name).x, Px(18)) : 0.0F;
    const float side = Px(12);
    const Plot plot{
        .min = ImVec2(min.x + side, min.y + ImGui::GetFontSize() + Px(16)),
        .max = ImVec2(max.x - side - (unwritten > 0.0F ? unwritten + Px(16) : 0.0F), max.y - face.size - Px(10)),
        .low = min_value,
        .high = max_value,
        .tallest = HeightOf(highest, style)};
    inner::DragLinesUse use;
    const glm::dvec2 before = is_usable ? SensibleRange(range, min_value, max_value) : glm::dvec2(0.0);
    glm::dvec2 edited = before;
    ButtonUse fit;
    bool takes_all = false;
    if (is_usable) {
        edited = UseRange(plot, before, use);
        fit = TitleAndFit(draw, min, max, highest > 0, style);
    }
    ImGui::SetCursorScreenPos(min);
    ImGui::InvisibleButton("histogram", size);
    Record("histogram");
    // ImGui reports an item as hovered even if an earlier one overlaps it.
    const bool on_part = use.low.hovered || use.high.hovered || fit.hovered;
    const bool hovered = ImGui::IsItemHovered() && !on_part;
    if (is_usable && hovered) {
        fit.clicked |= ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) && highest > 0;
        takes_all = ImGui::IsMouseClicked(ImGuiMouseButton_Right);
    }
    takes_all |= use.low.reset || use.high.reset;
    if (takes_all) edited = {min_value, max_value};
    if (fit.clicked) edited = Fitted(counts, min_value, max_value);

    if (is_usable) {
        DrawBars(draw, plot, counts, edited, style);
        if (style.unwritten > 0) {
            const float right = max.x - side, left = right - unwritten;
            DrawUnwritten(draw, plot, left, right, style);
            face.Draw(draw, ImVec2(left, plot.max.y + Px(5)), Shown(palette.quiet), style.unwritten_name);
        }
        inner::DrawDragLine(draw, plot.X(edited.x), plot.min.y, plot.max.y, Shown(palette.text), use.low);
        inner::DrawDragLine(draw, plot.X(edited.y), plot.min.y, plot.max.y, Shown(palette.text), use.high);
        DrawEnds(draw, plot, edited);
        if (hovered) DrawReadout(draw, {min, max}, plot, ImGui::GetIO().MousePos, counts, style);
    } else {
        inner::DrawHint(
            draw, min, max,
            counts.empty() ? marked("Nothing has been counted yet.") : marked("The range to count over is empty."));
    }
    draw->PopClipRect();
    const bool changed = (edited != before || takes_all || fit.clicked) && edited != range;
    if (changed) range = edited;
    return changed;
}

}  // namespace widgets
