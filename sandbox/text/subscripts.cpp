#include "text/subscripts.h"

namespace viewing {
namespace {

bool is_small(char sign) {
    return sign >= 'a' && sign <= 'z';
}

bool is_in_name(char sign) {
    return is_small(sign) || (sign >= 'A' && sign <= 'Z') || (sign >= '0' && sign <= '9') || sign == '_';
}

/// Returns the length of the subscript after the underscore at `at`; 0 if the underscore belongs to a name.
std::size_t subscript_length(std::string_view text, std::size_t at) {
    constexpr std::size_t longest = 4;
    constexpr std::string_view script_l = "ℓ";
    const auto is_letter = [](char sign) { return is_in_name(sign) && sign != '_' && !(sign >= '0' && sign <= '9'); };
    const std::string_view before = text.substr(0, at);
    const std::size_t letter = before.ends_with(script_l) ? script_l.size() : 1;
    if (at == 0 || (letter == 1 && !is_letter(text[at - 1])) || (at > letter && is_in_name(text[at - letter - 1])))
        return 0;
    std::size_t end = at + 1;
    while (end < text.size() && is_small(text[end])) ++end;
    const bool goes_on = end < text.size() && is_in_name(text[end]);
    return goes_on || end - at - 1 > longest ? 0 : end - at - 1;
}

}  // namespace

std::vector<TextPart> subscript_parts(std::string_view text) {
    std::vector<TextPart> parts;
    std::size_t begin = 0;
    for (std::size_t at = text.find('_'); at != std::string_view::npos; at = text.find('_', at + 1)) {
        const std::size_t length = subscript_length(text, at);
        if (length == 0) continue;
        parts.push_back({text.substr(begin, at - begin)});
        parts.push_back({text.substr(at + 1, length), true});
        begin = at + 1 + length;
    }
    if (begin < text.size()) parts.push_back({text.substr(begin)});
    return parts;
}

}  // namespace viewing
