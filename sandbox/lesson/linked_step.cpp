#include "lesson/linked_step.h"

#include <algorithm>

#include "text/words.h"

namespace viewing {

std::optional<Link> lesson_link(std::string_view text) {
    if (!is_link(text)) return std::nullopt;
    Result<Link> link = read_link(text);
    if (!link || link->kind != Link::Kind::lesson) return std::nullopt;
    return *std::move(link);
}

Result<LinkedStep> load_linked_step(const Link& link) {
    Result<Lesson> lesson = load_lesson(link.text);
    if (!lesson) return Error{"link: " + lesson.error()};
    const std::size_t count = lesson->steps.size();
    if (link.step > count)
        return Error{"link: step " + std::to_string(link.step) + ": " + lesson->id + " has steps 1 to " +
                     std::to_string(count)};
    return LinkedStep{*std::move(lesson), link.step - 1};
}

std::optional<std::string> link_to(const Lesson& lesson, std::size_t step) {
    const std::vector<LessonFile> own = lessons();
    const bool is_own = std::any_of(own.begin(), own.end(), [&lesson](const LessonFile& file) {
        return file.id == lesson.id && file.path == lesson.file;
    });
    if (!is_own) return std::nullopt;
    return lesson_fragment(lesson.id, step + 1);
}

}  // namespace viewing
