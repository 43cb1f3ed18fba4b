// Questions whose answer is entered as numbers: one number, a vector, or a matrix.
#include <algorithm>
#include <cmath>
#include <limits>

#include "lesson/questions/other_row.h"
#include "lesson/questions/question_form.h"
#include "text/numbers.h"

namespace viewing {
namespace {

using form::Object;

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

/// Returns right ÷ entered for the entry whose right value is the largest; none if either of the two values is zero.
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

/// Returns the factor with which the most entries are right; 1 if the question allows no factor. A factor other than 1
/// must fit at least two nonzero entries, since for a single entry some factor always fits.
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

Result<Answer> model_numbers(const Ask& ask, const Surroundings& surroundings) {
    Answer model;
    const Result<Json> value = evaluate(ask.expect, with_constants(ask, surroundings));
    if (!value) return Error{value.error()};
    append_numbers(*value, model.numbers);
    if (std::ssize(model.numbers) != ask.rows * ask.columns)
        return Error{"must be " + std::to_string(ask.rows * ask.columns) + " numbers, got " + describe(*value)};
    return model;
}

Verdict near_numbers(const Ask& ask, const Answer& answer, const Surroundings& surroundings) {
    Verdict unknown;
    const Result<Answer> model = model_numbers(ask, surroundings);
    if (!model || model->numbers.size() != answer.numbers.size()) return unknown;
    tell_near_numbers(ask, answer.numbers, model->numbers, unknown);
    if (ask.columns == 1 || (unknown.near != Near::right_parts && unknown.near != Near::nothing)) return unknown;
    std::vector<double> numbers = answer.numbers;
    for (double& number : numbers) number *= best_factor(answer.numbers, model->numbers, ask);
    if (const std::optional<OtherRow> other = other_row(numbers, unknown.places, ask.expect, surroundings)) {
        unknown.other_row = other->row;
        std::vector<double>& found = other->is_light ? unknown.other_light : unknown.other_plane;
        for (int i = 0; i < 4; ++i) found.push_back(other->numbers[i]);
    }
    return unknown;
}

/// Writes numbers row by row: "1, 0; 0, 1", or with decimals if one of them is not whole.
std::string numbers_in_words(const Ask& ask, const Answer& model) {
    std::string words;
    const auto columns = static_cast<std::size_t>(ask.columns);
    const bool are_whole = std::all_of(model.numbers.begin(), model.numbers.end(),
                                       [](double number) { return number == std::round(number); });
    for (std::size_t i = 0; i < model.numbers.size(); ++i) {
        const bool begins_row = columns > 1 && i % columns == 0;
        if (i > 0) words += begins_row ? "; " : ", ";
        words += number_text(model.numbers[i], are_whole ? 0 : 3);
    }
    return words;
}

/// Reads the right answer, and how close an entered one must be to it.
void add_expected(Object<LessonStep>& question, const LessonReading& reading) {
    const auto tolerance = form::number({0.0, 1e12});
    question.required("expect", expression_form(reading), in_ask(&Ask::expect))
        .optional("tol", tolerance, in_ask(&Ask::tolerance))
        .optional("tol_rel", tolerance, in_ask(&Ask::relative_tolerance))
        .optional("up_to_factor", form::boolean(), in_ask(&Ask::up_to_factor));
}

/// Reads "size": the number of rows and, for a matrix, also of columns.
void add_size(Object<LessonStep>& question, int most) {
    const auto set_size = [](LessonStep& step, int size) {
        step.ask.rows = size;
        if (step.ask.columns > 1) step.ask.columns = size;
    };
    question.optional("size", form::whole(2, most), set_size);
}

constexpr QuestionKind of_numbers(int rows, int columns, decltype(QuestionKind::read) read) {
    return {
        .read = read,
        .read_wrong = read_wrong_numbers,
        .is_right = [](const Ask& ask, const Answer& answer, const Surroundings& surroundings) -> Result<bool> {
            const Result<Answer> model = model_numbers(ask, surroundings);
            if (!model) return Error{model.error()};
            return are_close(answer.numbers, model->numbers, ask);
        },
        .are_same = [](const Ask& ask, const Answer& answer,
                       const Answer& sample) { return are_close(answer.numbers, sample.numbers, ask); },
        .near = near_numbers,
        .model = model_numbers,
        .in_words = numbers_in_words,
        .rows = rows,
        .columns = columns,
        .is_typed = true,
        .needs_check = true,
    };
}

}  // namespace

void read_wrong_numbers(Object<LessonStep>& wrong) {
    constexpr Range any_number{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max()};
    for (const char* const key : sample_keys)
        wrong.optional(
            key, numbers_form("sample", any_number, 16),
            [](LessonStep& step, const std::vector<double>& numbers, const Where& where) {
                if (std::ssize(numbers) != step.ask.rows * step.ask.columns)
                    where.refuse("must have " + std::to_string(step.ask.rows * step.ask.columns) + " numbers");
                step.ask.wrong.back().sample.numbers = numbers;
            });
}

constexpr QuestionKind question_kinds::number = of_numbers(1, 1, add_expected);

constexpr QuestionKind question_kinds::vector =
    of_numbers(3, 1, [](Object<LessonStep>& question, const LessonReading& reading) {
        add_expected(question, reading);
        add_size(question, 12);
    });

constexpr QuestionKind question_kinds::matrix =
    of_numbers(4, 4, [](Object<LessonStep>& question, const LessonReading& reading) {
        add_expected(question, reading);
        add_size(question, 4);
        question.optional("shows_as", form::name(), in_ask(&Ask::shows_as));
    });

}  // namespace viewing
