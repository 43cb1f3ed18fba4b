// Runs hidden-surface methods in the background. Long ones report their progress and can be canceled; meanwhile, the
// window keeps the previous answer. Does not use GL. Read studio.h next.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "platform/background.h"
#include "topics/hidden/numbers/hidden_views.h"

namespace viewing {

/// For use from one thread. Every call first collects work that has finished since the last call.
class HiddenWorker {
public:
    /// Starts work on the question, unless it is already answered, in progress, canceled or failed. If only the camera
    /// differs, the previous question is completed first, so that answers appear even while the camera moves.
    void ask(const HiddenQuestion& question, const Scene& scene, int scene_version);

    /// Waits until no work is left, but at most `seconds`; a negative value sets no limit.
    void wait(double seconds);

    /// Returns the newest answer for this scene; null while there is none. The pointer stays the same until there is
    /// another answer.
    std::shared_ptr<const HiddenAnswer> answer(int scene_version);

    /// Whether the latest work was on this question and failed, so that no answer will come.
    bool has_failed(const HiddenQuestion& question, int scene_version);

    /// Returns the reason why the latest work failed, but only once.
    std::optional<std::string> take_failure();

    /// Returns the progress from 0 to 1; nothing if no work is in progress.
    std::optional<float> fraction();

    /// Ends the current work because the user canceled it. Its incomplete result becomes the answer, and the same
    /// question does not start again.
    void cancel();

    /// Ends the current work without a result, and forgets the last answer.
    void forget();

private:
    struct Job {
        HiddenQuestion question;
        Scene scene;
        int scene_version = -1;
    };
    /// Reused by all work on the same scene.
    struct Solver;
    using Answer = std::shared_ptr<const HiddenAnswer>;

    void start(Job job);
    void take_over();  ///< makes finished work the answer, and starts the waiting question
    void drop_current();

    std::optional<Job> waiting_;
    std::optional<HiddenQuestion> current_;  ///< the question in progress
    int current_version_ = -1;
    bool is_dropped_ = false;  ///< the answer to the current question is not needed
    Answer answer_;
    int answer_version_ = -1;
    std::optional<HiddenQuestion> failed_;
    int failed_version_ = -1;
    std::optional<std::string> failure_;  ///< until take_failure()
    std::shared_ptr<Solver> solver_;      ///< used only by the current work
    BackgroundTask<Answer> task_;
};

}  // namespace viewing
