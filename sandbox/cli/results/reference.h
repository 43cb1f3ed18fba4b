// The reference for snapshot --compare, which is read before anything is drawn and then compared with the picture.
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
    /// Reads the file; a missing one is not an error yet. Throws Failure if the file is not a PNG, or if a mask does
    /// not have the picture's size.
    Reference(std::string file, const ThresholdOptions& thresholds, glm::ivec2 size_px);

    /// Adds the comparison to the report, and, if `diff` is given, the picture of the differences to the outputs. Adds
    /// neither if the reference does not exist.
    void hold_against(const Image& drawn, const std::optional<std::string>& diff, Outputs& outputs,
                      EndingReport& report);

    /// Return the exit status and the message for this comparison.
    ExitStatus status() const;
    std::string told() const;
    /// Prints the message on standard output, unless a result goes there. Throws Failure with the message if there is
    /// no reference, or if the pictures differ and a result goes to standard output.
    void tell(bool stdout_is_taken) const;

private:
    std::string file_;
    CompareOptions limits_;
    Mask mask_;
    std::optional<Image> expected_;
    std::optional<CompareReport> compared_;
};

}  // namespace viewing
