#include "app/answer_judge.h"

#include <algorithm>
#include <utility>

#include "grading/lesson_numbers.h"
#include "lesson/allowed.h"
#include "lesson/filled_text.h"
#include "lesson/questions/goal_progress.h"
#include "lesson/questions/question_kind.h"
#include "lesson/questions/typed_matrix.h"
#include "text/catalogue.h"

namespace viewing {
namespace {

/// Everything that a verdict depends on, copied so that another thread can judge the answer.
struct Case {
    std::shared_ptr<const Lesson> lesson;
    std::size_t step = 0;
    Answer answer;
    Params now, start;
    Scene scene;

    Result<Verdict> judged(Renderer& renderer) const {
        LessonNumbers numbers(now, start, scene, &renderer);
        return judge(lesson->steps[step].ask, answer, numbers.surroundings());
    }
};

/// Rejects a goal that was reached by changing a field that the step does not allow, and names that field.
Verdict with_what_is_allowed(const Verdict& verdict, const Ask& ask, const Params& start, const Params& now) {
    if (!verdict.right || !kind_of(ask).is_on_screen) return verdict;
    const std::vector<std::string> others = changed_without_leave(start, now, ask.allow);
    if (others.empty()) return verdict;
    const std::string why = say("Goal met, but {field} must keep its original value here.", "field"_a = others.front());
    return {.say = LessonText{{why}}};
}

}  // namespace

bool AnswerJudge::Question::is_at(const LessonRun& run) const {
    return lesson == run.shared_lesson() && step == run.index();
}

bool AnswerJudge::Question::is_of(const LessonRun& run, const Params& now) const {
    if (!is_at(run)) return false;
    return params ? *params == now : answer == run.answer();
}

bool AnswerJudge::update(Workbench& workbench, Session& session, const Moment& moment) {
    const bool was_checking = std::exchange(workbench.is_checking, false);
    LessonRun* const run = workbench.guide.is_shown() ? workbench.guide.run() : nullptr;
    if (run && run->wants_reveal() && !session.loading_fraction()) {
        const Params start = session.in_own_looks(run->step().start.params);
        LessonNumbers numbers(start, start, session.scene(), nullptr);
        run->take_reveal(
            filled_or_same(run->step().reveal.say, with_constants(run->step().ask, numbers.surroundings())));
    }
    if (run) show_products(*run, session);
    const bool has_model = run && run->is_revealed() && show_model(*run, session, moment.may_wait);
    if (!run || run->is_revealed() || workbench.guide.is_revealing() || session.loading_fraction()) {
        give_up();
        return was_checking || has_model;
    }
    const Ask& ask = run->step().ask;
    const bool is_goal = kind_of(ask).is_on_screen;
    const bool is_asked = asked_ && asked_->is_of(*run, session.params);
    if (!ask.progress.empty() && run->progress().at != session.params && !has_measured_progress(ask)) {
        LessonNumbers numbers(session.params, run->step().start.params, session.scene(), &renderer_);
        run->progress() = {session.params, progress_of(ask, with_constants(ask, numbers.surroundings()))};
    }
    const auto asked_case = [&] {
        const Params start = session.in_own_looks(run->step().start.params);
        return Case{asked_->lesson, asked_->step,   asked_->answer, asked_->params.value_or(start),
                    start,          session.scene()};
    };
    if (!is_asked) give_up();
    if (std::optional<Result<std::optional<Verdict>>> done = task_.take()) {
        if (!*done)
            take(Error{done->error()}, workbench, session);
        else
            take(**done ? Result<Verdict>(***done) : asked_case().judged(renderer_), workbench, session);
        return true;
    }
    workbench.is_checking = task_.is_running();
    if (is_goal ? moment.is_held || is_asked : !moment.wants_check || task_.is_running())
        return workbench.is_checking != was_checking;
    asked_ = Question{run->shared_lesson(), run->index(), {}, std::nullopt};
    if (is_goal)
        asked_->params = session.params;
    else
        asked_->answer = run->answer();
    if (is_goal && session.params == session.in_own_looks(run->step().start.params)) {
        run->forget_verdict();
    } else if (!moment.may_wait || !is_measured(ask)) {
        take(asked_case().judged(renderer_), workbench, session);
    } else {
        workbench.is_checking = true;
        task_.start([question = asked_case(), this](WorkProgress&) -> Result<std::optional<Verdict>> {
            Result<Verdict> verdict = Verdict{};
            const Result<bool> could = side_.lend([&](Renderer& renderer) { verdict = question.judged(renderer); });
            if (!could) return Error{could.error()};
            if (!*could) return std::optional<Verdict>();
            if (!verdict) return Error{verdict.error()};
            return std::optional(*std::move(verdict));
        });
    }
    return true;
}

void AnswerJudge::show_products(LessonRun& run, const Session& session) {
    const Ask& ask = run.step().ask;
    if (ask.factors.empty() || session.loading_fraction()) return;
    LessonRun::Products& known = run.products();
    if (known.at == session.params && known.items == run.shown_items()) return;
    LessonNumbers numbers(session.params, run.step().start.params, session.scene(), nullptr);
    const Result<std::vector<glm::dmat4>> products =
        products_of(ask, run.shown_items(), with_constants(ask, numbers.surroundings()));
    if (!products) run.tell_trouble(products.error());
    known = {session.params, run.shown_items(), products ? *products : std::vector<glm::dmat4>()};
}

bool AnswerJudge::show_model(LessonRun& run, Session& session, bool may_wait) {
    const Ask& ask = run.step().ask;
    if (!kind_of(ask).is_typed || run.model() || run.lesson().sheet || session.loading_fraction()) return false;
    const Params start = session.in_own_looks(run.step().start.params);
    const Case question{run.shared_lesson(), run.index(), {}, start, start, session.scene()};
    const auto right = [](const Case& of, Renderer& renderer) {
        LessonNumbers numbers(of.now, of.start, of.scene, &renderer);
        const Result<Answer> model = model_answer(of.lesson->steps[of.step].ask, numbers.surroundings());
        return model ? *model : Answer{};  // an expression that fails leaves the field empty
    };
    if (!may_wait || !is_measured(ask)) {
        run.model() = right(question, renderer_);
        return true;
    }
    // The result may belong to a step that the user has since left.
    if (const std::optional<Result<Answer>> done = model_task_.take(); done && model_of_.is_at(run)) {
        run.model() = *done ? **done : Answer{};
        return true;
    }
    if (!model_task_.is_running()) {
        model_of_ = {run.shared_lesson(), run.index(), {}, std::nullopt};
        model_task_.start([question, right, this](WorkProgress&) -> Result<Answer> {
            Answer model;
            const Result<bool> could = side_.lend([&](Renderer& renderer) { model = right(question, renderer); });
            return could ? Result<Answer>(model) : Result<Answer>(Error{could.error()});
        });
    }
    return false;
}

void AnswerJudge::give_up() {
    if (!task_.is_running()) return;
    task_.drop();
    asked_.reset();
}

void AnswerJudge::take(const Result<Verdict>& verdict, Workbench& workbench, Session& session) {
    LessonRun& run = *workbench.guide.run();
    if (verdict) run.progress() = {session.params, verdict->progress};
    if (!verdict) return run.tell_trouble(verdict.error());
    const Ask& ask = run.step().ask;
    const Verdict told =
        with_what_is_allowed(*verdict, ask, session.in_own_looks(run.step().start.params), session.params);
    run.take(told);
    const bool tells = !kind_of(ask).is_on_screen || told.right || !told.say.empty();
    if (run.lesson().sheet && tells) workbench.exercises.desk.record(run, told, session.params);
    if (told.right) workbench.guide.reveal(session);
}

}  // namespace viewing
