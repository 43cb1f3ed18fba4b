// Text in zlib format, as stored in links and figures.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace viewing {

std::vector<std::uint8_t> deflated(std::string_view text);

/// The outcome of unpacking: complete, followed by other bytes, longer than allowed, or cut off or damaged.
enum class InflateEnd { whole, followed, too_long, damaged };

struct Inflated {
    InflateEnd end = InflateEnd::damaged;
    std::string text;  ///< "" unless `end` is whole
};

/// The inverse of deflated(), limited to `most` unpacked bytes. Throws std::bad_alloc.
Inflated inflated(std::span<const std::uint8_t> bytes, std::size_t most);

}  // namespace viewing
