// A picture in the format of its file name: pixels as PNG, shapes and text as SVG or PDF.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "figure/write.h"
#include "image/depth_file.h"
#include "image/image.h"
#include "state/params.h"

namespace viewing {

/// Whether the name has the ending of a vector format: .svg or .pdf.
bool is_vector_name(const std::string& target);

/// A picture as pixels or, if it has none, as shapes and text.
struct DrawnPicture {
    Image image;
    Drawing drawing;
    DepthImage depths = {};  ///< the picture's depths, if the file stores them instead of colors

    bool is_blank() const;  ///< all pixels have the same color, or nothing is drawn
};

/// Returns the state to store in a picture. If it is too long to be read back, prints a sentence on standard error and
/// returns "".
std::string carried_state(const Params& params);

std::vector<std::uint8_t> picture_file(const std::string& target, const DrawnPicture& picture,
                                       const VectorOptions& options);

}  // namespace viewing
