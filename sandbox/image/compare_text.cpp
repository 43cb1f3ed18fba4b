// Writes a comparison in words and as JSON.
#include <algorithm>
#include <cmath>

#include "image/compare.h"
#include "text/json.h"
#include "text/numbers.h"
#include "text/words.h"

namespace viewing {

namespace {

std::string share_text(double share) {
    return figures(100.0 * share, 4) + "%";
}

std::string size_text(const std::array<int, 2>& size) {
    return std::to_string(size[0]) + " × " + std::to_string(size[1]);
}

/// Returns, for example, "; where: x 3 … 9, y 4 … 8 and 2 more places", or nothing.
std::string places(const CompareReport& report) {
    if (report.boxes.empty()) return "";
    const PixelBox& box = report.boxes.front();
    std::string text = "; where: x " + std::to_string(box.x) + " … " + std::to_string(box.x + box.width - 1) + ", y " +
                       std::to_string(box.y) + " … " + std::to_string(box.y + box.height - 1);
    const std::int64_t others = static_cast<std::int64_t>(report.boxes.size()) - 1 + report.boxes_left_out;
    if (others > 0) text += " and " + std::to_string(others) + (others == 1 ? " more place" : " more places");
    return text;
}

/// Returns the results of the portable profile's additional checks; nothing for the strict profile.
std::string portable_text(const CompareReport& report) {
    if (report.options.profile == CompareProfile::strict) return "";
    const auto largest = *std::max_element(report.local_shift.begin(), report.local_shift.end(),
                                           [](double p, double q) { return std::abs(p) < std::abs(q); });
    return "; " + std::to_string(report.resampled) + " more are edges sampled differently; the largest block has " +
           std::to_string(report.largest_block) + ", limit " + std::to_string(report.options.block_px) +
           "; the mean shifts by " + figures(largest, 3) + " in 16 × 16 pixels, limit " +
           figures(report.options.shift, 3);
}

}  // namespace

std::string sentence(const CompareReport& report) {
    const std::string compared = std::to_string(report.pixels - report.left_out);
    const std::string found = std::to_string(report.different) + " of " + compared + " pixels differ, at worst by " +
                              std::to_string(report.worst_found) + " of 255 at (" + std::to_string(report.worst_at[0]) +
                              ", " + std::to_string(report.worst_at[1]) + "); " + std::to_string(report.beyond) + " (" +
                              share_text(report.beyond_share()) + ") by more than " +
                              std::to_string(report.options.worst) + ", limit " + share_text(report.options.share) +
                              portable_text(report);
    if (report.sizes_differ)
        return "different: the sizes differ, A is " + size_text(report.size_a) + " and B is " +
               size_text(report.size_b) + "; in the part that both have, a channel differs by at most " +
               std::to_string(report.worst_found) + " of 255" + places(report);
    const std::string left_out = report.left_out > 0 ? "; " + counted(report.left_out, "pixel is left out by the mask",
                                                                      "pixels are left out by the mask")
                                                     : "";
    if (report.different == 0)
        return "equal: all " + (report.left_out > 0 ? compared + " compared" : size_text(report.size_a)) +
               " pixels are the same" + left_out;
    return (report.equal ? "equal within the thresholds: " : "different: ") + found + places(report) + left_out;
}

std::string as_json(const CompareReport& report) {
    auto boxes = nlohmann::ordered_json::array();
    for (const PixelBox& box : report.boxes)
        boxes.push_back(
            {{"x", box.x}, {"y", box.y}, {"width", box.width}, {"height", box.height}, {"pixels", box.pixels}});
    const bool is_portable = report.options.profile == CompareProfile::portable;
    nlohmann::ordered_json thresholds = {{"worst", report.options.worst}, {"share", report.options.share}};
    if (is_portable) {
        thresholds["block"] = report.options.block_px;
        thresholds["shift"] = report.options.shift;
    }
    const nlohmann::ordered_json json = {
        {"equal", report.equal},
        {"profile", profile_names[static_cast<std::size_t>(report.options.profile)]},
        {"sizes_differ", report.sizes_differ},
        {"size_a", report.size_a},
        {"size_b", report.size_b},
        {"pixels", report.pixels},
        {"left_out", report.left_out},
        {"different", report.different},
        {"beyond", report.beyond},
        {"resampled", report.resampled},
        {"share", report.beyond_share()},
        {"mean", report.mean},
        {"shift", report.shift},
        {"local_shift", is_portable ? nlohmann::ordered_json(report.local_shift) : nlohmann::ordered_json()},
        {"worst", report.worst_found},
        {"worst_at", report.worst_at},
        {"blocks", report.blocks},
        {"largest_block", report.largest_block},
        {"boxes", boxes},
        {"boxes_left_out", report.boxes_left_out},
        {"thresholds", thresholds},
        {"sentence", sentence(report)},
    };
    return json.dump(2) + "\n";
}

}  // namespace viewing
