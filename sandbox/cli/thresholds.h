// --worst and --share, the two thresholds of a comparison.
#pragma once

#include <optional>
#include <string>

#include "cli/options.h"
#include "image/compare.h"

namespace viewing {

class ThresholdOptions {
public:
    /// Declares them under the title "Thresholds".
    explicit ThresholdOptions(Options& options);
    ThresholdOptions(const ThresholdOptions&) = delete;
    ThresholdOptions& operator=(const ThresholdOptions&) = delete;

    bool given() const { return worst_ || share_; }
    CompareOptions values() const;  ///< throws Failure

private:
    const Options& options_;
    std::optional<std::string> worst_, share_;
};

}  // namespace viewing
