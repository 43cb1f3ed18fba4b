#include "topics/depth/shown/pixel_words.h"

#include "text/catalogue.h"

namespace viewing {

std::string surface_words(const PixelReport& pixel) {
    if (!pixel.written) return tr("background");
    return pixel.front_facing ? say("{object}, front face", "object"_a = object_text(pixel.object))
                              : say("{object}, back face", "object"_a = object_text(pixel.object));
}

std::vector<std::string> pixel_words(const PixelReport& pixel) {
    std::vector<std::string> words;
    words.push_back(say("pixel ({x}, {y})", "x"_a = pixel.pixel.x, "y"_a = pixel.pixel.y) +
                    fmt::format("  #{:02x}{:02x}{:02x}", pixel.color.r, pixel.color.g, pixel.color.b));
    words.push_back(surface_words(pixel));
    if (pixel.written && pixel.has_depth) words.push_back(say("eye z {z}", "z"_a = number_text(pixel.eye_z, 3)));
    if (pixel.written && !pixel.has_depth) words.emplace_back(tr("cleared depth"));
    words.push_back("z_window " + plain_decimals(pixel.window_depth, 6));
    const std::string stored = grouped_number(pixel.stored);
    words.push_back(pixel.precision.is_float ? say("stored {code} (float bits)", "code"_a = stored)
                                             : say("stored {code} of 2{bits}−1", "code"_a = stored,
                                                   "bits"_a = raised_text(pixel.precision.bits)));
    words.push_back(say("stencil {value}", "value"_a = pixel.stencil));
    return words;
}

}  // namespace viewing
