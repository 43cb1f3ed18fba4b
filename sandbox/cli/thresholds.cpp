#include "cli/thresholds.h"

#include "cli/values.h"

namespace viewing {

ThresholdOptions::ThresholdOptions(Options& options) : options_(options) {
    options.group("Thresholds");
    options.text("--worst", "N", worst_, "Levels of 255 that a channel may differ by, 0 to 255; default 2");
    options.text("--share", "F", share_, "Share of the pixels that may differ by more, 0 to 1; default 0");
}

CompareOptions ThresholdOptions::values() const {
    CompareOptions values;
    if (worst_) values.worst = whole_option(options_, "--worst", *worst_, 0, 255);
    if (share_) values.share = number_option(options_, "--share", *share_, 0.0, 1.0);
    return values;
}

}  // namespace viewing
