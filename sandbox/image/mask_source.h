// The source of a mask: rectangles, and pictures whose white pixels mark what to leave out.
#pragma once

#include <filesystem>
#include <vector>

#include "image/mask.h"
#include "text/result.h"

namespace viewing {

struct MaskSource {
    std::vector<MaskRect> rects;
    std::vector<std::filesystem::path> pictures;  ///< same size as the pictures being compared
    bool is_empty() const { return rects.empty() && pictures.empty(); }
};

/// Returns the combined mask for a picture of this size; an empty source leaves nothing out. The error names a picture
/// that cannot be read or has another size, or a rectangle outside the picture, or says that nothing is left to
/// compare.
Result<Mask> mask_of(const MaskSource& source, int width, int height);

}  // namespace viewing
