// Reads lesson and lecture files with the same checks as state files. Every message names the file, the step and the
// field.
#include <algorithm>

#include "lesson/lecture_reader.h"
#include "lesson/step_reader.h"
#include "platform/file.h"
#include "state/scene.h"
#include "text/words.h"

namespace viewing {
namespace {

namespace fs = std::filesystem;

/// Reads the topic under which lists show the lesson; "" if there is none.
std::string group_at(const Json& document, const Where& where) {
    if (!has(document, "group")) return "";
    if (!document["group"].is_string()) where.key("group").refuse("must be a topic, such as \"Camera\"");
    return document["group"].get<std::string>();
}

/// Reads what the lesson's last card says: three sentences, and the matching exercise.
LessonEnd read_end(const Json& document, const Where& where) {
    LessonEnd end;
    if (!has(document, "end")) return end;
    const Json& object = document["end"];
    const Where inside = where.key("end");
    require_keys(object, inside, {"says", "exercise"});
    const Where says = inside.key("says");
    constexpr std::size_t sentences = 3;
    if (!has(object, "says")) says.refuse("is missing: three sentences");
    require_array(object["says"], says, sentences, "a list of three sentences");
    if (object["says"].size() != sentences) says.refuse("must have three sentences");
    for (std::size_t i = 0; i < sentences; ++i) {
        end.says.push_back(read_text_of(object["says"][i], says.at(i)));
        if (end.says.back().empty()) says.at(i).refuse("must not be empty");
    }
    if (!has(object, "exercise")) return end;
    end.exercise = read_name(object["exercise"], inside.key("exercise"));
    std::vector<std::string> known;
    for (const fs::path& path : files_in(assets_directory() / "exercises", ".json"))
        known.push_back(path.stem().string());
    if (std::find(known.begin(), known.end(), end.exercise) == known.end())
        inside.key("exercise")
            .refuse("there is no exercise " + excerpt(end.exercise) + suggestion(end.exercise, known));
    return end;
}

Lesson read_lesson(const Json& document, const fs::path& folder, const Where& where, Mistakes& mistakes) {
    Lesson lesson;
    mistakes.part([&] {
        require_keys(
            document, where,
            {"lesson", "id", "title", "group", "slides", "minutes", "picture", "needs", "tags", "steps", "end"});
    });
    if (!document.is_object()) return lesson;
    mistakes.part([&] {
        if (!has(document, "lesson") || document["lesson"] != 1)
            where.key("lesson").refuse("must be 1, the version of the format that this program reads");
    });
    mistakes.part([&] { lesson.id = name_at(document, "id", where); });
    mistakes.part([&] { lesson.title = text_at(document, "title", where, true); });
    mistakes.part([&] { (void)group_at(document, where); });
    mistakes.part([&] { lesson.slides = read_slides(document, where); });
    mistakes.part([&] {
        if (has(document, "minutes")) lesson.minutes = read_whole(document["minutes"], where.key("minutes"), 1, 600);
    });
    mistakes.part([&] { lesson.needs = names_at(document, "needs", where); });
    mistakes.part([&] { lesson.tags = read_tags(document, where); });
    mistakes.part([&] { lesson.end = read_end(document, where); });
    const Where steps = where.key("steps");
    const bool are_steps = mistakes.part([&] {
        if (!has(document, "steps")) steps.refuse("is missing: a list of steps");
        require_array(document["steps"], steps, most_steps, "a list of 1 to 200 steps");
        if (document["steps"].empty()) steps.refuse("must have at least one step");
    });
    PresetShelf presets;
    mistakes.part([&] {
        if (has(document, "picture")) lesson.picture = state_at(document, "picture", folder, presets, where);
    });
    if (!are_steps) return lesson;
    for (std::size_t i = 0; i < document["steps"].size(); ++i) {
        lesson.steps.push_back(read_step(document["steps"][i], folder, presets, steps.at(i), mistakes));
        if (lesson.steps.back().slides.empty()) lesson.steps.back().slides = lesson.slides;
        const std::string& id = lesson.steps.back().id;
        const auto count = std::count_if(lesson.steps.begin(), lesson.steps.end(),
                                         [&](const LessonStep& step) { return !id.empty() && step.id == id; });
        mistakes.part([&] {
            if (count > 1) steps.at(i).key("id").refuse("another step has the id " + excerpt(id));
        });
    }
    return lesson;
}

Lesson read_lesson_or_lecture(const Json& document, const fs::path& folder, const Where& where, Mistakes& mistakes) {
    return is_lecture(document) ? read_lecture(document, folder, {where.prefix, "", &mistakes})
                                : read_lesson(document, folder, where, mistakes);
}

/// Reads the data that a list shows, even if the rest of the file is invalid.
LessonFile glance_at(const fs::path& path) {
    LessonFile file{path.stem().string(), {path.stem().string(), ""}, {}, 0, 0, path};
    const Result<std::string> text = read_text_file(path);
    if (!text) return file;
    const auto glance = guarded([&] {
        const Json document = parse_document(*text, "");
        const Where root{"", ""};
        if (document.contains("id")) file.id = read_name(document["id"], root);
        if (document.contains("title")) file.title = read_text_of(document["title"], root);
        file.group = group_at(document, root);
        file.slides = read_slides(document, root);
        file.needs = names_at(document, "needs", root);
        if (document.contains("minutes")) file.minutes = read_whole(document["minutes"], root, 1, 600);
        if (document.contains("steps")) file.steps = static_cast<int>(document["steps"].size());
        if (has(document, "parts"))
            for (const Json& part : document["parts"])
                if (has(part, "minutes")) file.minutes += read_whole(part["minutes"], root, 1, 600);
        if (!has(document, "steps") || !document["steps"].is_array()) return true;
        file.listed_steps.assign(static_cast<std::size_t>(file.steps), {{}, file.slides});
        for (std::size_t i = 0; i < file.listed_steps.size(); ++i) {
            const Json& step = document["steps"][i];
            if (has(step, "slides")) file.listed_steps[i].slides = read_slides(step, root);
            if (has(step, "ask") && has(step["ask"], "question"))
                file.listed_steps[i].question = read_text_of(step["ask"]["question"], root);
        }
        return true;
    });
    (void)glance;  // parts that cannot be read keep their defaults
    return file;
}

}  // namespace

Result<Lesson> parse_lesson(std::string_view json, const std::string& source, const fs::path& folder) {
    return guarded([&] {
        const Where root{source + ": ", ""};
        Mistakes mistakes;
        Lesson lesson = read_lesson_or_lecture(parse_document(json, root.prefix), folder, root, mistakes);
        mistakes.refuse();
        return lesson;
    });
}

std::vector<std::string> lesson_mistakes(std::string_view json, const std::string& source, const fs::path& folder) {
    const Where root{source + ": ", ""};
    Mistakes mistakes;
    mistakes.part([&] { read_lesson_or_lecture(parse_document(json, root.prefix), folder, root, mistakes); });
    return mistakes.all();
}

namespace {

std::vector<LessonFile> listed(const char* folder) {
    std::vector<LessonFile> files;
    const fs::path assets = assets_directory();
    if (assets.empty()) return files;
    for (const fs::path& path : files_in(assets / folder, ".json")) files.push_back(glance_at(path));
    return files;
}

/// A lesson's or a lecture's file, and its name in messages.
struct NamedSource {
    fs::path path;
    std::string source;
};

Result<NamedSource> source_of(const std::string& argument) {
    const fs::path path(argument);
    if (path.has_parent_path() || path.extension() == ".json") return NamedSource{path, argument};
    std::vector<std::string> ids;
    for (const std::vector<LessonFile>& files : {lessons(), lectures()})
        for (const LessonFile& file : files) {
            if (file.id == argument) return NamedSource{file.path, file.path.filename().string()};
            ids.push_back(file.id);
        }
    return Error{one_line(argument) + ": neither a file nor a lesson (viewing-sandbox lesson --list lists them)" +
                 suggestion(argument, ids)};
}

}  // namespace

std::vector<LessonFile> lessons() {
    return listed("lessons");
}

std::vector<LessonFile> lectures() {
    return listed("lectures");
}

Result<Lesson> load_lesson(const std::string& argument) {
    const Result<NamedSource> named = source_of(argument);
    if (!named) return Error{named.error()};
    const Result<std::string> text = read_text_file(named->path);
    if (!text) return Error{text.error()};
    Result<Lesson> lesson = parse_lesson(*text, named->source, named->path.parent_path());
    if (lesson) lesson->file = named->path;
    return lesson;
}

Result<std::vector<std::string>> lecture_mistakes(const std::string& argument) {
    const Result<NamedSource> named = source_of(argument);
    if (!named) return Error{named.error()};
    const Result<std::string> text = read_text_file(named->path);
    if (!text) return Error{text.error()};
    const Result<bool> is_one = guarded([&] {
        const Where root{named->source + ": ", ""};
        if (!is_lecture(parse_document(*text, root.prefix)))
            root.refuse("is not a lecture: it must have \"lecture\": 1 and \"parts\"");
        return true;
    });
    if (!is_one) return Error{is_one.error()};
    return lesson_mistakes(*text, named->source, named->path.parent_path());
}

}  // namespace viewing
