#include "frame/depth/fragment_text.h"

#include <bit>
#include <cstdio>

#include "state/compare.h"

namespace viewing {
namespace {

constexpr int least_decimals = 3, most_decimals = 12;

std::string with_decimals(float value, int decimals) {
    return plain_decimals(static_cast<double>(value), decimals);
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

/// Describes the effect on color and depth if GL's rounding decides.
Message rounding_sentence(const Fragment& fragment, const Message& name) {
    if (!fragment.passes)
        return message("{fragment}: GL's rounding decides here, so the pixel is unchanged.", "fragment"_a = name);
    if (!fragment.depth.write && fragment.drawn)
        return message("{fragment}: GL's rounding decides here, so the color is replaced; the mask keeps the depth.",
                       "fragment"_a = name);
    if (!fragment.depth.write)
        return message("{fragment}: GL's rounding decides here, so nothing is written.", "fragment"_a = name);
    return fragment.drawn
               ? message("{fragment}: GL's rounding decides here, so color and depth are replaced.",
                         "fragment"_a = name)
               : message("{fragment}: GL's rounding decides here, so the depth is replaced but the color is not.",
                         "fragment"_a = name);
}

/// Describes the effect on color and depth if the comparison decides.
Message compare_decision(const Fragment& fragment, const Message& name, const std::string& asked) {
    if (!fragment.passes) {
        if (asks_nothing(fragment.depth.func))
            return message("{fragment}: {compare}, so the pixel is unchanged.", "fragment"_a = name,
                           "compare"_a = asked);
        return fragment.tie ? message("{fragment}: {compare} is false (a tie), so the pixel is unchanged.",
                                      "fragment"_a = name, "compare"_a = asked)
                            : message("{fragment}: {compare} is false, so the pixel is unchanged.", "fragment"_a = name,
                                      "compare"_a = asked);
    }
    if (!fragment.depth.write && fragment.drawn)
        return message("{fragment}: {compare}, so the color is replaced; the mask keeps the depth.",
                       "fragment"_a = name, "compare"_a = asked);
    if (!fragment.depth.write)
        return message("{fragment}: {compare}, so nothing is written.", "fragment"_a = name, "compare"_a = asked);
    return fragment.drawn ? message("{fragment}: {compare}, so color and depth are replaced.", "fragment"_a = name,
                                    "compare"_a = asked)
                          : message("{fragment}: {compare}, so the depth is replaced but the color is not.",
                                    "fragment"_a = name, "compare"_a = asked);
}

/// Returns the fragment, corrected to match its cell, which was read back before and after the fragment was drawn.
/// Returns nullopt if the fragment cannot have caused the change.
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
    if (fragment.culled) return {{}, message("culled")};
    if (fragment.stencil_fails) return {{}, message("stencil fails")};
    if (!fragment.is_sent) return {{}, message("not sent")};
    const Message passes = fragment.drawn ? message("passes") : message("passes, no color");
    if (!fragment.depth.test)
        return {message("depth test off"), fragment.drawn ? message("drawn") : message("no color")};
    if (fragment.decided_by_rounding)
        return {message("rounding decides"), fragment.passes ? passes : message("fails"), true};
    const Message asked =
        verbatim(compare_text(fragment.depth.func, fragment.stored, fragment.compared_with, precision));
    if (!fragment.tie || asks_nothing(fragment.depth.func)) return {asked, fragment.passes ? passes : message("fails")};
    return {asked,
            !fragment.passes ? message("tie: fails")
            : fragment.drawn ? message("tie: passes")
                             : message("tie: passes, no color"),
            true};
}

Message fragment_name(const Fragment& fragment) {
    return message("{object}, triangle {number}", "object"_a = object_message(fragment.object),
                   "number"_a = grouped_number(fragment.triangle + 1));
}

Message decision_sentence(const Fragment& fragment, const DepthPrecision& precision) {
    const Message name = fragment_name(fragment);
    if (fragment.culled)
        return fragment.front_facing ? message("{fragment} is culled: it is front-facing.", "fragment"_a = name)
                                     : message("{fragment} is culled: it is back-facing.", "fragment"_a = name);
    if (fragment.stencil_fails)
        return message("{fragment}: the stencil test fails, so the pixel is unchanged.", "fragment"_a = name);
    if (!fragment.is_sent)
        return message("{fragment} is not sent to GL: the method found another surface here.", "fragment"_a = name);
    if (!fragment.depth.test)
        return message("{fragment}: the depth test is off, so the color is replaced but the depth is not.",
                       "fragment"_a = name);
    if (fragment.decided_by_rounding) return rounding_sentence(fragment, name);
    return compare_decision(fragment, name,
                            compare_text(fragment.depth.func, fragment.stored, fragment.compared_with, precision));
}

Message cell_sentence(const std::optional<Fragment>& incoming, const BufferCell& before, const BufferCell& after,
                      const DepthPrecision& precision) {
    const std::optional<Fragment> sent = incoming ? as_read_back(*incoming, before, after) : std::nullopt;
    if (sent) return decision_sentence(*sent, precision);
    if (before == after) return message("This triangle does not cover the pixel.");
    if (before.stored == after.stored) return message("This triangle changes the color but not the depth.");
    return message("This triangle changes color and depth.");
}

int seen_fragment(const std::vector<Fragment>& fragments) {
    for (int i = static_cast<int>(fragments.size()); i-- > 0;)
        if (fragments[static_cast<std::size_t>(i)].drawn) return i;
    return -1;
}

}  // namespace viewing
