// Subscripts in sentences: "ℓ_y" and "z_ndc" have one, "GL_LESS" has none. Sentences are stored as typed; the code that
// draws them moves the subscript's letters down.
#pragma once

#include <string_view>
#include <vector>

namespace viewing {

struct TextPart {
    std::string_view text;
    bool is_lowered = false;

    bool operator==(const TextPart&) const = default;
};

/// Splits a text at its subscripts: a single letter, an underscore that is not shown, and one to four lower-case
/// letters.
std::vector<TextPart> subscript_parts(std::string_view text);

}  // namespace viewing
