#include "image/mask_source.h"

#include "image/png.h"

namespace viewing {

Result<Mask> mask_of(const MaskSource& source, int width, int height) {
    if (source.is_empty()) return Mask();
    Mask mask(width, height);
    const auto size = [](int w, int h) { return std::to_string(w) + " × " + std::to_string(h); };
    for (const MaskRect& rect : source.rects) {
        if (rect.x >= width || rect.y >= height)
            return Error{"the mask " + std::to_string(rect.x) + "," + std::to_string(rect.y) + "," +
                         std::to_string(rect.width) + "," + std::to_string(rect.height) +
                         " lies outside the picture of " + size(width, height) + " pixels"};
        mask.leave_out(rect);
    }
    for (const std::filesystem::path& file : source.pictures) {
        const Result<Image> white = read_png(file);
        if (!white) return Error{white.error()};
        if (white->width != width || white->height != height)
            return Error{file.string() + ": the mask is " + size(white->width, white->height) +
                         " pixels, the picture " + size(width, height)};
        mask.leave_out(Mask(*white));
    }
    if (mask.pixels() == std::int64_t{width} * height)
        return Error{"the masks leave nothing to compare of the picture of " + size(width, height) + " pixels"};
    return mask;
}

}  // namespace viewing
