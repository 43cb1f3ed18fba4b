#include "lesson/tree.h"

#include <algorithm>

namespace viewing {

bool has(const Json& object, const char* key) {
    return object.contains(key);
}

std::vector<std::string> keys_of(const Json& object) {
    std::vector<std::string> keys;
    for (const auto& [key, value] : object.items()) keys.push_back(key);
    return keys;
}

namespace {

/// A line of text, not empty if it is needed.
form::Form<std::string> line_form(bool is_needed) {
    const auto is_line = [=](const std::string& text, const Where& where) {
        if (is_needed && text.empty()) where.refuse("must not be empty");
        if (std::any_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }))
            where.refuse("must not contain line breaks or other control characters");
    };
    return form::text("a string", 4000)
        .then(is_line, {{"minLength", is_needed ? 1 : 0}, {"not", {{"pattern", "[\\u0000-\\u001f]"}}}});
}

void append_numbers(const Json& value, std::vector<double>& numbers, const Range& range, std::size_t most,
                    const Where& where) {
    if (value.is_number()) {
        numbers.push_back(read_number(value, where, range));
        return;
    }
    require_array(value, where, most, "a number or a list of numbers");
    for (std::size_t i = 0; i < value.size(); ++i) append_numbers(value[i], numbers, range, most, where.at(i));
}

}  // namespace

form::Form<LessonText> text_form(bool is_needed) {
    const auto one = [](const std::string& text) { return LessonText{{text}}; };
    form::Object<LessonText> several;
    for (std::size_t i = 0; i < language_count; ++i)
        several.add(
            names_of<Language>()[i],
            line_form(is_needed && i == 0), [i](LessonText & text) -> auto& { return text.by_language[i]; }, i == 0);
    return form::either<LessonText>("a string or {\"en\": …, \"ko\": …}",
                                    {line_form(is_needed).then(one), several.form()})
        .named(is_needed ? "needed_text" : "text");
}

form::Form<std::vector<std::string>> names_form() {
    return form::list(form::name(), "a list of names", {most_entries});
}

form::Form<std::vector<std::pair<std::string, LessonText>>> tags_form() {
    const auto text = text_form(false);
    const auto read = [text](const Json& value, const Where& where) {
        require_object(value, where, "an object of names and strings");
        std::vector<std::pair<std::string, LessonText>> tags;
        for (const auto& [tag, said] : value.items()) tags.emplace_back(tag, text.read(said, where.key(tag)));
        return tags;
    };
    return {"an object of names and strings", &Json::is_object, read, [text](Json& definitions) {
                return Json{{"type", "object"}, {"additionalProperties", text.schema(definitions)}};
            }};
}

form::Form<std::vector<double>> numbers_form(const char* name, const Range& range, std::size_t most) {
    const auto read = [=](const Json& value, const Where& where) {
        std::vector<double> numbers;
        append_numbers(value, numbers, range, most, where);
        return numbers;
    };
    const auto schema = [=](Json&) {
        const Json list = form::list_of({{"$ref", std::string("#/$defs/") + name}}, most);
        return Json{{"anyOf", {form::number_in(range), list}}};
    };
    return form::Form<std::vector<double>>{"a number or a list of numbers",
                                           [](const Json& value) { return value.is_number() || value.is_array(); },
                                           read, schema}
        .named(name);
}

}  // namespace viewing
