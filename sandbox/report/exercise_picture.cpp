#include "report/exercise_picture.h"

#include "lesson/allowed.h"
#include "report/state_numbers.h"
#include "state/json.h"

namespace viewing {

Result<ExercisePicture> exercise_picture(const HandIn& hand_in, const std::string& exercise, Renderer& renderer) {
    const Result<std::vector<Exercise>> all = load_exercises({});
    if (!all) return Error{all.error()};
    const Result<std::vector<Exercise>> one = of_set(*all, exercise);
    if (!one) return Error{one.error()};
    if (one->size() != 1) return Error{"--exercise names one exercise, not a set"};
    Result<Lesson> made = sheet(*one, hand_in.course, hand_in.student, numbers_at_start(&renderer));
    if (!made) return Error{made.error()};
    const LessonStep& step = made->steps.front();
    ExercisePicture picture{*made, step.start.params};
    const HandInItem* const item = hand_in.find(one->front().id);
    if (!item) return picture;
    for (const Attempt& attempt : item->attempts) {
        if (!attempt.is_goal) continue;
        const Result<Params> changed = apply_settings(step.start.params, attempt.settings, "set ");
        if (!changed) return Error{changed.error()};
        const std::vector<std::string> others = changed_without_leave(step.start.params, *changed, step.ask.allow);
        if (!others.empty()) return Error{"the file changes " + others.front() + ", which the exercise does not allow"};
        picture.params = *changed;
    }
    return picture;
}

}  // namespace viewing
