// Questions whose answer consists of tiles: put in order (order, product), clicked in order (sequence), or chosen in
// any order (subset).
#include <algorithm>

#include "lesson/questions/question_form.h"

namespace viewing {
namespace {

using form::Object;

constexpr int most_tiles = 12;

form::Form<std::vector<int>> items_form() {
    return form::list(form::whole(0, most_tiles - 1), "a list of item indices, from 0", {most_entries});
}

void check_items(const std::vector<int>& items, const Ask& ask, const Where& where) {
    for (std::size_t i = 0; i < items.size() && !ask.items.empty(); ++i)  // none: they could not be read
        if (items[i] >= std::ssize(ask.items))
            where.at(i).refuse("must be a whole number from 0 to " + std::to_string(ask.items.size() - 1));
}

/// One list of indices, or several lists that are equally right.
form::Form<std::vector<std::vector<int>>> expected_items_form() {
    using Lists = std::vector<std::vector<int>>;
    auto several = form::list(items_form(), "a list of lists", {most_entries, 1});
    several.takes = [](const Json& value) { return value.is_array() && !value.empty() && value[0].is_array(); };
    return form::either<Lists>("a list of item indices, from 0",
                               {several, items_form().then([](const std::vector<int>& one) { return Lists{one}; })});
}

void add_items(Object<LessonStep>& question, const LessonReading&) {
    const auto expect = [](LessonStep& step, const std::vector<std::vector<int>>& lists, const Where& where) {
        for (const std::vector<int>& items : lists) check_items(items, step.ask, where);
        step.ask.expected_items = lists;
    };
    question
        .required("items",
                  form::list(text_form(false), "a list of two to twelve strings",
                             {most_tiles, 2, "must have at least two items"})
                      .strict(),
                  in_ask(&Ask::items))
        .required("expect", expected_items_form(), expect);
}

/// Reads the tiles and, if the file has them, their matrices.
void add_items_and_factors(Object<LessonStep>& question, const LessonReading& reading) {
    add_items(question, reading);
    question.optional("factors", expressions_form(reading), in_ask(&Ask::factors))
        .optional("shows_as", form::name(), in_ask(&Ask::shows_as))
        .need({"shows_as"}, "factors");
}

/// Says what is right about chosen tiles.
Verdict near_set(const Ask& ask, const Answer& answer, const Surroundings&) {
    Verdict verdict;
    const std::vector<int>& items = answer.items;
    if (items.empty() || ask.expected_items.empty()) return verdict;
    const auto holds_all = [](const std::vector<int>& all, const std::vector<int>& some) {
        return std::all_of(some.begin(), some.end(),
                           [&](int one) { return std::find(all.begin(), all.end(), one) != all.end(); });
    };
    for (const std::vector<int>& expected : ask.expected_items) {
        if (holds_all(expected, items)) verdict.near = Near::incomplete;
        if (holds_all(items, expected)) verdict.near = Near::too_many;
    }
    if (verdict.near != Near::nothing) return verdict;
    const std::vector<int>& expected = ask.expected_items.front();
    const auto right = static_cast<int>(std::count_if(items.begin(), items.end(), [&](int one) {
        return std::find(expected.begin(), expected.end(), one) != expected.end();
    }));
    verdict.near = right == 0 ? Near::no_items : Near::some_items;
    if (right > 0) verdict.places = {right};
    return verdict;
}

/// Says how many tiles at the beginning are right.
Verdict near_order(const Ask& ask, const Answer& answer, const Surroundings&) {
    Verdict verdict;
    const std::vector<int>& items = answer.items;
    if (items.empty() || ask.expected_items.empty()) return verdict;
    int most = 0;
    for (const std::vector<int>& expected : ask.expected_items) {
        const auto end = std::mismatch(items.begin(), items.end(), expected.begin(), expected.end());
        most = std::max(most, static_cast<int>(end.first - items.begin()));
    }
    verdict.near = most == 0 ? Near::first_wrong : Near::first_items;
    if (most > 0) verdict.places = {most};
    return verdict;
}

std::vector<int> sorted(std::vector<int> items) {
    std::sort(items.begin(), items.end());
    return items;
}

void read_wrong_items(Object<LessonStep>& wrong) {
    for (const char* const key : sample_keys)
        wrong.optional(key, items_form(), [](LessonStep& step, const std::vector<int>& items, const Where& where) {
            check_items(items, step.ask, where);
            step.ask.wrong.back().sample.items = items;
        });
}

bool are_same_items(const Ask&, const Answer& answer, const Answer& sample) {
    return answer.items == sample.items;
}

bool are_same_set(const Ask&, const Answer& answer, const Answer& sample) {
    return sorted(answer.items) == sorted(sample.items);
}

constexpr QuestionKind of_items(decltype(QuestionKind::read) read, const char* between, bool sorts) {
    return {
        .read = read,
        .read_wrong = read_wrong_items,
        .is_right = [](const Ask& ask, const Answer& answer, const Surroundings&) -> Result<bool> {
            return std::any_of(ask.expected_items.begin(), ask.expected_items.end(), [&](const auto& expected) {
                return kind_of(ask).are_same(ask, answer, {{}, expected});
            });
        },
        .are_same = are_same_items,
        .near = near_order,
        .model = [](const Ask& ask, const Surroundings&) -> Result<Answer> {
            return ask.expected_items.empty() ? Answer{} : Answer{{}, ask.expected_items.front()};
        },
        .in_words =
            [](const Ask& ask, const Answer& model) {
                std::string words;
                for (const int item : model.items)
                    words += (words.empty() ? "" : kind_of(ask).between) + ask.items[item].shown();
                return words;
            },
        .between = between,
        .has_items = true,
        .is_ordered = true,
        .sorts = sorts,
        .needs_check = true,
    };
}

constexpr QuestionKind of_set() {
    QuestionKind kind = of_items(add_items, ", ", false);
    kind.are_same = are_same_set;
    kind.near = near_set;
    kind.is_ordered = false;
    return kind;
}

}  // namespace

constexpr QuestionKind question_kinds::sequence = of_items(add_items_and_factors, " → ", false);
constexpr QuestionKind question_kinds::order = of_items(add_items, " → ", true);
constexpr QuestionKind question_kinds::product = of_items(add_items_and_factors, " · ", true);
constexpr QuestionKind question_kinds::subset = of_set();

}  // namespace viewing
