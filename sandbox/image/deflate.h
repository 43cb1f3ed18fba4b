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

/// The outcome of unpacking: the text is whole, is followed by other bytes, is longer than allowed, or is cut off or
/// damaged.
enum class InflateEnd { whole, followed, too_long, damaged };

struct Inflated {
    InflateEnd end = InflateEnd::damaged;
    std::string text;  ///< "" unless `end` is whole
};

/// Reverses deflated(), up to `most` unpacked bytes. Throws std::bad_alloc if memory runs out.
Inflated inflated(std::span<const std::uint8_t> bytes, std::size_t most);

}  // namespace viewing
