#include "session/guide.h"

#include <algorithm>
#include <utility>

#include "lesson/blend.h"
#include "lesson/questions/question_kind.h"
#include "state/file/state_json.h"
#include "state/scene.h"
#include "text/catalogue.h"

namespace viewing {
namespace {

/// Returns the time when a file was last written; none if the file does not exist.
std::optional<std::filesystem::file_time_type> time_of(const std::filesystem::path& file) {
    std::error_code error;
    const auto time = std::filesystem::last_write_time(file, error);
    return error ? std::nullopt : std::optional(time);
}

}  // namespace

void Guide::open(const std::string& argument, std::size_t step) {
    reading_.start([argument, step](WorkProgress&) -> Result<LinkedStep> {
        Result<Lesson> lesson = load_lesson(argument);
        if (!lesson) return Error{lesson.error()};
        return LinkedStep{*std::move(lesson), step};
    });
}

void Guide::open(const Link& link) {
    reading_.start([link](WorkProgress&) { return load_linked_step(link); });
}

void Guide::begin(Lesson lesson, std::size_t step, Session& session) {
    begin(LessonRun(std::move(lesson), step), session);
}

void Guide::begin(LessonRun run, Session& session) {
    run_.emplace(std::move(run));
    is_shown_ = true;
    before_jump_ = run_->index();
    reveal_.reset();
    held_.reset();
    reading_again_.drop();
    file_time_.reset();
    if (watches_file()) file_time_ = time_of(run_->lesson().file);
    arrive(session);
}

bool Guide::watches_file() const {
    if (!is_shown() || is_sheet() || run_->lesson().file.empty()) return false;
    return run_->lesson().file.parent_path() != assets_directory() / "lessons";
}

void Guide::follow_file(Session& session, double dt_s) {
    constexpr double every_s = 1.0;
    if (std::optional<Result<Lesson>> read = reading_again_.take()) {
        if (!*read) {
            session.message = {read->error(), true};
            return;
        }
        const std::vector<LessonStep>& steps = (*read)->steps;
        const auto same = std::find_if(steps.begin(), steps.end(),
                                       [&](const LessonStep& step) { return step.id == run_->step().id; });
        const std::size_t step = same != steps.end() ? static_cast<std::size_t>(same - steps.begin()) : run_->index();
        const bool was_revealed = run_->is_revealed();
        begin(*std::move(*read), step, session);
        if (was_revealed) run_->reveal();
        return_to_step(session);
        session.message = {tr("the lesson's file changed and was reloaded"), false};
    }
    unwatched_s_ += dt_s;
    if (unwatched_s_ < every_s || !watches_file() || reading_again_.is_running()) return;
    unwatched_s_ = 0.0;
    const std::filesystem::path& file = run_->lesson().file;
    const auto now = time_of(file);
    if (!now || now == file_time_) return;
    file_time_ = now;
    reading_again_.start([argument = file.string()](WorkProgress&) { return load_lesson(argument); });
}

void Guide::arrive(Session& session) {
    if (!is_sheet())
        return_to_step(session);
    else
        put(run_->reached().value_or(shown()), session);
}

void Guide::update(Session& session, double dt_s) {
    if (std::optional<Result<LinkedStep>> read = reading_.take()) {
        if (*read)
            begin(std::move((*read)->lesson), (*read)->step, session);
        else
            session.message = {read->error(), true};
    }
    follow_file(session, dt_s);
    if (!reveal_) return;
    reveal_->passed_s += dt_s;
    const double share = reveal_->over_s > 0.0 ? std::min(reveal_->passed_s / reveal_->over_s, 1.0) : 1.0;
    // Ease in and out, so that the eye can follow.
    session.params = session.in_own_looks(blended(reveal_->from, reveal_->to, share * share * (3.0 - 2.0 * share)));
    if (share >= 1.0) reveal_.reset();
}

void Guide::put(const Params& params, Session& session) {
    reveal_.reset();
    held_.reset();
    LoadedState state = run_->step().start;
    state.params = session.in_own_looks(params);
    session.replace(state);
}

void Guide::resume(Session& session) {
    if (!run_) return;
    is_shown_ = true;
    arrive(session);
}

void Guide::close() {
    run_.reset();
    is_shown_ = false;
    reveal_.reset();
    held_.reset();
}

void Guide::next(Session& session) {
    if (!is_shown()) return;
    if (reveal_) {  // the user is in a hurry, so finish the reveal immediately
        reveal_->passed_s = reveal_->over_s;
        return update(session, 0.0);
    }
    if (!run_->is_revealed() && !is_sheet()) return reveal(session);
    if (run_->end() && !run_->shows_end()) return run_->show_end(true);
    if (run_->is_last()) return;
    run_->go_to(run_->index() + 1);
    if (!is_sheet()) run_->cover();
    arrive(session);
}

void Guide::previous(Session& session) {
    if (!is_shown()) return;
    if (run_->shows_end()) return run_->show_end(false);
    if (run_->is_revealed() && !is_sheet() && !run_->step().only_shows())
        run_->cover();
    else if (!run_->is_first())
        run_->go_to(run_->index() - 1);
    arrive(session);
}

void Guide::go_to(std::size_t step, Session& session) {
    if (!run_) return;
    before_jump_ = run_->index();
    run_->go_to(step);
    if (!is_sheet()) run_->cover();
    arrive(session);
}

void Guide::go_back(Session& session) {
    go_to(before_jump_, session);
}

void Guide::reveal(Session& session) {
    if (!run_) return;
    const LessonStep& step = run_->step();
    const Params start = session.in_own_looks(step.start.params);
    const bool has_improvised = session.params != start;
    const bool has_reached = kind_of(step.ask).is_on_screen && run_->verdict() && run_->verdict()->right;
    run_->reveal();
    // If the user reached the goal, keep the user's state instead of the model solution.
    const Params from = has_reached ? session.params : start;
    const Result<Params> changed = apply_settings(from, step.reveal.settings);
    const Params to = has_reached && changed ? *changed : step.revealed;
    held_.reset();
    if (!has_reached && has_improvised) put(from, session);
    reveal_ = Revealing{from, to, moves ? step.reveal.over_s : 0.0, 0.0};
}

void Guide::return_to_step(Session& session) {
    if (run_) put(shown(), session);
}

void Guide::hold_before(bool is_held, Session& session) {
    if (!is_shown() || reveal_) return;
    if (is_held && !held_ && run_->is_revealed())
        held_ = std::exchange(session.params, session.in_own_looks(run_->step().start.params));
    else if (!is_held && held_)
        session.params = session.in_own_looks(*std::exchange(held_, std::nullopt));
}

bool Guide::departs(const Session& session) const {
    if (!run_ || reveal_ || held_) return false;
    return session.in_own_looks(shown()) != session.params;
}

}  // namespace viewing
