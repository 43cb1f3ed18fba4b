// The fonts in a drawing: the characters that it uses from each, and font files that contain only those.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "figure/drawing.h"

namespace viewing {

/// Returns the characters used from each font, by file name.
std::map<std::string, std::set<char32_t>> characters_of(const Drawing& drawing);

/// Returns a font file with the outlines of these characters only, and without rules that would substitute other
/// glyphs; the whole file if it cannot be made smaller.
std::vector<std::uint8_t> subset(std::span<const std::byte> file, const std::set<char32_t>& characters);

/// Returns a character in UTF-8.
std::string utf8(char32_t character);

}  // namespace viewing
