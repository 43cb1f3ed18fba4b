// The program's font files. All are embedded, except that in a browser the Korean ones are fetched from the page's
// folder on first use.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace viewing {

/// Returns the file's bytes; empty while it is loading or if it cannot be loaded.
std::span<const std::byte> font_file(std::string_view name);

/// Returns the number of files fetched so far. Rebuild the fonts when it increases.
int arrived_font_files();

}  // namespace viewing
