// A chart's axes, with a line and a number at each decade and small ticks in between. If the decades are dense, only
// some of them have a number; if there are few, the ticks at 2 and 5 have one, too.
#include <algorithm>
#include <cmath>
#include <string>

#include "widgets/chart/chart_inner.h"
#include "widgets/inner.h"

namespace widgets::inner {

float LogScale::At(double value) const {
    constexpr double far = 1e5;  ///< in pixels; nothing farther away is visible, and lines lose precision there
    const double fraction = (std::log10(value) - low) / (high - low);
    return static_cast<float>(std::clamp(from + fraction * (to - from), -far, far));
}

bool LogScale::Holds(double value) const {
    constexpr double rounding = 1e-9;
    const double at = std::log10(value);
    return at >= low - rounding && at <= high + rounding;
}

bool CanBeDrawn(const glm::dvec2& point) {
    return point.x > 0.0 && point.y > 0.0 && std::isfinite(point.x) && std::isfinite(point.y);
}

namespace {

LogScale ScaleOf(const ChartAxis& axis, std::span<const ChartCurve> curves, int component) {
    constexpr double least_ratio = 1.001;
    if (axis.min > 0.0 && std::isfinite(axis.max) && axis.max >= axis.min * least_ratio) {
        return {std::log10(axis.min), std::log10(axis.max), 0.0F, 1.0F};
    }
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const ChartCurve& curve : curves) {
        for (const glm::dvec2& point : curve.points) {
            if (!CanBeDrawn(point)) continue;
            low = std::min(low, std::log10(point[component]));
            high = std::max(high, std::log10(point[component]));
        }
    }
    if (low > high) return {0.0, 1.0, 0.0F, 1.0F};
    constexpr double rounding = 1e-9;
    low = std::floor(low + rounding);
    high = std::ceil(high - rounding);
    return {low, std::max(high, low + 1.0), 0.0F, 1.0F};
}

struct Tick {
    double value;
    bool is_decade;
    std::string label;  ///< may be empty
};

std::string TickLabel(int digit, int decade) {
    if (decade >= -2 && decade <= 3)
        return viewing::plain_decimals(digit * std::pow(10.0, decade), std::max(-decade, 0));
    const std::string power = "10" + viewing::raised_text(decade);
    return digit == 1 ? power : std::to_string(digit) + "·" + power;
}

/// `label_room`: space for one label along the axis, in pixels.
std::vector<Tick> TicksOf(const LogScale& scale, float label_room) {
    const double decade_px = std::abs(scale.to - scale.from) / (scale.high - scale.low);
    const int stride = std::max(1, static_cast<int>(std::ceil(label_room / decade_px)));
    // The labels at 1, 2, 5 and 10 are at least 0.3 decades apart.
    const bool labels_between = 0.3 * decade_px >= 1.6 * label_room && scale.high - scale.low < 2.5;
    const bool has_minor = decade_px >= Px(28);
    constexpr double rounding = 1e-9;
    std::vector<Tick> ticks;
    const int first = static_cast<int>(std::floor(scale.low - rounding));
    const int last = static_cast<int>(std::floor(scale.high + rounding));
    for (int decade = first; decade <= last; ++decade) {
        if (!has_minor && decade % stride != 0) continue;
        for (int digit = 1; digit <= (has_minor ? 9 : 1); ++digit) {
            const double value = digit * std::pow(10.0, decade);
            if (!scale.Holds(value)) continue;
            const bool has_label = digit == 1 ? decade % stride == 0 : labels_between && (digit == 2 || digit == 5);
            ticks.push_back({value, digit == 1, has_label ? TickLabel(digit, decade) : ""});
        }
    }
    return ticks;
}

struct Inks {
    ImU32 decade, frame, text;
    float line;
};

void DrawTicksX(ImDrawList* draw, const ChartPlot& plot, std::span<const Tick> ticks, const Inks& inks,
                const Face& face) {
    for (const Tick& tick : ticks) {
        const float x = std::floor(plot.x.At(tick.value)) + 0.5F;
        if (tick.is_decade) draw->AddLine(ImVec2(x, plot.min.y), ImVec2(x, plot.max.y), inks.decade, inks.line);
        draw->AddLine(ImVec2(x, plot.max.y), ImVec2(x, plot.max.y + Px(tick.is_decade ? 5 : 3)), inks.frame, inks.line);
        if (tick.label.empty()) continue;
        const ImVec2 size = face.Measure(tick.label);
        const ImVec2 at(std::floor(x - 0.5F * size.x), std::floor(plot.max.y + Px(6)));
        face.Draw(draw, at, inks.text, tick.label);
        RecordRect(("x/" + tick.label).c_str(), ImVec2(x - 0.5F * size.x, at.y),
                   ImVec2(x + 0.5F * size.x, at.y + size.y), tick.label);
    }
}

void DrawTicksY(ImDrawList* draw, const ChartPlot& plot, std::span<const Tick> ticks, const Inks& inks,
                const Face& face) {
    for (const Tick& tick : ticks) {
        const float y = std::floor(plot.y.At(tick.value)) + 0.5F;
        if (tick.is_decade) draw->AddLine(ImVec2(plot.min.x, y), ImVec2(plot.max.x, y), inks.decade, inks.line);
        draw->AddLine(ImVec2(plot.min.x - Px(tick.is_decade ? 5 : 3), y), ImVec2(plot.min.x, y), inks.frame, inks.line);
        if (tick.label.empty()) continue;
        const ImVec2 size = face.Measure(tick.label);
        const ImVec2 at(std::floor(plot.min.x - Px(8) - size.x), std::floor(y - 0.5F * size.y));
        face.Draw(draw, at, inks.text, tick.label);
        RecordRect(("y/" + tick.label).c_str(), ImVec2(at.x, y - 0.5F * size.y),
                   ImVec2(at.x + size.x, y + 0.5F * size.y), tick.label);
    }
}

}  // namespace

ChartPlot DrawAxes(ImDrawList* draw, ImVec2 min, ImVec2 max, std::span<const ChartCurve> curves,
                   const LogChartStyle& style, float label_room) {
    const Context& context = CurrentContext();
    const Palette& palette = context.palette;
    const Face face = FaceOf(context.fonts.note);
    const Inks inks{.decade = Shown(Mix(palette.view_ground, palette.quiet, 0.22F)),
                    .frame = Shown(Mix(palette.border, palette.quiet, 0.5F)),
                    .text = Shown(palette.quiet),
                    .line = Px(1) * palette.stroke};
    ChartPlot plot{.min = {}, .max = {}, .x = ScaleOf(style.x, curves, 0), .y = ScaleOf(style.y, curves, 1)};

    plot.min.y = min.y + face.size + Px(12);
    plot.max.y = max.y - 2.0F * face.size - Px(15);
    plot.y.from = plot.max.y;
    plot.y.to = plot.min.y;
    const std::vector<Tick> ticks_y = TicksOf(plot.y, face.size * 1.3F);
    float widest = 0.0F;
    for (const Tick& tick : ticks_y) widest = std::max(widest, face.Measure(tick.label).x);
    plot.min.x = min.x + std::ceil(widest) + Px(14);
    plot.max.x = std::max(max.x - label_room, plot.min.x + Px(40));
    plot.x.from = plot.min.x;
    plot.x.to = plot.max.x;
    float label_width = face.Measure("1000").x;
    for (const double end : {plot.x.low, plot.x.high}) {
        label_width = std::max(label_width, face.Measure(TickLabel(1, static_cast<int>(std::floor(end)))).x);
    }
    const std::vector<Tick> ticks_x = TicksOf(plot.x, label_width + Px(6));

    DrawTicksX(draw, plot, ticks_x, inks, face);
    DrawTicksY(draw, plot, ticks_y, inks, face);
    draw->AddRect(plot.min, plot.max, inks.frame, 0.0F, 0, inks.line);
    face.Draw(draw, ImVec2(min.x + Px(6), min.y + Px(5)), inks.text, style.y.title);
    const float title_x = plot.max.x - face.Measure(style.x.title).x;
    face.Draw(draw, ImVec2(std::floor(std::max(title_x, plot.min.x)), std::floor(max.y - face.size - Px(5))), inks.text,
              style.x.title);
    return plot;
}

}  // namespace widgets::inner
