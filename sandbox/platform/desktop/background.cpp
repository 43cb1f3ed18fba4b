#include "platform/background.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <system_error>
#include <thread>
#include <vector>

#include "platform/threads.h"

namespace viewing {
namespace {

std::atomic<void (*)()> wake_at_end{nullptr};

}  // namespace

void wake_when_work_ends(void (*wake)()) {
    wake_at_end = wake;
}

struct BackgroundCall::State {
    mutable std::mutex mutex;
    mutable std::condition_variable changed;
    bool is_done = false;
    std::thread thread;
};

BackgroundCall::BackgroundCall(std::function<void()> work) : state_(std::make_shared<State>()) {
    state_->thread = std::thread([state = state_.get(), run = std::move(work)] {
        run();
        {
            const std::lock_guard lock(state->mutex);
            state->is_done = true;
            state->changed.notify_all();
        }
        if (void (*const wake)() = wake_at_end) wake();
    });
}

BackgroundCall::~BackgroundCall() {
    state_->thread.join();
}

bool BackgroundCall::is_done() const {
    const std::lock_guard lock(state_->mutex);
    return state_->is_done;
}

bool can_start_threads(int count) {
    std::mutex gate;
    std::vector<std::thread> threads;
    bool could = true;
    {
        const std::lock_guard closed(gate);  // no thread ends before the last one has started
        try {
            for (int i = 0; i < count; ++i) threads.emplace_back([&gate] { const std::lock_guard passed(gate); });
        } catch (const std::system_error&) {
            could = false;
        }
    }
    for (std::thread& thread : threads) thread.join();
    return could;
}

int threads_of_a_driver() {
    constexpr unsigned most_cores = 16, beside = 4;
    return static_cast<int>(std::min(std::thread::hardware_concurrency(), most_cores) + beside);
}

void BackgroundCall::wait(double seconds) const {
    std::unique_lock lock(state_->mutex);
    const auto is_over = [this] { return state_->is_done; };
    if (seconds < 0.0)
        state_->changed.wait(lock, is_over);
    else
        state_->changed.wait_for(lock, std::chrono::duration<double>(seconds), is_over);
}

}  // namespace viewing
