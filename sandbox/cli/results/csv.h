// Cells for comma-separated values (RFC 4180).
#pragma once

#include <string>

namespace viewing {

/// Returns the text, in quotes if it contains a comma, a quote or a line break.
std::string csv_quoted(const std::string& text);

}  // namespace viewing
