#include "platform/background.h"

#include <chrono>
#include <condition_variable>
#include <thread>

namespace viewing {

struct BackgroundCall::State {
    mutable std::mutex mutex;
    mutable std::condition_variable changed;
    bool is_done = false;
    std::thread thread;
};

BackgroundCall::BackgroundCall(std::function<void()> work) : state_(std::make_unique<State>()) {
    state_->thread = std::thread([state = state_.get(), run = std::move(work)] {
        run();
        const std::lock_guard lock(state->mutex);
        state->is_done = true;
        state->changed.notify_all();
    });
}

BackgroundCall::~BackgroundCall() {
    state_->thread.join();
}

bool BackgroundCall::is_done() const {
    const std::lock_guard lock(state_->mutex);
    return state_->is_done;
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
