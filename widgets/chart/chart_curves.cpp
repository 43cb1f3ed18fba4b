// A chart's curves as lines and markers that differ in shape as well as in color. chart_labels.cpp places their names.
#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/chart/chart_inner.h"
#include "widgets/inner.h"

namespace widgets::inner {

float Distance(ImVec2 a, ImVec2 b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

ImVec2 Between(ImVec2 a, ImVec2 b, float t) {
    return ImVec2(a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t);
}

ImVec2 PlaceOf(const ChartPlot& plot, const glm::dvec2& point) {
    return ImVec2(plot.x.At(point.x), plot.y.At(point.y));
}

bool IsInPlot(const ChartPlot& plot, const glm::dvec2& point) {
    return inner::CanBeDrawn(point) && plot.x.Holds(point.x) && plot.y.Holds(point.y);
}

bool ClipToPlot(const ChartPlot& plot, ImVec2& a, ImVec2& b) {
    float enter = 0.0F, leave = 1.0F;
    const float moves[] = {a.x - b.x, b.x - a.x, a.y - b.y, b.y - a.y};
    const float rooms[] = {a.x - plot.min.x, plot.max.x - a.x, a.y - plot.min.y, plot.max.y - a.y};
    for (int side = 0; side < 4; ++side) {
        if (moves[side] == 0.0F) {
            if (rooms[side] < 0.0F) return false;
            continue;
        }
        const float t = rooms[side] / moves[side];
        if (moves[side] < 0.0F) enter = std::max(enter, t);
        if (moves[side] > 0.0F) leave = std::min(leave, t);
    }
    if (enter > leave) return false;
    const ImVec2 from = a;
    a = Between(from, b, enter);
    b = Between(from, b, leave);
    return true;
}

namespace {

/// The lengths of dashes and gaps, alternating, in design pixels.
using Dash = std::array<float, 4>;
constexpr Dash dashes[] = {{0, 0, 0, 0}, {7, 4, 7, 4}, {2, 3, 2, 3}, {9, 3, 2, 3}};

class DashedLine {
public:
    DashedLine(ImDrawList* draw, const ChartPlot& plot, const Dash& dash, ImU32 color, float width)
        : draw_(draw), plot_(plot), dash_(dash), color_(color), width_(width) {}

    void LineTo(ImVec2 next) {
        if (has_last_ && Distance(last_, next) < Px(1)) return;
        ImVec2 a = last_, b = next;
        if (has_last_ && ClipToPlot(plot_, a, b)) Draw(a, b);
        last_ = next;
        has_last_ = true;
    }
    void Lift() { has_last_ = false; }

private:
    void Draw(ImVec2 a, ImVec2 b) {
        const float length = Distance(a, b);
        if (dash_[0] <= 0.0F) {
            draw_->AddLine(a, b, color_, width_);
            return;
        }
        for (float done = 0.0F; done < length;) {
            const float part = std::min(Px(dash_[phase_]) - used_, length - done);
            if (phase_ % 2 == 0) {
                draw_->AddLine(Between(a, b, done / length), Between(a, b, (done + part) / length), color_, width_);
            }
            done += std::max(part, 0.01F);
            used_ += part;
            if (used_ >= Px(dash_[phase_]) - 0.01F) {
                phase_ = (phase_ + 1) % dash_.size();
                used_ = 0.0F;
            }
        }
    }

    ImDrawList* draw_;
    const ChartPlot& plot_;
    const Dash& dash_;
    ImU32 color_;
    float width_;
    ImVec2 last_;
    bool has_last_ = false;
    std::size_t phase_ = 0;
    float used_ = 0.0F;  ///< used part of the current dash or gap
};

void DrawMarker(ImDrawList* draw, ImVec2 at, std::size_t shape, float r, ImU32 color) {
    const float line = Px(1.5F) * CurrentContext().palette.stroke;
    switch (shape % 6) {
        case 0:
            draw->AddCircleFilled(at, r, color);
            break;
        case 1:
            draw->AddRectFilled(ImVec2(at.x - 0.9F * r, at.y - 0.9F * r), ImVec2(at.x + 0.9F * r, at.y + 0.9F * r),
                                color);
            break;
        case 2:
            draw->AddNgonFilled(at, 1.25F * r, color, 4);
            break;
        case 3:
        case 4: {
            const float up = shape % 6 == 3 ? 1.0F : -1.0F;
            draw->AddTriangleFilled(ImVec2(at.x, at.y - 1.2F * up * r), ImVec2(at.x - 1.15F * r, at.y + 0.85F * up * r),
                                    ImVec2(at.x + 1.15F * r, at.y + 0.85F * up * r), color);
            break;
        }
        default:
            draw->AddLine(ImVec2(at.x - r, at.y - r), ImVec2(at.x + r, at.y + r), color, line);
            draw->AddLine(ImVec2(at.x - r, at.y + r), ImVec2(at.x + r, at.y - r), color, line);
            break;
    }
}

}  // namespace

void DrawCurve(ImDrawList* draw, const ChartPlot& plot, const ChartCurve& curve, std::size_t index, ImU32 color) {
    const float width = Px(curve.emphasized ? 2.75F : 1.6F) * CurrentContext().palette.stroke;
    DashedLine line(draw, plot, dashes[index % std::size(dashes)], color, width);
    for (const glm::dvec2& point : curve.points) {
        if (inner::CanBeDrawn(point)) {
            line.LineTo(PlaceOf(plot, point));
        } else {
            line.Lift();
        }
    }
    ImVec2 last(-1e6F, -1e6F);
    for (const glm::dvec2& point : curve.points) {
        if (!IsInPlot(plot, point)) continue;
        const ImVec2 at = PlaceOf(plot, point);
        if (Distance(at, last) < Px(9)) continue;
        DrawMarker(draw, at, index, Px(curve.emphasized ? 4.5F : 3.5F), color);
        last = at;
    }
}

void DrawDashedVertical(ImDrawList* draw, const ChartPlot& plot, float x, ImU32 color, float width) {
    DashedLine line(draw, plot, dashes[1], color, width);
    line.LineTo(ImVec2(x, plot.min.y));
    line.LineTo(ImVec2(x, plot.max.y));
}

}  // namespace widgets::inner
