// Hidden-surface methods beside the window: long ones run in the background, show how far they are and can be
// cancelled, while the window goes on with the answer before. Knows no GL. Read studio.h next.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "frame/hidden/hidden_views.h"
#include "platform/background.h"

namespace viewing {

/// Used from one thread. Whatever is asked of it, it first takes over what has been finished meanwhile.
class HiddenWorker {
public:
    /// Starts on the question, unless it is the one that is answered, worked on, was cancelled or failed. A question
    /// that differs only in where the camera is lets the one before come to its end, so that a moving camera gets
    /// answers.
    void ask(const HiddenQuestion& question, const Scene& scene, int scene_version);

    /// Waits until nothing is worked on, at most so long; negative: as long as it takes.
    void wait(double seconds);

    /// The newest answer for this scene; null while there is none. The same pointer until there is another.
    std::shared_ptr<const HiddenAnswer> answer(int scene_version);

    /// Whether the latest work was on this question and failed: there will be no answer.
    bool has_failed(const HiddenQuestion& question, int scene_version);

    /// Why the latest work failed, once.
    std::optional<std::string> take_failure();

    /// 0 … 1 while it works.
    std::optional<float> fraction();

    /// A person's wish: gives up what is worked on. Its unfinished answer is the answer, and the same question is not
    /// worked on again.
    void cancel();

    /// Nobody wants an answer any more: what is worked on is given up and leaves nothing behind, nor does the last one.
    void forget();

private:
    struct Job {
        HiddenQuestion question;
        Scene scene;
        int scene_version = -1;
    };
    /// Kept from one job to the next on the same scene.
    struct Solver;
    using Answer = std::shared_ptr<const HiddenAnswer>;

    void start(Job job);
    void take_over();  ///< what is finished becomes the answer, and what waits is begun
    void drop_current();

    std::optional<Job> waiting_;
    std::optional<HiddenQuestion> current_;  ///< worked on
    int current_version_ = -1;
    bool is_dropped_ = false;  ///< the current one's answer is not wanted
    Answer answer_;
    int answer_version_ = -1;
    std::optional<HiddenQuestion> failed_;
    int failed_version_ = -1;
    std::optional<std::string> failure_;  ///< until it is taken
    std::shared_ptr<Solver> solver_;      ///< while something is worked on, only for that
    BackgroundTask<Answer> task_;
};

}  // namespace viewing
