// A page has only one thread, so work waits in a queue and runs between frames. If the browser can suspend WebAssembly
// (JavaScript Promise Integration), work runs on its own stack and pauses when it checks for cancellation and the page
// is due for a frame; otherwise it runs without a pause. The JavaScript side is in app/browser/page/page.js.
#include "platform/background.h"

#include <emscripten.h>

#include <algorithm>
#include <cstdlib>
#include <deque>
#include <memory>
#include <utility>

#include "platform/browser/standstill.h"
#include "platform/threads.h"
#include "text/catalogue.h"

EM_JS(void, page_begin_work, (void* run, void* stack_end), { page.beginWork(run, stack_end); });
// Does nothing, unless page.js replaces it, by name, with a function that suspends.
EM_JS(void, page_pause, (), {});
EM_JS(int, page_can_pause, (), { return page.canPause ? 1 : 0; });

namespace viewing {
namespace {

constexpr double slice_ms = 8.0;
constexpr std::size_t stack_bytes = 1U << 20U;

void (*wake_at_end)() = nullptr;
double slice_began_ms = 0.0;
bool is_at_work = false;
double longest_standstill_ms = 0.0;

}  // namespace

struct BackgroundCall::State {
    std::function<void()> work;
    bool has_begun = false, is_done = false;

    void run() {
        has_begun = true;
        const double began_ms = emscripten_get_now();
        work();
        if (!page_can_pause()) longest_standstill_ms = std::max(longest_standstill_ms, emscripten_get_now() - began_ms);
        is_done = true;
        if (wake_at_end) wake_at_end();
    }
};

namespace {

std::deque<std::function<void()>> waiting;
bool is_running = false;  ///< some work has begun, and may be suspended

/// Runs all waiting work, on its own stack if the browser can suspend WebAssembly.
void run_waiting() {
    is_at_work = true;
    slice_began_ms = emscripten_get_now();
    while (!waiting.empty()) {
        const std::function<void()> call = std::move(waiting.front());
        waiting.pop_front();
        call();
        give_way();
    }
    is_at_work = is_running = false;
}

void* end_of_stack() {
    static char* const stack = static_cast<char*>(std::aligned_alloc(16, stack_bytes));
    return stack ? stack + stack_bytes : nullptr;
}

}  // namespace

void give_way() {
    if (!is_at_work || emscripten_get_now() - slice_began_ms < slice_ms) return;
    is_at_work = false;  // the page's own code that runs in between is not work
    page_pause();
    is_at_work = true;
    slice_began_ms = emscripten_get_now();
}

double take_standstill_ms() {
    return std::exchange(longest_standstill_ms, 0.0);
}

void wake_when_work_ends(void (*wake)()) {
    wake_at_end = wake;
}

BackgroundCall::BackgroundCall(std::function<void()> work) : state_(std::make_shared<State>()) {
    state_->work = std::move(work);
    waiting.push_back([state = state_] {
        if (!state->is_done) state->run();
    });
    if (!std::exchange(is_running, true)) page_begin_work(reinterpret_cast<void*>(run_waiting), end_of_stack());
}

/// Most tasks live as long as the page. If one is destroyed earlier, its work has already ended or has not begun.
BackgroundCall::~BackgroundCall() {
    if (!state_->has_begun) state_->is_done = true;
}

bool BackgroundCall::is_done() const {
    return state_->is_done;
}

/// The page cannot block, so this does not wait for work that has begun. Work that has not begun runs right here if
/// there is no time limit.
void BackgroundCall::wait(double seconds) const {
    if (seconds < 0.0 && !state_->has_begun) state_->run();
}

bool can_start_threads(int) {
    return true;
}

int threads_of_a_driver() {
    return 0;
}

}  // namespace viewing
