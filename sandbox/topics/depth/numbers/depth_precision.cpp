#include "topics/depth/numbers/depth_precision.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace viewing {
namespace {

constexpr int curve_points = 240;  // enough for the sawtooth of a float's step over ten decades
constexpr std::uint32_t code_of_one = std::bit_cast<std::uint32_t>(1.0F);

struct Steps {
    StepPoints whole, quantization, arithmetic;
};

Steps steps_of(const DepthCoding& coding) {
    // With an infinite far, curves end where the chart's axis usually ends.
    const double end = coding.lens.is_infinite() ? std::max(coding.lens.reach, 1e4) : coding.lens.far;
    Steps steps;
    for (int i = 0; i <= curve_points; ++i) {
        const double share = static_cast<double>(i) / curve_points;
        const double start = coding.lens.logarithmic_near(), z = start * std::pow(end / start, share);
        const FightingOnset onset = fighting_onset(coding, z);
        if (!onset.is_reachable) continue;
        steps.whole.emplace_back(z, onset.gap());
        steps.quantization.emplace_back(z, onset.quantization);
        steps.arithmetic.emplace_back(z, onset.arithmetic);
    }
    return steps;
}

/// Returns the largest code, that of window depth 1.
std::uint32_t last_code(const DepthPrecision& precision) {
    return precision.is_float ? code_of_one : (std::uint32_t{1} << static_cast<unsigned>(precision.bits)) - 1;
}

double depth_of_code(std::uint32_t code, const DepthPrecision& precision) {
    return precision.is_float ? std::bit_cast<float>(code) : code / static_cast<double>(last_code(precision));
}

double distance_of_code(std::uint32_t code, const Lens& lens, DepthMapping mapping, const DepthPrecision& precision) {
    const double z = distance_of_window_depth(lens, mapping, depth_of_code(code, precision));
    return std::clamp(z, lens.near, lens.far);
}

}  // namespace

PrecisionCurves precision_curves(const Params& params, const Derived& derived) {
    const DepthCoding now = depth_coding(params, derived);
    Steps current = steps_of(now);
    PrecisionCurves curves{{params.depth.format, params.depth.mapping, std::move(current.whole)},
                           std::move(current.quantization),
                           std::move(current.arithmetic),
                           {}};
    for (const DepthFormat format : {DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f}) {
        for (const DepthMapping mapping : {DepthMapping::standard, DepthMapping::reversed, DepthMapping::logarithmic}) {
            if (format == params.depth.format && mapping == params.depth.mapping) continue;
            // The other mappings are shown at their best: reversed depth gets the clip range that it needs.
            const bool zero_to_one =
                mapping == DepthMapping::reversed && (mapping != params.depth.mapping || derived.clip_zero_to_one);
            curves.others.push_back(
                {format, mapping, steps_of({now.lens, mapping, precision_of(format), zero_to_one}).whole});
        }
    }
    return curves;
}

Message short_name(DepthFormat format, DepthMapping mapping) {
    const DepthPrecision precision = precision_of(format);
    const Message bits = precision.is_float ? message("float") : verbatim(std::to_string(precision.bits));
    switch (mapping) {
        case DepthMapping::standard:
            return precision.is_float ? bits : message("{bits} bit", "bits"_a = bits);
        case DepthMapping::reversed:
            return message("{format} rev", "format"_a = bits);
        case DepthMapping::logarithmic:
            return message("{format} log", "format"_a = bits);
    }
    return bits;
}

DepthCodes depth_codes(const Lens& lens, DepthMapping mapping, const DepthPrecision& precision, int most_ticks) {
    const std::uint32_t last = last_code(precision);
    const auto most = static_cast<std::uint32_t>(std::max(most_ticks, 2));
    const std::uint32_t steps = std::min(last, last <= most ? last : std::bit_floor(most));
    DepthCodes made;
    made.codes_per_tick = std::llround(static_cast<double>(last) / steps);
    for (std::uint32_t i = 0; i <= steps; ++i) {
        const auto from_start = static_cast<std::uint32_t>(std::llround(static_cast<double>(last) * i / steps));
        const std::uint32_t code = mapping == DepthMapping::reversed ? last - from_start : from_start;
        made.codes.push_back(code);
        made.eye_distances.push_back(distance_of_code(code, lens, mapping, precision));
    }
    return made;
}

Message codes_sentence(const Lens& lens, DepthMapping mapping, const DepthPrecision& precision) {
    if (!precision.is_float)
        return message("Half of all codes lie between near and z = {z}.",
                       "z"_a = figures(distance_of_window_depth(lens, mapping, 0.5), 3));
    const double middle = 0.5 * (lens.near + lens.shown_far());
    const std::uint32_t code =
        std::bit_cast<std::uint32_t>(static_cast<float>(std::clamp(window_depth(lens, mapping, middle), 0.0, 1.0)));
    const std::uint32_t farther = mapping == DepthMapping::reversed ? code : code_of_one - code;
    if (lens.is_infinite())
        return message("Of the {all} floats from 0 to 1, {farther} lie beyond z = {z}.",
                       "all"_a = grouped_number(code_of_one), "farther"_a = grouped_number(farther),
                       "z"_a = figures(middle, 3));
    return message(
        "Of the {all} floats from 0 to 1, {farther} lie in the farther half of the distance, beyond z = {z}.",
        "all"_a = grouped_number(code_of_one), "farther"_a = grouped_number(farther), "z"_a = figures(middle, 3));
}

}  // namespace viewing
