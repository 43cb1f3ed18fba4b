// Measures how busy the real window is while nobody touches it.
#pragma once

#include <optional>
#include <string>

namespace viewing::bench {

/// Starts the window on its own display, lets it come to rest, and returns the CPU time it uses over the next five
/// seconds, in percent of one core. Returns nothing if there is no Xvfb or the window does not start.
std::optional<double> idle_percent(const std::string& sandbox);

}  // namespace viewing::bench
