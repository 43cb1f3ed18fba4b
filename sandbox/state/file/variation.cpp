#include "state/file/variation.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "state/file/document.h"
#include "text/words.h"

namespace viewing {
namespace {

/// Returns the text as parsed JSON; null if it is not JSON.
Json json_of(const std::string& text) {
    return Json::parse(text, nullptr, false, false).is_discarded() ? Json() : Json::parse(text);
}

/// Drops the rounding errors of an interpolation: 2.2, not 2.1999999999999997.
double rounded(double value) {
    constexpr double digits = 14.0;
    const double scale = std::pow(10.0, digits - 1.0 - std::floor(std::log10(std::abs(value))));
    const double found = std::round(value * scale) / scale;
    return std::isfinite(found) ? found : value;  // 0, or close to it
}

/// Interpolates between two numbers or two lists of numbers; returns null for any other values.
Json between(const Json& from, const Json& to, double share) {
    if (from.is_number() && to.is_number()) {
        const auto a = from.get<double>(), b = to.get<double>();
        const double value = share == 0.0 ? a : share == 1.0 ? b : rounded(a + (b - a) * share);
        constexpr double exact_below = 1e15;
        const bool is_whole = value == std::floor(value) && std::abs(value) < exact_below;
        return is_whole ? Json(static_cast<std::int64_t>(value)) : Json(value);
    }
    if (!from.is_array() || !to.is_array() || from.size() != to.size()) return nullptr;
    Json list = Json::array();
    for (std::size_t i = 0; i < from.size(); ++i) {
        list.push_back(between(from[i], to[i], share));
        if (list.back().is_null()) return nullptr;
    }
    return list;
}

}  // namespace

Result<Variation> Variation::parse(const std::string& text) {
    const std::string form = "--vary " + one_line(text) + ": must be PATH=FROM:TO:COUNT";
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) return Error{form + ", as in light.position[0]=-3:3:61"};
    Variation variation;
    variation.path = text.substr(0, equals);
    variation.values = split_outside_brackets(text.substr(equals + 1), ':');
    if (variation.values.size() < 3) return Error{form + "; more values can come between FROM and TO"};
    const std::string count = variation.values.back();
    variation.values.pop_back();
    const auto [end, error] = std::from_chars(count.data(), count.data() + count.size(), variation.count);
    if (error != std::errc() || end != count.data() + count.size() || variation.count < 1 ||
        variation.count > most_frames)
        return Error{form + " with COUNT a whole number from 1 to " + std::to_string(most_frames)};
    if (variation.count > 1 && static_cast<std::size_t>(variation.count) < variation.values.size())
        return Error{form + " with a COUNT that is not below the number of values, " +
                     std::to_string(variation.values.size()) + ": otherwise, some would be skipped"};
    return variation;
}

std::string Variation::setting(int index, Ease ease) const {
    const double linear = count > 1 ? static_cast<double>(index) / (count - 1) : 0.0;
    const double share = ease == Ease::smooth ? linear * linear * (3.0 - 2.0 * linear) : linear;
    const auto last = static_cast<double>(values.size() - 1);
    const double place = share * last;
    const double leg = std::min(std::floor(place), std::max(last - 1.0, 0.0));
    const auto from = static_cast<std::size_t>(leg);
    const Json value = between(json_of(values[from]), json_of(values[from + 1]), place - leg);
    if (!value.is_null()) return path + "=" + value.dump();
    return path + "=" + values[static_cast<std::size_t>(place)];
}

}  // namespace viewing
