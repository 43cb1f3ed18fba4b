// How often a test with random input tries.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>

#include "platform/sanitized.h"

namespace viewing::testing {

/// Returns the number of trials in a test; VIEWING_LONG_TESTS=N multiplies it by N.
inline int trials(int usual) {
    const char* const longer = std::getenv("VIEWING_LONG_TESTS");
    return usual * std::max(longer ? std::atoi(longer) : 1, 1);
}

/// Whether VIEWING_LONG_TESTS is set, so that a test that covers a part of something covers all of it.
inline bool is_long() {
    return std::getenv("VIEWING_LONG_TESTS") != nullptr;
}

/// Whether a test that walks through a list takes the entry at `index`: every entry or, under sanitizers, which are ten
/// times as slow, every fourth. VIEWING_TEST_TURN=N says with which one to begin.
inline bool takes(std::size_t index) {
    const char* const turn = std::getenv("VIEWING_TEST_TURN");
    return !is_sanitized || is_long() || index % 4 == static_cast<std::size_t>(turn ? std::atoi(turn) : 0) % 4;
}

}  // namespace viewing::testing
