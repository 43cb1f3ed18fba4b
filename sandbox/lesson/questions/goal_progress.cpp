#include "lesson/questions/goal_progress.h"

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
