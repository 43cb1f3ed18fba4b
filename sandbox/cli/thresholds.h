// How two pictures are compared: --profile, --worst, --share and --mask.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/options.h"
#include "cli/output.h"
#include "image/compare.h"
#include "image/mask_source.h"
#include "state/file/document.h"

namespace viewing {

class ThresholdOptions {
public:
    /// Declares them under the title "Thresholds".
    explicit ThresholdOptions(Options& options);
    ThresholdOptions(const ThresholdOptions&) = delete;
    ThresholdOptions& operator=(const ThresholdOptions&) = delete;

    bool given() const { return profile_ || worst_ || share_ || !masks_.empty(); }
    /// Those of the profile, with what was typed in their place. Throws Failure.
    CompareOptions values() const;
    /// Pictures are read when they are wanted (mask_of). Throws Failure.
    MaskSource mask() const;
    /// The masks that are pictures.
    std::vector<FileArgument> files() const;
    /// The masks as they were typed.
    Json masks_as_json() const;

private:
    const Options& options_;
    std::optional<std::string> profile_, worst_, share_;
    std::vector<std::string> masks_;
};

}  // namespace viewing
