// Judges a lesson's answer: when Check is pressed, and a goal whenever its state has changed. What is measured in
// pictures is judged beside the window, with a sign that it is being checked. Read lesson/judge.h for the verdict.
#pragma once

#include <memory>
#include <optional>

#include "app/side_renderer.h"
#include "lesson/judge.h"
#include "platform/background.h"
#include "ui/window/workbench.h"

namespace viewing {

class AnswerJudge {
public:
    /// `renderer`, the window's, must outlive this: it measures where there can be no other.
    explicit AnswerJudge(Renderer& renderer) : renderer_(renderer) {}

    struct Moment {
        bool wants_check = false;  ///< Check was pressed
        bool is_held = false;      ///< something is moved by hand: what is measured waits for its end
        bool may_wait = false;     ///< else the verdict is there at once, as a picture has it
    };
    /// Called once a frame. Whether what the strip shows has changed.
    bool update(Workbench& workbench, Session& session, const Moment& moment);

private:
    /// What was asked, and with what.
    struct Question {
        std::shared_ptr<const Lesson> lesson;
        std::size_t step = 0;
        Answer answer;                 ///< of a goal none
        std::optional<Params> params;  ///< of a goal alone
        bool is_of(const LessonRun& run, const Params& now) const;
    };
    /// What is being judged; asked once more it is judged anew.
    void give_up();
    void take(const Result<Verdict>& verdict, Workbench& workbench, Session& session);

    Renderer& renderer_;
    SideRenderer side_;
    std::optional<Question> asked_;
    /// None: it could not be measured there.
    BackgroundTask<std::optional<Verdict>> task_;  ///< last: it ends before what it uses
};

}  // namespace viewing
