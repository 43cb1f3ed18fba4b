// A setting (PATH=VALUE) in readable form.
#pragma once

#include <string>

namespace viewing {

inline constexpr int all_digits = 0;

/// Returns a setting in words: "shadow.stencil=true" → "stencil on". Numbers have at most `digits` significant digits
/// or, with all_digits, as many as they need.
std::string setting_in_words(const std::string& setting, int digits);

/// Returns "shadow.stencil" for "shadow.stencil=true".
inline std::string path_of(const std::string& setting) {
    return setting.substr(0, setting.find('='));
}

}  // namespace viewing
