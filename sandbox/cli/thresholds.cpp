#include "cli/thresholds.h"

#include <array>

#include "cli/option_values.h"
#include "image/png.h"
#include "text/words.h"

namespace viewing {

ThresholdOptions::ThresholdOptions(Options& options) : options_(options) {
    options.group("Thresholds");
    options.text("--profile", "strict|portable", profile_,
                 "strict (default) for pictures of the same driver; portable for pictures of another driver: edges may "
                 "be sampled differently, but no block of five pixels may differ otherwise, and no 16 × 16 mean by "
                 "more than 0.6 levels");
    options.text("--worst", "N", worst_,
                 "Largest allowed difference of a channel, 0 to 255 levels; default 2, or 3 with portable");
    options.text("--share", "F", share_,
                 "Fraction of the pixels that may differ by more than --worst, 0 to 1; default 0, or 0.002 with "
                 "portable");
    options.texts("--mask", "X,Y,WIDTH,HEIGHT|MASK.png", masks_,
                  "Leaves out a rectangle, or the white pixels of a picture of the same size; repeatable");
}

CompareOptions ThresholdOptions::values() const {
    CompareOptions values;
    if (profile_)
        values =
            options_of(static_cast<CompareProfile>(choice_option(options_, "--profile", *profile_, profile_names)));
    if (worst_) values.worst = whole_option(options_, "--worst", *worst_, 0, 255);
    if (share_) values.share = number_option(options_, "--share", *share_, 0.0, 1.0);
    return values;
}

MaskSource ThresholdOptions::mask() const {
    MaskSource source;
    for (const FileArgument& picture : files()) source.pictures.emplace_back(picture.file);
    for (const std::string& mask : masks_) {
        if (is_png_name(mask)) continue;
        const std::vector<std::string> numbers = split_outside_brackets(mask, ',');
        if (numbers.size() != 4)
            options_.refuse(
                "--mask: must be X,Y,WIDTH,HEIGHT in pixels, such as 0,0,120,40, or the name of a .png picture, got "
                "\"" +
                one_line(mask) + "\"");
        std::array<int, 4> sides{};
        for (std::size_t i = 0; i < 4; ++i)
            sides[i] = whole_option(options_, "--mask", numbers[i], i < 2 ? 0 : 1, largest_image_side);
        source.rects.push_back({sides[0], sides[1], sides[2], sides[3]});
    }
    return source;
}

Json ThresholdOptions::masks_as_json() const {
    Json names = Json::array();
    for (const std::string& mask : masks_) names.push_back(printable(mask));
    return names;
}

std::vector<FileArgument> ThresholdOptions::files() const {
    std::vector<FileArgument> files;
    for (const std::string& mask : masks_)
        if (is_png_name(mask)) files.push_back({"--mask", mask});
    return files;
}

}  // namespace viewing
