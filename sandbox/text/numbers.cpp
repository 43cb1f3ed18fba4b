#include "text/numbers.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <locale>
#include <sstream>

#include "text/words.h"

namespace viewing {

namespace {

constexpr std::string_view minus = "−";
constexpr int max_decimals = 17;
constexpr std::string_view power_of_ten = "·10";
constexpr std::string_view raised_minus = "⁻";
constexpr std::string_view raised_digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
constexpr double largest_fixed = 1e6;  ///< magnitudes from here on are written as 1.234·10⁶
constexpr double residue = 1e-9;       ///< smaller magnitudes come from rounding and are written as 0.000

/// The ways to write a number: 12.5, 1.25·10¹, or, if space is short, 1.25e1.
enum class Notation { fixed, power, compact };

/// to_chars writes 1.5e-05; the program writes 1.5·10⁻⁵.
void append_exponent(NumberChars& out, std::string_view exponent, Notation notation) {
    const bool compact = notation == Notation::compact;
    out.append(compact ? "e" : power_of_ten);
    if (exponent.front() == '-') out.append(compact ? minus : raised_minus);
    exponent.remove_prefix(1);
    while (exponent.size() > 1 && exponent.front() == '0') exponent.remove_prefix(1);
    for (const char digit : exponent) {
        out.append(compact ? std::string_view(&digit, 1) : raised_digits[digit - '0']);
    }
}

NumberChars written(double value, int decimals, Notation notation) {
    char raw[48];
    const auto format = notation == Notation::fixed ? std::chars_format::fixed : std::chars_format::scientific;
    const std::to_chars_result end = std::to_chars(raw, raw + sizeof raw, std::abs(value), format, decimals);
    const std::string_view digits(raw, static_cast<std::size_t>(end.ptr - raw));
    const bool shows_zero = digits.find_first_of("123456789") == std::string_view::npos;

    NumberChars out;
    if (value < 0.0 && !shows_zero) out.append(minus);
    const std::size_t exponent = digits.find('e');
    out.append(digits.substr(0, exponent));
    if (exponent != std::string_view::npos) append_exponent(out, digits.substr(exponent + 1), notation);
    return out;
}

}  // namespace

void NumberChars::append(std::string_view text) {
    for (const char byte : text) {
        if (bytes == static_cast<int>(sizeof data)) return;
        data[bytes++] = byte;
        if (!continues_character(byte)) ++columns;
    }
}

NumberChars number_chars(double value, int decimals, Tiny tiny) {
    decimals = std::clamp(decimals, 0, max_decimals);
    NumberChars out;
    if (std::isnan(value)) {
        out.append("—");
        return out;
    }
    if (std::isinf(value)) {
        if (value < 0.0) out.append(minus);
        out.append("∞");
        return out;
    }
    const double magnitude = std::abs(value);
    const bool vanishes = magnitude > 0.0 && magnitude < 0.5 * std::pow(10.0, -decimals);
    const bool counts = tiny == Tiny::exact || (tiny == Tiny::exponent && magnitude >= residue);
    const bool needs_power = magnitude >= largest_fixed || (vanishes && counts);
    return written(value, decimals, needs_power ? Notation::power : Notation::fixed);
}

NumberChars fitted_number(double value, int decimals, Tiny tiny, std::string_view unit, int columns) {
    decimals = std::clamp(decimals, 0, max_decimals);
    NumberChars suffix;
    suffix.append(unit);
    NumberChars out;
    for (int digits = decimals; digits >= 0; --digits) {
        out = number_chars(value, digits, tiny);
        if (out.columns + suffix.columns <= columns) {
            out.append(unit);
            return out;
        }
    }
    if (out.columns <= columns || !std::isfinite(value)) return out;
    for (const Notation notation : {Notation::power, Notation::compact}) {
        for (int digits = 3; digits >= 0; --digits) {
            out = written(value, digits, notation);
            if (out.columns <= columns) return out;
        }
    }
    return out;
}

std::string plain_number(double value) {
    const double magnitude = std::abs(value);
    const bool plain = value == 0.0 || (magnitude >= 1e-6 && magnitude < 10.0 * largest_fixed);
    char raw[32];
    const auto format = plain ? std::chars_format::fixed : std::chars_format::scientific;
    return std::string(raw, std::to_chars(raw, raw + sizeof raw, value, format).ptr);
}

std::string raised_text(int value) {
    std::string text;
    for (const char digit : std::to_string(value)) text += digit == '-' ? raised_minus : raised_digits[digit - '0'];
    return text;
}

std::string lowered_text(std::initializer_list<std::size_t> indices) {
    static constexpr std::string_view digits[] = {"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉"};
    std::string text;
    for (const std::size_t index : indices)
        for (const char digit : std::to_string(index)) text += digits[digit - '0'];
    return text;
}

std::string number_text(double value, int decimals) {
    return std::string(number_chars(value, decimals, Tiny::exponent).view());
}

std::string plain_decimals(double value, int decimals) {
    std::array<char, 384> text;  // the largest double has 309 digits before its point
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed,
                                   std::clamp(decimals, 0, max_decimals));
    return {text.data(), end.ptr};
}

namespace {

std::string without_zeros_at_end(std::string decimals) {
    if (decimals.find('.') == std::string::npos) return decimals;
    decimals.erase(decimals.find_last_not_of('0') + 1);
    if (decimals.back() == '.') decimals.pop_back();
    return decimals;
}

}  // namespace

std::string figures(double value, int digits) {
    if (std::isnan(value)) return "—";
    const std::string sign(value < 0.0 ? minus : "");
    const double size = std::abs(value);
    if (std::isinf(size)) return sign + "∞";
    if (size == 0.0) return "0";
    const auto exponent_of = [](double x) { return static_cast<int>(std::floor(std::log10(x))); };
    const double place = std::pow(10.0, digits - 1 - exponent_of(size));
    const double rounded = std::isfinite(place) && place > 0.0 ? std::round(size * place) / place : size;
    const int exponent = exponent_of(rounded);
    if (exponent >= -4 && exponent < 6) {
        return sign + without_zeros_at_end(plain_decimals(rounded, digits - 1 - exponent));
    }
    return sign + without_zeros_at_end(plain_decimals(rounded / std::pow(10.0, exponent), digits - 1)) + "·10" +
           raised_text(exponent);
}

std::string figures_of(std::span<const double> numbers, int digits) {
    std::string text;
    for (const double number : numbers) text += (text.empty() ? "" : ", ") + figures(number, digits);
    return "(" + text + ")";
}

std::optional<double> read_figures(std::string_view text) {
    static constexpr std::string_view ten = "·10";
    const std::size_t power = text.find(ten);
    std::string plain(text.substr(0, power));
    if (plain.starts_with(minus)) plain.replace(0, std::string_view(minus).size(), "-");
    if (power == std::string_view::npos) return parse_double(plain);
    constexpr int largest = 330;
    for (int exponent = -largest; exponent <= largest; ++exponent)
        if (text.substr(power + ten.size()) == raised_text(exponent))
            return parse_double(plain + "e" + std::to_string(exponent));
    return std::nullopt;
}

std::string steady_figures(double value) {
    if (value == 0.0) return "0";
    if (!std::isfinite(value)) return number_text(value, 0);
    // Round first: 9.999 gets as many decimals as 10.0.
    int exponent = static_cast<int>(std::floor(std::log10(std::abs(value))));
    if (std::abs(value) >= 9.995 * std::pow(10.0, exponent)) ++exponent;
    if (exponent >= -4 && exponent < 6) return number_text(value, std::max(2 - exponent, 0));
    return number_text(value / std::pow(10.0, exponent), 2) + "·10" + raised_text(exponent);
}

std::string percent(double share, int decimals) {
    const double per_cent = 100.0 * share, least = std::pow(10.0, -decimals);
    if (share > 0.0 && per_cent < 0.5 * least) return "< " + number_text(least, decimals) + "%";
    if (share < 1.0 && per_cent >= 100.0 - 0.5 * least) return "> " + number_text(100.0 - least, decimals) + "%";
    return number_text(per_cent, decimals) + "%";
}

std::string grouped_number(std::int64_t number) {
    std::string text = std::to_string(number);
    const std::size_t first_digit = number < 0 ? 1 : 0;
    for (std::size_t place = text.size(); place > first_digit + 3;) {
        place -= 3;
        text.insert(place, 1, ',');
    }
    return text;
}

std::string shortest_number(double value) {
    std::array<char, 32> digits;
    return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}

std::string hex_color(std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
    return fmt::format("#{:02x}{:02x}{:02x}", red, green, blue);
}

std::string format_number(double value) {
    if (value == 0.0) {
        return std::signbit(value) ? "-0.0" : "0";
    }
    if (std::isnan(value)) return "NaN";
    const auto digits = [value](std::chars_format format) {
        std::array<char, 64> buffer;
        return std::string(buffer.data(),
                           std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format).ptr);
    };
    // "1e+06" becomes "1e6"
    std::string scientific = digits(std::chars_format::scientific);
    const std::size_t sign = scientific.find('e') + 1;
    const std::size_t exponent = std::min(scientific.find_first_not_of('0', sign + 1), scientific.size() - 1);
    scientific.erase(sign + 1, exponent - sign - 1);
    if (scientific[sign] == '+') {
        scientific.erase(sign, 1);
    }

    const double size = std::abs(value);
    if (size < 1e-4 || size >= 1e15) {
        return scientific;
    }
    constexpr std::size_t longer_but_plainer = 3;
    const std::string plain = digits(std::chars_format::fixed);
    return plain.size() <= scientific.size() + longer_but_plainer ? plain : scientific;
}

std::optional<double> parse_double(std::string_view text) {
    double value = 0.0;
#ifdef __cpp_lib_to_chars
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
#else  // libc++ 14 reads only whole numbers
    if (text.find_first_not_of("0123456789.-eE+") != std::string_view::npos || text.substr(0, 1) == "+") {
        return std::nullopt;
    }
    std::istringstream stream{std::string(text)};
    stream.imbue(std::locale::classic());
    if (!(stream >> value) || stream.peek() != std::istringstream::traits_type::eof()) return std::nullopt;
#endif
    return value;
}

namespace {

constexpr std::string_view real_minus = "−";

bool is_of_word(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

bool begins_number(std::string_view text, std::size_t at) {
    const auto is_digit = [&](std::size_t place) {
        return place < text.size() && text[place] >= '0' && text[place] <= '9';
    };
    return is_digit(at) || (text[at] == '.' && is_digit(at + 1));
}

/// Reads the number that begins at `at`, and moves `at` past it.
double take_number(std::string_view text, std::size_t& at) {
    const std::size_t begin = at;
    const auto digits = [&] {
        while (at < text.size() && text[at] >= '0' && text[at] <= '9') ++at;
    };
    digits();
    if (at < text.size() && text[at] == '.') ++at;
    digits();
    const std::size_t mantissa_end = at;
    if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
        ++at;
        const bool is_real = text.substr(at).starts_with(real_minus);
        const bool is_negative = is_real || (at < text.size() && text[at] == '-');
        if (is_real)
            at += real_minus.size();
        else if (is_negative || (at < text.size() && text[at] == '+'))
            ++at;
        const std::size_t exponent = at;
        digits();
        if (at > exponent) {
            const std::string mantissa(text.substr(begin, mantissa_end - begin));
            const std::string power(text.substr(exponent, at - exponent));
            return parse_double(mantissa + (is_negative ? "e-" : "e") + power).value_or(is_negative ? 0.0 : HUGE_VAL);
        }
        at = mantissa_end;
    }
    return parse_double(text.substr(begin, at - begin)).value_or(0.0);
}

}  // namespace

std::vector<double> numbers_in(std::string_view text) {
    constexpr std::size_t most = 1000;
    std::vector<double> numbers;
    double sign = 1.0;
    for (std::size_t at = 0; at < text.size() && numbers.size() < most;) {
        if (begins_number(text, at)) {
            double value = sign * take_number(text, at);
            if (at + 1 < text.size() && text[at] == '/' && begins_number(text, at + 1))
                value /= take_number(text, ++at);
            if (std::isfinite(value)) numbers.push_back(value);
            while (at < text.size() && is_of_word(text[at])) ++at;  // skip a unit, or a suffix such as f
            sign = 1.0;
        } else if (is_of_word(text[at])) {
            while (at < text.size() && (is_of_word(text[at]) || text[at] == '.')) ++at;
            sign = 1.0;
        } else if (text.substr(at).starts_with(real_minus)) {
            at += real_minus.size();
            sign = -1.0;
        } else {
            sign = text[at] == '-' ? -1.0 : text[at] == ' ' && sign < 0.0 ? -1.0 : 1.0;
            ++at;
        }
    }
    return numbers;
}

}  // namespace viewing
