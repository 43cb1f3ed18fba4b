// A picture in the form that its file's name says: pixels as PNG, shapes and text as SVG or PDF.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "figure/write.h"
#include "image/image.h"
#include "state/params.h"

namespace viewing {

/// Whether shapes and text are wanted: .svg or .pdf.
bool is_vector_name(const std::string& target);

/// Pixels, or where there are none shapes and text.
struct DrawnPicture {
    Image image;
    Drawing drawing;

    bool is_blank() const;  ///< all pixels have the same colour, or nothing is drawn
};

/// The state that a figure carries; "", with a sentence on standard error, where it is longer than one can be read
/// back.
std::string carried_state(const Params& params);

std::vector<std::uint8_t> picture_file(const std::string& target, const DrawnPicture& picture,
                                       const VectorOptions& options);

}  // namespace viewing
