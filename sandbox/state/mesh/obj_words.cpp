#include "state/mesh/obj_words.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "text/words.h"

namespace viewing {

namespace {

bool take(char c, std::string_view& word) {
    if (word.empty() || word.front() != c) return false;
    word.remove_prefix(1);
    return true;
}

/// Removes a sign from the front of a word; returns whether it is a minus.
bool take_sign(std::string_view& word) {
    const bool is_negative = take('-', word);
    if (!is_negative) take('+', word);
    return is_negative;
}

struct Keyword {
    std::string_view word;
    Statement statement;
};

/// The keywords of Wavefront's format, most frequent first.
constexpr Keyword keywords[] = {
    {"v", Statement::position},       {"f", Statement::face},          {"vn", Statement::normal},
    {"vt", Statement::numbers},       {"s", Statement::smoothing},     {"l", Statement::line},
    {"p", Statement::point},          {"g", Statement::names},         {"o", Statement::names},
    {"usemtl", Statement::names},     {"mtllib", Statement::names},    {"fo", Statement::face},
    {"vp", Statement::numbers},       {"mg", Statement::numbers},      {"cstype", Statement::numbers},
    {"deg", Statement::numbers},      {"bmat", Statement::numbers},    {"step", Statement::numbers},
    {"curv", Statement::surface},     {"curv2", Statement::numbers},   {"surf", Statement::surface},
    {"parm", Statement::numbers},     {"trim", Statement::numbers},    {"hole", Statement::numbers},
    {"scrv", Statement::numbers},     {"sp", Statement::numbers},      {"end", Statement::numbers},
    {"con", Statement::numbers},      {"bevel", Statement::names},     {"c_interp", Statement::names},
    {"d_interp", Statement::names},   {"lod", Statement::numbers},     {"usemap", Statement::names},
    {"maplib", Statement::names},     {"ctech", Statement::numbers},   {"stech", Statement::numbers},
    {"shadow_obj", Statement::names}, {"trace_obj", Statement::names},
};

}  // namespace

std::string_view without_comment(std::string_view line) {
    std::size_t end = line.find('#');
    while (end != std::string_view::npos && end > 0 && line[end - 1] == '.') end = line.find('#', end + 1);
    return line.substr(0, end);
}

std::string_view next_word(std::string_view& line) {
    std::size_t begin = 0;
    while (begin < line.size() && is_space(line[begin])) {
        ++begin;
    }
    std::size_t end = begin;
    while (end < line.size() && !is_space(line[end])) {
        ++end;
    }
    const std::string_view word = line.substr(begin, end - begin);
    line.remove_prefix(end);
    return word;
}

std::string_view take_digits(std::string_view& word) {
    std::size_t end = 0;
    while (end < word.size() && is_digit(word[end])) ++end;
    const std::string_view digits = word.substr(0, end);
    word.remove_prefix(end);
    return digits;
}

std::optional<double> number_of(std::string_view word) {
    constexpr double all_digits_held = 1e18;  // beyond this, further digits change nothing
    const bool is_negative = take_sign(word);
    double digits_value = 0.0;
    int power_of_ten = 0;
    const std::string_view whole = take_digits(word);
    for (const char digit : whole)
        if (digits_value < all_digits_held)
            digits_value = 10.0 * digits_value + (digit - '0');
        else
            ++power_of_ten;
    std::string_view decimals;
    if (take('.', word)) decimals = take_digits(word);
    for (const char digit : decimals) {
        if (digits_value >= all_digits_held) break;
        digits_value = 10.0 * digits_value + (digit - '0');
        --power_of_ten;
    }
    if (whole.empty() && decimals.empty()) return std::nullopt;
    if (take('e', word) || take('E', word)) {
        const bool divides = take_sign(word);
        const std::string_view digits = take_digits(word);
        if (digits.empty()) return std::nullopt;
        constexpr int beyond_all = 9999;
        int exponent = 0;
        for (const char digit : digits) exponent = std::min(10 * exponent + (digit - '0'), beyond_all);
        power_of_ten += divides ? -exponent : exponent;
    }
    if (!word.empty()) return std::nullopt;
    if (is_negative) digits_value = -digits_value;
    if (digits_value == 0.0) return digits_value;
    constexpr int held = 300;  // 10^300 still fits into a double
    for (; power_of_ten < -held; power_of_ten += held) digits_value /= 1e300;
    return power_of_ten < 0 ? digits_value / std::pow(10.0, -power_of_ten)
                            : digits_value * std::pow(10.0, power_of_ten);
}

bool is_no_finite_number(std::string_view word) {
    take_sign(word);
    const std::string lower = in_lower_case(std::string(word.substr(0, 8)));
    return lower.starts_with("nan") || lower.starts_with("inf") || lower.find(".#") != std::string::npos;
}

std::optional<NamedCorner> corner_of(std::string_view word) {
    constexpr std::size_t most_digits = 9;
    NamedCorner corner;
    for (int part = 0; part < 3; ++part) {
        const bool is_negative = take('-', word);
        const std::string_view digits = take_digits(word);
        if (digits.empty() && (part == 0 || is_negative)) return std::nullopt;
        if (part != 1) {
            if (digits.size() > most_digits) return std::nullopt;
            int index = 0;
            for (const char digit : digits) index = 10 * index + (digit - '0');
            (part == 0 ? corner.position : corner.normal) = is_negative ? -index : index;
        }
        if (word.empty()) return corner;
        if (!take('/', word)) return std::nullopt;
    }
    return std::nullopt;
}

std::optional<Statement> statement_of(std::string_view keyword) {
    const auto* const found = std::find_if(std::begin(keywords), std::end(keywords),
                                           [keyword](const Keyword& known) { return known.word == keyword; });
    return found == std::end(keywords) ? std::nullopt : std::optional(found->statement);
}

const char* foreign_encoding(std::string_view beginning) {
    using namespace std::string_view_literals;
    if (beginning.starts_with("\xff\xfe\0\0"sv) || beginning.starts_with("\0\0\xfe\xff"sv)) return "UTF-32";
    if (beginning.starts_with("\xff\xfe"sv) || beginning.starts_with("\xfe\xff"sv)) return "UTF-16";
    const auto is_zero = [&](std::size_t place) { return beginning[place] == '\0'; };
    const bool alternates =
        beginning.size() >= 4 && is_zero(0) == is_zero(2) && is_zero(1) == is_zero(3) && is_zero(0) != is_zero(1);
    return alternates ? "UTF-16" : nullptr;
}

}  // namespace viewing
