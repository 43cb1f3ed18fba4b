// Lessons in the window: the strip, the keys, covered and highlighted parts, the pages.
#include <algorithm>
#include <utility>

#include "lesson/questions/question_kind.h"
#include "text/catalogue.h"
#include "ui/lesson/code_plate.h"
#include "ui/lesson/strip.h"
#include "ui/window/clipboard.h"
#include "ui/window/workbench.h"

namespace viewing {

std::vector<CardPicture> Workbench::wanted_cards() {
    if (exercises.typed_matrix.is_open()) return exercises.typed_matrix.wanted_pictures();
    if (exercises.page.is_open()) return exercises.page.wanted_pictures(exercises.desk);
    if (start_page.is_open()) return start_page.wanted_pictures();
    if (presenter.shows_overview()) return overview_pictures(guide);
    if (guide.is_shown() && guide.run()->shows_end()) return {EndCard::wanted_picture(*guide.run())};
    return {};
}

namespace {

/// Returns whether a state itself lists P or a control of the lens.
bool shows_lens(const std::vector<std::string>& matrices, const std::vector<std::string>& controls) {
    const auto is_of_lens = [](const std::string& path) {
        return path == "projection.fovy" || path == "projection.aspect";
    };
    return std::find(matrices.begin(), matrices.end(), "P") != matrices.end() ||
           std::any_of(controls.begin(), controls.end(), is_of_lens);
}

/// Everything that a step names: the parts in its layout, its framed and covered parts, and what may be changed.
std::vector<std::string> named_in(const LessonStep& step) {
    const LayoutParams& layout = step.start.params.view.layout;
    std::vector<std::string> names;
    for (const auto* const list :
         {&step.cover, &step.highlight, &step.reveal.highlight, &step.ask.allow, &layout.controls})
        names.insert(names.end(), list->begin(), list->end());
    for (const std::string& matrix : layout.matrices) names.push_back("matrix:" + matrix);
    return names;
}

bool is_any(const std::vector<std::string>& names, std::initializer_list<std::string_view> parts) {
    return std::any_of(names.begin(), names.end(), [&](const std::string& name) {
        return std::any_of(parts.begin(), parts.end(),
                           [&](std::string_view part) { return name.find(part) != std::string::npos; });
    });
}

/// On stage, marks only what the step is about, and lets a narrow view show as much as a wide one.
void show_only_named(const LessonStep& step, bool presents, Stage& stage, ViewState& views) {
    views.marks_lights = views.marks_plane = !presents;
    views.marks_derivation = !presents && !step.target;  // a step's own mark must be the only p or q
    if (!presents) return;
    const std::vector<std::string> names = named_in(step);
    const bool follows = step.start.params.follow.has_value();
    views.marks_lights =
        follows || is_any(names, {"light", "matrix:S", "matrix:follow", "shadow_derivation", "lecture_code"});
    views.marks_plane =
        follows || is_any(names, {"plane.", "matrix:S", "matrix:R", "matrix:follow", "derivation", "lecture_code"});
    const bool is_about_lens = step.keeps_lens || is_any(names, {"matrix:P", "projection.fovy", "projection.aspect"});
    if (!is_about_lens) stage.least_aspect = Stage::written_for;
}

/// Covers what the question asks for, until it is answered.
void cover_question(const LessonRun& run, Stage& stage) {
    stage.asks = !run.is_revealed();
    stage.cover.clear();
    if (!stage.asks) return;
    const std::vector<std::string>& cover = stage.cover = run.step().cover;
    // While a question is open, tooltips hide their formulas; matrix entries hide their symbols only if the step says
    // so.
    if (std::count(cover.begin(), cover.end(), "formulas") > 0) stage.cover.emplace_back("symbols");
}

/// Covers, marks and arranges what the lesson's current step says. `lower`: the lower views that the step names.
void set_lesson_stage(const Guide& guide, bool presents, Stage& stage, ViewState& views, StageViews& lower) {
    const LessonRun* const run = guide.run();
    lower = {};
    const bool leads = run && (guide.is_shown() || guide.is_sheet());
    if (stage.is_of_lesson || leads) {
        stage = {};
        stage.is_of_lesson = leads;
        views.movable.reset();
        views.marks_lights = views.marks_plane = views.marks_derivation = true;
    }
    if (!leads) return;
    cover_question(*run, stage);
    if (!guide.is_shown()) return;  // exploring does not uncover what an exercise asks for
    const LessonStep& step = run->step();
    if (stage.asks) {
        const bool may_change_all = kind_of(step.ask).is_on_screen && step.ask.allow.empty();
        if (!may_change_all) views.movable = step.start.params.view.layout.controls;
        if (views.movable) views.movable->insert(views.movable->end(), step.ask.allow.begin(), step.ask.allow.end());
    }
    stage.highlight = stage.asks ? step.highlight : step.reveal.highlight;
    show_only_named(step, presents, stage, views);
    lower.left = step.names_lower_left;
    lower.right = step.names_lower_right;
    // If the revealed answer is what starts following a point, that point already has its own mark.
    const bool is_followed_now = !stage.asks && step.revealed.follow && !step.start.params.follow;
    if (step.target && !is_followed_now)
        stage.target = Stage::Target{step.target->point_world, step.target->label.shown()};
}

}  // namespace

void Workbench::set_stage(const Session& session) {
    arrangement.presents = widgets.is_on_stage = presenter.is_on();
    if (guide.is_shown()) past.note(*guide.run());
    set_lesson_stage(guide, presenter.is_on(), stage, views, arrangement.stage);
    if (!guide.is_shown()) {
        const Params& params = session.params;
        const LayoutParams& listed = params.view.layout;
        // A mirror with its own fovy is compared with the camera's.
        const bool keeps_lens = !presenter.is_on() || params.projection.aspect > 0.0 || params.reflection.fovy > 0.0 ||
                                params.camera_overrides.clip_from_view || params.slips.degrees_as_radians ||
                                shows_lens(listed.matrices, listed.controls);
        stage.least_aspect = keeps_lens ? 0.0 : Stage::written_for;
    }
    std::vector<std::string>& covered = widgets.targets.covered;
    covered = stage.cover;
    if (stage.asks)
        for (const char* tells : {"sentences", "advice", "formulas"}) covered.emplace_back(tells);
    widgets.targets.highlighted = stage.highlight;
    views.target = stage.target;
}

void Workbench::leave_lesson(Session& session) {
    guide.leave();
    if (guide.is_sheet() && !guide.run()->is_revealed())
        session.message = {tr("the values that the exercise asks for stay hidden until you solve it"), false};
}

void Workbench::follow_lesson(Session& session, const FrameInput& input) {
    guide.update(session, input.dt_s);
    exercises.follow(guide, replay, session);
    presenter.update(input, guide, session);
    const LessonRun* const run = guide.run();
    if (run && start_page.is_finished(run->lesson().id)) presenter.show_overview(guide);
}

bool Workbench::take_key_of_page(const KeyPress& press, Session& session) {
    const bool searches =
        press.ctrl && press.key == Key::p && !exercises.typed_matrix.is_open() && !presenter.is_blank();
    if (searches) return false;
    const bool is_covered = exercises.typed_matrix.is_open() || exercises.page.is_open() || start_page.is_open();
    if (!is_covered) return presenter.take(press, guide, session);
    const bool closes = press.key == Key::escape;
    if (closes && exercises.typed_matrix.is_open())
        exercises.typed_matrix.close();
    else if (closes && exercises.page.is_open())
        exercises.page.close();
    else if (closes)
        start_page.close();
    return press.key != Key::f11;
}

void Workbench::draw_lesson(Session& session, const Layout& layout, const Pictures& pictures, Requests& requests) {
    if (guide.is_shown() && !layout.strip.empty()) {
        begin_area("lesson", layout.strip, 0, ImVec2(0.0F, 0.0F));
        if (std::exchange(strip_step_, guide.run()->index()) != guide.run()->index()) ImGui::SetScrollY(0.0F);
        const StripLook look{presenter.is_on(), guide.departs(session), presenter.clock(), is_checking,
                             guide.watches_file()};
        const StripWishes wishes = draw_strip(*guide.run(), layout.strip, look);
        ImGui::End();
        requests.check_answer = wishes.check;
        if (wishes.next) guide.next(session);
        if (wishes.previous) guide.previous(session);
        if (wishes.again) guide.return_to_step(session);
        if (wishes.overview) guide.is_sheet() ? exercises.open_page() : presenter.show_overview(guide);
        if (wishes.paste) paste_answer(guide);
        if (wishes.show_matrix) exercises.typed_matrix.open(*guide.run());
        if (wishes.leave) leave_lesson(session);
        if (wishes.edit) open_step_editor(session);
        const Rect editor{{0.0F, layout.top_bar.max.y}, {width_of_editor(layout.strip.width()), layout.strip.min.y}};
        if (!editor.empty() && !presenter.shows_overview()) step_editor_.draw(guide, session, editor);
    }
    draw_end(session, pictures);
    draw_overview(presenter, guide, session, pictures);
    if (start_page.draw(guide, presenter, session, past, pictures)) exercises.open_page();
    exercises.draw(guide, session, file_dialog_, pictures);
    const ImVec2 window_px = ImGui::GetIO().DisplaySize;
    const float bottom = layout.strip.empty() ? window_px.y : layout.strip.min.y;
    const Rect above{{0.0F, 0.0F}, {window_px.x, bottom}};
    if (presenter.shows_code()) draw_code_plate(link_for_code(guide, session, link_address), link_address, above);
    presenter.draw(guide, above);
}

void Workbench::open_step_editor(Session& session) {
    if (guide.is_shown() && guide.watches_file())
        step_editor_.open();
    else
        session.message = {tr("only the steps of your own lessons can be edited: save a state as a step first"), false};
}

void Workbench::save_as_step() {
    const bool is_own = guide.run() && guide.watches_file();
    file_dialog_.show_save_step(is_own ? guide.run()->lesson().file : "",
                                guide.is_shown() ? stage.highlight : std::vector<std::string>{});
}

void Workbench::draw_end(Session& session, const Pictures& pictures) {
    const bool is_hidden = presenter.shows_overview() || start_page.is_open() || exercises.page.is_open();
    if (is_hidden || !guide.is_shown() || !guide.run()->shows_end()) return;
    const EndCard::Wishes wishes = end_card_.draw(*guide.run(), presenter.is_on(), pictures);
    if (wishes.back) guide.previous(session);
    if (wishes.next) guide.next(session);
    if (wishes.overview) presenter.show_overview(guide);
    if (!wishes.lesson.empty()) guide.open(wishes.lesson);
    if (wishes.exercise.empty()) return;
    exercises.open_page();
    exercises.go_to(wishes.exercise, false);
}

}  // namespace viewing
