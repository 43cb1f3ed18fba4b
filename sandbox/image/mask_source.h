// Where a mask comes from: rectangles, and pictures of which white is left out.
#pragma once

#include <filesystem>
#include <vector>

#include "image/mask.h"
#include "text/result.h"

namespace viewing {

struct MaskSource {
    std::vector<MaskRect> rects;
    std::vector<std::filesystem::path> pictures;  ///< of the size of what is compared
    bool is_empty() const { return rects.empty() && pictures.empty(); }
};

/// All of them as the mask of a picture of this size; an empty source leaves nothing out. The error names a picture
/// that cannot be read or has another size, a rectangle that lies outside, or says that nothing is left to compare.
Result<Mask> mask_of(const MaskSource& source, int width, int height);

}  // namespace viewing
