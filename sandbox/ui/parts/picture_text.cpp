#include "ui/parts/picture_text.h"

#include <stb/stb_truetype.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "embedded/fonts.h"

namespace viewing {
namespace {

/// Removes and returns the first character of a UTF-8 text, which must be valid.
int take_character(std::string_view& text) {
    const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
    const unsigned first = byte(0);
    const std::size_t length = first < 0x80U ? 1 : first < 0xE0U ? 2 : first < 0xF0U ? 3 : 4;
    unsigned character = length == 1 ? first : first & (0xFFU >> (length + 1));
    for (std::size_t i = 1; i < length; ++i) character = character << 6U | (byte(i) & 0x3FU);
    text.remove_prefix(std::min(length, text.size()));
    return static_cast<int>(character);
}

class CaptionFace {
public:
    explicit CaptionFace(int height_px) {
        const std::span<const std::byte> file = embedded_font("JetBrainsMono-Regular.ttf");
        stbtt_InitFont(&font_, reinterpret_cast<const unsigned char*>(file.data()), 0);
        scale_ = stbtt_ScaleForPixelHeight(&font_, static_cast<float>(height_px));
        int ascent = 0, descent = 0, gap = 0;
        stbtt_GetFontVMetrics(&font_, &ascent, &descent, &gap);
        baseline_px_ = static_cast<int>(std::lround(static_cast<float>(ascent) * scale_));
    }

    /// Calls `each` with each character and its left edge; returns the width.
    template <typename Each>
    float walk(std::string_view text, const Each& each) const {
        float x_px = 0.0F;
        while (!text.empty()) {
            const int character = take_character(text);
            each(character, x_px);
            int advance = 0, bearing = 0;
            stbtt_GetCodepointHMetrics(&font_, character, &advance, &bearing);
            x_px += static_cast<float>(advance) * scale_;
        }
        return x_px;
    }

    void draw(Image& image, int character, float x_px, int top_px, std::uint8_t level) const {
        int width = 0, height = 0, left = 0, top = 0;
        unsigned char* const cover =
            stbtt_GetCodepointBitmap(&font_, scale_, scale_, character, &width, &height, &left, &top);
        for (int row = 0; row < height; ++row)
            for (int column = 0; column < width; ++column) {
                const int x = static_cast<int>(std::lround(x_px)) + left + column,
                          y = top_px + baseline_px_ + top + row;
                if (x < 0 || y < 0 || x >= image.width || y >= image.height) continue;
                const int share = cover[row * width + column];
                std::uint8_t* const pixel = image.pixel(x, y);
                for (int channel = 0; channel < 3; ++channel)
                    pixel[channel] = static_cast<std::uint8_t>((pixel[channel] * (255 - share) + level * share) / 255);
            }
        stbtt_FreeBitmap(cover, nullptr);
    }

private:
    stbtt_fontinfo font_{};
    float scale_ = 1.0F;
    int baseline_px_ = 0;
};

}  // namespace

int caption_width_px(const std::string& text, int height_px) {
    return static_cast<int>(std::ceil(CaptionFace(height_px).walk(text, [](int, float) {})));
}

void draw_caption(Image& image, const std::string& text, int left_px, int top_px, int height_px, std::uint8_t level) {
    const CaptionFace face(height_px);
    face.walk(text, [&](int character, float x_px) {
        face.draw(image, character, static_cast<float>(left_px) + x_px, top_px, level);
    });
}

}  // namespace viewing
