// The reference of snapshot --compare: read before anything is drawn, then held against the picture.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "cli/ending_report.h"
#include "cli/thresholds.h"
#include "image/compare.h"
#include "image/mask.h"

namespace viewing {

class Reference {
public:
    /// A file that is not there is no failure yet; one that is no PNG, or a mask of another size than the picture is
    /// going to have, throws Failure.
    Reference(std::string file, const ThresholdOptions& thresholds, glm::ivec2 size_px);

    /// Tells the report of it, and adds the picture of the differences where a name for it is given and the reference
    /// is there.
    void hold_against(const Image& drawn, const std::optional<std::string>& diff, Outputs& outputs,
                      EndingReport& report);

    /// How the command ends by it, and what it says then.
    ExitStatus status() const;
    std::string told() const;
    /// Says so on standard output, unless that is taken; throws Failure where only standard error is left for it.
    void tell(bool stdout_is_taken) const;

private:
    std::string file_;
    CompareOptions limits_;
    Mask mask_;
    std::optional<Image> expected_;
    std::optional<CompareReport> compared_;
};

}  // namespace viewing
