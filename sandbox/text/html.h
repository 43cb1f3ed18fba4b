// The pieces that the program's HTML pages are made of: each page is one file, with its pictures in it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace viewing {

/// A text fit to stand between tags and in quoted attributes.
std::string escaped(std::string_view text);

std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace viewing
