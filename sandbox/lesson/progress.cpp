#include "lesson/progress.h"

#include <algorithm>

#include "lesson/step_reader.h"
#include "text/numbers.h"

namespace viewing {
namespace {

std::string value_in_words(const Json& value) {
    if (value.is_number()) return figures(value.get<double>(), 3);
    if (value.is_string()) return value.get<std::string>();
    if (!value.is_array()) return "—";
    std::string text;
    for (const Json& entry : value) text += (text.empty() ? "(" : ", ") + value_in_words(entry);
    return text + ")";
}

}  // namespace

std::vector<GoalNumber> read_progress(const Json& ask, const std::vector<std::string>& constants, const Where& where) {
    constexpr std::size_t most_numbers = 3;
    std::vector<GoalNumber> numbers;
    if (!has(ask, "progress")) return numbers;
    const Json& list = ask["progress"];
    const Where inside = where.key("progress");
    require_array(list, inside, most_numbers, "a list of numbers to show");
    for (std::size_t i = 0; i < list.size(); ++i) {
        const Where at = inside.at(i);
        require_keys(list[i], at, {"name", "value", "needed"});
        if (!has(list[i], "value")) at.key("value").refuse("is missing: an expression");
        numbers.push_back({text_at(list[i], "name", at, true),
                           expression_in(list[i]["value"], at.key("value"), constants),
                           text_at(list[i], "needed", at, true)});
    }
    return numbers;
}

bool has_measured_progress(const Ask& ask) {
    return std::any_of(ask.progress.begin(), ask.progress.end(),
                       [](const GoalNumber& number) { return is_measured(number.value); });
}

std::vector<std::string> progress_of(const Ask& ask, const Surroundings& surroundings) {
    std::vector<std::string> texts;
    for (const GoalNumber& number : ask.progress) {
        const Result<Json> value = evaluate(number.value, surroundings);
        texts.push_back(value ? value_in_words(*value) : "—");
    }
    return texts;
}

}  // namespace viewing
