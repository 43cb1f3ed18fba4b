// A computation beside the window: started, watched, cancelled; its result is taken when it is there.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

#include "platform/progress.h"

namespace viewing {

template <typename T>
class BackgroundTask {
public:
    using Work = std::function<T(WorkProgress&)>;

    /// What was running is cancelled and its result dropped.
    void start(Work work) {
        job_ = std::make_unique<Job>();
        job_->thread = std::jthread([job = job_.get(), run = std::move(work)] {
            job->result = run(job->progress);
            job->is_done = true;
        });
    }

    bool is_running() const { return job_ != nullptr; }  ///< until its result is taken
    float fraction() const { return job_ ? job_->progress.fraction.load() : 0.0F; }
    void cancel() {
        if (job_) job_->progress.cancelled = true;
    }

    /// The result, once, when there is one; a cancelled task gives what it had.
    std::optional<T> take() {
        if (!job_ || !job_->is_done) return std::nullopt;
        job_->thread.join();
        T result = std::move(*job_->result);
        job_.reset();
        return result;
    }

private:
    struct Job {
        ~Job() { progress.cancelled = true; }
        WorkProgress progress;
        std::optional<T> result;
        std::atomic<bool> is_done{false};
        std::jthread thread;  ///< last: it is waited for before the others go
    };
    std::unique_ptr<Job> job_;
};

}  // namespace viewing
