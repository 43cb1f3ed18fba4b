// How busy the real window is when nobody touches it.
#pragma once

#include <optional>
#include <string>

namespace viewing::bench {

/// CPU of the window in percent of one core, over five seconds from when it came to rest, on a display of its own. None
/// where there is no Xvfb, or no window comes up.
std::optional<double> idle_percent(const std::string& sandbox);

}  // namespace viewing::bench
