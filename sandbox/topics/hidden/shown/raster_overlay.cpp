#include "topics/hidden/shown/raster_overlay.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "text/numbers.h"
#include "ui/parts/look.h"
#include "ui/parts/view_parts.h"

namespace viewing {
namespace {

ImFont* digits_font() {
    ImFont* font = widgets::CurrentContext().fonts.small_number;
    return font ? font : ImGui::GetFont();
}

/// Returns ".532", without the leading 0, since window depths are between 0 and 1.
std::string depth_digits(double depth, int decimals) {
    const std::string text = number_text(depth, decimals);
    return text.starts_with("0.") ? text.substr(1) : text;
}

/// Returns how many decimals of a depth fit in a square of this side length; 0 if too few fit to be useful.
int decimals_in(float side) {
    for (int decimals = 4; decimals >= 2; --decimals) {
        const ImVec2 size =
            digits_font()->CalcTextSizeA(digits_font()->FontSize, 1e9F, 0.0F, depth_digits(0.88888, decimals).c_str());
        if (size.x + px(4.0F) <= side && size.y <= side) return decimals;
    }
    return 0;
}

void draw_lines(ImDrawList* draw, const RasterPlaces& places, glm::ivec2 size) {
    const Rect whole = places.whole();
    const ImU32 color = with_alpha(palette().quiet, 110);
    const bool has_room = places.of({0, 0}).width() >= px(5.0F);
    for (int x = 1; has_room && x < size.x; ++x) {
        const float at = std::round(places.of({x, 0}).min.x);
        draw->AddLine({at, whole.min.y}, {at, whole.max.y}, color);
    }
    for (int y = 1; has_room && y < size.y; ++y) {
        const float at = std::round(places.of({0, y}).min.y);
        draw->AddLine({whole.min.x, at}, {whole.max.x, at}, color);
    }
    draw->AddRect(whole.min, whole.max, palette().quiet, 0.0F, 0, px(1.2F));
}

void draw_depths(const Overlay& overlay, const RasterPlaces& places, const IdImage& image) {
    const int decimals = decimals_in(places.of({0, 0}).width());
    if (decimals == 0) return;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            if (image.id(x, y) == IdImage::background) continue;
            const std::string text = depth_digits(image.depths[image.index(x, y)], decimals);
            const ImVec2 size = digits_font()->CalcTextSizeA(digits_font()->FontSize, 1e9F, 0.0F, text.c_str());
            const ImVec2 middle = places.middle({x, y});
            const ImVec2 at(std::round(middle.x - 0.5F * size.x), std::round(middle.y - 0.5F * size.y));
            if (overlay.is_free({at, {at.x + size.x, at.y + size.y}}))
                widgets::PlateText(overlay.draw(), at, palette().text, text.c_str(), digits_font());
        }
}

/// Returns a rectangle around a pixel, large enough to be visible even if the pixel is small.
Rect ring_of(const Rect& pixel) {
    const float grow = std::max(0.0F, px(5.0F) - 0.5F * pixel.width());
    return {{pixel.min.x - grow, pixel.min.y - grow}, {pixel.max.x + grow, pixel.max.y + grow}};
}

bool shows_raster(const HiddenResult& result) {
    return has_raster(result.request.visibility) && !result.image.ids.empty();
}

void draw_ring(ImDrawList* draw, const Rect& ring, ImU32 color) {
    draw->AddRect(ring.min, ring.max, palette().ground, 0.0F, 0, px(4.0F));
    draw->AddRect(ring.min, ring.max, color, 0.0F, 0, px(2.2F));
}

}  // namespace

ImVec2 RasterPlaces::place_of(const glm::dvec2& position_px) const {
    const glm::dvec2 share =
        (position_px / glm::dvec2(result_.image.width, result_.image.height) - 0.5) * result_.request.share + 0.5;
    return {view_.min.x + view_.width() * static_cast<float>(share.x),
            view_.min.y + view_.height() * static_cast<float>(share.y)};
}

Rect RasterPlaces::of(glm::ivec2 pixel) const {
    return {place_of(pixel), place_of(pixel + 1)};
}

ImVec2 RasterPlaces::middle(glm::ivec2 pixel) const {
    return place_of(glm::dvec2(pixel) + 0.5);
}

Rect RasterPlaces::whole() const {
    return {place_of({0.0, 0.0}), place_of({result_.image.width, result_.image.height})};
}

std::optional<glm::ivec2> RasterPlaces::pixel_at(ImVec2 place) const {
    if (!view_.contains(place)) return std::nullopt;
    return raster_pixel({place.x - view_.min.x, place.y - view_.min.y}, view_.size_px(),
                        {result_.image.width, result_.image.height}, result_.request.share);
}

void draw_raster_lines(const Overlay& overlay, const HiddenResult& result) {
    if (shows_raster(result))
        draw_lines(overlay.draw(), RasterPlaces(overlay.rect(), result), {result.image.width, result.image.height});
}

void draw_raster_depths(const Overlay& overlay, const HiddenResult& result) {
    if (shows_raster(result)) draw_depths(overlay, RasterPlaces(overlay.rect(), result), result.image);
}

void draw_pixel_of_step(Overlay& overlay, const HiddenResult& result, glm::ivec2 pixel, const std::string& text) {
    const Rect ring = ring_of(RasterPlaces(overlay.rect(), result).of(pixel)), &view = overlay.rect();
    draw_ring(overlay.draw(), ring, palette().accent);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const float margin = px(5.0F), gap = px(4.0F), most_x = view.max.x - size.x - 2.0F * margin;
    const bool is_below = ring.max.y + gap + size.y + margin < view.max.y;
    const ImVec2 at(std::max(std::min(ring.max.x + gap, most_x), view.min.x + margin),
                    is_below ? ring.max.y + gap : ring.min.y - gap - size.y);
    draw_plate(overlay.draw(), {at, {at.x + size.x, at.y + size.y}}, {margin, 1.0F});
    overlay.keep_labels_off({{at.x - margin, at.y - 1.0F}, {at.x + size.x + margin, at.y + size.y + 1.0F}});
    overlay.draw()->AddText(at, palette().text, text.c_str());
}

void draw_chosen_pixel(const Overlay& overlay, const HiddenResult& result) {
    const std::optional<glm::ivec2>& pixel = result.request.visibility.pixel;
    if (!pixel || pixel->x >= result.image.width || pixel->y >= result.image.height) return;
    draw_ring(overlay.draw(), ring_of(RasterPlaces(overlay.rect(), result).of(*pixel)), palette().point);
}

}  // namespace viewing
