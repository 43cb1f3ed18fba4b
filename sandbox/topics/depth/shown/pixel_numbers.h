// The numbers of one pixel, from the stored code back to the point in the world, each with the formula that derives it
// from the previous one. Pure functions. See pixel_view.cpp for usage.
#pragma once

#include <string>
#include <vector>

#include "frame/derive.h"
#include "frame/pixel_report.h"

namespace viewing {

struct PixelNumber {
    std::string name;   ///< "z_{window}": a widgets::Formula, untranslated
    std::string value;  ///< starts with a minus sign, or with a space in its place
    std::string unit;   ///< follows the value, in the muted color, if it fits: "of 2²⁴ − 1"
    std::string title, explanation;
    std::string formula;  ///< a widgets::Formula; may be empty
};

/// Returns the stored code, z_window, z_ndc, eye z, Δz (and for a float buffer, eye Δz), stencil, and world position,
/// in this order. If the pixel still has the cleared depth, eye z, both Δz, and the world position are "—".
std::vector<PixelNumber> pixel_numbers(const PixelReport& pixel, const Params& params, const Derived& derived);

/// Rounds to about three significant digits: "0.00151", "153", "8.58·10⁻⁶".
std::string step_text(double step);

}  // namespace viewing
