#include "text/words.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>

#include <fmt/format.h>

#include "text/numbers.h"

namespace viewing {
namespace {

struct Character {
    std::optional<char32_t> code_point;  ///< none if the bytes are not valid UTF-8
    std::size_t bytes = 1;
};

/// Returns the first character of a nonempty text.
Character character_at(std::string_view text) {
    const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char lead = byte(0);
    if (lead < 0x80) return {lead, 1};
    const std::size_t count = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
    if (lead < 0xc2 || lead > 0xf4 || text.size() < count) return {};
    char32_t code_point = lead & (0xffU >> (count + 1));
    for (std::size_t i = 1; i < count; ++i) {
        if (!continues_character(text[i])) return {};
        code_point = (code_point << 6U) | (byte(i) & 0x3fU);
    }
    return {code_point, count};
}

/// Whether a character is a C0 or C1 control, a line separator, a noncharacter, or a character that changes the writing
/// direction or has no width (except the two joiners that scripts need).
bool is_deceptive(char32_t c) {
    return c < 0x20 || (c >= 0x7f && c < 0xa0) || c == 0x00ad || c == 0x061c || c == 0x200b || c == 0x200e ||
           c == 0x200f || (c >= 0x2028 && c <= 0x202e) || (c >= 0x2060 && c <= 0x2069) || c == 0xfeff ||
           (c & 0xfffeU) == 0xfffeU;
}

/// Returns the start of the character at or before this position.
std::size_t begin_of_character(std::string_view text, std::size_t at) {
    while (at > 0 && at < text.size() && continues_character(text[at])) {
        --at;
    }
    return at;
}

}  // namespace

std::size_t character_count(std::string_view text) {
    return text.size() - static_cast<std::size_t>(std::count_if(text.begin(), text.end(), continues_character));
}

void remove_last_character(std::string& text) {
    while (!text.empty() && continues_character(text.back())) {
        text.pop_back();
    }
    if (!text.empty()) {
        text.pop_back();
    }
}

std::string printable(std::string_view text) {
    std::string shown;
    for (std::size_t at = 0; at < text.size();) {
        const Character character = character_at(text.substr(at));
        const std::string_view bytes = text.substr(at, character.bytes);
        if (!character.code_point)
            shown += fmt::format("\\x{:02x}", static_cast<unsigned char>(bytes.front()));
        else if (is_deceptive(*character.code_point))
            shown += fmt::format("\\u{:04x}", static_cast<unsigned>(*character.code_point));
        else
            shown += bytes;
        at += character.bytes;
    }
    return shown;
}

bool is_utf8(std::string_view text) {
    for (std::size_t at = 0; at < text.size();) {
        const Character character = character_at(text.substr(at));
        if (!character.code_point) return false;
        at += character.bytes;
    }
    return true;
}

std::string excerpt(std::string_view text) {
    constexpr std::size_t longest = 20;
    std::size_t end = 0;
    for (std::size_t count = 0; end < text.size() && count < longest; ++count)
        end += character_at(text.substr(end)).bytes;
    return printable(text.substr(0, end)) + (end < text.size() ? "…" : "");
}

std::string without_middle(std::string_view text, std::size_t most_bytes) {
    if (text.size() <= most_bytes) return std::string(text);
    const std::size_t begin = begin_of_character(text, most_bytes / 2),
                      end = begin_of_character(text, text.size() - most_bytes / 2);
    return std::string(text.substr(0, begin)) + " … " + std::string(text.substr(end));
}

std::string one_line(std::string_view text) {
    const std::size_t length = begin_of_character(text, std::min<std::size_t>(text.size(), 200));
    return printable(text.substr(0, length)) + (length < text.size() ? "…" : "");
}

std::string counted(std::int64_t count, const std::string& one, const std::string& many) {
    return grouped_number(count) + ' ' + (count == 1 ? one : many.empty() ? one + "s" : many);
}

std::string in_lines(const std::string& text, std::size_t width, const std::string& first, std::size_t indent) {
    std::istringstream words(text);
    std::string result, begin = first, line;
    for (std::string word; words >> word;) {
        if (!line.empty() && character_count(begin) + character_count(line) + 1 + character_count(word) > width) {
            result += begin + line + "\n";
            begin.assign(indent, ' ');
            line.clear();
        }
        line += (line.empty() ? "" : " ") + word;
    }
    return result + begin + line + "\n";
}

std::string_view unbroken_start(std::string_view text) {
    static constexpr std::string_view signs[] = {"=", "+", "−", "/", "×", "÷", "<", ">", "≤", "≥", "≈", "≠", "≪", "≫"};
    const auto is_sign = [](std::string_view word) {
        return std::find(std::begin(signs), std::end(signs), word) != std::end(signs);
    };
    std::size_t end = std::min(text.find(' '), text.size());
    bool ends_with_sign = is_sign(text.substr(0, end));
    while (end < text.size()) {
        const std::size_t next = std::min(text.find(' ', end + 1), text.size());
        const bool next_is_sign = is_sign(text.substr(end + 1, next - end - 1));
        if (!ends_with_sign && !next_is_sign) break;
        end = next;
        ends_with_sign = next_is_sign;
    }
    return text.substr(0, end);
}

std::string in_lower_case(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

std::string percent_encoded(char byte) {
    return fmt::format("%{:02X}", static_cast<unsigned char>(byte));
}

std::vector<std::string> split_outside_brackets(std::string_view text, char sign) {
    std::vector<std::string> parts(1);
    int depth = 0;
    bool is_quoted = false;
    for (const char c : text) {
        if (c == '"') is_quoted = !is_quoted;
        if (!is_quoted && (c == '[' || c == '{')) ++depth;
        if (!is_quoted && (c == ']' || c == '}')) --depth;
        if (c == sign && depth == 0 && !is_quoted)
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

namespace {

template <typename Parts, typename Text>
std::string joined_parts(const Parts& parts, const Text& text) {
    std::string all;
    for (const auto& part : parts) all += (all.empty() ? "" : ", ") + text(part);
    return all;
}

}  // namespace

std::string joined(std::span<const char* const> names) {
    return joined_parts(names, [](const char* name) { return std::string(name); });
}

std::string joined(std::span<const std::string> names) {
    return joined_parts(names, [](const std::string& name) { return name; });
}

std::string joined(std::span<const int> numbers) {
    return joined_parts(numbers, [](int number) { return std::to_string(number); });
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
    constexpr std::size_t longest = 64;
    a = a.substr(0, longest);
    b = b.substr(0, longest);
    std::array<std::array<std::size_t, longest + 1>, longest + 1> cost;
    for (std::size_t i = 0; i <= a.size(); ++i) {
        for (std::size_t j = 0; j <= b.size(); ++j) {
            if (i == 0 || j == 0) {
                cost[i][j] = i + j;
                continue;
            }
            const bool same = a[i - 1] == b[j - 1];
            cost[i][j] = std::min({cost[i - 1][j] + 1, cost[i][j - 1] + 1, cost[i - 1][j - 1] + (same ? 0 : 1)});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                cost[i][j] = std::min(cost[i][j], cost[i - 2][j - 2] + 1);
            }
        }
    }
    return cost[a.size()][b.size()];
}

bool is_near(std::size_t distance, std::size_t word_length) {
    return word_length > 1 && distance <= std::clamp<std::size_t>(word_length / 2, 1, 3);
}

std::optional<std::string> nearest_name(std::string_view word, std::span<const std::string> candidates) {
    const auto distance = [word](const std::string& candidate) { return edit_distance(word, candidate); };
    const auto best =
        std::min_element(candidates.begin(), candidates.end(),
                         [&](const std::string& a, const std::string& b) { return distance(a) < distance(b); });
    if (best == candidates.end() || !is_near(distance(*best), word.size())) {
        return std::nullopt;
    }
    return *best;
}

std::string suggestion(std::string_view word, std::span<const std::string> candidates) {
    const std::optional<std::string> nearest = nearest_name(word, candidates);
    return nearest ? "; did you mean " + *nearest + "?" : "";
}

}  // namespace viewing
