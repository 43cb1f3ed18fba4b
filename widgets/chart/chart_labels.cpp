// Places the names of curves at their ends so that none covers another.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "widgets/chart/chart_inner.h"
#include "widgets/inner.h"

namespace widgets::inner {

namespace {

bool AreApart(const Box& a, const Box& b) {
    return a.max.x <= b.min.x || b.max.x <= a.min.x || a.max.y <= b.min.y || b.max.y <= a.min.y;
}

/// Returns the curve's last point inside the plot; null if there is none.
const glm::dvec2* EndOf(const ChartPlot& plot, const ChartCurve& curve) {
    for (std::size_t i = curve.points.size(); i > 0; --i) {
        if (IsInPlot(plot, curve.points[i - 1])) return &curve.points[i - 1];
    }
    return nullptr;
}

/// Returns the areas that a name should avoid: the markers and, in small pieces, the lines.
std::vector<Box> Obstacles(const ChartPlot& plot, std::span<const ChartCurve> curves) {
    std::vector<Box> boxes;
    const auto add = [&boxes](ImVec2 at, float r) {
        boxes.push_back({ImVec2(at.x - r, at.y - r), ImVec2(at.x + r, at.y + r)});
    };
    const float step = Px(6);
    for (const ChartCurve& curve : curves) {
        std::optional<ImVec2> last;
        for (const glm::dvec2& point : curve.points) {
            if (!CanBeDrawn(point)) {
                last.reset();
                continue;
            }
            const ImVec2 at = PlaceOf(plot, point);
            if (last && Distance(*last, at) < step) continue;
            if (IsInPlot(plot, point)) add(at, Px(4));
            ImVec2 from = last.value_or(at), to = at;
            last = at;
            if (!ClipToPlot(plot, from, to)) continue;
            const float length = Distance(from, to);
            for (float done = step; done < length; done += step) add(Between(from, to, done / length), Px(1));
        }
    }
    return boxes;
}

/// Moves the box up or down to the nearest free place. Returns nullopt if there is none within `most_px`.
std::optional<Box> Nudged(const Box& wanted, const ChartPlot& plot, float most_px, std::span<const Box> taken,
                          std::span<const Box> obstacles) {
    const float height = wanted.max.y - wanted.min.y, step = std::ceil(height * 0.25F);
    const int most = static_cast<int>(most_px / step) + 1;
    for (int i = 0; i <= 2 * most; ++i) {
        const float dy = step * static_cast<float>(i % 2 == 0 ? i / 2 : -(i + 1) / 2);
        const Box box{ImVec2(wanted.min.x, wanted.min.y + dy), ImVec2(wanted.max.x, wanted.max.y + dy)};
        const bool is_inside = box.min.y >= plot.min.y - 0.5F * height && box.max.y <= plot.max.y + 0.5F * height;
        if (is_inside && IsFree(box, taken) && IsFree(box, obstacles)) return box;
    }
    return std::nullopt;
}

}  // namespace

bool IsFree(const Box& box, std::span<const Box> taken) {
    return std::all_of(taken.begin(), taken.end(), [&](const Box& other) { return AreApart(box, other); });
}

std::vector<EndLabel> PlaceLabels(const ChartPlot& plot, std::span<const ChartCurve> curves, float right,
                                  const std::vector<Box>& taken) {
    const inner::Face face = inner::FaceOf(CurrentContext().fonts.note);
    std::vector<EndLabel> wanted;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const glm::dvec2* point = EndOf(plot, curves[i]);
        if (!point) continue;
        const ImVec2 end = PlaceOf(plot, *point), size = face.Measure(curves[i].name);
        const float left = std::floor(std::max(std::min(end.x + Px(9), right - size.x), plot.min.x));
        const float top = std::floor(end.y - 0.5F * size.y);
        wanted.push_back({i, end, {ImVec2(left, top), ImVec2(left + size.x, top + size.y)}});
    }
    std::stable_sort(wanted.begin(), wanted.end(), [&](const EndLabel& a, const EndLabel& b) {
        const bool a_first = curves[a.curve].emphasized, b_first = curves[b.curve].emphasized;
        return a_first != b_first ? a_first : a.end.y < b.end.y;
    });
    const std::vector<Box> obstacles = Obstacles(plot, curves);
    const auto place_all = [&](float gap) {
        std::vector<EndLabel> placed;
        std::vector<Box> avoided = taken;
        for (const EndLabel& label : wanted) {
            const auto& [min, max] = label.box;
            const Box spaced{{min.x, min.y - gap}, {max.x, max.y + gap}};
            std::optional<Box> box = Nudged(spaced, plot, 3.0F * face.size, avoided, obstacles);
            if (!box) box = Nudged(spaced, plot, plot.max.y - plot.min.y, avoided, {});
            if (!box) continue;
            placed.push_back({label.curve, label.end, {{min.x, box->min.y + gap}, {max.x, box->max.y - gap}}});
            avoided.push_back(placed.back().box);
        }
        return placed;
    };
    // With space for frames around two names, if all names still fit.
    std::vector<EndLabel> placed = place_all(Px(4));
    return placed.size() == wanted.size() ? placed : place_all(0.0F);
}

void DrawEndLabel(ImDrawList* draw, const EndLabel& label, const char* name, ImU32 color) {
    const float middle = 0.5F * (label.box.min.y + label.box.max.y);
    if (std::abs(middle - label.end.y) > 0.7F * (label.box.max.y - label.box.min.y)) {
        draw->AddLine(label.end, ImVec2(label.box.min.x - Px(2), middle), WithAlpha(color, 0.5F),
                      Px(1) * CurrentContext().palette.stroke);
    }
    PlateText(draw, label.box.min, color, name, CurrentContext().fonts.note);
    RecordRect(("label/" + std::string(name)).c_str(), label.box.min, label.box.max, name);
}

}  // namespace widgets::inner
