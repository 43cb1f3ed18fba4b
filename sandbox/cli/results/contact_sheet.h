// Pictures in rows and columns on one sheet, each with a line below it.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "image/image.h"

namespace viewing {

struct SheetPicture {
    Image image;                        ///< all of one size
    std::vector<std::string> captions;  ///< from long to short: the first that fits stands there
};

/// `columns`: 1 or more; what is missing in the last row stays empty. Not empty.
Image contact_sheet(const std::vector<SheetPicture>& pictures, int columns);

/// The size that the sheet would have.
glm::ivec2 contact_sheet_size_px(glm::ivec2 picture_px, int count, int columns);

}  // namespace viewing
