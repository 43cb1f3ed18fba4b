#include "cli/results/reference.h"

#include <filesystem>
#include <system_error>

#include "image/png.h"

namespace viewing {

Reference::Reference(std::string file, const ThresholdOptions& thresholds, glm::ivec2 size_px)
    : file_(std::move(file)),
      limits_(thresholds.values()),
      mask_(value_or_end(mask_of(thresholds.mask(), size_px.x, size_px.y))) {
    std::error_code error;
    if (std::filesystem::exists(file_, error)) expected_ = value_or_end(read_png(file_));
}

void Reference::hold_against(const Image& drawn, const std::optional<std::string>& diff, Outputs& outputs,
                             EndingReport& report) {
    if (!expected_) return;
    compared_ = compare_images(drawn, *expected_, limits_, mask_);
    report.tell("compare", Json::parse(as_json(*compared_)));
    if (diff) outputs.add(*diff, encode_png(diff_picture(drawn, *expected_, limits_, mask_)));
}

ExitStatus Reference::status() const {
    if (!compared_) return ExitStatus::reference_missing;
    return compared_->equal ? ExitStatus::done : ExitStatus::different;
}

std::string Reference::told() const {
    return compared_ ? sentence(*compared_) : file_ + ": there is no such reference";
}

void Reference::tell(bool stdout_is_taken) const {
    if (status() == ExitStatus::reference_missing) throw Failure(status(), told());
    if (!stdout_is_taken)
        print(told() + "\n");
    else if (status() == ExitStatus::different)
        throw Failure(status(), file_ + ": " + told());
}

}  // namespace viewing
