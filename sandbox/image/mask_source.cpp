#include "image/mask_source.h"

#include "image/png.h"

namespace viewing {

Result<Mask> mask_of(const MaskSource& source, int width, int height) {
    if (source.is_empty()) return Mask();
    Mask mask(width, height);
    for (const MaskRect& rect : source.rects) mask.leave_out(rect);
    for (const std::filesystem::path& file : source.pictures) {
        const Result<Image> white = read_png(file);
        if (!white) return Error{white.error()};
        if (white->width != width || white->height != height)
            return Error{file.string() + ": the mask is " + std::to_string(white->width) + " × " +
                         std::to_string(white->height) + " pixels, the picture " + std::to_string(width) + " × " +
                         std::to_string(height)};
        mask.leave_out(Mask(*white));
    }
    return mask;
}

}  // namespace viewing
