// Cells of comma-separated values, as RFC 4180 has them.
#pragma once

#include <string>

namespace viewing {

/// In quotes where a comma, a quote or the end of a line asks for them.
std::string csv_quoted(const std::string& text);

}  // namespace viewing
