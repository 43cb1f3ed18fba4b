// The slides of the lecture by number, for the headings of lists.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace viewing {

/// Returns the heading for items that belong to these slides, in the current language; "" if there are no slides. The
/// heading names only the first slide: "Slide 12 · Depth fighting".
std::string slide_heading(const std::vector<int>& slides);

/// Returns the slide that a search names: 12 for "s12", "S 12" and "slide 12"; nothing for other words.
std::optional<int> searched_slide(std::string_view search);

}  // namespace viewing
