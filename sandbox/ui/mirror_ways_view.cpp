#include "ui/mirror_ways_view.h"

#include <algorithm>
#include <cstdio>
#include <string>

#include "ui/look.h"
#include "ui/view_parts.h"

namespace viewing {
namespace {

constexpr float gap = 6.0F;

const char* explanation_of(MirrorWay way) {
    switch (way) {
        case MirrorWay::clip_distance:
            return "The mirrored scene is cut at the mirror, vertex by vertex, with gl_ClipDistance. The other "
                   "pictures are "
                   "compared with this one.";
        case MirrorWay::none:
            return "Nothing is cut: what lies behind the mirror, or crosses it, stands in front of the image.";
        case MirrorWay::oblique:
            return "The near plane is the mirror itself: nothing else is needed, but depth is measured from that plane "
                   "on, "
                   "and the far plane tilts with it.";
        case MirrorWay::camera:
            break;
    }
    return "The camera is mirrored in place of the scene and its picture flipped left and right: the same picture.";
}

std::string percent(std::int64_t part, std::int64_t whole) {
    return widgets::NumberText(whole > 0 ? 100.0 * static_cast<double>(part) / static_cast<double>(whole) : 0.0, 2) +
           " %";
}

/// With three decimals, whatever the size: depths are from 0 to 1.
std::string depth_text(double depth) {
    char text[16];
    std::snprintf(text, sizeof text, "%.3f", depth);
    return text;
}

/// "0.83 % differ · depth 0.912 … 0.987".
std::string numbers_of(MirrorWay way, const MirrorWayReport& report) {
    const std::string differ = way == MirrorWay::clip_distance ? "the reference"
                               : report.different == 0         ? "no pixel differs"
                                                               : percent(report.different, report.compared) + " differ";
    return differ + " · depth " + depth_text(report.first_depth) + "…" + depth_text(report.last_depth);
}

bool is_chosen(const ReflectionParams& reflection, MirrorWay way) {
    Params params;
    params.reflection = reflection;
    return mirrored_in(params, way).reflection == reflection;
}

void way_picture(Session& session, const Rect& place, MirrorWay way, const MirrorWaysShown& shown) {
    const widgets::Context& context = widgets::CurrentContext();
    const auto index = static_cast<std::size_t>(way);
    picture_item(name_of(way), place, shown.pictures[index]);
    if (ImGui::IsItemClicked()) session.params = mirrored_in(session.params, way);
    ImDrawList* draw = ImGui::GetWindowDrawList();
    if (is_chosen(session.params.reflection, way))
        draw->AddRect(place.min, place.max, palette().mirror, 0.0F, 0, px(2.0F));
    widgets::HaloText(draw, {place.min.x + px(6.0F), place.min.y + px(3.0F)}, palette().text, name_of(way));
    if (shown.ways) {
        const std::string numbers = numbers_of(way, shown.ways->reports[index]);
        ImGui::PushFont(context.fonts.note);
        const float height = ImGui::GetTextLineHeight();
        widgets::HaloText(draw, {place.min.x + px(6.0F), place.max.y - height - px(4.0F)}, palette().text,
                          numbers.c_str());
        ImGui::PopFont();
    }
    widgets::Tooltip(name_of(way), explanation_of(way));
}

}  // namespace

void draw_mirror_ways_view(Session& session, const Rect& rect, const MirrorWaysShown& shown) {
    if (!session.params.reflection.enabled) {
        ImGui::SetCursorScreenPos(rect.min);
        widgets::Note("Reflection is off: there is no image to compare.");
        return;
    }
    // Two by two, each with the shape of the camera's picture.
    const glm::ivec2 made = shown.ways ? shown.ways->size_px : glm::ivec2(16, 9);
    const float aspect = static_cast<float>(made.x) / static_cast<float>(std::max(made.y, 1));
    const float width = std::min(0.5F * (rect.width() - px(gap)), 0.5F * (rect.height() - px(gap)) * aspect);
    const ImVec2 size(width, width / aspect);
    for (std::size_t index = 0; index < mirror_way_count; ++index) {
        const ImVec2 min(rect.min.x + static_cast<float>(index % 2) * (size.x + px(gap)),
                         rect.min.y + static_cast<float>(index / 2) * (size.y + px(gap)));
        way_picture(session, {min, {min.x + size.x, min.y + size.y}}, static_cast<MirrorWay>(index), shown);
    }
}

}  // namespace viewing
