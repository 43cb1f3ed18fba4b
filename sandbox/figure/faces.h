// The fonts of a drawing: which characters of each are in it, and files that have those alone.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "figure/drawing.h"

namespace viewing {

/// The characters of each font, by its file's name.
std::map<std::string, std::set<char32_t>> characters_of(const Drawing& drawing);

/// A font file with the outlines of these characters and nothing that would put others in their place. The whole file
/// where it cannot be made smaller.
std::vector<std::uint8_t> subset(std::span<const std::byte> file, const std::set<char32_t>& characters);

/// UTF-8.
std::string utf8(char32_t character);

}  // namespace viewing
