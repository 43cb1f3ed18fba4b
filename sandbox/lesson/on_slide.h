// Everything that the program has for one slide of the lecture.
#pragma once

#include "lesson/lesson.h"

namespace viewing {

struct OnSlide {
    struct Step {
        std::string lesson;    ///< the lesson's id
        std::size_t step = 0;  ///< counted from 0
        LessonText title;      ///< the lesson's title
        LessonText question;
    };
    std::vector<NamedFile> presets;
    std::vector<Step> steps;
};

/// Returns the presets and the steps that name the slide, in the order of the lecture. Reads the files of the assets
/// directory, so keep the result.
OnSlide on_slide(int slide);

}  // namespace viewing
