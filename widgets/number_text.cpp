// Numbers as characters: one rule for how a value is written everywhere, and what may be typed for one.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>

#include "widgets/inner.h"

namespace widgets {

namespace {

constexpr std::string_view minus = "−";
constexpr int max_decimals = 17;
constexpr std::string_view power_of_ten = "·10";
constexpr std::string_view raised_minus = "⁻";
constexpr std::string_view raised_digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
constexpr double largest_fixed = 1e6;  ///< from here on 1.234·10⁶
constexpr double noise = 1e-9;         ///< smaller magnitudes are rounding residues: 0.000

}  // namespace

namespace inner {

void NumberChars::Append(std::string_view text) {
    for (const char byte : text) {
        if (bytes == static_cast<int>(sizeof data)) return;
        data[bytes++] = byte;
        const bool continues_character = (byte & 0xC0) == 0x80;
        if (!continues_character) ++columns;
    }
}

namespace {

/// 12.5, 1.25·10¹, and 1.25e1 where there is no room for that.
enum class Notation { fixed, power, compact };

/// to_chars writes 1.5e-05; ours is 1.5·10⁻⁵.
void AppendExponent(NumberChars& out, std::string_view exponent, Notation notation) {
    const bool compact = notation == Notation::compact;
    out.Append(compact ? "e" : power_of_ten);
    if (exponent.front() == '-') out.Append(compact ? minus : raised_minus);
    exponent.remove_prefix(1);
    while (exponent.size() > 1 && exponent.front() == '0') exponent.remove_prefix(1);
    for (const char digit : exponent) {
        out.Append(compact ? std::string_view(&digit, 1) : raised_digits[digit - '0']);
    }
}

NumberChars Write(double value, int decimals, Notation notation) {
    char raw[48];
    const auto format = notation == Notation::fixed ? std::chars_format::fixed : std::chars_format::scientific;
    const std::to_chars_result end = std::to_chars(raw, raw + sizeof raw, std::abs(value), format, decimals);
    const std::string_view digits(raw, static_cast<std::size_t>(end.ptr - raw));
    const bool shows_zero = digits.find_first_of("123456789") == std::string_view::npos;

    NumberChars out;
    if (value < 0.0 && !shows_zero) out.Append(minus);
    const std::size_t exponent = digits.find('e');
    out.Append(digits.substr(0, exponent));
    if (exponent != std::string_view::npos) AppendExponent(out, digits.substr(exponent + 1), notation);
    return out;
}

}  // namespace

NumberChars FormatNumber(double value, int decimals, Tiny tiny) {
    decimals = std::clamp(decimals, 0, max_decimals);
    NumberChars out;
    if (std::isnan(value)) {
        out.Append("—");
        return out;
    }
    if (std::isinf(value)) {
        if (value < 0.0) out.Append(minus);
        out.Append("∞");
        return out;
    }
    const double magnitude = std::abs(value);
    const bool vanishes = magnitude >= noise && magnitude < 0.5 * std::pow(10.0, -decimals);
    const bool needs_power = magnitude >= largest_fixed || (vanishes && tiny == Tiny::exponent);
    return Write(value, decimals, needs_power ? Notation::power : Notation::fixed);
}

NumberChars FitNumber(double value, int decimals, Tiny tiny, std::string_view unit, int columns) {
    decimals = std::clamp(decimals, 0, max_decimals);
    NumberChars suffix;
    suffix.Append(unit);
    NumberChars out;
    for (int digits = decimals; digits >= 0; --digits) {
        out = FormatNumber(value, digits, tiny);
        if (out.columns + suffix.columns <= columns) {
            out.Append(unit);
            return out;
        }
    }
    if (out.columns <= columns || !std::isfinite(value)) return out;
    for (const Notation notation : {Notation::power, Notation::compact}) {
        for (int digits = 3; digits >= 0; --digits) {
            out = Write(value, digits, notation);
            if (out.columns <= columns) return out;
        }
    }
    return out;
}

std::string PlainText(double value) {
    const double magnitude = std::abs(value);
    const bool plain = value == 0.0 || (magnitude >= 1e-6 && magnitude < 10.0 * largest_fixed);
    char raw[32];
    const auto format = plain ? std::chars_format::fixed : std::chars_format::scientific;
    return std::string(raw, std::to_chars(raw, raw + sizeof raw, value, format).ptr);
}

}  // namespace inner

std::string RaisedText(int value) {
    std::string text;
    for (const char digit : std::to_string(value)) text += raised_digits[digit - '0'];
    return text;
}

std::string NumberText(double value, int decimals) {
    return std::string(inner::FormatNumber(value, decimals, inner::Tiny::exponent).view());
}

namespace {

/// The end of "7.5·10⁻⁶" from "·" on as "e-6", which takes no more bytes; empty when it is anything else.
std::string ExponentOf(std::string_view text) {
    if (!text.starts_with(power_of_ten)) return {};
    text.remove_prefix(power_of_ten.size());
    std::string exponent = "e";
    if (text.starts_with(raised_minus)) {
        exponent += '-';
        text.remove_prefix(raised_minus.size());
    }
    while (!text.empty()) {
        const auto* digit = std::find_if(std::begin(raised_digits), std::end(raised_digits),
                                         [text](std::string_view raised) { return text.starts_with(raised); });
        if (digit == std::end(raised_digits)) return {};
        exponent += static_cast<char>('0' + (digit - std::begin(raised_digits)));
        text.remove_prefix(digit->size());
    }
    return exponent;
}

}  // namespace

std::optional<double> ParseNumber(std::string_view text, std::string_view unit) {
    const auto trim = [&text] {
        while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
        while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
    };
    trim();
    if (!unit.empty() && text.ends_with(unit)) text.remove_suffix(unit.size());
    trim();
    if (text.starts_with('+')) {
        text.remove_prefix(1);
        if (text.starts_with('-') || text.starts_with(minus)) return std::nullopt;
    }

    std::string exponent;
    if (const std::size_t power = text.find(power_of_ten); power != std::string_view::npos) {
        exponent = ExponentOf(text.substr(power));
        if (exponent.empty()) return std::nullopt;
        text = text.substr(0, power);
    }

    char plain[64];
    std::size_t length = 0;
    while (!text.empty()) {
        if (length == sizeof plain) return std::nullopt;
        if (text.starts_with(minus)) {
            plain[length++] = '-';
            text.remove_prefix(minus.size());
        } else {
            plain[length++] = text.front() == ',' ? '.' : text.front();
            text.remove_prefix(1);
        }
    }
    if (length + exponent.size() > sizeof plain) return std::nullopt;
    length += exponent.copy(plain + length, exponent.size());
    double value = 0.0;
    const std::from_chars_result end = std::from_chars(plain, plain + length, value);
    if (end.ec != std::errc() || end.ptr != plain + length || !std::isfinite(value)) return std::nullopt;
    return value;
}

}  // namespace widgets
