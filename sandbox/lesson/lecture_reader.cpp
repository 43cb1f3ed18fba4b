#include "lesson/lecture_reader.h"

#include <algorithm>
#include <map>
#include <optional>

#include "lesson/step_reader.h"
#include "text/words.h"

namespace viewing {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_parts = 100;
constexpr int most_minutes = 600;

class LectureReader {
public:
    LectureReader(const fs::path& folder, Mistakes& mistakes) : folder_(folder), mistakes_(mistakes) {}

    Lesson read(const Json& document, const Where& where) {
        const bool is_object = mistakes_.part([&] { require_object(document, where, "an object"); });
        if (!is_object) return std::move(lecture_);
        mistakes_.part([&] { require_keys(document, where, {"lecture", "id", "title", "parts"}); });
        mistakes_.part([&] {
            if (document["lecture"] != 1)
                where.key("lecture").refuse("must be 1, the version of the format that this program reads");
        });
        mistakes_.part([&] { lecture_.id = name_at(document, "id", where); });
        mistakes_.part([&] { lecture_.title = text_at(document, "title", where, true); });
        lecture_.lecture.emplace();
        mistakes_.part([&] { read_parts(document, where.key("parts")); });
        return std::move(lecture_);
    }

private:
    void read_parts(const Json& document, const Where& where) {
        if (!has(document, "parts")) where.refuse("is missing: a list of lessons and presets");
        require_array(document["parts"], where, most_parts, "a list of 1 to 100 parts");
        if (document["parts"].empty()) where.refuse("must have at least one part");
        for (std::size_t i = 0; i < document["parts"].size(); ++i)
            mistakes_.part([&] { read_part(document["parts"][i], where.at(i)); });
    }

    void read_part(const Json& part, const Where& where) {
        require_object(part, where, "an object");
        if (has(part, "lesson") == has(part, "preset")) where.refuse("must have either \"lesson\" or \"preset\"");
        Lecture::Part read;
        read.first = lecture_.steps.size();
        mistakes_.part([&] {
            if (!has(part, "minutes")) where.key("minutes").refuse("is missing: a whole number from 1 to 600");
            read.minutes = read_whole(part["minutes"], where.key("minutes"), 1, most_minutes);
        });
        has(part, "lesson") ? read_lesson_part(part, read, where) : read_preset_part(part, read, where);
        mistakes_.part([&] {
            if (has(part, "title")) read.title = text_at(part, "title", where, true);
        });
        read.count = lecture_.steps.size() - read.first;
        lecture_.minutes += read.minutes;
        lecture_.lecture->parts.push_back(std::move(read));
    }

    void read_lesson_part(const Json& part, Lecture::Part& read, const Where& where) {
        mistakes_.part([&] { require_keys(part, where, {"lesson", "steps", "title", "end", "minutes"}); });
        const Lesson* lesson = nullptr;
        mistakes_.part([&] { lesson = &lesson_of(name_at(part, "lesson", where), where.key("lesson")); });
        bool has_end = true;
        mistakes_.part([&] {
            if (has(part, "end")) has_end = read_bool(part["end"], where.key("end"));
        });
        if (!lesson) return;
        read.lesson = lesson->id;
        read.title = lesson->title;
        if (has_end) read.end = lesson->end;
        if (!has(part, "steps")) {
            lecture_.steps.insert(lecture_.steps.end(), lesson->steps.begin(), lesson->steps.end());
            return;
        }
        mistakes_.part([&] {
            const Where steps = where.key("steps");
            require_array(part["steps"], steps, most_entries, "a list of steps: their numbers, from 1, or their ids");
            if (part["steps"].empty()) steps.refuse("must have at least one step");
            for (std::size_t i = 0; i < part["steps"].size(); ++i)
                mistakes_.part([&] { lecture_.steps.push_back(step_of(*lesson, part["steps"][i], steps.at(i))); });
        });
    }

    static const LessonStep& step_of(const Lesson& lesson, const Json& value, const Where& where) {
        if (!value.is_string())
            return lesson.steps[static_cast<std::size_t>(
                read_whole(value, where, 1, static_cast<int>(lesson.steps.size())) - 1)];
        const std::string id = read_name(value, where);
        std::vector<std::string> ids;
        for (const LessonStep& step : lesson.steps) {
            if (step.id == id) return step;
            ids.push_back(step.id);
        }
        where.refuse("the lesson " + lesson.id + " has no step " + excerpt(id) + suggestion(id, ids));
    }

    void read_preset_part(const Json& part, Lecture::Part& read, const Where& where) {
        mistakes_.part([&] { require_keys(part, where, {"preset", "title", "say", "minutes"}); });
        LessonStep step;
        const bool is_known = mistakes_.part([&] {
            step.id = name_at(part, "preset", where);
            step.start = presets_.get(step.id, where.key("preset"));
        });
        mistakes_.part([&] { step.ask.question = text_at(part, "say", where, true); });
        mistakes_.part([&] { step.say = read.title = text_at(part, "title", where, true); });
        if (!is_known) return;
        const ViewParams usual;
        step.names_lower_left = step.start.params.view.lower_left != usual.lower_left;
        step.names_lower_right = step.start.params.view.lower_right != usual.lower_right;
        step.slides = step.start.titles.slides;
        step.start.preset = nullptr;  // its caption is part.say
        step.revealed = step.start.params;
        lecture_.steps.push_back(std::move(step));
    }

    /// Reads a lesson once: one of the program's by its id, or a file beside the lecture's.
    const Lesson& lesson_of(const std::string& name, const Where& where) {
        const auto known = lessons_.find(name);
        if (known != lessons_.end()) return known->second;
        if (name.find('/') != std::string::npos)
            where.refuse("must be a lesson's id or a file beside this one, got \"" + excerpt(name) + "\"");
        Result<Lesson> lesson = load_lesson(name.ends_with(".json") ? (folder_ / name).string() : name);
        if (!lesson) where.refuse(lesson.error());
        if (lesson->lecture) where.refuse(excerpt(name) + " is a lecture; a part must be a lesson");
        return lessons_.emplace(name, *std::move(lesson)).first->second;
    }

    const fs::path& folder_;
    Mistakes& mistakes_;
    Lesson lecture_;
    PresetShelf presets_;
    std::map<std::string, Lesson> lessons_;
};

}  // namespace

bool is_lecture(const Json& document) {
    return document.is_object() && document.contains("lecture");
}

Lesson read_lecture(const Json& document, const fs::path& folder, const Where& where, Mistakes& mistakes) {
    return LectureReader(folder, mistakes).read(document, where);
}

std::size_t Lecture::part_of(std::size_t step) const {
    std::size_t part = parts.size() - 1;
    while (part > 0 && step < parts[part].first) --part;
    return part;
}

}  // namespace viewing
