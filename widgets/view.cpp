// Text over a picture: text on a plate, and labels placed beside their points.
#include <algorithm>
#include <cmath>

#include "widgets/inner.h"

namespace widgets {

namespace {

constexpr float plate_margin_x = 3.0F, plate_margin_y = 1.0F;  // in design pixels

void DrawTextPlate(ImDrawList* draw, ImVec2 at, ImVec2 size) {
    const ImVec2 margin(inner::Px(plate_margin_x), inner::Px(plate_margin_y));
    draw->AddRectFilled(ImVec2(at.x - margin.x, at.y - margin.y),
                        ImVec2(at.x + size.x + margin.x, at.y + size.y + margin.y),
                        inner::Shown(CurrentContext().palette.view_ground), inner::Px(3));
}

/// Returns whether a line crosses a rectangle. Clips the line at one edge after another (Liang and Barsky).
bool Crosses(ImVec2 from, ImVec2 to, ImVec2 min, ImVec2 max) {
    float begin = 0.0F, end = 1.0F;
    const auto cut = [&](float start, float way, float least, float most) {
        if (way == 0.0F) return start >= least && start <= most;
        const float one = (least - start) / way, other = (most - start) / way;
        begin = std::max(begin, std::min(one, other));
        end = std::min(end, std::max(one, other));
        return begin <= end;
    };
    return cut(from.x, to.x - from.x, min.x, max.x) && cut(from.y, to.y - from.y, min.y, max.y);
}

/// Directions from a point to its label, in order of preference.
const ImVec2 sides[8] = {{1, 0}, {1, -1}, {-1, 0}, {-1, -1}, {0, -1}, {0, 1}, {1, 1}, {-1, 1}};

}  // namespace

void PlateText(ImDrawList* draw, ImVec2 position, ImU32 color, const char* text, ImFont* font) {
    const inner::Face face = inner::FaceOf(font);
    DrawTextPlate(draw, position, face.Measure(text));
    face.Draw(draw, position, color, text);
}

void LabelPlacer::Avoid(ImVec2 min, ImVec2 max) {
    taken_.push_back({min, max});
}

void LabelPlacer::AvoidLine(ImVec2 from, ImVec2 to) {
    lines_.push_back({from, to});
}

bool LabelPlacer::IsFree(const Box& box) const {
    if (box.min.x < min_.x || box.min.y < min_.y || box.max.x > max_.x || box.max.y > max_.y) return false;
    return std::none_of(taken_.begin(), taken_.end(), [&box](const Box& other) {
        return box.min.x < other.max.x && other.min.x < box.max.x && box.min.y < other.max.y && other.min.y < box.max.y;
    });
}

bool LabelPlacer::IsCrossed(const Box& box) const {
    return std::any_of(lines_.begin(), lines_.end(),
                       [&box](const Line& line) { return Crosses(line.from, line.to, box.min, box.max); });
}

std::optional<LabelPlacer::Box> LabelPlacer::Find(ImVec2 point, ImVec2 size, std::span<const ImVec2> rivals) const {
    std::optional<Box> crossed;
    const auto is_nearer_to_rival = [&](const Box& box) {
        const ImVec2 middle((box.min.x + box.max.x) * 0.5F, (box.min.y + box.max.y) * 0.5F);
        const auto away = [&](ImVec2 from) { return std::hypot(middle.x - from.x, middle.y - from.y); };
        return std::any_of(rivals.begin(), rivals.end(), [&](ImVec2 rival) { return away(rival) < away(point); });
    };
    for (const float distance : {inner::Px(7), inner::Px(18), inner::Px(34)}) {
        for (const ImVec2& side : sides) {
            const float reach = side.x != 0.0F && side.y != 0.0F ? distance * 0.7F : distance;
            const ImVec2 min(std::round(point.x + side.x * (reach + size.x * 0.5F) - size.x * 0.5F),
                             std::round(point.y + side.y * (reach + size.y * 0.5F) - size.y * 0.5F));
            const Box box{min, ImVec2(min.x + size.x, min.y + size.y)};
            if (!IsFree(box) || is_nearer_to_rival(box)) continue;
            if (!IsCrossed(box)) return box;
            if (!crossed) crossed = box;
        }
    }
    return crossed;
}

bool LabelPlacer::Place(ImVec2 point, const char* text, ImU32 color, std::span<const LetterRole> roles,
                        std::span<const ImVec2> rivals) {
    const inner::Face face = inner::FaceOf(nullptr);
    const bool is_formula = !roles.empty();
    const inner::FormulaLayout layout(is_formula ? text : "", roles, color, face);
    const ImVec2 size = is_formula ? layout.size : face.Measure(text);
    const ImVec2 margin(std::ceil(inner::Px(plate_margin_x)), std::ceil(inner::Px(plate_margin_y)));
    const std::optional<Box> box = Find(point, ImVec2(size.x + 2.0F * margin.x, size.y + 2.0F * margin.y), rivals);
    if (!box) return false;

    const float marker = inner::Px(4);
    Avoid(box->min, box->max);
    Avoid(ImVec2(point.x - marker, point.y - marker), ImVec2(point.x + marker, point.y + marker));
    inner::RecordRect(text, box->min, box->max, text);
    const ImVec2 at(box->min.x + margin.x, box->min.y + margin.y);
    if (is_formula) {
        DrawTextPlate(draw_, at, size);
        layout.Draw(draw_, at);
    } else {
        PlateText(draw_, at, color, text);
    }
    return true;
}

}  // namespace widgets
