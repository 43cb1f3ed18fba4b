#include "lesson/judge.h"

#include <algorithm>
#include <cmath>

#include "lesson/other_row.h"
#include "lesson/progress.h"

namespace viewing {
namespace {

void append_numbers(const Json& value, std::vector<double>& numbers) {
    if (value.is_number()) numbers.push_back(value.get<double>());
    if (value.is_array())
        for (const Json& entry : value) append_numbers(entry, numbers);
}

/// Returns the tolerance that applies to every entry.
double tolerance_of(const Ask& ask, const std::vector<double>& right) {
    double largest = 0.0;
    for (const double number : right) largest = std::max(largest, std::abs(number));
    return std::max({ask.tolerance, ask.relative_tolerance * largest, 1e-9});
}

std::vector<bool> close_entries(const std::vector<double>& typed, const std::vector<double>& right, double factor,
                                double tolerance) {
    std::vector<bool> close;
    for (std::size_t i = 0; i < typed.size(); ++i) close.push_back(std::abs(typed[i] * factor - right[i]) <= tolerance);
    return close;
}

bool are_all(const std::vector<bool>& close) {
    return std::find(close.begin(), close.end(), false) == close.end();
}

/// Returns the factor for the entry whose right value is the largest; none if its right or its entered value is zero.
std::optional<double> factor_at_largest(const std::vector<double>& typed, const std::vector<double>& right) {
    const auto by_size = [](double a, double b) { return std::abs(a) < std::abs(b); };
    const auto at = static_cast<std::size_t>(std::max_element(right.begin(), right.end(), by_size) - right.begin());
    if (right[at] == 0.0 || typed[at] == 0.0) return std::nullopt;
    return right[at] / typed[at];
}

bool are_close(const std::vector<double>& typed, const std::vector<double>& right, const Ask& ask) {
    if (typed.size() != right.size() || right.empty()) return false;
    const std::optional<double> factor = ask.up_to_factor ? factor_at_largest(typed, right) : 1.0;
    return factor && are_all(close_entries(typed, right, *factor, tolerance_of(ask, right)));
}

/// Returns the factor with which the most entries are right, or 1 if none is allowed. A factor other than 1 must fit at
/// least two nonzero entries, since for a single entry some factor always fits.
double best_factor(const std::vector<double>& typed, const std::vector<double>& right, const Ask& ask) {
    const double tolerance = tolerance_of(ask, right);
    const auto fitting = [&](double factor) {
        const std::vector<bool> close = close_entries(typed, right, factor, tolerance);
        return std::count(close.begin(), close.end(), true);
    };
    double best = 1.0;
    for (std::size_t i = 0; ask.up_to_factor && i < typed.size(); ++i) {
        if (typed[i] == 0.0 || right[i] == 0.0) continue;
        const double factor = right[i] / typed[i];
        const std::vector<bool> close = close_entries(typed, right, factor, tolerance);
        int telling = 0;
        for (std::size_t j = 0; j < typed.size(); ++j) telling += close[j] && right[j] != 0.0 ? 1 : 0;
        if (telling >= 2 && fitting(factor) > fitting(best)) best = factor;
    }
    return best;
}

/// Returns the relation of a wrong number to the right one, if it holds to within 0.2 %.
Near relation_to(double right, double typed) {
    constexpr double relative = 2e-3, degrees_per_radian = 180.0 / 3.14159265358979323846;
    if (typed == 0.0 || right == 0.0) return Near::nothing;
    const auto is_right = [&](double number) { return std::abs(number - right) <= relative * std::abs(right); };
    if (is_right(2.0 * typed)) return Near::half;
    if (is_right(0.5 * typed)) return Near::twice;
    if (is_right(1.0 / typed)) return Near::reciprocal;
    if (is_right(degrees_per_radian * typed)) return Near::radians;
    if (is_right(typed / degrees_per_radian)) return Near::degrees;
    for (const double factor : {10.0, 100.0, 1000.0})
        if (is_right(factor * typed) || is_right(typed / factor)) return Near::decimal;
    return Near::nothing;
}

/// Says what is right about numbers: by rows of a matrix, or by entries.
void tell_near_numbers(const Ask& ask, const std::vector<double>& typed, const std::vector<double>& right,
                       Verdict& verdict) {
    if (typed.size() != right.size() || right.empty()) return;
    const double tolerance = tolerance_of(ask, right);
    const std::optional<double> factor = factor_at_largest(typed, right);
    if (right.size() > 1 && factor && are_all(close_entries(typed, right, *factor, tolerance))) {
        verdict.near = Near::factor;
        return;
    }
    const std::vector<bool> close = close_entries(typed, right, best_factor(typed, right, ask), tolerance);
    const std::vector<bool> opposite = close_entries(typed, right, -1.0, tolerance);
    bool are_signs = true;
    std::vector<int> wrong_rows, right_rows;
    for (int row = 0; row < ask.rows; ++row) {
        bool is_right = true;
        for (auto i = static_cast<std::size_t>(row * ask.columns);
             i < static_cast<std::size_t>((row + 1) * ask.columns); ++i) {
            is_right = is_right && close[i];
            are_signs = are_signs && (close[i] || opposite[i]);
        }
        (is_right ? right_rows : wrong_rows).push_back(row + 1);
    }
    if (are_signs && !ask.up_to_factor) {
        verdict.near = Near::sign;
        verdict.places = std::move(wrong_rows);
    } else if (!right_rows.empty()) {
        verdict.near = Near::right_parts;
        verdict.places = std::move(right_rows);
    } else if (right.size() == 1) {
        verdict.near = relation_to(right.front(), typed.front());
    }
}

/// Says what is right about chosen or ordered tiles.
void tell_near_items(const Ask& ask, const std::vector<int>& items, Verdict& verdict) {
    if (items.empty() || ask.expected_items.empty()) return;
    if (ask.kind == AskKind::subset) {
        const auto holds_all = [](const std::vector<int>& all, const std::vector<int>& some) {
            return std::all_of(some.begin(), some.end(),
                               [&](int one) { return std::find(all.begin(), all.end(), one) != all.end(); });
        };
        for (const std::vector<int>& expected : ask.expected_items) {
            if (holds_all(expected, items)) verdict.near = Near::incomplete;
            if (holds_all(items, expected)) verdict.near = Near::too_many;
        }
        if (verdict.near != Near::nothing) return;
        const std::vector<int>& expected = ask.expected_items.front();
        const auto right = static_cast<int>(std::count_if(items.begin(), items.end(), [&](int one) {
            return std::find(expected.begin(), expected.end(), one) != expected.end();
        }));
        verdict.near = right == 0 ? Near::no_items : Near::some_items;
        if (right > 0) verdict.places = {right};
        return;
    }
    int most = 0;
    for (const std::vector<int>& expected : ask.expected_items) {
        const auto end = std::mismatch(items.begin(), items.end(), expected.begin(), expected.end());
        most = std::max(most, static_cast<int>(end.first - items.begin()));
    }
    verdict.near = most == 0 ? Near::first_wrong : Near::first_items;
    if (most > 0) verdict.places = {most};
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
    return is_measured(ask.expect) || is_measured(ask.until) || has_measured_progress(ask) ||
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

namespace {

Result<Verdict> judged(const Ask& ask, const Answer& answer, const Surroundings& surroundings) {
    const Result<bool> right = is_right(ask, answer, surroundings);
    if (!right) return Error{right.error()};
    if (*right) return Verdict{.right = true};
    if (ask.kind == AskKind::choice) {
        if (answer.items.empty()) return Verdict{};
        const LessonChoice& chosen = ask.choices[static_cast<std::size_t>(answer.items.front())];
        return Verdict{.say = chosen.why, .tag = chosen.tag};
    }
    for (const WrongAnswer& wrong : ask.wrong) {
        const Result<bool> does_fit = fits(wrong, ask, answer, surroundings);
        if (!does_fit) return Error{does_fit.error()};
        if (*does_fit) return Verdict{.say = wrong.say, .tag = wrong.tag, .points = wrong.points};
    }
    Verdict unknown;
    if (has_items(ask.kind)) tell_near_items(ask, answer.items, unknown);
    const Result<Answer> model = is_typed(ask.kind) ? model_answer(ask, surroundings) : Answer{};
    if (!is_typed(ask.kind) || !model || model->numbers.size() != answer.numbers.size()) return unknown;
    tell_near_numbers(ask, answer.numbers, model->numbers, unknown);
    if (ask.kind != AskKind::matrix || (unknown.near != Near::right_parts && unknown.near != Near::nothing))
        return unknown;
    std::vector<double> numbers = answer.numbers;
    for (double& number : numbers) number *= best_factor(answer.numbers, model->numbers, ask);
    if (const std::optional<OtherRow> other = other_row(numbers, unknown.places, ask.expect, surroundings)) {
        unknown.other_row = other->row;
        std::vector<double>& found = other->is_light ? unknown.other_light : unknown.other_plane;
        for (int i = 0; i < 4; ++i) found.push_back(other->numbers[i]);
    }
    return unknown;
}

}  // namespace

Result<Verdict> judge(const Ask& ask, const Answer& answer, Surroundings surroundings) {
    surroundings = with_constants(ask, std::move(surroundings));
    surroundings.answer = answer_as_json(ask, answer);
    Result<Verdict> verdict = judged(ask, answer, surroundings);
    if (verdict) verdict->progress = progress_of(ask, surroundings);
    return verdict;
}

}  // namespace viewing
