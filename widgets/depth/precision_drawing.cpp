// Drawing of a PrecisionChart. See precision_inner.h.
#include <algorithm>
#include <cmath>

#include "text/numbers.h"
#include "widgets/depth/precision_inner.h"

namespace widgets::inner {

std::optional<double> ValueAt(const ChartCurve& curve, double x) {
    for (std::size_t i = 1; i < curve.points.size(); ++i) {
        const glm::dvec2 &a = curve.points[i - 1], &b = curve.points[i];
        if (!CanBeDrawn(a) || !CanBeDrawn(b) || !(a.x <= x && x <= b.x)) continue;
        if (a.x == b.x) return b.y;
        const double share = std::log(x / a.x) / std::log(b.x / a.x);
        return a.y * std::pow(b.y / a.y, share);
    }
    return std::nullopt;
}

const ChartCurve* EmphasizedOf(std::span<const ChartCurve> curves) {
    const auto found =
        std::find_if(curves.begin(), curves.end(), [](const ChartCurve& curve) { return curve.emphasized; });
    return found == curves.end() ? nullptr : &*found;
}

ImU32 FaintColor(ImU32 color) {
    const Palette& palette = CurrentContext().palette;
    return Mix(palette.view_ground, color, palette.stroke > 1.0F ? 0.65F : 0.5F);
}

namespace {

/// Draws dots along a segment of a curve. `walked`, the pixels since the last dot, keeps the dots evenly spaced even
/// around corners.
void DrawDots(ImDrawList* draw, ImVec2 a, ImVec2 b, ImU32 color, float radius, float& walked) {
    const float length = Distance(a, b), step = 3.5F * radius;
    float at = step - walked;
    for (; at <= length; at += step) draw->AddCircleFilled(Between(a, b, at / length), radius, color, 8);
    walked = length - (at - step);
}

}  // namespace

void DrawPlainCurve(ImDrawList* draw, const ChartPlot& plot, const ChartCurve& curve, bool dotted) {
    const float stroke = CurrentContext().palette.stroke;
    const ImU32 color = Shown(dotted || curve.emphasized ? curve.color : FaintColor(curve.color));
    const float width = Px(curve.emphasized ? 2.75F : 1.5F) * stroke;
    std::optional<ImVec2> last;
    float walked = 0.0F;
    for (const glm::dvec2& point : curve.points) {
        if (!CanBeDrawn(point)) {
            last.reset();
            continue;
        }
        const ImVec2 at = PlaceOf(plot, point);
        if (last && Distance(*last, at) < Px(1)) continue;
        ImVec2 from = last.value_or(at), to = at;
        last = at;
        if (!ClipToPlot(plot, from, to)) continue;
        if (dotted) {
            DrawDots(draw, from, to, color, Px(1.5F) * stroke, walked);
        } else {
            draw->AddLine(from, to, color, width);
        }
    }
}

namespace {

bool CrossesLine(const Box& box, std::span<const LineName> lines) {
    return std::any_of(lines.begin(), lines.end(),
                       [&box](const LineName& line) { return line.x > box.min.x && line.x < box.max.x; });
}

/// Returns a place to the right or left of the line, in the highest free row.
std::optional<Box> RoomFor(const ChartPlot& plot, float x, ImVec2 size, std::span<const Box> taken,
                           std::span<const LineName> not_over) {
    // A name is also outside the frame around its line.
    const float row = size.y + Px(4), away = Px(11), lowest = plot.min.y + 0.6F * (plot.max.y - plot.min.y);
    for (float top = plot.min.y + Px(4); top + size.y <= lowest; top += row) {
        for (const float left : {x + away, x - away - size.x}) {
            const Box box{ImVec2(std::floor(left), std::floor(top)),
                          ImVec2(std::floor(left) + size.x, std::floor(top) + size.y)};
            const bool inside = box.min.x >= plot.min.x && box.max.x <= plot.max.x;
            if (inside && IsFree(box, taken) && !CrossesLine(box, not_over)) return box;
        }
    }
    return std::nullopt;
}

}  // namespace

std::vector<Box> DrawLineNames(ImDrawList* draw, const ChartPlot& plot, std::span<const LineName> names) {
    const Face face = FaceOf(CurrentContext().fonts.note);
    const ImU32 plate = Shown(WithAlpha(CurrentContext().palette.view_ground, 0.85F));
    std::vector<Box> taken;
    for (const LineName& name : names) {
        const ImVec2 size = face.Measure(name.text);
        std::optional<Box> box = RoomFor(plot, name.x, size, taken, names);
        if (!box) box = RoomFor(plot, name.x, size, taken, {});
        if (!box) continue;
        const Box around{ImVec2(box->min.x - Px(3), box->min.y - Px(1)),
                         ImVec2(box->max.x + Px(3), box->max.y + Px(1))};
        draw->AddRectFilled(around.min, around.max, plate, Px(3));
        face.Draw(draw, box->min, Shown(name.color), name.text);
        RecordRect((std::string("name/") + name.recorded_as).c_str(), box->min, box->max, name.text);
        taken.push_back(around);
    }
    return taken;
}

void DrawPrecisionReadout(ImDrawList* draw, const Box& area, const ChartPlot& plot, ImVec2 pointer,
                          std::span<const ChartCurve> curves, const PrecisionChartStyle& style) {
    const bool inside =
        pointer.x >= plot.min.x && pointer.x <= plot.max.x && pointer.y >= plot.min.y && pointer.y <= plot.max.y;
    const ChartCurve* curve = EmphasizedOf(curves);
    if (!inside || !curve) return;
    const double z = ValueAtPixel(plot.x, pointer.x);
    const std::optional<double> step = ValueAt(*curve, z);
    if (!step) return;

    const Palette& palette = CurrentContext().palette;
    draw->AddLine(ImVec2(pointer.x, plot.min.y), ImVec2(pointer.x, plot.max.y), Shown(WithAlpha(palette.quiet, 0.6F)),
                  Px(1));
    const ImVec2 at = PlaceOf(plot, {z, *step});
    if (IsInPlot(plot, {z, *step})) {
        // A crosshair, to read the distance off the axis below and the value off the axis at the left.
        draw->AddLine(ImVec2(plot.min.x, at.y), ImVec2(plot.max.x, at.y), Shown(WithAlpha(palette.quiet, 0.6F)), Px(1));
        RecordRect("crosshair", ImVec2(plot.min.x, plot.min.y), at, viewing::steady_figures(*step));
        draw->AddCircleFilled(at, Px(4), Shown(curve->color));
        draw->AddCircle(at, Px(6.5F), Shown(palette.text), 0, Px(1.5F) * palette.stroke);
    }
    std::vector<std::string> lines{
        say("z: {z}", "z"_a = viewing::steady_figures(z)),
        say("{name}: {value}", "name"_a = tr(style.y.title), "value"_a = viewing::steady_figures(*step))};
    for (const ChartCurve& term : style.terms) {
        if (const std::optional<double> value = ValueAt(term, z)) {
            lines.push_back(
                say("{name}: {value}", "name"_a = tr(term.name), "value"_a = viewing::steady_figures(*value)));
        }
    }
    DrawReadoutBox(draw, area, at, curve->name, lines);
}

}  // namespace widgets::inner
