// Writes a drawing as SVG and as PDF: shapes become paths, text stays text with embedded fonts, and pictures become
// images. Equal drawings with equal options give byte-identical files.
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
    std::string note;  ///< the state shown, as JSON; "" if there is none
};

std::string as_svg(const Drawing& drawing, const VectorOptions& options);

/// Returns one page of the drawing's size. A side may be at most 200 inches long, the limit of PDF readers.
std::vector<std::uint8_t> as_pdf(const Drawing& drawing, const VectorOptions& options);

}  // namespace viewing
