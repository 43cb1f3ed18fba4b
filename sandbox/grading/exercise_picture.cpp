#include "grading/exercise_picture.h"

#include "grading/state_numbers.h"
#include "lesson/allowed.h"

namespace viewing {

Result<ExercisePicture> exercise_picture(const HandIn& hand_in, const std::string& exercise, Renderer& renderer) {
    const Result<std::vector<Exercise>> all = load_exercises({});
    if (!all) return Error{all.error()};
    const Result<std::vector<Exercise>> one = of_set(*all, exercise);
    if (!one) return Error{one.error()};
    if (one->size() != 1) return Error{"--exercise must name one exercise, not a set"};
    Result<Lesson> made = sheet(*one, hand_in.course, hand_in.student, numbers_at_start(&renderer));
    if (!made) return Error{made.error()};
    const LessonStep& step = made->steps.front();
    ExercisePicture picture{*made, step.start.params};
    const HandInItem* const item = hand_in.find(one->front().id);
    if (!item) return picture;
    for (const Attempt& attempt : item->attempts) {
        if (!attempt.is_goal) continue;
        const Result<Params> changed = changed_start(step, attempt.settings);
        if (!changed) return Error{changed.error()};
        picture.params = *changed;
    }
    return picture;
}

}  // namespace viewing
