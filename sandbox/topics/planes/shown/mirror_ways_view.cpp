#include "topics/planes/shown/mirror_ways_view.h"

#include <algorithm>
#include <cfloat>
#include <string>
#include <vector>

#include "text/catalogue.h"
#include "ui/parts/look.h"
#include "ui/parts/view_parts.h"

namespace viewing {
namespace {

constexpr float picture_gap = 6.0F, picture_margin = 6.0F;

const char* explanation_of(MirrorWay way) {
    switch (way) {
        case MirrorWay::clip_distance:
            return tr(
                "gl_ClipDistance clips the mirrored scene at the mirror: each vertex writes its signed distance from "
                "the mirror, and each triangle is clipped where that distance is 0. The other pictures are compared "
                "with this one.");
        case MirrorWay::none:
            return tr(
                "Nothing is clipped: objects that lie behind the mirror or cross it appear in front of the mirror "
                "image.");
        case MirrorWay::oblique:
            return tr(
                "The mirror itself is the near plane: nothing else is needed, but depth is measured from that plane, "
                "and the far plane tilts with it.");
        case MirrorWay::camera:
            break;
    }
    return tr(
        "The camera is mirrored instead of the scene, and its picture is flipped left to right. The result is the "
        "same.");
}

/// Always uses three decimals, since depths are between 0 and 1.
std::string depth_text(double depth) {
    return plain_decimals(depth, 3);
}

std::string difference_of(MirrorWay way, const MirrorWayReport& report) {
    if (report.image_pixels == 0 && report.different == 0) return tr("no image");
    if (way == MirrorWay::clip_distance) return tr("the reference");
    if (report.different == 0) return tr("none differ");
    const double share = static_cast<double>(report.different) / static_cast<double>(report.compared);
    return say("{share} differ", "share"_a = percent(share, 2));
}

/// Returns the mirror image's range of depths; empty if no pixel shows the mirror image.
std::string depths_of(const MirrorWayReport& report) {
    if (report.image_pixels == 0) return "";
    return say("depth {first}…{last}", "first"_a = depth_text(report.first_depth),
               "last"_a = depth_text(report.last_depth));
}

bool is_chosen(const ReflectionParams& reflection, MirrorWay way) {
    Params params;
    params.reflection = reflection;
    return mirrored_in(params, way).reflection == reflection;
}

/// Draws a picture's name at the top and its numbers at the bottom, in several lines if needed, leaving out those that
/// would cover too much of the picture; the tooltip shows them all.
void captions(ImDrawList* draw, const Rect& place, const char* name, std::span<const std::string> numbers) {
    const widgets::Fonts& fonts = widgets::CurrentContext().fonts;
    const float width = place.width() - px(2.0F * picture_margin);
    if (width < fonts.note->FontSize) return;
    float room = 0.6F * place.height();
    const auto size_of = [](const std::string& text, const ImFont* font) {
        return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0F, text.c_str());
    };
    const auto fits = [&](const ImVec2& size) { return size.x <= width && size.y <= room; };
    const auto write = [&](const std::string& text, ImFont* font, float top) {
        widgets::PlateText(draw, {place.min.x + px(picture_margin), top}, palette().text, text.c_str(), font);
    };
    ImFont* const head = fits(size_of(name, fonts.text)) ? fonts.text : fonts.note;
    const std::string title = widgets::BrokenAtBlanks(name, width, *head);
    if (const ImVec2 size = size_of(title, head); fits(size)) {
        write(title, head, place.min.y + px(0.5F * picture_margin));
        room -= size.y;
    }
    ImFont* const small = place.height() < px(200.0F) ? fonts.note : fonts.text;
    std::string below;
    for (const std::string& number : numbers) {
        const std::string more = below + (below.empty() ? "" : "\n") + widgets::BrokenAtBlanks(number, width, *small);
        if (!fits(size_of(more, small))) break;
        below = more;
    }
    if (!below.empty()) write(below, small, place.max.y - px(0.5F * picture_margin) - size_of(below, small).y);
}

void way_picture(Session& session, const Rect& place, MirrorWay way, const MirrorWaysShown& shown) {
    const auto index = static_cast<std::size_t>(way);
    picture_item(name_of(way), place, shown.pictures[index]);
    if (ImGui::IsItemClicked()) session.params = mirrored_in(session.params, way);
    ImDrawList* draw = ImGui::GetWindowDrawList();
    if (is_chosen(session.params.reflection, way))
        draw->AddRect(place.min, place.max, palette().mirror, 0.0F, 0, px(2.0F));
    std::string told = explanation_of(way);
    const DepthParams& depth = session.params.depth;
    if (way == MirrorWay::oblique && depth.mapping == DepthMapping::logarithmic && depth.logarithm_per_vertex)
        told += std::string(" ") +
                tr("Here each vertex writes its own logarithmic z, so the mirror no longer acts as the near plane.");
    std::vector<std::string> numbers;
    if (shown.ways) {
        const MirrorWayReport& report = shown.ways->reports[index];
        numbers = {difference_of(way, report), depths_of(report)};
        for (const std::string& number : numbers) told += "\n" + number;
    }
    widgets::Tooltip(name_of(way), told.c_str());
    captions(draw, place, tr(name_of(way)), numbers);
}

}  // namespace

void draw_mirror_ways_view(Session& session, const Rect& rect, const MirrorWaysShown& shown) {
    if (!session.params.reflection.enabled) {
        ImGui::SetCursorScreenPos(rect.min);
        widgets::Note("Reflection is off: there is no mirror image to compare.");
        return;
    }
    // The pictures have the camera picture's aspect ratio. The grid with the largest ones is best.
    const glm::ivec2 made = shown.ways ? glm::max(shown.ways->size_px, 1) : glm::ivec2(16, 9);
    const float aspect = static_cast<float>(made.x) / static_cast<float>(made.y);
    const auto share = [](float whole, std::size_t count) {
        return (whole - static_cast<float>(count - 1) * px(picture_gap)) / static_cast<float>(count);
    };
    std::size_t columns = 2;
    float width = 1.0F;
    for (const std::size_t tried : {std::size_t{2}, mirror_way_count}) {
        const float possible =
            std::min(share(rect.width(), tried), share(rect.height(), mirror_way_count / tried) * aspect);
        if (possible <= width) continue;
        columns = tried;
        width = possible;
    }
    const ImVec2 size(width, std::max(width / aspect, 1.0F));
    for (std::size_t index = 0; index < mirror_way_count; ++index) {
        const ImVec2 min(rect.min.x + static_cast<float>(index % columns) * (size.x + px(picture_gap)),
                         rect.min.y + static_cast<float>(index / columns) * (size.y + px(picture_gap)));
        way_picture(session, {min, {min.x + size.x, min.y + size.y}}, static_cast<MirrorWay>(index), shown);
    }
}

}  // namespace viewing
