// The files of the program's fonts. All are part of the program; in a browser the Korean ones lie beside the page and
// are fetched when they are wanted first.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace viewing {

/// Empty while it is on its way, or if it cannot come.
std::span<const std::byte> font_file(std::string_view name);

/// How many have arrived since the program began: fonts are to be built anew when it counts up.
int arrived_font_files();

}  // namespace viewing
