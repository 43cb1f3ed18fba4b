// Pictures for a page that is opened from disk: as a script that hands them over, since a page may not look into the
// pixels of pictures that are files.
#pragma once

#include <string>
#include <string_view>

namespace viewing {

/// Calls pictures(name, {expected, actual, difference}) with PNG files as data.
std::string picture_script(const std::string& name, std::string_view expected, std::string_view actual,
                           std::string_view difference);

}  // namespace viewing
