// The building blocks of the program's HTML pages. Each page is one file that contains its pictures.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace viewing {

/// Escapes a text, so that it is safe between tags and in quoted attributes.
std::string escaped(std::string_view text);

std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace viewing
