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

constexpr std::size_t longest_text = 4000;  // bytes

std::string read_plain_text(const Json& value, const Where& where) {
    if (!value.is_string()) refuse_value(value, where, "a string");
    std::string text = value.get<std::string>();
    if (text.size() > longest_text) where.refuse("longer than " + std::to_string(longest_text) + " bytes");
    if (std::any_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }))
        where.refuse("must not contain line breaks or other control characters");
    return text;
}

}  // namespace

LessonText read_text_of(const Json& value, const Where& where) {
    LessonText text;
    if (value.is_string()) {
        text.by_language.front() = read_plain_text(value, where);
        return text;
    }
    if (!value.is_object()) refuse_value(value, where, "a string or {\"en\": …, \"ko\": …}");
    const std::span<const char* const> languages = names_of<Language>();
    require_keys(value, where, {languages.begin(), languages.end()});
    if (!has(value, "en")) where.key("en").refuse("is missing");
    for (std::size_t i = 0; i < languages.size(); ++i)
        if (has(value, languages[i]))
            text.by_language[i] = read_plain_text(value[languages[i]], where.key(languages[i]));
    return text;
}

form::Form<LessonText> text_form(bool is_needed) {
    const auto read = [](const Json& value, const Where& where) { return read_plain_text(value, where); };
    const auto form = [&](std::size_t least) -> form::Form<std::string> {
        const Json schema = {{"type", "string"},
                             {"minLength", least},
                             {"maxLength", longest_text},
                             {"not", {{"pattern", "[\\u0000-\\u001f]"}}}};
        return {"a string", &Json::is_string, read, [schema](Json&) { return schema; }};
    };
    const auto english = form(is_needed ? 1 : 0);
    form::Object<LessonText> several;
    for (std::size_t i = 0; i < language_count; ++i) {
        const auto text = [i](LessonText & all) -> auto& {
            return all.by_language[i];
        };
        i == 0 ? several.required(names_of<Language>()[i], english, text)
               : several.optional(names_of<Language>()[i], form(0), text);
    }
    const auto one = [](const std::string& text) { return LessonText{{text}}; };
    const auto is_there = [=](const LessonText& text, const Where& where) {
        if (is_needed && text.empty()) where.refuse("must not be empty");
    };
    return form::either<LessonText>("a string or {\"en\": …, \"ko\": …}", {english.then(one), several.form()})
        .then(is_there)
        .named(is_needed ? "needed_text" : "text");
}

form::Form<std::vector<std::string>> names_form() {
    return form::list(form::name(), "a list of names", {most_entries});
}

LessonText text_at(const Json& object, const char* key, const Where& where, bool is_needed) {
    if (!has(object, key)) {
        if (is_needed) where.key(key).refuse("is missing: a string");
        return {};
    }
    LessonText text = read_text_of(object[key], where.key(key));
    if (is_needed && text.empty()) where.key(key).refuse("must not be empty");
    return text;
}

std::string name_at(const Json& object, const char* key, const Where& where) {
    if (!has(object, key)) where.key(key).refuse("is missing: a name");
    return read_name(object[key], where.key(key));
}

std::vector<std::string> names_at(const Json& object, const char* key, const Where& where) {
    std::vector<std::string> names;
    if (!has(object, key)) return names;
    const Where inside = where.key(key);
    require_array(object[key], inside, most_entries, "a list of names");
    for (std::size_t i = 0; i < object[key].size(); ++i) names.push_back(read_name(object[key][i], inside.at(i)));
    return names;
}

std::vector<std::pair<std::string, LessonText>> read_tags(const Json& object, const Where& where) {
    std::vector<std::pair<std::string, LessonText>> tags;
    if (!has(object, "tags")) return tags;
    require_object(object["tags"], where.key("tags"), "an object of names and strings");
    for (const auto& [tag, text] : object["tags"].items())
        tags.emplace_back(tag, read_text_of(text, where.key("tags").key(tag)));
    return tags;
}

}  // namespace viewing
