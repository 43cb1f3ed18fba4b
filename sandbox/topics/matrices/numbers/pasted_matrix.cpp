#include "topics/matrices/numbers/pasted_matrix.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>
#include <vector>

#include "frame/matrix_facts.h"
#include "text/numbers.h"
#include "text/words.h"

namespace viewing {
namespace {

bool has(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

bool is_word(char sign) {
    return std::isalnum(static_cast<unsigned char>(sign)) != 0 || sign == '_';
}

/// Removes comments: from //, # or MATLAB's % to the end of the line, and between /* and */.
std::string without_comments(std::string_view text) {
    std::string kept;
    for (std::size_t at = 0; at < text.size();) {
        const std::string_view rest = text.substr(at);
        if (rest.starts_with("/*")) {
            at = std::min(text.find("*/", at), text.size() - 2) + 2;
        } else if (rest.starts_with("//") || rest.front() == '#' || rest.front() == '%') {
            at = std::min(text.find('\n', at), text.size());
        } else {
            kept += text[at++];
        }
    }
    return kept;
}

std::vector<std::string> words_in(std::string_view text) {
    std::vector<std::string> words;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const std::size_t begin = at;
        while (at < text.size() && is_word(text[at])) ++at;
        if (at > begin) words.emplace_back(text.substr(begin, at - begin));
    }
    return words;
}

/// Returns the letter of the matrix that the words before the numbers name; 0 if they name none.
char letter_in(std::string_view front) {
    static constexpr std::pair<std::string_view, char> names[] = {{"view_from_world", 'V'},
                                                                  {"world_from_view", 'C'},
                                                                  {"clip_from_view", 'P'},
                                                                  {"shadow_from_world", 'S'},
                                                                  {"mirror_from_world", 'R'},
                                                                  {"view", 'V'},
                                                                  {"camera", 'C'},
                                                                  {"projection", 'P'},
                                                                  {"proj", 'P'},
                                                                  {"shadow", 'S'},
                                                                  {"mirror", 'R'},
                                                                  {"reflection", 'R'}};
    char letter = 0;
    for (const std::string& word : words_in(front)) {
        if (word.size() == 1 && has("VCPSR", word)) letter = word.front();
        const std::string small = in_lower_case(word);
        for (const auto& [name, its] : names)
            if (small == name || small == std::string(name) + "matrix") letter = its;
    }
    return letter;
}

/// A number with a decimal point, as it is written.
struct Written {
    int digits = 0;  ///< significant ones
    int decimals = 0;
    bool has_exponent = false;
};

std::vector<Written> written_numbers(std::string_view text) {
    const auto is_digit = [text](std::size_t at) {
        return at < text.size() && std::isdigit(static_cast<unsigned char>(text[at])) != 0;
    };
    std::vector<Written> numbers;
    for (std::size_t point = text.find('.'); point != std::string_view::npos; point = text.find('.', point + 1)) {
        std::size_t begin = point, end = point + 1;
        while (begin > 0 && is_digit(begin - 1)) --begin;
        while (is_digit(end)) ++end;
        if (end == point + 1) continue;
        Written number;
        for (std::size_t at = begin; at < end; ++at)
            if (is_digit(at) && (number.digits > 0 || text[at] != '0')) ++number.digits;
        number.decimals = static_cast<int>(end - point - 1);
        number.has_exponent = end < text.size() && (text[end] == 'e' || text[end] == 'E');
        numbers.push_back(number);
    }
    return numbers;
}

/// Returns half a unit in the last place, to which the least exact entry is known. Numbers are printed either with the
/// same number of decimals or, as C++ streams do, with the same number of significant digits; in both cases, zeros at
/// the end may be left out. The way that explains the text with fewer such zeros counts.
double written_tolerance(std::string_view text, const glm::dmat4& matrix) {
    constexpr double least = 1e-9, most = 5.1e-3;
    const std::vector<Written> numbers = written_numbers(text);
    int decimals = 0, digits = 0;
    for (const Written& number : numbers) {
        if (!number.has_exponent) decimals = std::max(decimals, number.decimals);
        digits = std::max(digits, number.digits);
    }
    if (digits == 0) return least;
    const auto without_decimals = std::count_if(numbers.begin(), numbers.end(), [&](const Written& number) {
        return number.has_exponent || number.decimals < decimals;
    });
    const auto without_digits = std::count_if(numbers.begin(), numbers.end(), [&](const Written& number) {
        return number.digits > 0 && number.digits < digits;
    });
    const double largest = largest_entry(matrix);
    const double last_place = without_digits <= without_decimals && largest > 0.0
                                  ? std::floor(std::log10(largest)) - digits + 1.0
                                  : -decimals;
    return std::clamp(0.51 * std::pow(10.0, last_place), least, most);
}

struct Syntax {
    const char* name;
    bool by_columns;
};

Syntax syntax_of(std::string_view text) {
    if (has(text, "mat4")) return {"GLM", true};
    if (has(text, "array(") || has(text, "matrix(")) return {"NumPy", false};
    if (has(text, "\\\\")) return {"LaTeX", false};
    if (has(text, "{") && !has(text, "\"")) return {"C array", true};
    const std::size_t open = text.find('[');
    if (open == std::string_view::npos) return {"plain text", false};
    const std::string_view inside = text.substr(open);
    if (inside.find(';') < inside.find(']')) return {"MATLAB", false};
    const bool is_nested = inside.find('[', 1) < inside.find(']');
    if (!has(inside, ",")) return {is_nested ? "NumPy" : "MATLAB", false};
    return {"JSON", !is_nested};
}

/// The parts of a text that may be the matrix, the likeliest first.
std::vector<std::string_view> likely_parts(std::string_view text) {
    // Digits before the numbers, as in "GLfloat m[16] =", are not entries. A second assignment may follow, such as that
    // of shadow_sign; within the first, dtype=… may follow the numbers.
    const std::size_t equals = text.find('=');
    const std::string_view front = text.substr(0, equals),
                           body = equals == std::string_view::npos ? text : text.substr(equals + 1);
    std::vector<std::string_view> parts{body, body.substr(0, body.find('=')), front, text};
    // JSON with other members, and rows with sentences below them. A matrix is short, and not far from the beginning.
    constexpr std::size_t searched = 1 << 14, longest = 1 << 11;
    const std::string_view near = text.substr(0, searched);
    for (std::size_t open = near.find_first_of("[({"); open != std::string_view::npos;
         open = near.find_first_of("[({", open + 1)) {
        int depth = 0;
        for (std::size_t at = open; at < std::min(open + longest, text.size()); ++at) {
            if (has("[({", text.substr(at, 1))) ++depth;
            if (has("])}", text.substr(at, 1)) && --depth == 0) {
                parts.push_back(text.substr(open, at + 1 - open));
                break;
            }
        }
    }
    std::vector<std::size_t> rows;  // where lines with four numbers begin, in an unbroken sequence
    for (std::size_t begin = 0; begin < near.size();) {
        const std::size_t end = std::min(near.find('\n', begin), near.size());
        if (numbers_in(near.substr(begin, end - begin)).size() != 4)
            rows.clear();
        else
            rows.push_back(begin);
        if (rows.size() >= 4) parts.push_back(text.substr(rows[rows.size() - 4], end - rows[rows.size() - 4]));
        begin = end + 1;
    }
    return parts;
}

/// Returns the factor that MATLAB prints before the entries of a matrix, as in "1.0e+03 *"; 1 if there is none.
double common_factor(std::string_view front) {
    const std::size_t star = front.find_last_not_of(" \t\r\n");
    if (star == std::string_view::npos || front[star] != '*') return 1.0;
    const std::vector<double> numbers = numbers_in(front.substr(0, star));
    return numbers.empty() ? 1.0 : numbers.back();
}

/// Says why a text does not contain 16 numbers, as far as the text shows it.
Error wrong_count(std::string_view text) {
    const std::size_t count = numbers_in(text).size();
    std::string error =
        "a matrix has 16 numbers, but there " + std::string(count == 1 ? "is " : "are ") + std::to_string(count);
    const std::vector<std::string> words = words_in(in_lower_case(std::string(text)));
    const auto is_there = [&](const char* word) { return std::find(words.begin(), words.end(), word) != words.end(); };
    int commas = 0;  // between digits
    for (std::size_t at = 1; at + 1 < text.size(); ++at)
        commas += text[at] == ',' && std::isdigit(static_cast<unsigned char>(text[at - 1])) != 0 &&
                          std::isdigit(static_cast<unsigned char>(text[at + 1])) != 0
                      ? 1
                      : 0;
    if (is_there("nan") || is_there("inf")) return Error{error + "; nan and inf are none"};
    if (count == 32 && commas >= 16) return Error{error + "; write decimals with a point instead of a comma"};
    if (count > 16) error += "; leave out indices and labels";
    return Error{error};
}

}  // namespace

Result<PastedMatrix> read_pasted_matrix(std::string_view text) {
    const std::string plain = without_comments(text);
    const Syntax syntax = syntax_of(plain);
    const std::string_view whole = plain;
    std::vector<double> numbers;
    std::string_view entries;
    for (const std::string_view part : likely_parts(whole)) {
        entries = part;
        numbers = numbers_in(part);
        if (numbers.size() == 16) break;
    }
    if (numbers.size() != 16) return wrong_count(whole);
    const std::size_t begin = static_cast<std::size_t>(entries.data() - whole.data());
    const double factor = common_factor(whole.substr(0, begin));
    PastedMatrix pasted;
    for (int i = 0; i < 16; ++i) {
        const double number = factor * numbers[i];
        if (!std::isfinite(number)) return Error{"every entry must be a finite number"};
        (syntax.by_columns ? pasted.matrix[i / 4][i % 4] : pasted.matrix[i % 4][i / 4]) = number;
    }
    pasted.syntax = syntax.name;
    pasted.by_columns = syntax.by_columns;
    pasted.letter = letter_in(begin == 0 ? whole.substr(0, whole.find('=')) : whole.substr(0, begin));
    pasted.tolerance = written_tolerance(entries, pasted.matrix);
    pasted.has_more = numbers_in(whole.substr(begin + entries.size())).size() >= 16;
    return pasted;
}

}  // namespace viewing
