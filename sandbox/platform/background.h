// Background work that can be started, watched and canceled; it ends with a result, or with one sentence that says why
// there is none. Only this module creates threads. Browsers have none, so they use browser/background.cpp instead of
// desktop/background.cpp.
#pragma once

#include <chrono>
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

/// How long the window's own thread may work for a task in one frame: not felt while nothing is dragged.
inline constexpr auto a_moment = std::chrono::milliseconds(30);

/// Sets a function that the work's thread calls whenever work ends, to wake a window that sleeps until something
/// happens. Null removes the function.
void wake_when_work_ends(void (*wake)());

/// Returns the sentence that replaces the result if an exception ended the work. Call while handling that exception.
Error failure_of_work();

/// Runs a function in the background. Most code uses BackgroundTask instead.
class BackgroundCall {
public:
    /// `work` must not throw.
    explicit BackgroundCall(std::function<void()> work);
    ~BackgroundCall();  ///< waits until the work ends
    BackgroundCall(const BackgroundCall&) = delete;
    BackgroundCall& operator=(const BackgroundCall&) = delete;

    bool is_done() const;
    /// Waits until the work ends, but no longer than `seconds`; if `seconds` is negative, there is no limit.
    void wait(double seconds) const;

private:
    struct State;
    std::shared_ptr<State> state_;
};

/// Computes a T in the background. Use it from one thread; only `Work` runs in another one. Only wait() and the
/// destructor block; the destructor waits for all work that was started.
template <typename T>
class BackgroundTask {
public:
    using Work = std::function<Result<T>(WorkProgress&)>;

    /// Drops the work in progress and starts new work.
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
        } catch (...) {  // no thread available
            job_->result.emplace(failure_of_work());
        }
    }

    /// Cancels the work in progress and forgets its result. The work ends by itself, sooner or later.
    void drop() {
        std::erase_if(dropped_, [](const auto& job) { return is_over(*job); });
        if (!job_) return;
        job_->progress.canceled = true;
        dropped_.push_back(std::move(job_));
    }

    bool is_running() const { return job_ != nullptr; }  ///< true until take() returns the result
    bool is_done() const { return job_ && is_over(*job_); }
    float fraction() const { return job_ ? job_->progress.fraction.load() : 0.0F; }
    void cancel() {
        if (job_) job_->progress.canceled = true;
    }
    /// Waits until the work ends, but no longer than `seconds`; if `seconds` is negative, there is no limit.
    void wait(double seconds) const {
        if (job_ && job_->call) job_->call->wait(seconds);
    }

    /// Returns the result once, as soon as there is one; a canceled task returns its incomplete result. An exception in
    /// the work becomes an error.
    std::optional<Result<T>> take() {
        if (!is_done()) return std::nullopt;
        const std::unique_ptr<Job> job = std::move(job_);
        return std::move(job->result);
    }

private:
    struct Job {
        ~Job() { progress.canceled = true; }
        WorkProgress progress;
        std::optional<Result<T>> result;
        std::unique_ptr<BackgroundCall> call;  ///< null if no thread could be started; declared last, so that it
                                               ///< is destroyed first and waits for the work
    };
    static bool is_over(const Job& job) { return !job.call || job.call->is_done(); }

    std::unique_ptr<Job> job_;
    std::vector<std::unique_ptr<Job>> dropped_;  ///< jobs that were still running at the last check
};

/// Entries that a task reports before it ends, in order. Any thread may write and read them.
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
