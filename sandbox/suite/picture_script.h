// Pictures for a page that is opened from disk: as a script that hands them over, since a page may not look into the
// pixels of pictures that are files.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace viewing {

/// Calls pictures(name, {expected, actual, difference}) with PNG files as data.
std::string picture_script(const std::string& name, std::span<const std::uint8_t> expected,
                           std::span<const std::uint8_t> actual, std::span<const std::uint8_t> difference);

}  // namespace viewing
