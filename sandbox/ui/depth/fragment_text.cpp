#include "ui/depth/fragment_text.h"

#include <bit>
#include <cstdio>

#include "text/numbers.h"
#include "widgets/widgets.h"

namespace viewing {
namespace {

constexpr int least_decimals = 3, most_decimals = 12;

std::string with_decimals(float value, int decimals) {
    char text[48];
    std::snprintf(text, sizeof text, "%.*f", decimals, static_cast<double>(value));
    return text;
}

struct Pair {
    std::string incoming, stored;
};

Pair float_pair(std::uint32_t incoming, std::uint32_t stored) {
    const auto a = std::bit_cast<float>(incoming), b = std::bit_cast<float>(stored);
    for (int decimals = least_decimals; decimals <= most_decimals; ++decimals) {
        const Pair pair{with_decimals(a, decimals), with_decimals(b, decimals)};
        if (incoming == stored || pair.incoming != pair.stored) return pair;
    }
    return {bits_text(incoming), bits_text(stored)};
}

const char* relation(CompareFunc func) {
    switch (func) {
        case CompareFunc::less:
            return " < ";
        case CompareFunc::equal:
            return " = ";
        case CompareFunc::lequal:
            return " ≤ ";
        case CompareFunc::greater:
            return " > ";
        case CompareFunc::notequal:
            return " ≠ ";
        case CompareFunc::gequal:
            return " ≥ ";
        case CompareFunc::never:
        case CompareFunc::always:
            break;
    }
    return "";
}

bool asks_nothing(CompareFunc func) {
    return func == CompareFunc::never || func == CompareFunc::always;
}

/// What becomes of colour and depth where the tests let a fragment through.
const char* what_is_written(const Fragment& fragment) {
    if (!fragment.depth.write)
        return fragment.drawn ? "the colour is replaced, the mask keeps the depth" : "nothing is written";
    return fragment.drawn ? "colour and depth are replaced" : "the depth is replaced, the colour is not";
}

/// The fragment as the cell shows it, which was read back before it and after it. None: it cannot have done that.
std::optional<Fragment> as_read_back(Fragment sent, const BufferCell& before, const BufferCell& after) {
    const bool changes = before != after, changes_depth = before.stored != after.stored;
    if (changes_depth && !(sent.depth.test && sent.depth.write)) return std::nullopt;
    if (sent.culled || sent.stencil_fails) return changes ? std::nullopt : std::optional(sent);
    if (!sent.depth.test) return changes && !sent.passes ? std::nullopt : std::optional(sent);
    const bool keeps_color = sent.passes && !sent.drawn;
    if (changes && sent.depth.write) sent.stored = after.stored;
    sent.compared_with = before.stored;
    sent.tie = sent.stored == before.stored;
    const bool is_true = compare(sent.depth.func, sent.stored, before.stored);
    const bool would_change = sent.depth.write && !sent.tie;
    sent.passes = changes || (is_true && !would_change);
    sent.drawn = sent.passes && (before.color != after.color || !keeps_color);
    sent.decided_by_rounding = sent.passes != is_true;
    return sent;
}

}  // namespace

std::string code_text(std::uint32_t stored, const DepthPrecision& precision) {
    return precision.is_float ? with_decimals(std::bit_cast<float>(stored), 9) : grouped_number(stored);
}

std::string bits_text(std::uint32_t stored) {
    char text[16];
    std::snprintf(text, sizeof text, "0x%08x", stored);
    return text;
}

std::string compare_text(CompareFunc func, std::uint32_t incoming, std::uint32_t stored,
                         const DepthPrecision& precision) {
    if (asks_nothing(func)) return gl_name(func);
    const Pair pair =
        precision.is_float ? float_pair(incoming, stored) : Pair{grouped_number(incoming), grouped_number(stored)};
    return pair.incoming + relation(func) + pair.stored;
}

TestText test_text(const Fragment& fragment, const DepthPrecision& precision) {
    if (fragment.culled) return {"", "culled"};
    if (fragment.stencil_fails) return {"", "stencil fails"};
    const char* passes = fragment.drawn ? "passes" : "passes, no colour";
    if (!fragment.depth.test)
        return {"depth test off", !fragment.passes ? "not sent" : fragment.drawn ? "drawn" : "no colour"};
    if (fragment.decided_by_rounding) return {"rounding decides", fragment.passes ? passes : "fails"};
    const std::string asked = compare_text(fragment.depth.func, fragment.stored, fragment.compared_with, precision);
    const std::string tie = fragment.tie && !asks_nothing(fragment.depth.func) ? "tie: " : "";
    return {asked, tie + (fragment.passes ? passes : "fails")};
}

std::string fragment_name(const Fragment& fragment) {
    return fragment.object + ", triangle " + grouped_number(fragment.triangle + 1);
}

std::string decision_sentence(const Fragment& fragment, const DepthPrecision& precision) {
    const std::string name = fragment_name(fragment);
    if (fragment.culled)
        return name + " is culled: it turns its " + (fragment.front_facing ? "front" : "back") + " to the camera.";
    if (fragment.stencil_fails) return name + ": the stencil test fails, so the pixel stays.";
    if (!fragment.depth.test) {
        if (!fragment.passes) return name + " is not sent to GL: the method has found another surface here.";
        return name + ": the depth test is off, so the colour is replaced and the depth is not.";
    }
    if (fragment.decided_by_rounding)
        return name +
               ": GL's rounding decides here: " + (fragment.passes ? what_is_written(fragment) : "the pixel stays") +
               ".";
    const std::string asked =
        name + ": " + compare_text(fragment.depth.func, fragment.stored, fragment.compared_with, precision);
    if (fragment.passes) return asked + ", so " + what_is_written(fragment) + ".";
    if (asks_nothing(fragment.depth.func)) return asked + ", so the pixel stays.";
    return asked + " is false" + (fragment.tie ? ", a tie" : "") + ": the pixel stays.";
}

std::string cell_sentence(const std::optional<Fragment>& incoming, const BufferCell& before, const BufferCell& after,
                          const DepthPrecision& precision) {
    const std::optional<Fragment> sent = incoming ? as_read_back(*incoming, before, after) : std::nullopt;
    if (sent) return decision_sentence(*sent, precision);
    if (before == after) return "This triangle does not cover the pixel.";
    if (before.stored == after.stored) return "This triangle changes the colour, the depth stays.";
    return "This triangle changes colour and depth.";
}

int seen_fragment(const std::vector<Fragment>& fragments) {
    for (int i = static_cast<int>(fragments.size()); i-- > 0;)
        if (fragments[static_cast<std::size_t>(i)].drawn) return i;
    return -1;
}

}  // namespace viewing
