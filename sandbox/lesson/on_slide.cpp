#include "lesson/on_slide.h"

#include <algorithm>

namespace viewing {
namespace {

bool is_on(int slide, const std::vector<int>& slides) {
    return std::find(slides.begin(), slides.end(), slide) != slides.end();
}

}  // namespace

OnSlide on_slide(int slide) {
    OnSlide found;
    for (NamedFile& preset : presets())
        if (is_on(slide, preset.slides)) found.presets.push_back(std::move(preset));
    for (const LessonFile& file : lessons()) {
        if (!is_on(slide, file.slides)) continue;
        const Result<Lesson> lesson = load_lesson(file.path.string());
        if (!lesson) continue;  // opening the lesson says why
        for (std::size_t i = 0; i < lesson->steps.size(); ++i)
            if (is_on(slide, lesson->steps[i].slides))
                found.steps.push_back({lesson->id, i, lesson->title, lesson->steps[i].ask.question});
    }
    return found;
}

}  // namespace viewing
