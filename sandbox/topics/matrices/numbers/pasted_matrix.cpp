#include "topics/matrices/numbers/pasted_matrix.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>
#include <vector>

#include "text/numbers.h"

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
    for (std::size_t at = 0; at < front.size();) {
        std::size_t end = at;
        while (end < front.size() && is_word(front[end])) ++end;
        std::string word(front.substr(at, end - at));
        if (word.size() == 1 && has("VCPSR", word)) letter = word.front();
        std::transform(word.begin(), word.end(), word.begin(),
                       [](unsigned char sign) { return static_cast<char>(std::tolower(sign)); });
        for (const auto& [name, its] : names)
            if (word == name || word == std::string(name) + "matrix") letter = its;
        at = std::max(end, at + 1);
    }
    return letter;
}

/// Returns half a unit in the last place of the number with the most decimals.
double written_tolerance(std::string_view text) {
    std::size_t most = 0;
    for (std::size_t at = text.find('.'); at != std::string_view::npos; at = text.find('.', at + 1)) {
        std::size_t end = at + 1;
        while (end < text.size() && std::isdigit(static_cast<unsigned char>(text[end])) != 0) ++end;
        most = std::max(most, end - at - 1);
    }
    return most == 0 ? 1e-9 : std::clamp(0.51 * std::pow(10.0, -static_cast<double>(most)), 1e-9, 5.1e-3);
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

}  // namespace

Result<PastedMatrix> read_pasted_matrix(std::string_view text) {
    const std::string plain = without_comments(text);
    const Syntax syntax = syntax_of(plain);
    // Digits before the numbers, as in "GLfloat m[16] =", are not entries.
    const std::size_t equals = plain.find('=');
    const std::string_view whole = plain, front = whole.substr(0, equals);
    const std::string_view body = equals == std::string::npos ? whole : whole.substr(equals + 1);
    std::vector<double> numbers = numbers_in(body);
    // A second assignment may follow, such as that of shadow_sign; within the first, dtype=… may follow the numbers.
    if (numbers.size() != 16) numbers = numbers_in(body.substr(0, body.find('=')));
    if (numbers.size() != 16) numbers = numbers_in(front);
    if (numbers.size() != 16) numbers = numbers_in(whole);
    if (numbers.size() != 16)
        return Error{"a matrix has 16 numbers, but there " + std::string(numbers.size() == 1 ? "is " : "are ") +
                     std::to_string(numbers.size())};
    PastedMatrix pasted;
    for (int i = 0; i < 16; ++i) {
        const double number = numbers[i];
        if (!std::isfinite(number)) return Error{"every entry must be a finite number"};
        (syntax.by_columns ? pasted.matrix[i / 4][i % 4] : pasted.matrix[i % 4][i / 4]) = number;
    }
    pasted.syntax = syntax.name;
    pasted.by_columns = syntax.by_columns;
    pasted.letter = letter_in(front);
    pasted.tolerance = written_tolerance(whole);
    return pasted;
}

}  // namespace viewing
