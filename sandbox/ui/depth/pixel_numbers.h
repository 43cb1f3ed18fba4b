// The numbers of one pixel, from the stored code back to the point in the world, each with the formula that derives it
// from the previous one. Pure functions. See pixel_view.cpp for usage.
#pragma once

#include <string>
#include <vector>

#include "frame/derive.h"
#include "frame/pixel_report.h"

namespace viewing {

struct PixelNumber {
    std::string name;   ///< "z_window", a widgets::Formula, untranslated
    std::string value;  ///< has a space where a minus sign would be
    std::string unit;   ///< in the quiet color after the value; dropped first: "of 2²⁴ − 1"
    std::string title, explanation;
    std::string formula;  ///< a widgets::Formula; may be empty
};

/// Returns stored code, z_window, z_ndc, eye z, Δz, stencil, and world position, in this order. If the pixel still has
/// the cleared depth, the numbers derived from it are "—".
std::vector<PixelNumber> pixel_numbers(const PixelReport& pixel, const Params& params, const Derived& derived);

/// Rounds to about three significant digits: "0.00151", "152.6", "8.58·10⁻⁶".
std::string step_text(double step);

}  // namespace viewing
