#include "cli/results/contact_sheet.h"

#include <algorithm>

#include "text/words.h"
#include "ui/parts/picture_text.h"

namespace viewing {
namespace {

constexpr int margin_px = 8, text_px = 20;
constexpr std::uint8_t ground = 24, light = 225;

bool fits(const std::string& caption, int width_px) {
    return caption_width_px(caption, text_px) <= width_px;
}

/// Returns the index of the longest captions that fit below all pictures; the shortest ones if none do.
std::size_t level_of(const std::vector<SheetPicture>& pictures) {
    const std::size_t shortest = pictures.front().captions.size() - 1;
    for (std::size_t level = 0; level < shortest; ++level)
        if (std::all_of(pictures.begin(), pictures.end(), [level](const SheetPicture& picture) {
                return fits(picture.captions[level], picture.image.width);
            }))
            return level;
    return shortest;
}

/// Cuts a caption off, with an ellipsis, so that it does not run into the next one.
std::string fitted(const std::string& caption, int width_px) {
    if (fits(caption, width_px)) return caption;
    for (std::string kept = caption; !kept.empty();) {
        remove_last_character(kept);
        if (fits(kept + "…", width_px)) return kept + "…";
    }
    return "";
}

}  // namespace

glm::ivec2 contact_sheet_size_px(glm::ivec2 picture_px, int count, int columns) {
    const int rows = (count + columns - 1) / columns;
    return {margin_px + columns * (picture_px.x + margin_px),
            margin_px + rows * (picture_px.y + text_px + 2 * margin_px)};
}

Image contact_sheet(const std::vector<SheetPicture>& pictures, int columns) {
    const Image& first = pictures.front().image;
    const glm::ivec2 size_px =
        contact_sheet_size_px({first.width, first.height}, static_cast<int>(pictures.size()), columns);
    Image sheet{size_px.x, size_px.y, {}};
    sheet.rgba.assign(sheet.row_bytes() * static_cast<std::size_t>(sheet.height), ground);
    for (std::size_t at = 3; at < sheet.rgba.size(); at += 4) sheet.rgba[at] = 255;
    const std::size_t level = level_of(pictures);
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const Image& image = pictures[i].image;
        const int column = static_cast<int>(i) % columns, row = static_cast<int>(i) / columns;
        const int left = margin_px + column * (first.width + margin_px);
        const int top = margin_px + row * (first.height + text_px + 2 * margin_px);
        for (int y = 0; y < image.height; ++y) std::copy_n(image.row(y), image.row_bytes(), sheet.pixel(left, top + y));
        draw_caption(sheet, fitted(pictures[i].captions[level], image.width), left, top + image.height + margin_px / 2,
                     text_px, light);
    }
    return sheet;
}

}  // namespace viewing
