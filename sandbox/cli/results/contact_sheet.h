// Pictures in rows and columns on one sheet, each with a caption below it.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "image/image.h"

namespace viewing {

struct SheetPicture {
    Image image;                        ///< all have the same size
    std::vector<std::string> captions;  ///< from long to short, as many for each picture
};

/// Returns the sheet. `columns` must be at least 1; the last row may have gaps. `pictures` must not be empty.
Image contact_sheet(const std::vector<SheetPicture>& pictures, int columns);

/// Returns the size of the sheet.
glm::ivec2 contact_sheet_size_px(glm::ivec2 picture_px, int count, int columns);

}  // namespace viewing
