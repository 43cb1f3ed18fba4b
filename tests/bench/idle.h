// Measures how busy the real window is while nobody touches it.
#pragma once

#include <optional>
#include <string>

namespace viewing::bench {

/// Returns the window's CPU time in percent of one core, over the five seconds after it comes to rest on its own
/// display. The result is empty without Xvfb or if the window does not start.
std::optional<double> idle_percent(const std::string& sandbox);

}  // namespace viewing::bench
