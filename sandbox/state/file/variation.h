// One field of a state on its way through values: what a sweep varies.
#pragma once

#include <string>
#include <vector>

#include "text/result.h"

namespace viewing {

enum class Ease {
    linear,
    smooth  ///< begins and ends at rest: 3t² − 2t³ over the whole way
};

/// "light.position[0]=-3:3:61": a path, two or more values to go through, and in how many pictures. Values are JSON, or
/// texts; numbers and lists of numbers are met at equal distances and are in between in between, all others stay until
/// the next.
struct Variation {
    std::string path;
    std::vector<std::string> values;  ///< as --set takes them
    int count = 0;                    ///< 1 … most_frames

    static constexpr int most_frames = 10'000;
    static Result<Variation> parse(const std::string& text);

    /// "light.position[0]=-2.9" for picture `index` from 0 on; the first one alone where there is one.
    std::string setting(int index, Ease ease) const;
};

}  // namespace viewing
