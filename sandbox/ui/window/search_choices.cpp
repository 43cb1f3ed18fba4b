// The entries that the window offers to the search. Choosing an entry has the same effect as the control or the key
// that the entry names.
#include <utility>

#include "lesson/exercise.h"
#include "state/file/beside.h"
#include "state/file/state_json.h"
#include "ui/window/workbench.h"

namespace viewing {
namespace {

/// Shows a topic in a lower view and makes that view visible.
void show_topic(Topic topic, Params& params, ViewState& views, const Layout& layout) {
    if (!is_shown(params, topic)) choose_topic(params, Slot::right, topic);
    const Slot slot = topic_of(params, Slot::left) == topic ? Slot::left : Slot::right;
    const bool is_hidden = (slot == Slot::left ? layout.lower_left : layout.lower_right).empty();
    if (!is_hidden) return;
    params.view.layout.big = ViewName::none;
    views.lower = LowerChoice{slot, params.view.lower_left, params.view.lower_right};
}

}  // namespace

Place Workbench::place() const {
    if (presenter.is_on()) return guide.is_shown() ? Place::lesson_on_stage : Place::stage;
    return guide.is_shown() ? Place::lesson : Place::window;
}

std::vector<SearchEntry> Workbench::offered_to_search(const Session& session) {
    if (!exercise_titles_) {
        exercise_titles_.emplace();
        for (const Result<Exercise>& exercise : viewing::exercises())
            if (exercise) exercise_titles_->push_back({exercise->id, exercise->title});
    }
    SearchLimits limits;
    limits.place = place();
    // When a lesson is on stage, there is space only for the step's own lower views.
    limits.may_choose_view = limits.place != Place::lesson_on_stage;
    limits.movable = views.movable;
    limits.covered = widgets.targets.covered;
    return search_entries({presets_.all(), start_page.lessons(), *exercise_titles_}, limits, session.params);
}

void Workbench::draw_search(const CommandContext& context, const Layout& layout) {
    Session& session = context.session;
    Requests& requests = context.requests;
    const std::optional<SearchChoice> choice = search_.draw([&] { return offered_to_search(session); });
    if (!choice) return;
    start_page.close();
    exercises.page.close();
    presenter.close_overview();
    if (const auto* preset = std::get_if<PresetChoice>(&*choice)) {
        session.open(preset->name);
    } else if (const auto* lesson = std::get_if<LessonPlace>(&*choice)) {
        const auto known = past.progress.find(lesson->id);
        guide.open(lesson->file, lesson->step.value_or(known == past.progress.end() ? 0 : known->second.step));
    } else if (const auto* exercise = std::get_if<ExerciseChoice>(&*choice)) {
        exercises.desk.open();
        exercises.go_to(exercise->id, false);
    } else if (const auto* field = std::get_if<FieldChoice>(&*choice)) {
        const UiParams looks = session.params.ui;
        const bool adds = field->is_beside && session.params.view.beside.shows == Beside::settings;
        Result<Params> changed =
            apply_settings(adds ? beside_params(session.params) : session.params, {&field->setting, 1}, "");
        if (!changed) return session.report(Error{changed.error()});
        if (field->is_beside)
            show_beside(session.params, *std::move(changed));
        else
            session.params = *std::move(changed);
        const UiParams& now = session.params.ui;
        if (now.theme != looks.theme) requests.chosen_theme = now.theme;
        if (now.scale != looks.scale) requests.chosen_scale = now.scale;
        if (now.language != looks.language) requests.chosen_language = now.language;
    } else if (const auto* topic = std::get_if<Topic>(&*choice)) {
        show_topic(*topic, session.params, views, layout);
    } else if (const auto* command = std::get_if<const WindowCommand*>(&*choice)) {
        (*command)->run(*this, context);
    }
}

}  // namespace viewing
