// Work beside the window: started, watched, cancelled; its result is taken when it is there, or one sentence about why
// there is none. The one place that makes threads: where there are none (a browser), another file stands in the place
// of desktop/background.cpp.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "platform/progress.h"
#include "text/result.h"

namespace viewing {

/// From now on `wake` is called whenever work has ended, in its thread: for a window that sleeps until something
/// happens. Null: nobody is waked.
void wake_when_work_ends(void (*wake)());

/// What a person is told instead of a result, where `std::current_exception` is what ended the work.
Error failure_of_work();

/// One call of a function beside the caller's. BackgroundTask is what others use.
class BackgroundCall {
public:
    /// `work` throws nothing.
    explicit BackgroundCall(std::function<void()> work);
    ~BackgroundCall();  ///< waits for its end
    BackgroundCall(const BackgroundCall&) = delete;
    BackgroundCall& operator=(const BackgroundCall&) = delete;

    bool is_done() const;
    /// Waits for its end, at most so long; negative: as long as it takes.
    void wait(double seconds) const;

private:
    struct State;
    std::shared_ptr<State> state_;
};

/// A computation of a T. All of it is used from one thread; only `Work` runs in another. Its end waits for all work
/// that was begun, nothing else does unless it is told to.
template <typename T>
class BackgroundTask {
public:
    using Work = std::function<Result<T>(WorkProgress&)>;

    /// What was running is dropped.
    void start(Work work) {
        drop();
        job_ = std::make_unique<Job>();
        try {
            job_->call = std::make_unique<BackgroundCall>([job = job_.get(), run = std::move(work)] {
                try {
                    job->result.emplace(run(job->progress));
                } catch (...) {
                    job->result.emplace(failure_of_work());
                }
            });
        } catch (...) {  // no thread for it
            job_->result.emplace(failure_of_work());
        }
    }

    /// Cancels what is running and forgets its result. It ends by itself, be that soon or late.
    void drop() {
        std::erase_if(dropped_, [](const auto& job) { return is_over(*job); });
        if (!job_) return;
        job_->progress.cancelled = true;
        dropped_.push_back(std::move(job_));
    }

    bool is_running() const { return job_ != nullptr; }  ///< until its result is taken
    bool is_done() const { return job_ && is_over(*job_); }
    float fraction() const { return job_ ? job_->progress.fraction.load() : 0.0F; }
    void cancel() {
        if (job_) job_->progress.cancelled = true;
    }
    /// At most so long; negative: as long as it takes.
    void wait(double seconds) const {
        if (job_ && job_->call) job_->call->wait(seconds);
    }

    /// The result, once, when there is one; a cancelled task gives what it had. What the work threw is an error.
    std::optional<Result<T>> take() {
        if (!is_done()) return std::nullopt;
        const std::unique_ptr<Job> job = std::move(job_);
        return std::move(job->result);
    }

private:
    struct Job {
        ~Job() { progress.cancelled = true; }
        WorkProgress progress;
        std::optional<Result<T>> result;
        std::unique_ptr<BackgroundCall> call;  ///< last: its end is waited for before the others go; null: no thread
    };
    static bool is_over(const Job& job) { return !job.call || job.call->is_done(); }

    std::unique_ptr<Job> job_;
    std::vector<std::unique_ptr<Job>> dropped_;  ///< not ended yet, when last looked at
};

/// What a task tells before its end, in order; filled and read from any thread.
template <typename Entry>
class BackgroundLog {
public:
    void add(Entry entry) {
        const std::lock_guard lock(mutex_);
        entries_.push_back(std::move(entry));
    }
    std::vector<Entry> entries() const {
        const std::lock_guard lock(mutex_);
        return entries_;
    }

private:
    mutable std::mutex mutex_;
    std::vector<Entry> entries_;
};

}  // namespace viewing
