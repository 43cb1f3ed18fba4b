// Numbers as characters, one function for each way in which the program writes them. For a person: a real minus sign,
// digits in groups, 1.2·10⁻⁷. For code and files: what compilers and JSON read. What may be typed for a number stands
// with the widgets (ParseNumber).
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace viewing {

// ---- for a person --------------------------------------------------------------------------------------------------

/// Fixed decimals (0 … 17), never "−0.000"; "—" for NaN, "∞" for infinity. From 10⁶ on, and where the decimals would
/// show nothing of it, as 1.234·10⁶, 7.5·10⁻⁶; below 10⁻⁹ it is a rounding residue: 0.000.
std::string number_text(double value, int decimals);

/// So many significant digits, without zeros at the end, as in a sentence: "0.25", "−3500", "1.2·10⁻⁷", "∞".
std::string figures(double value, int digits = 2);

/// Three significant digits, zeros at the end kept so that a moving value does not jump: "4.00", "12.5", "12,300",
/// "1.20·10⁻⁷", and plainly "0".
std::string steady_figures(double value);

/// A share as "12.5 %"; what would be rounded to nothing or to all without being it is "< 0.1 %", "> 99.9 %".
std::string percent(double share, int decimals = 1);

/// A count: "12,345".
std::string grouped_number(std::int64_t number);

/// A whole number raised: 24 → "²⁴", −5 → "⁻⁵".
std::string raised_text(int value);

/// Indices lowered: "₁₂" for 1 and 2.
std::string lowered_text(std::initializer_list<std::size_t> indices);

// ---- for code and files --------------------------------------------------------------------------------------------

/// The shortest decimal that reads back to exactly `value`, as JSON takes it: "0.5", "-0.0", "40000", "1e6".
std::string format_number(double value);

/// The same as C, Python and CSV have it, at times with an exponent of two digits: "0.5", "-0", "1e-05", "inf".
std::string shortest_number(double value);

/// A colour: "#e4572e".
std::string hex_color(std::uint8_t red, std::uint8_t green, std::uint8_t blue);

/// Fixed decimals with the keyboard's minus: "-0.500".
std::string plain_decimals(double value, int decimals);

/// What a text field starts with: the shortest digits that read back to the same value, in signs that a keyboard has.
std::string plain_number(double value);

/// A whole text as one finite number with a point, whatever the locale: "1e-3", "-.5". Blanks and a leading "+" are
/// refused.
std::optional<double> parse_double(std::string_view text);

/// All numbers of a text in their order, whatever stands between them: "array([[1., -2e-3], [3, 4]], dtype=float64)",
/// "[1 2; 3 4]", "1 & 1/3 \\\\". A minus may be the real one; 1/3 is a quotient; digits in a word are none. At most
/// 1000.
std::vector<double> numbers_in(std::string_view text);

// ---- where room is short -------------------------------------------------------------------------------------------

/// A number in characters, UTF-8, with a real minus; on the stack, since tables write hundreds in a frame.
struct NumberChars {
    char data[48];
    int bytes = 0;
    int columns = 0;  ///< characters

    std::string_view view() const { return {data, static_cast<std::size_t>(bytes)}; }
    void append(std::string_view text);
};

/// What becomes of a magnitude too small for the decimals: 0.00, or 4.00·10⁻⁵ if it is no rounding residue.
enum class Tiny { zero, exponent };
/// What number_text writes, with a choice.
NumberChars number_chars(double value, int decimals, Tiny tiny);
/// The same with at most so many characters: fewer decimals, then without the unit, then 1.2·10⁵, then 1.2e5.
NumberChars fitted_number(double value, int decimals, Tiny tiny, std::string_view unit, int columns);

}  // namespace viewing
