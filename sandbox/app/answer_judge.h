// Judges a lesson's answers when Check is pressed, and its goals whenever the state changes. Answers that need measured
// pictures are judged in the background, while the window shows that they are being checked. See
// lesson/questions/judge.h for how a verdict is reached.
#pragma once

#include <memory>
#include <optional>

#include "app/side_renderer.h"
#include "lesson/questions/judge.h"
#include "platform/background.h"
#include "ui/window/workbench.h"

namespace viewing {

class AnswerJudge {
public:
    /// `renderer` is the window's own and must outlive this object. It takes the measurements if no second renderer can
    /// be created.
    explicit AnswerJudge(Renderer& renderer) : renderer_(renderer) {}

    struct Moment {
        bool wants_check = false;  ///< Check was pressed
        bool is_held = false;      ///< a drag is in progress, so goals are judged when it ends
        bool may_wait = false;     ///< if false, as for pictures in files, update() blocks until the verdict is known
    };
    /// Call once a frame. Returns whether the lesson strip has changed.
    bool update(Workbench& workbench, Session& session, const Moment& moment);
    /// Whether a right answer is being computed in the background.
    bool computes_model() const { return model_task_.is_running(); }

private:
    /// A question, and the answer or the state to judge.
    struct Question {
        std::shared_ptr<const Lesson> lesson;
        std::size_t step = 0;
        Answer answer;                 ///< empty for a goal
        std::optional<Params> params;  ///< only for a goal
        bool is_at(const LessonRun& run) const;
        bool is_of(const LessonRun& run, const Params& now) const;
    };
    /// Computes the right answer to a typed question that has been revealed, in the background if the answer must be
    /// measured. Returns whether the answer has just become known.
    bool show_model(LessonRun& run, Session& session, bool may_wait);
    /// Computes the products of a question's tiles for the current state.
    static void show_products(LessonRun& run, const Session& session);
    /// Drops the judgment in progress, so that the next check starts a new one.
    void give_up();
    void take(const Result<Verdict>& verdict, Workbench& workbench, Session& session);

    Renderer& renderer_;
    SideRenderer side_;
    std::optional<Question> asked_;
    Question model_of_;  ///< the question of model_task_
    BackgroundTask<Answer> model_task_;
    /// Its result is empty if no side renderer could take the measurements.
    BackgroundTask<std::optional<Verdict>> task_;  ///< declared last, so that it ends before the members it uses
};

}  // namespace viewing
