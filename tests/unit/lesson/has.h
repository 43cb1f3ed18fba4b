// What a sentence says.
#pragma once

#include <string>

namespace viewing::testing {

/// Whether a text has this part.
inline bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace viewing::testing
