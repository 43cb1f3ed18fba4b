// Text over a picture: halos, and labels placed beside their points.
#include <algorithm>
#include <cmath>

#include "widgets/halo.h"
#include "widgets/inner.h"

namespace widgets {

namespace {

float HaloRadius() {
    return std::max(1.0F, inner::Px(1.25F) * CurrentContext().palette.stroke);
}

ImU32 HaloColor() {
    return inner::Shown(inner::WithAlpha(CurrentContext().palette.view_ground, 0.8F));
}

}  // namespace

void HaloText(ImDrawList* draw, ImVec2 position, ImU32 color, const char* text, ImFont* font) {
    const inner::Face face = inner::FaceOf(font);
    const float r = HaloRadius();
    for (const ImVec2& side : halo_sides) {
        face.Draw(draw, ImVec2(position.x + side.x * r, position.y + side.y * r), HaloColor(), text);
    }
    face.Draw(draw, position, color, text);
}

void LabelPlacer::Avoid(ImVec2 min, ImVec2 max) {
    taken_.push_back({min, max});
}

bool LabelPlacer::IsFree(const Box& box) const {
    if (box.min.x < min_.x || box.min.y < min_.y || box.max.x > max_.x || box.max.y > max_.y) return false;
    return std::none_of(taken_.begin(), taken_.end(), [&box](const Box& other) {
        return box.min.x < other.max.x && other.min.x < box.max.x && box.min.y < other.max.y && other.min.y < box.max.y;
    });
}

bool LabelPlacer::Place(ImVec2 point, const char* text, ImU32 color, std::span<const LetterRole> roles) {
    const inner::Face face = inner::FaceOf(nullptr);
    const bool is_formula = !roles.empty();
    const inner::FormulaLayout layout(is_formula ? text : "", roles, color, face);
    const ImVec2 size = is_formula ? layout.size : face.Measure(text);
    const float margin = HaloRadius(), marker = inner::Px(4);

    for (const float distance : {inner::Px(7), inner::Px(18), inner::Px(34)}) {
        for (const ImVec2& side : halo_sides) {
            const float reach = side.x != 0.0F && side.y != 0.0F ? distance * 0.7F : distance;
            const ImVec2 at(std::round(point.x + side.x * (reach + size.x * 0.5F) - size.x * 0.5F),
                            std::round(point.y + side.y * (reach + size.y * 0.5F) - size.y * 0.5F));
            const Box box{ImVec2(at.x - margin, at.y - margin), ImVec2(at.x + size.x + margin, at.y + size.y + margin)};
            if (!IsFree(box)) continue;
            taken_.push_back(box);
            Avoid(ImVec2(point.x - marker, point.y - marker), ImVec2(point.x + marker, point.y + marker));
            inner::RecordRect(text, box.min, box.max, text);
            if (!is_formula) {
                HaloText(draw_, at, color, text);
                return true;
            }
            for (const ImVec2& halo : halo_sides) {
                layout.DrawIn(draw_, ImVec2(at.x + halo.x * margin, at.y + halo.y * margin), HaloColor());
            }
            layout.Draw(draw_, at);
            return true;
        }
    }
    return false;
}

}  // namespace widgets
