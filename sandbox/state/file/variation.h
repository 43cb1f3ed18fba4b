// A sweep: one field that moves through a list of values.
#pragma once

#include <string>
#include <vector>

#include "text/result.h"

namespace viewing {

enum class Ease {
    linear,
    smooth  ///< starts and ends at rest: 3t² − 2t³ over the whole sweep
};

/// "light.position[0]=-3:3:61": a path, two or more values, and the number of pictures. The values are JSON or strings,
/// and are spaced evenly. Numbers and lists of numbers are interpolated; any other value stays constant until the next
/// one.
struct Variation {
    std::string path;
    std::vector<std::string> values;  ///< in the form that --set takes
    int count = 0;                    ///< 1 … most_frames

    static constexpr int most_frames = 10'000;
    static Result<Variation> parse(const std::string& text);

    /// Returns the setting for picture `index`, counted from 0: "light.position[0]=-2.9". A single picture gets the
    /// first value.
    std::string setting(int index, Ease ease) const;
};

}  // namespace viewing
