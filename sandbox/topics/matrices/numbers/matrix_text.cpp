#include "topics/matrices/numbers/matrix_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "text/numbers.h"

namespace viewing {
namespace {

/// The sixteen entries as strings in listing order: rows first or columns first.
using Entries = std::array<std::array<std::string, 4>, 4>;

/// A language's notation for NaN and infinity.
struct Specials {
    const char* nan;
    const char* infinity;
    const char* minus_infinity;
};

/// A language's notation for numbers and lists.
struct Notation {
    Specials specials;
    bool columns_first = false;
    bool needs_point = false;  ///< "1.0", since "1" is an integer in C, GLSL and Python
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

std::string digits_of(double value, const Notation& notation) {
    if (std::isnan(value)) return notation.specials.nan;
    if (std::isinf(value)) return value > 0.0 ? notation.specials.infinity : notation.specials.minus_infinity;
    const double without_negative_zero = value + 0.0;
    std::string text = shortest_number(without_negative_zero);
    if (notation.needs_point && text.find_first_of(".e") == std::string::npos) text += ".0";
    return text;
}

/// Writes 1e-05 as 1 \cdot 10^{-5}, since LaTeX has no exponent notation for numbers.
std::string with_power_of_ten(const std::string& number) {
    const std::size_t e = number.find('e');
    if (e == std::string::npos) return number;
    return number.substr(0, e) + R"( \cdot 10^{)" + std::to_string(std::stoi(number.substr(e + 1))) + "}";
}

/// Collects `entry(row, column)` in listing order.
template <typename Entry>
Entries entries_of(const Notation& notation, const Entry& entry) {
    Entries entries;
    for (std::size_t line = 0; line < 4; ++line)
        for (std::size_t place = 0; place < 4; ++place)
            entries[line][place] = notation.columns_first ? entry(place, line) : entry(line, place);
    return entries;
}

/// Right-aligns the entries of each column.
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

/// Writes "S[2,1]" as S_{2,1}, and a word in upright type.
std::string latex_name(std::string_view name) {
    const std::size_t bracket = name.find('[');
    std::string letters, index;
    for (const char sign : name.substr(0, bracket)) {
        if (sign == '_') letters += '\\';
        letters += sign;
    }
    if (bracket != std::string_view::npos)
        index = "_{" + std::string(name.substr(bracket + 1, name.size() - bracket - 2)) + "}";
    return (letters.size() > 2 ? "\\mathrm{" + letters + "}" : letters) + index;
}

/// Writes "S[2,1]" as S_2_1.
std::string code_name(std::string_view name) {
    std::string code(name.substr(0, name.find(']')));
    std::replace_if(
        code.begin(), code.end(), [](char sign) { return sign == '[' || sign == ','; }, '_');
    return code;
}

const Notation& notation_of(MatrixFormat format) {
    switch (format) {
        case MatrixFormat::latex:
            return latex;
        case MatrixFormat::glm:
            return cpp;
        case MatrixFormat::glsl:
            return glsl;
        case MatrixFormat::numpy:
            return python;
        case MatrixFormat::matlab:
            return matlab;
        case MatrixFormat::text:
            break;
    }
    return plain;
}

std::string entries_text(std::string_view name, Entries entries, MatrixFormat format) {
    const std::string code = code_name(name);
    switch (format) {
        case MatrixFormat::text:
            align(entries);
            return std::string(name) + " =\n  " + joined(entries, "  ", "\n  ") + "\n";
        case MatrixFormat::latex:
            return latex_name(name) + " =\n\\begin{bmatrix}\n    " + joined(entries, " & ", " \\\\\n    ") +
                   "\n\\end{bmatrix}\n";
        case MatrixFormat::glm:
            return constructor_text("const glm::dmat4 " + code, entries);
        case MatrixFormat::glsl:
            return constructor_text("const mat4 " + code + " = mat4", entries);
        case MatrixFormat::numpy: {
            const std::string opening = code + " = np.array([";
            const std::string indent = "],\n" + std::string(opening.size(), ' ') + "[";
            return opening + "[" + joined(entries, ", ", indent) + "]])\n";
        }
        case MatrixFormat::matlab: {
            const std::string opening = code + " = [";
            const std::string indent = ";\n" + std::string(opening.size(), ' ');
            return opening + joined(entries, ", ", indent) + "];\n";
        }
    }
    return {};
}

std::string digits_in(MatrixFormat format, double value) {
    const std::string digits = digits_of(value, notation_of(format));
    return format == MatrixFormat::latex ? with_power_of_ten(digits) : digits;
}

}  // namespace

double rounded_to(double value, int digits) {
    if (digits == 0 || !std::isfinite(value)) return value;
    std::array<char, 64> text;
    const auto end = std::to_chars(text.begin(), text.end(), value, std::chars_format::scientific, digits - 1).ptr;
    return parse_double({text.data(), static_cast<std::size_t>(end - text.data())}).value_or(value);
}

std::string matrix_text(std::string_view name, const glm::dmat4& matrix, MatrixFormat format, int digits) {
    const auto entry = [&](std::size_t row, std::size_t column) {
        const double value = matrix[static_cast<glm::length_t>(column)][static_cast<glm::length_t>(row)];
        return digits_in(format, rounded_to(value, digits));
    };
    return entries_text(name, entries_of(notation_of(format), entry), format);
}

std::string matrix_text(std::string_view name, const MatrixSymbols& symbols, MatrixFormat format) {
    const auto entry = [&](std::size_t row, std::size_t column) {
        const std::string symbol = symbols[4 * row + column];
        if (format == MatrixFormat::text) return symbol;
        return format == MatrixFormat::latex ? symbol_as_latex(symbol) : symbol_as_code(symbol);
    };
    return entries_text(name, entries_of(notation_of(format), entry), format);
}

std::string number_text(std::string_view name, double value, MatrixFormat format, std::string_view remark) {
    const std::string is = " = " + digits_in(format, value), code = code_name(name), said(remark);
    switch (format) {
        case MatrixFormat::text:
            return std::string(name) + is + " (" + said + ")\n";
        case MatrixFormat::latex:
            return latex_name(name) + is + "\n";
        case MatrixFormat::glm:
            return "const double " + code + is + ";  // " + said + "\n";
        case MatrixFormat::glsl:
            return "const float " + code + is + ";  // " + said + "\n";
        case MatrixFormat::numpy:
            return code + is + "  # " + said + "\n";
        case MatrixFormat::matlab:
            return code + is + ";  % " + said + "\n";
    }
    return {};
}

}  // namespace viewing
