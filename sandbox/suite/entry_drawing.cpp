#include "suite/entry_drawing.h"

#include "frame/finite.h"
#include "frame/plan/plan.h"
#include "frame/problems.h"
#include "grading/exercise_picture.h"
#include "platform/file.h"
#include "report/as_json.h"
#include "report/matrices_report.h"
#include "state/file/state_json.h"
#include "text/numbers.h"
#include "topics/depth/measured/fighting_as_json.h"
#include "topics/hidden/measured/order_report.h"
#include "topics/hidden/measured/visibility_report.h"
#include "topics/hidden/numbers/hidden_views.h"
#include "topics/planes/measured/mirror_report.h"

namespace viewing {
namespace {

Result<LoadedState> plain_state(const SuiteEntry& entry) {
    if (entry.inline_state.empty()) return load_state(entry.state);
    const Result<Params> params = parse_state(entry.inline_state, entry.name);
    if (!params) return Error{params.error()};
    LoadedState state;
    state.params = *params;
    state.scene_origin = entry.name + ": scene";
    return state;
}

/// Loads the state of a lesson's step; for a picture of the window, also adds the lesson to `request`.
Result<LoadedState> lesson_state(const SuiteStep& step, PictureRequest& request) {
    Result<Lesson> lesson = load_lesson(step.lesson);
    if (!lesson) return Error{lesson.error()};
    const auto count = static_cast<int>(lesson->steps.size());
    if (step.step > count)
        return Error{step.lesson + " has " + counted(count, "step") + ", but no step " + std::to_string(step.step)};
    const auto index = static_cast<std::size_t>(step.step - 1);
    return show_step({*std::move(lesson), index, step.revealed, step.presents, true}, request);
}

Result<LoadedState> exercise_state(const SuiteStep& step, PictureRequest& request, Renderer& renderer) {
    const HandIn nothing{{}, step.course, step.student, {}, {}};
    Result<ExercisePicture> shown = exercise_picture(nothing, step.exercise, renderer);
    if (!shown) return Error{shown.error()};
    LoadedState state = show_step({std::move(shown->lesson), 0, false, false, true}, request);
    state.params = shown->params;
    return state;
}

Result<LoadedState> state_of(const SuiteEntry& entry, PictureRequest& request, Renderer& renderer) {
    if (!entry.step) return plain_state(entry);
    return entry.step->lesson.empty() ? exercise_state(*entry.step, request, renderer)
                                      : lesson_state(*entry.step, request);
}

Result<Json> measured(const SuiteMeasure& measure, const SuiteSubject& subject, Renderer& renderer) {
    const Params& params = subject.state.params;
    const glm::ivec2 size_px = subject.request.size_px;
    if (measure.what == "order") return order_as_json(params, subject.scene, size_px);
    if (measure.what == "fighting") return fighting_as_json(renderer, params, subject.scene, size_px);
    if (measure.what == "mirror") return mirror_as_json(renderer, params, subject.scene, size_px);
    return visibility_as_json(renderer, params, subject.scene, size_px);
}

}  // namespace

Result<SuiteSubject> subject_of(const SuiteEntry& entry, Renderer& renderer, bool allows_outside) {
    SuiteSubject subject;
    subject.request = {entry.view, entry.size_px, entry.samples, nullptr};
    Result<LoadedState> state = state_of(entry, subject.request, renderer);
    if (!state) return Error{state.error()};
    const Result<Params> params = apply_settings(state->params, entry.settings, entry.name + ": set: ");
    if (!params) return Error{params.error()};
    state->params = *params;
    state->reach.is_everywhere = state->reach.is_everywhere || allows_outside;
    Result<Scene> scene = load_scene(state->params.scene, state->base, state->params.coplanar,
                                     {.origin = state->scene_origin, .reach = state->reach});
    if (!scene) return Error{scene.error()};
    subject.state = *std::move(state);
    subject.scene = *std::move(scene);
    const Params& wanted = subject.state.params;
    subject.derived = derive(wanted, subject.scene, Viewport{entry.size_px});
    if (const Status finite = check_finite(subject.derived); !finite) return Error{finite.error()};
    if (const auto question = hidden_question(wanted, subject.derived, entry.size_px))
        if (const Message why = beyond_hidden_budget(subject.scene, *question); !why.empty()) return Error{say(why)};
    return subject;
}

std::string fingerprint(const SuiteEntry& entry, const SuiteSubject& subject) {
    std::string text = write_state(subject.state.params);
    const auto add = [&text](const auto&... parts) { ((text += "\n" + std::string(parts)), ...); };
    const auto number = [](auto value) { return std::to_string(value); };
    add(number(static_cast<int>(entry.view)), number(entry.size_px.x), number(entry.size_px.y),
        number(entry.samples.value_or(-1)), number(entry.limits.worst), format_number(entry.limits.share),
        number(entry.limits.reach_px), number(static_cast<int>(entry.limits.profile)),
        entry.checks_picture ? "picture" : "");
    for (const MaskRect& rect : entry.mask.rects)
        add("mask", number(rect.x), number(rect.y), number(rect.width), number(rect.height));
    for (const std::filesystem::path& file : entry.mask.pictures) add("mask", file.string(), all_bytes(file));
    if (entry.matrices_tolerance) add("matrices", format_number(*entry.matrices_tolerance));
    for (const SuiteMeasure& measure : entry.measures) add(measure.what, format_number(measure.tolerance));
    for (const std::string& problem : entry.wanted_problems) add("must", problem);
    for (const std::string& problem : entry.unwanted_problems) add("must not", problem);
    if (entry.allows_no_problem) add("none");
    if (entry.step)
        add(entry.step->lesson, number(entry.step->step), entry.step->revealed ? "revealed" : "",
            entry.step->presents ? "present" : "", entry.step->exercise, entry.step->course, entry.step->student);
    for (const std::filesystem::path& file : subject.scene.read) add(file.string(), all_bytes(file));
    return text;
}

std::vector<Problem> problems_of(const SuiteSubject& subject) {
    const Params& params = subject.state.params;
    return find_problems(params, subject.derived, subject.scene, plan(params, subject.derived));
}

Result<Json> numbers_of_entry(const SuiteEntry& entry, const SuiteSubject& subject,
                              const std::vector<Problem>& problems, Renderer& renderer) {
    Json numbers;
    if (entry.matrices_tolerance) numbers["matrices"] = matrices_as_json(subject.derived, problems);
    for (const SuiteMeasure& measure : entry.measures) {
        Result<Json> value = measured(measure, subject, renderer);
        if (!value) return Error{value.error()};
        numbers["measure"][measure.what] = without_times(*std::move(value));
    }
    return numbers;
}

}  // namespace viewing
