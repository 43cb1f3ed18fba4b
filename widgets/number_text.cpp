// Parsing of typed numbers.
#include <algorithm>
#include <iterator>

#include "widgets/inner.h"

namespace widgets {

namespace {

constexpr std::string_view minus = "−";
constexpr std::string_view power_of_ten = "·10";
constexpr std::string_view raised_minus = "⁻";
constexpr std::string_view raised_digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};

/// Converts the end of "7.5·10⁻⁶", from "·" on, to "e-6", which is never longer. Returns "" for any other text.
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
    return viewing::parse_double({plain, length});
}

}  // namespace widgets
