// A drawing as SVG and as PDF: shapes as paths, text as text in faces that are embedded, pictures as pictures. The same
// drawing gives a byte-equal file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "figure/drawing.h"
#include "image/png.h"

namespace viewing {

struct VectorOptions {
    double dpi = usual_dpi;  ///< pixels of the drawing per inch on paper
    std::string title;
    std::string note;  ///< the state that it shows, as JSON; "": none
};

std::string as_svg(const Drawing& drawing, const VectorOptions& options);

/// One page of the drawing's size. What a drawing may be: at most 200 inches a side, as PDF's readers have it.
std::vector<std::uint8_t> as_pdf(const Drawing& drawing, const VectorOptions& options);

}  // namespace viewing
