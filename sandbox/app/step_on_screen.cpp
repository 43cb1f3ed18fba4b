#include "app/step_on_screen.h"

#include "app/resting_window.h"
#include "grading/state_numbers.h"
#include "lesson/questions/question_kind.h"
#include "lesson/questions/seen_answer.h"
#include "state/person/language.h"

namespace viewing {

LessonFindings check_screen(const std::string& lesson_id, const LessonStep& step, const Measurer& measurer) {
    if (step.only_shows() || kind_of(step.ask).is_on_screen) return {};
    const auto found = [&](const std::string& what) { return lesson_id + ", step " + step.id + ": " + what; };
    const Result<Surroundings> numbers = numbers_of(step.start, step.start.params, measurer);
    const Result<Answer> right = numbers ? model_answer(step.ask, *numbers) : Result<Answer>(Error{numbers.error()});
    if (!right) return {};  // check_step reports the error

    PictureRequest request;
    request.size_px = {1600, 1500};  // so tall that the columns do not scroll
    Lesson lesson;
    lesson.id = lesson_id;
    lesson.steps.push_back(step);
    LoadedState state = show_step({.lesson = std::move(lesson), .has_strip = false}, request);
    state.params.ui.language = Language::en;
    // Smooth edges would take most of the time, and only texts about a pinned pixel are about them.
    if (!state.params.view.pixel && !state.params.view.pin) state.params.view.samples = 0;
    const Result<Scene> scene = load_scene(state.params.scene, state.base, state.params.coplanar,
                                           {.origin = state.scene_origin, .reach = state.reach});
    if (!scene) return {};
    const Language spoken = spoken_language();  // the window sets its state's language
    LessonFindings findings;
    RestingWindow window(*measurer.renderer(), state, *scene);
    if (const Status rests = window.rest(request); !rests) findings.push_back(found(rests.error()));
    for (const std::string& sentence : seen_answers(step, *right, window.texts())) findings.push_back(found(sentence));
    if (const Status back = speak(spoken); !back) findings.push_back(found(back.error()));
    return findings;
}

}  // namespace viewing
