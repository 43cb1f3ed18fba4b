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

}  // namespace viewing::testing
