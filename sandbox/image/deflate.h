// Texts in zlib's form: what links and figures carry.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace viewing {

std::vector<std::uint8_t> deflated(std::string_view text);

/// How the unpacking ended: with all of it, because something followed, because it would have been longer than allowed,
/// or because the bytes are cut off or damaged.
enum class InflateEnd { whole, followed, too_long, damaged };

struct Inflated {
    InflateEnd end = InflateEnd::damaged;
    std::string text;  ///< "" unless it is whole
};

/// What deflated() makes, back; of at most `most` bytes, however few they are when packed. Throws std::bad_alloc.
Inflated inflated(std::span<const std::uint8_t> bytes, std::size_t most);

}  // namespace viewing
