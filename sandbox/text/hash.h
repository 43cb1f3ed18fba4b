// A hash that is the same on every machine, forever. It chooses variants of exercises and detects changes in suites.
// Source: Fowler, Noll and Vo, FNV-1a, 64 bits.
#pragma once

#include <cstdint>
#include <string_view>

namespace viewing {

constexpr std::uint64_t fnv1a(std::string_view bytes) {
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const char byte : bytes) {
        hash ^= static_cast<unsigned char>(byte);
        hash *= 0x100000001b3U;
    }
    return hash;
}

}  // namespace viewing
