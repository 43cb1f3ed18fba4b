#include "topics/depth/shown/pixel_numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "text/catalogue.h"
#include "topics/depth/numbers/fragment_text.h"

namespace viewing {
namespace {

std::string with_place_for_sign(const std::string& number) {
    const bool is_negative = number.starts_with("−");
    return is_negative ? number : " " + number;
}

/// Returns how many decimals of a window depth are enough to distinguish adjacent integer codes, or adjacent floats
/// near 1.
int decimals_of(const DepthPrecision& precision) {
    return precision.is_float ? 9 : static_cast<int>(std::ceil(precision.bits * 0.30103)) + 1;
}

/// Returns how many decimals to show, from 3 to 6, so that a step of this size changes one of the last two, if
/// possible.
int decimals_for_step(double step) {
    if (!(step > 0.0) || !std::isfinite(step)) return 3;
    return std::clamp(static_cast<int>(std::ceil(-std::log10(step))) + 1, 3, 6);
}

std::string code_count(const DepthPrecision& precision) {
    return "(2^{" + std::to_string(precision.bits) + "} - 1)";
}

std::string eye_z_formula(const ProjectionParams& projection, DepthMapping mapping) {
    if (mapping == DepthMapping::logarithmic) return "z_{eye} = -n (f/n)^d; d = z_{window}";
    const bool reversed = mapping == DepthMapping::reversed;
    if (projection.is_orthographic())
        return reversed ? "z_{eye} = -(f - d (f - n)); d = z_{window}" : "z_{eye} = -(n + d (f - n)); d = z_{window}";
    if (std::isinf(projection.far))
        return reversed ? "z_{eye} = -n / d; d = z_{window}" : "z_{eye} = -n / (1 - d); d = z_{window}";
    return reversed ? "z_{eye} = -n f / (n + d (f - n)); d = z_{window}"
                    : "z_{eye} = -n f / (f - d (f - n)); d = z_{window}";
}

std::string step_formula(const ProjectionParams& projection, DepthMapping mapping, const DepthPrecision& precision) {
    if (precision.is_float) return "";
    const std::string codes = code_count(precision);
    if (mapping == DepthMapping::logarithmic) return "Δz = z ln(f/n) / " + codes;
    if (projection.is_orthographic()) return "Δz = (f - n) / " + codes;
    if (std::isinf(projection.far)) return "Δz = z^2 / (n " + codes + ")";
    return "Δz = z^2 (f - n) / (f n " + codes + ")";
}

PixelNumber stored_number(const PixelReport& pixel) {
    if (pixel.precision.is_float)
        return {marked("stored"),
                with_place_for_sign(bits_text(pixel.stored)),
                tr("float bits"),
                tr("Stored bits"),
                tr("The 32 bits of the float z_window, read back from the depth buffer."),
                ""};
    return {marked("stored"),
            with_place_for_sign(code_text(pixel.stored, pixel.precision)),
            say("of 2{power} − 1", "power"_a = raised_text(pixel.precision.bits)),
            tr("Stored code"),
            tr("Read back from the depth buffer, not recomputed: the integer nearest to"),
            "z_{window} " + code_count(pixel.precision)};
}

std::string point_text(const glm::dvec3& point) {
    return with_place_for_sign(number_text(point.x, 3)) + "  " + with_place_for_sign(number_text(point.y, 3)) + "  " +
           with_place_for_sign(number_text(point.z, 3));
}

}  // namespace

std::string step_text(double step) {
    if (!(step >= 1e-3)) return number_text(step, 2);
    return number_text(step, std::clamp(2 - static_cast<int>(std::floor(std::log10(step))), 0, 5));
}

std::vector<PixelNumber> pixel_numbers(const PixelReport& pixel, const Params& params, const Derived& derived) {
    const DepthMapping mapping = params.depth.mapping;
    const DepthPrecision& precision = pixel.precision;
    const int decimals = decimals_of(precision);
    const bool has_depth = pixel.written && pixel.has_depth;
    const auto known = [&](const std::string& text) { return with_place_for_sign(has_depth ? text : "—"); };
    const auto from_depth = [&](const char* explanation) {
        if (!pixel.written || pixel.has_depth) return std::string(explanation);
        return std::string(tr("The pixel's depth is the clear value.")) + " " + explanation;
    };

    std::vector<PixelNumber> numbers{stored_number(pixel)};
    numbers.push_back({"z_{window}", with_place_for_sign(number_text(pixel.window_depth, decimals)), "",
                       tr("Window depth"), tr("The stored value as a depth, 0 to 1."),
                       precision.is_float ? "" : "z_{window} = stored / " + code_count(precision)});
    numbers.push_back(
        {"z_{ndc}", with_place_for_sign(number_text(pixel.ndc_z, decimals)), "",
         tr("z in normalized device coordinates"),
         derived.clip_zero_to_one ? tr("With glClipControl the range is 0 to 1.") : tr("The range is −1 to 1."),
         derived.clip_zero_to_one ? "z_{ndc} = z_{window}" : "z_{ndc} = 2 z_{window} - 1"});
    numbers.push_back(
        {marked("eye z"), known(number_text(pixel.eye_z, decimals_for_step(pixel.step))), "", tr("Eye z"),
         from_depth(tr("Recovered from the stored depth; negative in front of the camera. n is near, f is far:")),
         eye_z_formula(params.projection, mapping)});
    numbers.push_back({marked("width Δz"), known(step_text(pixel.step)), "", tr("Width Δz"),
                       precision.is_float ? tr("The width of a code here, in eye z: one unit in the last place of the "
                                               "float.")
                                          : tr("The width of a code here, in eye z:"),
                       step_formula(params.projection, mapping, precision)});
    if (precision.is_float)
        numbers.push_back(
            {marked("eye Δz"), known(step_text(pixel.resolvable_step)), "", tr("Eye Δz"),
             tr("The smallest resolvable difference here: eye z itself is rounded to float32 before the depth is "
                "stored, so codes narrower than half a unit in the last place of eye z add no precision."),
             ""});
    numbers.push_back(
        {marked("stencil"), with_place_for_sign(std::to_string(pixel.stencil)), "", tr("Stencil"),
         tr("The value that the passes left in the stencil buffer: marks for the plane, shadows and decals."), ""});
    numbers.push_back({marked("world"), has_depth ? point_text(pixel.world) : " —", "", tr("World position"),
                       from_depth(tr("The point at this pixel, from its stored depth: x, y, z.")),
                       "C (x_{eye}, y_{eye}, z_{eye}, 1)"});
    return numbers;
}

}  // namespace viewing
