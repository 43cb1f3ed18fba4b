// How often a test with random input tries.
#pragma once

#include <algorithm>
#include <cstdlib>

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

}  // namespace viewing::testing
