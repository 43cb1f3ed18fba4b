// A picture in the form that its file's name says: pixels as PNG, shapes and text as SVG or PDF.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "figure/write.h"
#include "image/image.h"

namespace viewing {

/// Whether shapes and text are wanted: .svg or .pdf.
bool is_vector_name(const std::string& target);

/// Pixels, or where there are none shapes and text.
struct DrawnPicture {
    Image image;
    Drawing drawing;

    bool is_blank() const;  ///< all pixels have the same colour, or nothing is drawn
};

std::vector<std::uint8_t> picture_file(const std::string& target, const DrawnPicture& picture,
                                       const VectorOptions& options);

}  // namespace viewing
