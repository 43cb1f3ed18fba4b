// Stores pictures in a script, because a page that is opened from disk is not allowed to read the pixels of image
// files.
#pragma once

#include <string>
#include <string_view>

namespace viewing {

/// Returns a script that calls pictures(name, {expected, actual, difference}) with PNG files as data.
std::string picture_script(const std::string& name, std::string_view expected, std::string_view actual,
                           std::string_view difference);

}  // namespace viewing
