#include "topics/depth/numbers/fragment_text.h"

#include <bit>
#include <cstdio>

#include "state/compare_func.h"
#include "text/per_enum.h"

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

bool asks_nothing(CompareFunc func) {
    return func == CompareFunc::never || func == CompareFunc::always;
}

/// Returns the sentence about what happens to a fragment and its pixel.
const char* decision_of(const Fragment& fragment) {
    static constexpr const char* by_rounding[] = {
        marked("{fragment}: GL's rounding decides here, so the pixel is unchanged."),
        marked("{fragment}: GL's rounding decides here, so color and depth are replaced."),
        marked("{fragment}: GL's rounding decides here, so the depth is replaced but the color is not."),
        marked("{fragment}: GL's rounding decides here, so the color is replaced; the mask keeps the depth."),
        marked("{fragment}: GL's rounding decides here, so nothing is written.")};
    static constexpr const char* by_compare[] = {
        marked("{fragment}: {compare}, so the pixel is unchanged."),
        marked("{fragment}: {compare}, so color and depth are replaced."),
        marked("{fragment}: {compare}, so the depth is replaced but the color is not."),
        marked("{fragment}: {compare}, so the color is replaced; the mask keeps the depth."),
        marked("{fragment}: {compare}, so nothing is written.")};
    if (fragment.culled)
        return fragment.front_facing ? marked("{fragment} is culled: it is front-facing.")
                                     : marked("{fragment} is culled: it is back-facing.");
    if (fragment.stencil_fails) return marked("{fragment}: the stencil test fails, so the pixel is unchanged.");
    if (!fragment.is_sent) return marked("{fragment} is not sent to GL: the method found another surface here.");
    if (!fragment.depth.test)
        return marked("{fragment}: the depth test is off, so the color is replaced but the depth is not.");
    const int effect = !fragment.passes ? 0 : 1 + (fragment.drawn ? 0 : 1) + (fragment.depth.write ? 0 : 2);
    if (fragment.decided_by_rounding) return by_rounding[effect];
    if (fragment.passes || asks_nothing(fragment.depth.func)) return by_compare[effect];
    return fragment.tie ? marked("{fragment}: {compare} is false (a tie), so the pixel is unchanged.")
                        : marked("{fragment}: {compare} is false, so the pixel is unchanged.");
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
    static constexpr auto relations = per_enum<CompareFunc>("", " < ", " = ", " ≤ ", " > ", " ≠ ", " ≥ ", "");
    if (asks_nothing(func)) return gl_name(func);
    const Pair pair =
        precision.is_float ? float_pair(incoming, stored) : Pair{grouped_number(incoming), grouped_number(stored)};
    return pair.incoming + relations[func] + pair.stored;
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
    return message(fmt::runtime(decision_of(fragment)), "fragment"_a = fragment_name(fragment),
                   "compare"_a = compare_text(fragment.depth.func, fragment.stored, fragment.compared_with, precision));
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
        if (fragments[i].drawn) return i;
    return -1;
}

}  // namespace viewing
