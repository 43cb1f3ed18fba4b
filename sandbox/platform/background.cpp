#include "platform/background.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <new>
#include <thread>

#include "text/catalogue.h"

namespace viewing {
namespace {

std::atomic<void (*)()> wake_at_end{nullptr};

}  // namespace

void wake_when_work_ends(void (*wake)()) {
    wake_at_end = wake;
}

Error failure_of_work() {
    try {
        throw;
    } catch (const std::bad_alloc&) {
        return Error{tr("the memory does not suffice for this work: it is given up")};
    } catch (const std::exception& thrown) {
        return Error{say("this work is given up: {reason}", "reason"_a = thrown.what())};
    } catch (...) {
        return Error{tr("this work is given up, nobody knows why")};
    }
}

struct BackgroundCall::State {
    mutable std::mutex mutex;
    mutable std::condition_variable changed;
    bool is_done = false;
    std::thread thread;
};

BackgroundCall::BackgroundCall(std::function<void()> work) : state_(std::make_unique<State>()) {
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

void BackgroundCall::wait(double seconds) const {
    std::unique_lock lock(state_->mutex);
    const auto is_over = [this] { return state_->is_done; };
    if (seconds < 0.0)
        state_->changed.wait(lock, is_over);
    else
        state_->changed.wait_for(lock, std::chrono::duration<double>(seconds), is_over);
}

}  // namespace viewing
