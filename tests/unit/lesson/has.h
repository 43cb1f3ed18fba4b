// Searches error messages.
#pragma once

#include <string>

namespace viewing::testing {

/// Returns whether the text contains this part.
inline bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace viewing::testing
