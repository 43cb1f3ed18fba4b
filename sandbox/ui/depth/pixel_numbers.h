// The numbers of one pixel from the stored code back to the point in the world, each with the formula that leads to it
// from the one before. Pure. Read pixel_view.cpp for its use.
#pragma once

#include <string>
#include <vector>

#include "frame/derive.h"
#include "frame/pixel_report.h"

namespace viewing {

struct PixelNumber {
    std::string name;   ///< "z_window", as a widgets::Formula, not yet looked up
    std::string value;  ///< a sign that is not there keeps its place
    std::string unit;   ///< quiet behind it, and the first to be left out: "of 2²⁴ − 1"
    std::string title, explanation;
    std::string formula;  ///< as a widgets::Formula; may be empty
};

/// Stored code, z_window, z_ndc, eye z, Δz, stencil, world position, in this order. Where depth is as it
/// is cleared, those that would come from it are "—".
std::vector<PixelNumber> pixel_numbers(const PixelReport& pixel, const Params& params, const Derived& derived);

/// Three figures or so: "0.00151", "152.6", "8.58·10⁻⁶".
std::string step_text(double step);

}  // namespace viewing
