#include "lesson/filled_text.h"

#include <algorithm>
#include <cmath>

#include "text/numbers.h"
#include "text/words.h"

namespace viewing {
namespace {

/// Returns a value as it appears in a sentence: 0.25, −3, (0, 1, 0, 0); a name is unchanged.
std::string in_words(const Json& value, int digits) {
    if (value.is_number()) return figures(value.get<double>(), digits);
    if (value.is_string()) return value.get<std::string>();
    if (value.is_boolean()) return value.get<bool>() ? "true" : "false";
    std::string list;
    for (const Json& entry : value) list += (list.empty() ? "" : ", ") + in_words(entry, digits);
    return "(" + list + ")";
}

/// Whether a sentence can contain the value: it is neither null nor NaN.
bool has_words(const Json& value) {
    if (value.is_array()) return std::all_of(value.begin(), value.end(), has_words);
    return !value.is_null() && !(value.is_number() && std::isnan(value.get<double>()));
}

}  // namespace

bool has_places(const LessonText& text) {
    return text.in_english().find('{') != std::string::npos;
}

Result<std::string> filled(const std::string& text, const std::function<Result<Json>(const std::string&)>& value_of,
                           int digits) {
    std::string result;
    std::size_t at = 0;
    for (std::size_t open = text.find('{'); open != std::string::npos; open = text.find('{', at)) {
        const std::size_t close = text.find('}', open);
        if (close == std::string::npos) return Error{"has a { without a }"};
        result += text.substr(at, open - at);
        const Result<Json> value = value_of(text.substr(open + 1, close - open - 1));
        if (!value) return Error{value.error()};
        if (!has_words(*value)) return Error{excerpt(text.substr(open, close + 1 - open)) + " has no value"};
        result += in_words(*value, digits);
        at = close + 1;
    }
    return result + text.substr(at);
}

Result<LessonText> filled(const LessonText& text, const Surroundings& surroundings) {
    constexpr int digits = 4;
    LessonText result;
    for (std::size_t i = 0; i < language_count; ++i) {
        Result<std::string> one = filled(
            text.by_language[i], [&](const std::string& expression) { return evaluate(expression, surroundings); },
            digits);
        if (!one) return Error{one.error()};
        result.by_language[i] = *std::move(one);
    }
    return result;
}

LessonText filled_or_same(const LessonText& text, const Surroundings& surroundings) {
    const Result<LessonText> result = filled(text, surroundings);
    return result ? *result : text;
}

}  // namespace viewing
