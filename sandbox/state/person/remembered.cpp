#include "state/person/remembered.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <string>
#include <utility>

#include "platform/file.h"
#include "platform/shared_file.h"
#include "platform/text_file.h"
#include "state/fields.h"
#include "state/file/document.h"
#include "state/file/reader.h"
#include "text/words.h"

namespace viewing {
namespace {

namespace fs = std::filesystem;

constexpr int most_steps = 200;
constexpr std::size_t most_recent = 20;
constexpr int most_units = 100'000;  ///< limit of a position or a size: no screen is larger

std::optional<double> number_in(const Json& value, double min, double max) {
    if (!value.is_number()) return std::nullopt;
    const auto number = value.get<double>();
    return number >= min && number <= max ? std::optional(number) : std::nullopt;
}

glm::ivec2 pair_in(const Json& object, const char* key, int min, const Where& where) {
    const Json pair = object.contains(key) ? object[key] : Json();
    const bool is_pair = pair.is_array() && pair.size() == 2;
    const auto x = is_pair ? number_in(pair[0], min, most_units) : std::nullopt;
    const auto y = is_pair ? number_in(pair[1], min, most_units) : std::nullopt;
    if (!x || !y) where.key(key).refuse("must be two screen coordinates, got " + describe(pair));
    return {static_cast<int>(std::lround(*x)), static_cast<int>(std::lround(*y))};
}

/// Reads {"view-is-the-inverse": {"step": 3, "done": [1, 2]}, …}, where steps count from 1.
LessonsProgress lessons_in(const Json& object, const Where& where) {
    require_object(object, where, "an object of lessons");
    LessonsProgress lessons;
    for (const auto& [id, value] : object.items()) {
        const Where inside = where.key(id);
        require_object(value, inside, "an object with step and done");
        LessonProgress& progress = lessons[id];
        const auto number = [&](const Json& json, const Where& place) {
            return static_cast<std::size_t>(read_whole(json, place, 1, most_steps) - 1);
        };
        if (value.contains("step")) progress.step = number(value["step"], inside.key("step"));
        if (!value.contains("done")) continue;
        require_array(value["done"], inside.key("done"), most_steps, "a list of steps");
        for (const Json& step : value["done"]) progress.done.push_back(number(step, inside.key("done")));
        std::sort(progress.done.begin(), progress.done.end());
    }
    return lessons;
}

Json lessons_as_json(const LessonsProgress& lessons) {
    Json object = Json::object();
    for (const auto& [id, progress] : lessons) {
        Json done = Json::array();
        for (const std::size_t step : progress.done) done.push_back(step + 1);
        object[id] = {{"step", progress.step + 1}, {"done", std::move(done)}};
    }
    return object;
}

Student student_in(const Json& object, const Where& where) {
    require_object(object, where, "an object of strings");
    const auto text = [&](const char* key) {
        return object.contains(key) && object[key] != Json("") ? read_name(object[key], where.key(key)) : std::string();
    };
    return {text("course"), text("number"), text("name")};
}

MouseHabits mouse_in(const Json& object, const Where& where) {
    require_object(object, where, "an object of the mouse's settings");
    const auto is_on = [&](const char* key, bool usual) {
        return object.contains(key) ? read_bool(object[key], where.key(key)) : usual;
    };
    const MouseHabits usual;
    return {is_on("keep_horizon", usual.keeps_horizon), is_on("right_pans", usual.right_pans),
            is_on("middle_pans", usual.middle_pans), is_on("invert_y", usual.inverts_y),
            object.contains("sensitivity") ? read_number(object["sensitivity"], where.key("sensitivity"),
                                                         {least_sensitivity, greatest_sensitivity})
                                           : usual.sensitivity};
}

Json mouse_as_json(const MouseHabits& mouse) {
    return {{"keep_horizon", mouse.keeps_horizon},
            {"right_pans", mouse.right_pans},
            {"middle_pans", mouse.middle_pans},
            {"invert_y", mouse.inverts_y},
            {"sensitivity", mouse.sensitivity}};
}

template <typename Enum>
std::optional<Enum> name_in(const Json& object, const char* key, const Where& where) {
    if (!object.contains(key)) return std::nullopt;
    const std::span<const char* const> names = names_of<Enum>();
    const auto at = std::find_if(names.begin(), names.end(), [&](const char* name) { return object[key] == name; });
    if (at == names.end()) where.key(key).refuse("must be one of " + joined(names) + ", got " + describe(object[key]));
    return static_cast<Enum>(at - names.begin());
}

Remembered remembered_in(const Json& document, const Where& where) {
    if (!document.is_object()) where.refuse("must be an object, got " + describe(document));
    Remembered remembered;
    remembered.theme = name_in<Theme>(document, "theme", where);
    remembered.language = name_in<Language>(document, "language", where);
    if (document.contains("scale")) {
        const Range range = component_range(field("ui.scale"), 0);
        remembered.scale = number_in(document["scale"], range.min, range.max);
        if (!remembered.scale) where.key("scale").refuse("must be a scale factor, got " + describe(document["scale"]));
    }
    if (document.contains("window")) {
        const Json& window = document["window"];
        const Where inside = where.key("window");
        if (!window.is_object()) inside.refuse("must be an object, got " + describe(window));
        remembered.window = WindowPlace{pair_in(window, "position", -most_units, inside),
                                        pair_in(window, "size", 1, inside), window.value("maximised", Json()) == true};
    }
    if (document.contains("lessons")) remembered.lessons = lessons_in(document["lessons"], where.key("lessons"));
    if (document.contains("lesson")) remembered.lesson = read_name(document["lesson"], where.key("lesson"));
    if (document.contains("recent")) {
        const Where inside = where.key("recent");
        require_array(document["recent"], inside, most_recent, "a list of files");
        for (const Json& file : document["recent"]) remembered.recent.push_back(read_name(file, inside));
    }
    if (document.contains("mouse")) remembered.mouse = mouse_in(document["mouse"], where.key("mouse"));
    if (document.contains("student")) remembered.student = student_in(document["student"], where.key("student"));
    return remembered;
}

LessonsProgress merged_lessons(LessonsProgress kept, const LessonsProgress& known, const LessonsProgress& now) {
    for (const auto& [id, progress] : now) {
        const auto before = known.find(id);
        LessonProgress& merged = kept[id];
        if (before == known.end() || before->second.step != progress.step) merged.step = progress.step;
        std::vector<std::size_t> both;
        std::set_union(merged.done.begin(), merged.done.end(), progress.done.begin(), progress.done.end(),
                       std::back_inserter(both));
        merged.done = std::move(both);
    }
    return kept;
}

/// Returns the files opened since `known`, followed by the files listed in `kept`.
std::vector<std::string> merged_recent(const std::vector<std::string>& kept, const std::vector<std::string>& known,
                                       std::vector<std::string> now) {
    const auto is_as_it_was = [&](auto rest) {
        std::vector<std::string> left;
        for (const std::string& file : known)
            if (std::find(now.begin(), rest, file) == rest) left.push_back(file);
        return std::distance(rest, now.end()) <= std::ssize(left) && std::equal(rest, now.end(), left.begin());
    };
    auto rest = now.begin();
    while (!is_as_it_was(rest)) ++rest;
    now.erase(rest, now.end());
    for (const std::string& file : kept)
        if (std::find(now.begin(), now.end(), file) == now.end()) now.push_back(file);
    now.resize(std::min(now.size(), most_recent));
    return now;
}

}  // namespace

Remembered merged(const Remembered& kept, const Remembered& known, const Remembered& now) {
    Remembered merged = kept;
    const auto take_what_changed = [&](auto member) {
        if (now.*member != known.*member) merged.*member = now.*member;
    };
    take_what_changed(&Remembered::theme);
    take_what_changed(&Remembered::scale);
    take_what_changed(&Remembered::window);
    take_what_changed(&Remembered::language);
    take_what_changed(&Remembered::mouse);
    take_what_changed(&Remembered::student);
    take_what_changed(&Remembered::lesson);
    merged.lessons = merged_lessons(kept.lessons, known.lessons, now.lessons);
    merged.recent = merged_recent(kept.recent, known.recent, now.recent);
    return merged;
}

fs::path remembered_file() {
    const auto folder_in = [](const char* variable) {
        const char* value = std::getenv(variable);
        const fs::path folder = value ? value : "";
        return folder.is_absolute() ? folder : fs::path();
    };
    fs::path folder = folder_in("XDG_CONFIG_HOME");
    if (folder.empty())
        if (const fs::path home = folder_in("HOME"); !home.empty()) folder = home / ".config";
    return folder.empty() ? folder : folder / "viewing-sandbox" / "window.json";
}

Result<Remembered> read_remembered(const fs::path& file) {
    std::error_code error;
    if (file.empty() || fs::symlink_status(file, error).type() == fs::file_type::not_found) return Remembered{};
    const Result<std::string> text = read_text_file(file);
    if (!text) return Error{text.error()};
    const Where where{file.string() + ": ", ""};
    return guarded([&] { return remembered_in(parse_document(*text, where.prefix), where); });
}

Status write_remembered(const fs::path& file, const Remembered& remembered) {
    if (file.empty()) return std::monostate{};
    Json document = Json::object();
    if (remembered.theme) document["theme"] = name_of(*remembered.theme);
    if (remembered.scale) document["scale"] = *remembered.scale;
    if (remembered.language) document["language"] = name_of(*remembered.language);
    if (const auto& window = remembered.window)
        document["window"] = {{"position", {window->position.x, window->position.y}},
                              {"size", {window->size.x, window->size.y}},
                              {"maximised", window->maximized}};
    if (!remembered.lessons.empty()) document["lessons"] = lessons_as_json(remembered.lessons);
    if (!remembered.lesson.empty()) document["lesson"] = remembered.lesson;
    if (remembered.student != Student{})
        document["student"] = {{"course", remembered.student.course},
                               {"number", remembered.student.number},
                               {"name", remembered.student.name}};
    if (remembered.mouse != MouseHabits{}) document["mouse"] = mouse_as_json(remembered.mouse);
    if (!remembered.recent.empty()) document["recent"] = remembered.recent;
    const std::string text = print_document(document) + "\n";
    std::error_code failed;
    fs::create_directories(file.parent_path(), failed);
    if (failed) return Error{file.parent_path().string() + ": " + failed.message()};
    return write_file(file, text);
}

Result<Remembered> merge_remembered(const fs::path& file, const Remembered& known, const Remembered& now) {
    if (file.empty()) return now;
    return merge_into_file<Remembered>(
        file, read_remembered, [&](const Remembered& kept) { return merged(kept, known, now); },
        [&](const Remembered& merged) { return write_remembered(file, merged); });
}

bool is_reachable(const WindowPlace& window, std::span<const WindowPlace> screens) {
    constexpr int least = 100;
    return std::any_of(screens.begin(), screens.end(), [&](const WindowPlace& screen) {
        const glm::ivec2 min = glm::max(window.position, screen.position);
        const int right = std::min(window.position.x + window.size.x, screen.position.x + screen.size.x);
        return right - min.x >= least && window.position.y >= screen.position.y &&
               window.position.y + least <= screen.position.y + screen.size.y;
    });
}

}  // namespace viewing
