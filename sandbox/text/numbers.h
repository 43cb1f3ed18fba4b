// Numbers as text: one function for each way in which the program writes them. For people: a true minus sign, digits in
// groups, 1.2·10⁻⁷. For code and files: the form that compilers and JSON parsers read. The widgets define which numbers
// may be typed (ParseNumber).
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace viewing {

// ---- for people ----------------------------------------------------------------------------------------------------

/// Returns a number with a fixed number of decimals (0 … 17), never "−0.000"; "—" for NaN, "∞" for infinity. From 10⁶
/// on, or if all digits would be zero, writes 1.234·10⁶ or 7.5·10⁻⁶. A magnitude below 10⁻⁹ counts as a rounding
/// residue and is written without a power of ten: 0.000.
std::string number_text(double value, int decimals);

/// Returns a number with `digits` significant digits, without zeros at the end, for sentences: "0.25", "−3500",
/// "1.2·10⁻⁷", "∞".
std::string figures(double value, int digits = 2);

/// Returns numbers as figures() writes them, as a point or a plane: "(1, 4, 2)".
std::string figures_of(std::span<const double> numbers, int digits = 2);

/// Reads a number that figures() wrote; nothing for any other text, and for "∞" and "—".
std::optional<double> read_figures(std::string_view text);

/// Returns a number with three significant digits, or all digits before the point if there are more. Keeps zeros at the
/// end, so that a changing value does not jump: "4.00", "12.5", "12345", "1.20·10⁻⁷"; zero is "0".
std::string steady_figures(double value);

/// Returns a fraction as "12.5%". A positive fraction that would round to 0 becomes "< 0.1%", and a fraction below 1
/// that would round to 1 becomes "> 99.9%".
std::string percent(double share, int decimals = 1);

/// Returns a count with its digits in groups: "12,345".
std::string grouped_number(std::int64_t number);

/// Returns a whole number in superscript: 24 → "²⁴", −5 → "⁻⁵".
std::string raised_text(int value);

/// Returns indices in subscript: "₁₂" for 1 and 2.
std::string lowered_text(std::initializer_list<std::size_t> indices);

// ---- for code and files --------------------------------------------------------------------------------------------

/// Returns the shortest decimal that reads back to exactly `value`, as in JSON: "0.5", "-0.0", "40000", "1e6".
std::string format_number(double value);

/// Returns the shortest decimal that reads back to exactly `value`, as C, Python and CSV write it. An exponent has at
/// least two digits: "0.5", "-0", "1e-05", "inf".
std::string shortest_number(double value);

/// Returns a color as "#e4572e".
std::string hex_color(std::uint8_t red, std::uint8_t green, std::uint8_t blue);

/// Returns a number with a fixed number of decimals and an ASCII minus: "-0.500".
std::string plain_decimals(double value, int decimals);

/// Returns the initial content of a text field: the shortest digits that read back to the same value, in characters
/// that a keyboard can type.
std::string plain_number(double value);

/// Parses a whole text as one finite number with a decimal point, in any locale: "1e-3", "-.5". Refuses spaces and a
/// leading "+".
std::optional<double> parse_double(std::string_view text);

/// Returns all numbers in a text, in order, whatever is between them: "array([[1., -2e-3], [3, 4]], dtype=float64)",
/// "[1 2; 3 4]", "1 & 1/3 \\\\". The minus may be a true minus sign; 1/3 is a quotient; digits inside a word do not
/// count. Returns at most 1000 numbers.
std::vector<double> numbers_in(std::string_view text);

// ---- where space is short ------------------------------------------------------------------------------------------

/// A number in UTF-8 characters, with a true minus. It is kept on the stack, since tables write hundreds per frame.
struct NumberChars {
    char data[48];
    int bytes = 0;
    int columns = 0;  ///< characters

    std::string_view view() const { return {data, static_cast<std::size_t>(bytes)}; }
    void append(std::string_view text);
};

/// How to write a magnitude too small for the decimals: 0.00; 4.00·10⁻⁵ unless it is a rounding residue; or 4.00·10⁻⁵
/// however small it is.
enum class Tiny { zero, exponent, exact };
/// Writes the same as number_text, with a choice of how to write tiny numbers.
NumberChars number_chars(double value, int decimals, Tiny tiny);
/// Writes a number followed by `unit`, if possible in at most `columns` characters. To fit, drops decimals, then the
/// unit, then writes 1.2·10⁵, then 1.2e5.
NumberChars fitted_number(double value, int decimals, Tiny tiny, std::string_view unit, int columns);

}  // namespace viewing
