// Reads lesson and lecture files with the same checks as state files. Every message names the file, the step and the
// field.
#include <algorithm>
#include <set>

#include "lesson/lecture_reader.h"
#include "lesson/step_reader.h"
#include "platform/file.h"
#include "state/scene.h"
#include "text/words.h"

namespace viewing {
namespace {

namespace fs = std::filesystem;

using form::Object;

/// The topic under which lists show the lesson.
form::Form<std::string> group_form() {
    return form::text("a topic, such as \"Camera\"");
}

/// What the lesson's last card says: three sentences, and the matching exercise.
form::Form<LessonEnd> end_form() {
    const auto is_there = [](const std::string& exercise, const Where& where) {
        std::vector<std::string> known;
        for (const fs::path& path : files_in(assets_directory() / "exercises", ".json"))
            known.push_back(path.stem().string());
        if (std::find(known.begin(), known.end(), exercise) == known.end())
            where.refuse("there is no exercise " + excerpt(exercise) + suggestion(exercise, known));
    };
    return Object<LessonEnd>()
        .required("says", form::list(text_form(true), "a list of three sentences", {3, 3, "must have three sentences"}),
                  &LessonEnd::says)
        .optional("exercise", form::name().then(is_there), &LessonEnd::exercise)
        .form();
}

Object<Lesson> lesson_form(LessonReading& reading) {
    const auto add = [](Lesson& lesson, const std::vector<LessonStep>& steps, const Where& where) {
        std::set<std::string> ids;
        for (LessonStep& step : lesson.steps = steps) {
            if (step.slides.empty()) step.slides = lesson.slides;
            if (!step.id.empty() && !ids.insert(step.id).second)
                where.part([&] {
                    where.at(static_cast<std::size_t>(&step - lesson.steps.data()))
                        .key("id")
                        .refuse("another step has the id " + excerpt(step.id));
                });
        }
    };
    return Object<Lesson>()
        .version("lesson")
        .required("id", form::name(), &Lesson::id)
        .required("title", text_form(true), &Lesson::title)
        .checked("group", group_form())
        .optional("slides", form::slides(), &Lesson::slides)
        .optional("minutes", form::whole(1, 600), &Lesson::minutes)
        .optional("needs", names_form(), &Lesson::needs)
        .optional("tags", tags_form(), &Lesson::tags)
        .optional("end", end_form(), &Lesson::end)
        .optional("picture", state_form(reading), &Lesson::picture)
        .required(
            "steps",
            form::list(step_form(reading), "a list of 1 to 200 steps", {most_steps, 1, "must have at least one step"}),
            add);
}

Lesson read_lesson_or_lecture(const Json& document, const fs::path& folder, const Where& where) {
    if (is_lecture(document)) return read_lecture(document, folder, where);
    LessonReading reading{folder};
    return lesson_form(reading).read(document, where);
}

/// Reads the data that a list shows, even if the rest of the file is invalid.
LessonFile glance_at(const fs::path& path) {
    LessonFile file{path.stem().string(), {path.stem().string(), ""}, {}, 0, 0, path};
    const Result<std::string> text = read_text_file(path);
    if (!text) return file;
    // Make the forms only once: the window's start page reads every lesson's file in this way.
    static const form::Form<LessonText> question = text_form(false);
    static const form::Form<std::vector<int>> slides = form::slides();
    static const Object<LessonFile> glance = Object<LessonFile>()
                                                 .optional("id", form::name(), &LessonFile::id)
                                                 .optional("title", text_form(false), &LessonFile::title)
                                                 .optional("group", group_form(), &LessonFile::group)
                                                 .optional("slides", slides, &LessonFile::slides)
                                                 .optional("needs", names_form(), &LessonFile::needs)
                                                 .optional("minutes", form::whole(1, 600), &LessonFile::minutes);
    const auto read = guarded([&] {
        const Json document = parse_document(*text, "");
        const Where root{"", ""};
        glance.read_members(file, document, root);
        if (has(document, "parts"))
            for (const Json& part : document["parts"])
                if (has(part, "minutes")) file.minutes += read_whole(part["minutes"], root, 1, 600);
        if (!has(document, "steps") || !document["steps"].is_array()) return true;
        file.steps = static_cast<int>(document["steps"].size());
        file.listed_steps.assign(document["steps"].size(), {{}, file.slides});
        for (std::size_t i = 0; i < file.listed_steps.size(); ++i) {
            const Json& step = document["steps"][i];
            LessonFile::Step& listed = file.listed_steps[i];
            if (has(step, "slides")) listed.slides = slides.read(step["slides"], root);
            if (has(step, "ask") && has(step["ask"], "question"))
                listed.question = question.read(step["ask"]["question"], root);
        }
        return true;
    });
    (void)read;  // parts that cannot be read keep their defaults
    return file;
}

}  // namespace

std::string lesson_schema() {
    LessonReading none;
    return form::document("A lesson of the Viewing Sandbox", lesson_form(none));
}

Result<Lesson> parse_lesson(std::string_view json, const std::string& source, const fs::path& folder) {
    return guarded([&] {
        const Where root{source + ": ", ""};
        return read_lesson_or_lecture(parse_document(json, root.prefix), folder, root);
    });
}

std::vector<std::string> lesson_mistakes(std::string_view json, const std::string& source, const fs::path& folder) {
    std::vector<std::string> mistakes;
    const Where root{source + ": ", "", &mistakes};
    root.part([&] { read_lesson_or_lecture(parse_document(json, root.prefix), folder, root); });
    return mistakes;
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
    return Error{one_line(argument) +
                 ": neither a file nor a lesson or lecture (viewing-sandbox lesson --list and lecture --list "
                 "list them)" +
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
