#include "lesson/judge.h"

#include <algorithm>
#include <cmath>

namespace viewing {
namespace {

void append_numbers(const Json& value, std::vector<double>& numbers) {
    if (value.is_number()) numbers.push_back(value.get<double>());
    if (value.is_array())
        for (const Json& entry : value) append_numbers(entry, numbers);
}

/// Returns the difference in each entry, after multiplying `typed` by a common factor if the question allows one; none
/// if the answers cannot be compared. `largest` receives the largest absolute value in `right`.
std::optional<std::vector<double>> differences(std::vector<double> typed, const std::vector<double>& right,
                                               const Ask& ask, double& largest) {
    if (typed.size() != right.size() || right.empty()) return std::nullopt;
    const auto by_size = [](double a, double b) { return std::abs(a) < std::abs(b); };
    const auto at = static_cast<std::size_t>(std::max_element(right.begin(), right.end(), by_size) - right.begin());
    largest = std::abs(right[at]);
    if (ask.up_to_factor) {
        if (right[at] == 0.0 || typed[at] == 0.0) return std::nullopt;
        const double factor = right[at] / typed[at];
        for (double& number : typed) number *= factor;
    }
    for (std::size_t i = 0; i < typed.size(); ++i) typed[i] = std::abs(typed[i] - right[i]);
    return typed;
}

bool are_close(const std::vector<double>& typed, const std::vector<double>& right, const Ask& ask) {
    double largest = 0.0;
    const std::optional<std::vector<double>> apart = differences(typed, right, ask, largest);
    if (!apart) return false;
    const double tolerance = std::max({ask.tolerance, ask.relative_tolerance * largest, 1e-9});
    return std::all_of(apart->begin(), apart->end(), [&](double difference) { return difference <= tolerance; });
}

/// Returns the number of the row or entry that differs most from the right answer, counted from 1; 0 if there is only
/// one row, or if the answers cannot be compared.
int farthest_place(const Ask& ask, const Answer& answer, const Surroundings& surroundings) {
    if (ask.rows == 1 || answer.numbers.empty()) return 0;
    const Result<Answer> model = model_answer(ask, surroundings);
    double largest = 0.0;
    const auto apart = model ? differences(answer.numbers, model->numbers, ask, largest) : std::nullopt;
    if (!apart) return 0;
    return static_cast<int>(std::max_element(apart->begin(), apart->end()) - apart->begin()) / ask.columns + 1;
}

std::vector<int> sorted(std::vector<int> items) {
    std::sort(items.begin(), items.end());
    return items;
}

Result<bool> is_right(const Ask& ask, const Answer& answer, const Surroundings& surroundings) {
    if (ask.kind == AskKind::goal) return holds(ask.until, surroundings);
    if (ask.kind == AskKind::choice)
        return answer.items.size() == 1 && ask.choices[static_cast<std::size_t>(answer.items[0])].right;
    if (is_typed(ask.kind)) {
        const Result<Answer> model = model_answer(ask, surroundings);
        if (!model) return Error{model.error()};
        return are_close(answer.numbers, model->numbers, ask);
    }
    return std::any_of(ask.expected_items.begin(), ask.expected_items.end(), [&](const std::vector<int>& expected) {
        return ask.kind == AskKind::subset ? sorted(answer.items) == sorted(expected) : answer.items == expected;
    });
}

Result<bool> fits(const WrongAnswer& wrong, const Ask& ask, const Answer& answer, const Surroundings& surroundings) {
    if (!wrong.when.empty()) return holds(wrong.when, surroundings);
    if (is_typed(ask.kind)) return are_close(answer.numbers, wrong.sample.numbers, ask);
    return ask.kind == AskKind::subset ? sorted(answer.items) == sorted(wrong.sample.items)
                                       : answer.items == wrong.sample.items;
}

}  // namespace

Json constants_of(const Ask& ask) {
    return ask.constants.empty() ? Json::object() : Json::parse(ask.constants);
}

Surroundings with_constants(const Ask& ask, Surroundings surroundings) {
    surroundings.constants = constants_of(ask);
    return surroundings;
}

bool is_measured(const Ask& ask) {
    return is_measured(ask.expect) || is_measured(ask.until) ||
           std::any_of(ask.wrong.begin(), ask.wrong.end(),
                       [](const WrongAnswer& wrong) { return is_measured(wrong.when); });
}

Json answer_as_json(const Ask& ask, const Answer& answer) {
    if (answer.empty()) return nullptr;
    if (!is_typed(ask.kind)) return Json(answer.items);
    if (ask.kind == AskKind::number) return answer.numbers.front();
    if (ask.columns == 1) return Json(answer.numbers);
    Json rows = Json::array();
    const auto columns = static_cast<std::ptrdiff_t>(ask.columns);
    for (auto row = answer.numbers.begin(); row != answer.numbers.end(); row += columns)
        rows.push_back(Json(std::vector<double>(row, row + columns)));
    return rows;
}

Result<Answer> model_answer(const Ask& ask, const Surroundings& surroundings) {
    Answer model;
    if (ask.kind == AskKind::choice) {
        const auto right = std::find_if(ask.choices.begin(), ask.choices.end(),
                                        [](const LessonChoice& choice) { return choice.right; });
        model.items = {static_cast<int>(right - ask.choices.begin())};
    } else if (is_typed(ask.kind)) {
        const Result<Json> value = evaluate(ask.expect, with_constants(ask, surroundings));
        if (!value) return Error{value.error()};
        append_numbers(*value, model.numbers);
        if (std::ssize(model.numbers) != ask.rows * ask.columns)
            return Error{"must be " + std::to_string(ask.rows * ask.columns) + " numbers, got " + describe(*value)};
    } else if (!ask.expected_items.empty()) {
        model.items = ask.expected_items.front();
    }
    return model;
}

Result<Verdict> judge(const Ask& ask, const Answer& answer, Surroundings surroundings) {
    surroundings = with_constants(ask, std::move(surroundings));
    surroundings.answer = answer_as_json(ask, answer);
    const Result<bool> right = is_right(ask, answer, surroundings);
    if (!right) return Error{right.error()};
    if (*right) return Verdict{true, {}, "", 0, 0};
    if (ask.kind == AskKind::choice) {
        if (answer.items.empty()) return Verdict{};
        const LessonChoice& chosen = ask.choices[static_cast<std::size_t>(answer.items.front())];
        return Verdict{false, chosen.why, chosen.tag, 0, 0};
    }
    for (const WrongAnswer& wrong : ask.wrong) {
        const Result<bool> does_fit = fits(wrong, ask, answer, surroundings);
        if (!does_fit) return Error{does_fit.error()};
        if (*does_fit) return Verdict{false, wrong.say, wrong.tag, wrong.points, 0};
    }
    Verdict unknown;
    if (is_typed(ask.kind)) unknown.place = farthest_place(ask, answer, surroundings);
    return unknown;
}

}  // namespace viewing
