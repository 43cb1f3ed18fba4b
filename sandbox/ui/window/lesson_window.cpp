// Lessons in the window: the strip, the keys, covered and highlighted parts, the pages.
#include <algorithm>
#include <numeric>
#include <utility>

#include "lesson/questions/question_kind.h"
#include "platform/file.h"
#include "text/catalogue.h"
#include "text/numbers.h"
#include "ui/lesson/code_plate.h"
#include "ui/lesson/lesson_text.h"
#include "ui/lesson/strip.h"
#include "ui/window/areas.h"
#include "ui/window/workbench.h"

namespace viewing {

std::vector<CardPicture> Workbench::wanted_cards() {
    if (typed_matrix_.is_open()) return typed_matrix_.wanted_pictures();
    if (exercise_page.is_open()) return exercise_page.wanted_pictures(exercises);
    if (start_page.is_open()) return start_page.wanted_pictures();
    if (presenter.shows_overview()) return overview_pictures(guide);
    if (guide.is_shown() && guide.run()->shows_end()) return {EndCard::wanted_picture(*guide.run())};
    return {};
}

namespace {

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

}  // namespace

/// On stage, marks only what the step is about, and lets a narrow view show as much as a wide one.
void Workbench::show_only_named(const LessonStep& step) {
    views.marks_lights = views.marks_plane = !presenter.is_on();
    views.marks_derivation = !presenter.is_on() && !step.target;  // a step's own mark must be the only p or q
    if (!presenter.is_on()) return;
    const std::vector<std::string> names = named_in(step);
    const bool follows = step.start.params.follow.has_value();
    views.marks_lights =
        follows || is_any(names, {"light", "matrix:S", "matrix:follow", "shadow_derivation", "lecture_code"});
    views.marks_plane =
        follows || is_any(names, {"plane.", "matrix:S", "matrix:R", "matrix:follow", "derivation", "lecture_code"});
    constexpr double written_for = 1.6;
    const bool is_about_lens = step.keeps_lens || is_any(names, {"matrix:P", "projection.fovy", "projection.aspect"});
    if (!is_about_lens) stage.least_aspect = written_for;
}

void Workbench::cover_question(const LessonRun& run) {
    stage.asks = !run.is_revealed();
    stage.cover.clear();
    if (!stage.asks) return;
    const std::vector<std::string>& cover = stage.cover = run.step().cover;
    // While a question is open, tooltips hide their formulas; matrix entries hide their symbols only if the step says
    // so.
    if (std::count(cover.begin(), cover.end(), "formulas") > 0) stage.cover.emplace_back("symbols");
}

void Workbench::leave_lesson(Session& session) {
    guide.leave();
    if (guide.is_sheet() && !guide.run()->is_revealed())
        session.message = {tr("the values that the exercise asks for stay hidden until you solve it"), false};
}

void Workbench::follow_lesson(Session& session, const FrameInput& input) {
    guide.update(session, input.dt_s);
    follow_exercises(session);
    presenter.update(input, guide, session);
    const LessonRun* const run = guide.run();
    if (run && start_page.is_finished(run->lesson().id)) presenter.show_overview(guide);
}

void Workbench::set_lesson_stage() {
    LessonRun* const run = guide.run();
    arrangement.stage = {};
    const bool leads = run && (guide.is_shown() || guide.is_sheet());
    if (std::exchange(leads_, leads) || leads) {
        stage = {};
        views.movable.reset();
        views.marks_lights = views.marks_plane = views.marks_derivation = true;
    }
    if (!leads) return;
    if (!guide.is_shown()) return cover_question(*run);  // exploring does not uncover what an exercise asks for
    const Lesson& lesson = run->lesson();
    if (!lesson.sheet && !lesson.lecture) {
        LessonProgress& known = progress[lesson.id];
        last_lesson = lesson.id;
        for (const std::size_t step : known.done)  // another window may have added some steps
            if (step < lesson.steps.size()) run->set_done(step);
        known.step = run->index();
        for (std::size_t step = 0; step < lesson.steps.size(); ++step) {
            const auto at = std::lower_bound(known.done.begin(), known.done.end(), step);
            if (run->is_done(step) && (at == known.done.end() || *at != step)) known.done.insert(at, step);
        }
    }
    const LessonStep& step = run->step();
    stage.has_lesson = true;
    cover_question(*run);
    if (stage.asks) {
        const bool may_change_all = kind_of(step.ask).is_on_screen && step.ask.allow.empty();
        if (!may_change_all) views.movable = step.start.params.view.layout.controls;
        if (views.movable) views.movable->insert(views.movable->end(), step.ask.allow.begin(), step.ask.allow.end());
    }
    stage.highlight = stage.asks ? step.highlight : step.reveal.highlight;
    show_only_named(step);
    arrangement.stage.left = step.names_lower_left;
    arrangement.stage.right = step.names_lower_right;
    // If the revealed answer is what starts following a point, that point already has its own mark.
    const bool is_followed_now = !stage.asks && step.revealed.follow && !step.start.params.follow;
    if (step.target && !is_followed_now)
        stage.target = Stage::Target{step.target->point_world, step.target->label.shown()};
}

bool Workbench::take_key_of_page(const KeyPress& press, Session& session) {
    const bool searches = press.ctrl && press.key == Key::p && !typed_matrix_.is_open() && !presenter.is_blank();
    if (searches) return false;
    const bool is_covered = typed_matrix_.is_open() || exercise_page.is_open() || start_page.is_open();
    if (!is_covered) return presenter.take(press, guide, session);
    const bool closes = press.key == Key::escape;
    if (closes && typed_matrix_.is_open())
        typed_matrix_.close();
    else if (closes && exercise_page.is_open())
        exercise_page.close();
    else if (closes)
        start_page.close();
    return press.key != Key::f11;
}

void Workbench::draw_lesson(Session& session, const Layout& layout, const Pictures& pictures, Requests& requests) {
    if (guide.is_shown() && !layout.strip.empty()) {
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0F, 0.0F});
        begin_area("lesson", layout.strip);
        ImGui::PopStyleVar();
        if (std::exchange(strip_step_, guide.run()->index()) != guide.run()->index()) ImGui::SetScrollY(0.0F);
        const StripLook look{presenter.is_on(), guide.departs(session), presenter.clock(), is_checking,
                             guide.watches_file()};
        const StripWishes wishes = draw_strip(*guide.run(), layout.strip, look);
        ImGui::End();
        requests.check_answer = wishes.check;
        if (wishes.next) guide.next(session);
        if (wishes.previous) guide.previous(session);
        if (wishes.again) guide.return_to_step(session);
        if (wishes.overview) guide.is_sheet() ? exercise_page.open(exercises) : presenter.show_overview(guide);
        if (wishes.paste) paste_answer();
        if (wishes.show_matrix) typed_matrix_.open(*guide.run());
        if (wishes.leave) leave_lesson(session);
        if (wishes.edit) open_step_editor(session);
        const Rect editor{{0.0F, layout.top_bar.max.y}, {width_of_editor(layout.strip.width()), layout.strip.min.y}};
        if (!editor.empty() && !presenter.shows_overview()) step_editor_.draw(guide, session, editor);
    }
    draw_end(session, pictures);
    draw_overview(presenter, guide, session, pictures);
    if (start_page.draw(guide, presenter, session, {progress, last_lesson, recent}, pictures))
        exercise_page.open(exercises);
    draw_exercises(session, pictures);
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
    const bool is_hidden = presenter.shows_overview() || start_page.is_open() || exercise_page.is_open();
    if (is_hidden || !guide.is_shown() || !guide.run()->shows_end()) return;
    const EndCard::Wishes wishes = end_card_.draw(*guide.run(), presenter.is_on(), pictures);
    if (wishes.back) guide.previous(session);
    if (wishes.next) guide.next(session);
    if (wishes.overview) presenter.show_overview(guide);
    if (!wishes.lesson.empty()) guide.open(wishes.lesson);
    if (wishes.exercise.empty()) return;
    exercise_page.open(exercises);
    go_to_exercise(wishes.exercise, false);
}

void Workbench::remember_opened(const Session& session) {
    const auto remember = [this](const std::string& file) {
        constexpr std::size_t most = 10;
        if (!recent.empty() && recent.front() == file) return;
        std::erase(recent, file);
        recent.insert(recent.begin(), file);
        recent.resize(std::min(recent.size(), most));
    };
    if (!session.opening().empty()) {
        opening_ = session.opening();
    } else if (!opening_.empty()) {
        // A preset is opened by its name, which is not a file path.
        if (!session.message.is_error && opening_.find('/') != std::string::npos) remember(opening_);
        opening_.clear();
    }
    const auto* const scene = std::get_if<std::string>(&session.params.scene);
    const bool is_mesh = scene && scene->starts_with('/') && scene->ends_with(".obj");
    if (session.loading_fraction()) return;
    if (is_mesh && *scene != opened_mesh_) remember(*scene);
    opened_mesh_ = is_mesh ? *scene : "";
}

void Workbench::draw_lesson_button(Session& session) {
    const bool waits = guide.run() && !guide.is_shown();
    if (widgets::Button(waits ? "Back to the lesson###Lesson" : "Lesson")) {
        if (waits)
            guide.resume(session);
        else
            start_page.open();
    }
    widgets::Tooltip("Lesson", waits
                                   ? marked("Returns to the step that you left and restores its original state.")
                                   : marked("The lessons of the lecture: each step asks before it shows the answer."));
}

void Workbench::go_to_exercise(const std::string& id, bool replays) {
    wanted_exercise_ = id;
    wants_replay_ = replays;
}

void Workbench::follow_exercises(Session& session) {
    session.report(exercises.update(ImGui::GetTime()));
    if (!wanted_exercise_.empty() && exercises.is_ready()) {
        std::vector<std::size_t> all(exercises.entries().size());
        std::iota(all.begin(), all.end(), std::size_t{0});
        if (std::optional<LessonRun> run = exercises.sheet_at(wanted_exercise_, all)) {
            guide.begin(*std::move(run), session);
            const HandInItem* const item = exercises.hand_in().find(wanted_exercise_);
            if (wants_replay_ && item) replay.begin(guide.run()->step(), item->replay);
        }
        wanted_exercise_.clear();
    }
    // While an exercise's initial state is loading, the current state does not count as an answer.
    if (guide.is_shown() && guide.is_sheet() && !replay.is_playing() && !session.is_loading()) {
        const bool is_at_rest = !ImGui::IsAnyItemActive() && !session.is_moving() && !guide.is_revealing();
        exercises.follow(*guide.run(), session.params, is_at_rest, ImGui::GetTime());
        if (guide.run()->reached() != session.params) guide.run()->reached() = session.params;
    }
}

void Workbench::draw_exercises(Session& session, const Pictures& pictures) {
    const ExercisePage::Wishes wishes = exercise_page.draw(exercises, guide, session, pictures);
    if (wishes.save) choose_answers(FileDialog::Purpose::save_answers, session);
    if (wishes.open_answers) choose_answers(FileDialog::Purpose::open_answers, session);
    typed_matrix_.draw(pictures);
}

void Workbench::choose_answers(FileDialog::Purpose purpose, Session& session) {
    exercise_page.close();  // show the dialog over the views instead of over this page
    if (purpose == FileDialog::Purpose::open_answers) {
        file_dialog_.show(purpose, "", [this](const std::filesystem::path& file) { exercises.open_hand_in(file); });
        return;
    }
    file_dialog_.show(
        purpose, hand_in_file_name(exercises.student()), [this, &session](const std::filesystem::path& file) {
            session.write([file, text = hand_in_as_text(exercises.hand_in())] { return write_file(file, text); },
                          say("answers saved to {file}", "file"_a = file.string()));
        });
}

bool Workbench::takes_pasted_answer() const {
    return guide.is_shown() && !guide.run()->is_revealed() && guide.run()->step().ask.rows > 1;
}

void Workbench::paste_answer() {
    if (!takes_pasted_answer()) return;
    LessonRun* const run = guide.run();
    const Ask& ask = run->step().ask;
    const char* const text = ImGui::GetClipboardText();
    const std::vector<double> numbers = numbers_in(text ? text : "");
    const int wanted = ask.rows * ask.columns;
    if (std::ssize(numbers) != wanted) {
        run->tell_trouble(say("The clipboard has {count} numbers; the answer needs {wanted}.",
                              "count"_a = numbers.size(), "wanted"_a = wanted));
        return;
    }
    run->answer().numbers = numbers;
    run->unread().clear();
    run->forget_verdict();
}

}  // namespace viewing
