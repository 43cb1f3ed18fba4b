#include "frame/matrix_text.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "text/numbers.h"

namespace viewing {
namespace {

/// The sixteen entries as text, in the order in which they are listed: rows first or columns first.
using Entries = std::array<std::array<std::string, 4>, 4>;

/// How a language writes what has no digits.
struct Specials {
    const char* nan;
    const char* infinity;
    const char* minus_infinity;
};

/// How a language writes numbers and lists.
struct Notation {
    Specials specials;
    bool columns_first = false;
    bool needs_point = false;  ///< "1.0": in C and GLSL "1" is an integer
};

constexpr Notation plain{{"nan", "inf", "-inf"}, false, false};
constexpr Notation latex{{R"(\mathrm{NaN})", R"(\infty)", R"(-\infty)"}, false, false};
constexpr Notation cpp{{"std::numeric_limits<double>::quiet_NaN()", "std::numeric_limits<double>::infinity()",
                        "-std::numeric_limits<double>::infinity()"},
                       true,
                       true};
constexpr Notation glsl{
    {"uintBitsToFloat(0x7fc00000u)", "uintBitsToFloat(0x7f800000u)", "uintBitsToFloat(0xff800000u)"}, true, true};
constexpr Notation python{{"np.nan", "np.inf", "-np.inf"}, false, true};
constexpr Notation matlab{{"NaN", "Inf", "-Inf"}, false, false};

std::string number_text(double value, const Notation& notation) {
    if (std::isnan(value)) return notation.specials.nan;
    if (std::isinf(value)) return value > 0.0 ? notation.specials.infinity : notation.specials.minus_infinity;
    const double without_negative_zero = value + 0.0;
    std::string text = shortest_number(without_negative_zero);
    if (notation.needs_point && text.find_first_of(".e") == std::string::npos) text += ".0";
    return text;
}

/// LaTeX has no 1e-05: 1 \cdot 10^{-5}.
std::string with_power_of_ten(const std::string& number) {
    const std::size_t e = number.find('e');
    if (e == std::string::npos) return number;
    return number.substr(0, e) + R"( \cdot 10^{)" + std::to_string(std::stoi(number.substr(e + 1))) + "}";
}

Entries entries_of(const glm::dmat4& matrix, const Notation& notation) {
    Entries entries;
    for (glm::length_t line = 0; line < 4; ++line)
        for (glm::length_t place = 0; place < 4; ++place) {
            const double value = notation.columns_first ? matrix[line][place] : matrix[place][line];
            entries[static_cast<std::size_t>(line)][static_cast<std::size_t>(place)] = number_text(value, notation);
        }
    return entries;
}

/// All entries right-aligned to their column's width.
void align(Entries& entries) {
    for (std::size_t place = 0; place < 4; ++place) {
        std::size_t width = 0;
        for (const auto& line : entries) width = std::max(width, line[place].size());
        for (auto& line : entries) line[place].insert(0, width - line[place].size(), ' ');
    }
}

std::string joined(const Entries& entries, std::string_view between_places, std::string_view between_lines) {
    std::string text;
    for (std::size_t line = 0; line < 4; ++line)
        for (std::size_t place = 0; place < 4; ++place) {
            if (place > 0) text += between_places;
            if (place == 0 && line > 0) text += between_lines;
            text += entries[line][place];
        }
    return text;
}

std::string constructor_text(std::string_view opening, const Entries& entries) {
    return "// columns first\n" + std::string(opening) + "(\n    " + joined(entries, ", ", ",\n    ") + ");\n";
}

std::string latex_text(std::string_view name, Entries entries) {
    std::string escaped;
    for (const char letter : name) {
        if (letter == '_') escaped += '\\';
        escaped += letter;
    }
    for (auto& line : entries) std::transform(line.begin(), line.end(), line.begin(), with_power_of_ten);
    return "\\mathrm{" + escaped + "} =\n\\begin{bmatrix}\n    " + joined(entries, " & ", " \\\\\n    ") +
           "\n\\end{bmatrix}\n";
}

}  // namespace

std::string matrix_text(std::string_view name, const glm::dmat4& matrix, MatrixFormat format) {
    const std::string title(name);
    switch (format) {
        case MatrixFormat::text: {
            Entries entries = entries_of(matrix, plain);
            align(entries);
            return title + " =\n  " + joined(entries, "  ", "\n  ") + "\n";
        }
        case MatrixFormat::latex:
            return latex_text(name, entries_of(matrix, latex));
        case MatrixFormat::glm:
            return constructor_text("const glm::dmat4 " + title, entries_of(matrix, cpp));
        case MatrixFormat::glsl:
            return constructor_text("const mat4 " + title + " = mat4", entries_of(matrix, glsl));
        case MatrixFormat::numpy: {
            const std::string opening = title + " = np.array([";
            const std::string indent = "],\n" + std::string(opening.size(), ' ') + "[";
            return opening + "[" + joined(entries_of(matrix, python), ", ", indent) + "]])\n";
        }
        case MatrixFormat::matlab: {
            const std::string opening = title + " = [";
            const std::string indent = ";\n" + std::string(opening.size(), ' ');
            return opening + joined(entries_of(matrix, matlab), ", ", indent) + "];\n";
        }
    }
    return {};
}

}  // namespace viewing
