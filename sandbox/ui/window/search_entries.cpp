#include "ui/window/search_entries.h"

#include <algorithm>
#include <array>

#include "state/file/state_json.h"
#include "text/catalogue.h"
#include "text/per_enum.h"
#include "text/words.h"
#include "ui/parts/field_controls.h"
#include "ui/views/lower_view.h"

namespace viewing {
namespace {

std::string in_both_languages(const char* english) {
    return std::string(english) + "\n" + tr(english) + "\n";
}

std::string in_all_languages(const LessonText& text) {
    std::string all;
    for (const std::string& one : text.by_language) all += one + "\n";
    return all;
}

/// The value of a setting: "0.1" for "projection.near=0.1".
std::string value_in(const std::string& setting) {
    return setting.substr(setting.find('=') + 1);
}

bool is_part_covered(const std::vector<std::string>& covered, const std::string& target) {
    return std::any_of(covered.begin(), covered.end(), [&](const std::string& name) {
        return widgets::Contains(name, target) || widgets::Contains(target, name);
    });
}

bool can_be_typed(const Field& field) {
    static constexpr std::string_view types[] = {"bool", "int", "number", "vec3", "vec4", "color", "enum"};
    return field.path != "version" &&
           std::find(std::begin(types), std::end(types), type_name(field)) != std::end(types);
}

bool may_change(const SearchLimits& limits, const Field& field) {
    if (is_part_covered(limits.covered, target_of(field.path))) return false;
    if (!limits.movable || is_in(field.path, "ui")) return true;
    return std::any_of(limits.movable->begin(), limits.movable->end(),
                       [&](const std::string& allowed) { return is_in(field.path, allowed); });
}

/// Collects entries; names and descriptions are kept in lower case.
struct Entries {
    std::vector<SearchEntry> all;
    void add(EntryKind kind, std::string title, std::string note, SearchChoice choice, const std::string& names,
             const std::string& about = "") {
        std::string lower = in_lower_case(title + "\n" + names);
        all.push_back(
            {kind, std::move(title), std::move(note), std::move(choice), std::move(lower), in_lower_case(about), {}});
    }
};

void add_field(Entries& entries, const Field& field, const Params& params) {
    const std::string path(field.path), label(field.label), setting = setting_of(path, params);
    const std::string value = value_in(setting);
    std::string toggled;
    if (value == "true" || value == "false") toggled = path + "=" + (value == "true" ? "false" : "true");
    std::string words = path;
    std::replace_if(
        words.begin(), words.end(), [](char c) { return c == '.' || c == '_'; }, ' ');
    const std::string title = tr(label.c_str());
    entries.add(EntryKind::field, title + " · " + path, value, FieldChoice{field.path, toggled},
                in_both_languages(label.c_str()) + words);
}

void add_preset(Entries& entries, const NamedFile& preset) {
    std::string about = in_both_languages(preset.about.c_str()) + in_both_languages(preset.group.c_str());
    const std::string_view fixed = std::string_view(preset.fixed_by).substr(0, preset.fixed_by.find('='));
    if (const Field* const field = find_field(fixed)) about += in_both_languages(std::string(field->label).c_str());
    entries.add(preset.fixed_by.empty() ? EntryKind::preset : EntryKind::trouble, tr(preset.title.c_str()),
                tr(preset.group.c_str()), PresetChoice{preset.name}, preset.title + "\n" + preset.name, about);
    entries.all.back().slides = preset.slides;
}

void add_lesson(Entries& entries, const LessonFile& lesson, std::size_t number) {
    const std::string title = in_all_languages(lesson.title), file = lesson.path.string();
    entries.add(EntryKind::lesson, lesson.title.shown(), std::to_string(number),
                LessonPlace{lesson.id, file, std::nullopt}, title + lesson.id);
    entries.all.back().slides = lesson.slides;
    for (std::size_t i = 0; i < lesson.listed_steps.size(); ++i) {
        const LessonText& question = lesson.listed_steps[i].question;
        if (question.empty()) continue;
        entries.add(EntryKind::step, question.shown(), std::to_string(number) + "/" + std::to_string(i + 1),
                    LessonPlace{lesson.id, file, i}, in_all_languages(question), title + lesson.id);
        entries.all.back().slides = lesson.listed_steps[i].slides;
    }
}

}  // namespace

const char* name_of_kind(EntryKind kind) {
    static constexpr auto names =
        per_enum<EntryKind>(marked("command"), marked("setting"), marked("mistake"), marked("preset"), marked("view"),
                            marked("lesson"), marked("step"), marked("exercise"));
    return names[kind];
}

std::vector<SearchEntry> search_entries(const SearchLists& lists, const SearchLimits& limits, const Params& params) {
    Entries entries;
    for (const WindowCommand& command : window_commands())
        if (*command.name && command.is_in(limits.place))
            entries.add(EntryKind::command, tr(command.name), key_text(command.key), &command, command.name);
    for (const Field& field : fields())
        if (can_be_typed(field) && may_change(limits, field)) add_field(entries, field, params);
    for (const NamedFile& preset : lists.presets) add_preset(entries, preset);
    const std::span<const char* const> topics = topic_titles();
    for (std::size_t i = 1; limits.may_choose_view && i < topics.size(); ++i) {
        const auto topic = static_cast<Topic>(i);
        const std::string name(name_of(topic));
        if (is_part_covered(limits.covered, "view:" + name)) continue;
        entries.add(EntryKind::view, tr(topics[i]), is_shown(params, topic) ? "✓" : "", topic,
                    std::string(topics[i]) + "\n" + name);
    }
    for (std::size_t i = 0; i < lists.lessons.size(); ++i) add_lesson(entries, lists.lessons[i], i + 1);
    for (const ExerciseTitle& exercise : lists.exercises)
        entries.add(EntryKind::exercise, exercise.title.shown(), exercise.id.substr(0, exercise.id.find('-')),
                    ExerciseChoice{exercise.id}, in_all_languages(exercise.title) + exercise.id);
    return std::move(entries.all);
}

}  // namespace viewing
