// Turns a variant of an exercise into a lesson step: fills the constants into the state, then the state's numbers into
// everything else.
#include <algorithm>
#include <array>
#include <cmath>

#include "lesson/exercise.h"
#include "lesson/filled_text.h"
#include "lesson/questions/question_kind.h"
#include "lesson/step_reader.h"
#include "lesson/variants.h"
#include "text/words.h"

namespace viewing {
namespace {

constexpr std::size_t most_computed = 4096;             // expressions and {…} in a variant
constexpr std::size_t most_computed_bytes = 4U << 20U;  // total of their values, as JSON
constexpr std::array text_keys{"question", "say", "why", "label", "title", "note", "hints", "items", "name", "needed"};

/// Converts whole numbers to integers: vertex 3, not 3.0.
Json with_whole_numbers(Json value) {
    if (value.is_array())
        for (Json& entry : value) entry = with_whole_numbers(std::move(entry));
    if (!value.is_number_float()) return value;
    const double number = value.get<double>();
    constexpr double largest = 9007199254740992.0;  // 2⁵³
    if (number == std::trunc(number) && std::abs(number) < largest) return static_cast<std::int64_t>(number);
    return value;
}

/// Replaces strings that begin with "=", and placeholders in texts and keys, with their values.
class Filling {
public:
    explicit Filling(const Surroundings& surroundings) : surroundings_(surroundings) {}

    Json filled(const Json& value, const Where& where, bool is_text = false) {
        if (value.is_string()) {
            const std::string& text = value.get_ref<const std::string&>();
            if (text.starts_with('=')) return with_whole_numbers(computed(text.substr(1), where));
            return is_text ? Json(with_places(text, where)) : value;
        }
        if (value.is_array()) {
            Json list = Json::array();
            for (std::size_t i = 0; i < value.size(); ++i) list.push_back(filled(value[i], where.at(i), is_text));
            return list;
        }
        if (!value.is_object()) return value;
        Json object = Json::object();
        for (const auto& [key, member] : value.items()) {
            const bool holds_text = std::find(text_keys.begin(), text_keys.end(), key) != text_keys.end();
            object[with_places(key, where)] = filled(member, where.key(key), is_text || holds_text);
        }
        return object;
    }

private:
    Json computed(const std::string& expression, const Where& where) {
        if (++computed_ > most_computed)
            where.refuse("exceeds the limit of " + std::to_string(most_computed) + " expressions and {…} in a variant");
        Result<Json> value = evaluate(expression, surroundings_);
        if (!value) where.refuse(value.error());
        computed_bytes_ += value->dump().size();
        if (computed_bytes_ > most_computed_bytes)
            where.refuse("exceeds the limit of " + std::to_string(most_computed_bytes >> 20U) +
                         " MiB for the values of a variant as JSON");
        return *std::move(value);
    }

    std::string with_places(const std::string& text, const Where& where) {
        constexpr int digits = 6;
        Result<std::string> result = viewing::filled(
            text, [&](const std::string& expression) -> Result<Json> { return computed(expression, where); }, digits);
        if (!result) where.refuse(result.error());
        return *std::move(result);
    }

    const Surroundings& surroundings_;
    std::size_t computed_ = 0, computed_bytes_ = 0;
};

/// Drops wrong answers whose "unless" is true: for these numbers, they are not wrong.
Json wrong_answers(const Json& wrong, const Surroundings& surroundings, const Where& where) {
    Json kept = Json::array();
    for (std::size_t i = 0; i < wrong.size(); ++i) {
        Json one = wrong[i];
        if (one.is_object() && has(one, "unless")) {
            const Where inside = where.at(i).key("unless");
            if (!one["unless"].is_string()) refuse_value(one["unless"], inside, "an expression");
            const Result<bool> is_dropped = holds(one["unless"].get<std::string>(), surroundings);
            if (!is_dropped) inside.refuse(is_dropped.error());
            if (*is_dropped) continue;
            one.erase("unless");
        }
        kept.push_back(std::move(one));
    }
    return kept;
}

LessonStep read_variant(const Exercise& exercise, std::size_t variant, const NumbersAt& numbers_at) {
    const Where root{exercise.source + ": variant " + std::to_string(variant) + ": ", ""};
    const Json constants = Json::parse(exercise.variants[variant]);
    const auto only_constants = [](const std::string& name, std::span<const double>) -> Result<Json> {
        return Error{name + " is not known here: it depends on the state"};
    };
    Json step = Json::parse(exercise.pattern);
    LessonReading reading{exercise.file.parent_path()};
    if (has(step, "state"))
        step["state"] = Filling({only_constants, nullptr, constants}).filled(step["state"], root.key("state"));
    const Json* const state = has(step, "state") ? &step["state"] : nullptr;
    Result<Surroundings> numbers = numbers_at(read_start(state, reading, state ? root.key("state") : root));
    if (!numbers) throw Refusal(root.prefix + numbers.error());
    numbers->constants = constants;
    Filling filling(*numbers);
    for (const auto& [key, value] : step.items()) {
        if (key == "state") continue;
        const bool is_text = std::find(text_keys.begin(), text_keys.end(), key) != text_keys.end();
        if (key == "ask" && value.is_object() && has(value, "wrong") && value["wrong"].is_array())
            value["wrong"] = wrong_answers(value["wrong"], *numbers, root.key("ask").key("wrong"));
        value = filling.filled(value, root.key(key), is_text);
    }
    step["id"] = exercise.id;
    step["let"] = constants;
    const auto title = [&] {
        Json text = Json::object();
        for (std::size_t i = 0; i < language_count; ++i)
            if (!exercise.title.by_language[i].empty()) text[names_of<Language>()[i]] = exercise.title.by_language[i];
        return text;
    };
    if (!has(step, "say")) step["say"] = title();
    if (!has(step, "reveal")) step["reveal"] = {{"say", {{"en", "That is right."}, {"ko", "맞습니다."}}}};
    LessonStep read = step_form(reading).read(step, root);
    if (kind_of(read.ask).is_on_screen && read.ask.allow.empty())
        root.key("step").key("ask").key("allow").refuse("is missing: the fields that the goal may change");
    return read;
}

}  // namespace

Result<LessonStep> variant_step(const Exercise& exercise, std::size_t variant, const NumbersAt& numbers_at) {
    return guarded([&] { return read_variant(exercise, variant, numbers_at); });
}

Lesson empty_sheet(const std::string& course, const std::string& student) {
    Lesson lesson;
    lesson.id = "exercises";
    lesson.title.by_language = {"Exercises", "연습 문제"};
    lesson.sheet = Sheet{course, student, {}};
    return lesson;
}

void add_to_sheet(Lesson& sheet, const Exercise& exercise, std::size_t variant, const LessonStep& step) {
    sheet.steps.push_back(step);
    sheet.sheet->items.push_back({exercise.id, exercise.title, variant, exercise.points});
    for (const auto& tag : exercise.tags)
        if (std::find(sheet.tags.begin(), sheet.tags.end(), tag) == sheet.tags.end()) sheet.tags.push_back(tag);
}

Result<Lesson> sheet(const std::vector<Exercise>& exercises, const std::string& course, const std::string& student,
                     const NumbersAt& numbers_at) {
    Lesson lesson = empty_sheet(course, student);
    for (const Exercise& exercise : exercises) {
        const std::size_t variant = variant_of(course, student, exercise.id, exercise.variants.size());
        const Result<LessonStep> step = variant_step(exercise, variant, numbers_at);
        if (!step) return Error{step.error()};
        add_to_sheet(lesson, exercise, variant, *step);
    }
    if (lesson.steps.empty()) return Error{"there are no exercises to do"};
    return lesson;
}

}  // namespace viewing
