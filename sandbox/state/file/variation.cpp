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

/// Interpolates between two numbers or two lists of numbers; returns null for any other values.
Json between(const Json& from, const Json& to, double share) {
    if (from.is_number() && to.is_number()) {
        const auto a = from.get<double>(), b = to.get<double>();
        const double value = share == 1.0 ? b : a + (b - a) * share;
        const bool counts = from.is_number_integer() && to.is_number_integer() && value == std::floor(value);
        return counts ? Json(static_cast<std::int64_t>(value)) : Json(value);
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
