#include "lesson/lecture_reader.h"

#include <algorithm>
#include <map>
#include <optional>

#include "lesson/step_reader.h"
#include "text/words.h"

namespace viewing {
namespace {

namespace fs = std::filesystem;

using form::Object;

/// Presets and lessons, each read once.
struct Shelves {
    fs::path folder;
    PresetShelf presets = {};
    std::map<std::string, Lesson> lessons = {};

    /// Returns the program's lesson with this id, or the lesson in a file of this name in the lecture's folder.
    const Lesson* lesson(const std::string& name, const Where& where) {
        const auto known = lessons.find(name);
        if (known != lessons.end()) return &known->second;
        if (name.find('/') != std::string::npos)
            where.refuse("must be a lesson's id or a file beside this one, got \"" + excerpt(name) + "\"");
        Result<Lesson> lesson = load_lesson(name.ends_with(".json") ? (folder / name).string() : name);
        if (!lesson) where.refuse(lesson.error());
        if (lesson->lecture) where.refuse(excerpt(name) + " is a lecture; a part must be a lesson");
        return &lessons.emplace(name, *std::move(lesson)).first->second;
    }
};

/// A part as it is read.
struct PartRead {
    Lecture::Part part;
    std::vector<LessonStep> steps;  ///< a preset's one step, or the chosen steps of `lesson`; empty: all of them
    const Lesson* lesson = nullptr;
    bool has_end = true;
};

const LessonStep& step_of(const Lesson& lesson, const Json& value, const Where& where) {
    if (!value.is_string()) return lesson.steps[read_whole(value, where, 1, static_cast<int>(lesson.steps.size())) - 1];
    const std::string& id = value.get_ref<const std::string&>();
    std::vector<std::string> ids;
    for (const LessonStep& step : lesson.steps) {
        if (step.id == id) return step;
        ids.push_back(step.id);
    }
    where.refuse("the lesson " + lesson.id + " has no step " + excerpt(id) + suggestion(id, ids));
}

Object<PartRead> minutes_of_part() {
    return Object<PartRead>().required(
        "minutes", form::whole(1, 600), [](PartRead & read) -> auto& { return read.part.minutes; });
}

form::Form<PartRead> lesson_part(Shelves& shelves) {
    const auto lesson = [&](const std::string& name, const Where& where) { return shelves.lesson(name, where); };
    const auto as_json = [](const auto& value) { return Json(value); };
    const auto chosen = form::either<Json>("a step's number, from 1, or its id",
                                           {form::whole(1, most_steps).then(as_json), form::name().then(as_json)});
    const auto finish = [](PartRead read) {
        read.part.lesson = read.lesson->id;
        if (read.part.title.empty()) read.part.title = read.lesson->title;
        if (read.has_end) read.part.end = read.lesson->end;
        if (read.steps.empty()) read.steps = read.lesson->steps;
        return read;
    };
    const auto choose = [](PartRead& read, const std::vector<Json>& chosen, const Where& where) {
        for (std::size_t i = 0; read.lesson && i < chosen.size(); ++i)
            where.part([&] { read.steps.push_back(step_of(*read.lesson, chosen[i], where.at(i))); });
    };
    return minutes_of_part()
        .required("lesson", form::name().then(lesson), &PartRead::lesson)
        .optional(
            "title", text_form(true), [](PartRead & read) -> auto& { return read.part.title; })
        .optional("end", form::boolean(), &PartRead::has_end)
        .optional("steps",
                  form::list(chosen, "a list of steps: their numbers, from 1, or their ids",
                             {most_entries, 1, "must have at least one step"}),
                  choose)
        .form({}, "lesson")
        .then(finish);
}

form::Form<PartRead> preset_part(Shelves& shelves) {
    const auto preset = [&](const std::string& name, const Where& where) {
        LessonStep step;
        step.id = name;
        step.start = shelves.presets.get(name, where);
        const ViewParams usual;
        step.names_lower_left = step.start.params.view.lower_left != usual.lower_left;
        step.names_lower_right = step.start.params.view.lower_right != usual.lower_right;
        step.slides = step.start.titles.slides;
        step.start.preset = nullptr;  // the part's own sentence replaces the preset's caption
        step.revealed = step.start.params;
        return std::vector{step};
    };
    const auto start = [] {
        PartRead read;
        read.steps.resize(1);
        return read;
    };
    return minutes_of_part()
        .required("preset", form::name().then(preset), &PartRead::steps)
        .required(
            "say", text_form(true), [](PartRead & read) -> auto& { return read.steps.front().ask.question; })
        .required("title", text_form(true),
                  [](PartRead& read, const LessonText& title) { read.steps.front().say = read.part.title = title; })
        .form(start, "preset");
}

Object<Lesson> lecture_form(Shelves& shelves) {
    const auto part = form::either<PartRead>("an object with either \"lesson\" or \"preset\"",
                                             {lesson_part(shelves), preset_part(shelves)});
    const auto add = [](Lesson& lecture, const std::vector<PartRead>& parts) {
        lecture.lecture.emplace();
        for (const PartRead& read : parts) {
            Lecture::Part& added = lecture.lecture->parts.emplace_back(read.part);
            added.first = lecture.steps.size();
            added.count = read.steps.size();
            lecture.steps.insert(lecture.steps.end(), read.steps.begin(), read.steps.end());
            lecture.minutes += added.minutes;
        }
    };
    return Object<Lesson>()
        .version("lecture")
        .required("id", form::name(), &Lesson::id)
        .required("title", text_form(true), &Lesson::title)
        .required(
            "parts",
            form::list(part, "a list of 1 to 100 parts: lessons and presets", {100, 1, "must have at least one part"}),
            add);
}

}  // namespace

bool is_lecture(const Json& document) {
    return document.is_object() && document.contains("lecture");
}

Lesson read_lecture(const Json& document, const fs::path& folder, const Where& where) {
    Shelves shelves{folder};
    return lecture_form(shelves).read(document, where);
}

std::string lecture_schema() {
    Shelves none;
    return form::document("A lecture of the Viewing Sandbox", lecture_form(none));
}

std::size_t Lecture::part_of(std::size_t step) const {
    std::size_t part = parts.size() - 1;
    while (part > 0 && step < parts[part].first) --part;
    return part;
}

}  // namespace viewing
