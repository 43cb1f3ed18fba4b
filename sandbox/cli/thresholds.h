// Options for comparing two pictures: --profile, --worst, --share and --mask.
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
    /// Declares these options under the title "Thresholds".
    explicit ThresholdOptions(Options& options);
    ThresholdOptions(const ThresholdOptions&) = delete;
    ThresholdOptions& operator=(const ThresholdOptions&) = delete;

    bool given() const { return profile_ || worst_ || share_ || !masks_.empty(); }
    /// Returns the profile's thresholds, overridden by the given options. Throws Failure.
    CompareOptions values() const;
    /// Returns the masks; those that are pictures are read later (mask_of). Throws Failure.
    MaskSource mask() const;
    /// Returns the masks that are pictures.
    std::vector<FileArgument> files() const;
    /// Returns the masks as typed.
    Json masks_as_json() const;

private:
    const Options& options_;
    std::optional<std::string> profile_, worst_, share_;
    std::vector<std::string> masks_;
};

}  // namespace viewing
