// Reads what students type into a field for a number: fractions, roots, angles, π.
#pragma once

#include <optional>
#include <string_view>

namespace viewing {

/// Returns the value of a formula in the lesson language's notation: "4/2.7", "−sqrt(2)/2", "pi/6". Functions take
/// angles in radians; "cos(30°)" is cos(radians(30)), but "30°" alone is 30. None unless the value is a finite number.
std::optional<double> typed_number(std::string_view text);

}  // namespace viewing
