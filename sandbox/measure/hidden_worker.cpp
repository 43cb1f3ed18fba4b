#include "measure/hidden_worker.h"

#include <chrono>

namespace viewing {
namespace {

/// The same method with the same options; only the camera, the picture's size or the step are others.
bool is_same_work(const HiddenQuestion& a, const HiddenQuestion& b) {
    VisibilityParams of_a = a.camera.visibility, of_b = b.camera.visibility;
    of_a.step = of_b.step = -1;
    return of_a == of_b && a.camera.cull == b.camera.cull && a.other.has_value() == b.other.has_value();
}

}  // namespace

HiddenWorker::HiddenWorker() : thread_([this](const std::stop_token& stop) { work(stop); }) {}

HiddenWorker::~HiddenWorker() {
    forget();
    thread_.request_stop();
}

void HiddenWorker::ask(const HiddenQuestion& question, const Scene& scene, int scene_version) {
    const std::scoped_lock lock(mutex_);
    const bool works_on_it = current_ && !is_dropped_ && *current_ == question && current_version_ == scene_version;
    const bool is_answered = !current_ && answer_ && answer_->question == question && answer_version_ == scene_version;
    const bool waits = waiting_ && waiting_->question == question && waiting_->scene_version == scene_version;
    if (works_on_it || is_answered || waits) return;
    if (current_ && (current_version_ != scene_version || !is_same_work(*current_, question))) drop_current();
    waiting_ = Job{question, scene, scene_version};
    changed_.notify_all();
}

void HiddenWorker::wait(double seconds) {
    std::unique_lock lock(mutex_);
    const auto is_idle = [this] { return !waiting_ && !current_; };
    if (seconds < 0.0)
        changed_.wait(lock, is_idle);
    else
        changed_.wait_for(lock, std::chrono::duration<double>(seconds), is_idle);
}

std::shared_ptr<const HiddenAnswer> HiddenWorker::answer(int scene_version) const {
    const std::scoped_lock lock(mutex_);
    return answer_version_ == scene_version ? answer_ : nullptr;
}

std::optional<float> HiddenWorker::fraction() const {
    const std::scoped_lock lock(mutex_);
    if (!waiting_ && !current_) return std::nullopt;
    return progress_.fraction.load();
}

void HiddenWorker::cancel() {
    const std::scoped_lock lock(mutex_);
    waiting_.reset();
    if (current_) progress_.cancelled = true;
}

void HiddenWorker::forget() {
    const std::scoped_lock lock(mutex_);
    waiting_.reset();
    answer_.reset();
    drop_current();
}

void HiddenWorker::drop_current() {
    if (!current_) return;
    is_dropped_ = true;
    progress_.cancelled = true;
}

void HiddenWorker::work(const std::stop_token& stop) {
    std::unique_ptr<HiddenSurfaceSolver> solver;
    int solver_version = -1;
    std::unique_lock lock(mutex_);
    while (changed_.wait(lock, stop, [this] { return waiting_.has_value(); })) {
        const Job job = *std::exchange(waiting_, std::nullopt);
        current_ = job.question;
        current_version_ = job.scene_version;
        progress_.cancelled = is_dropped_ = false;
        progress_.fraction = 0.0F;
        lock.unlock();
        if (solver_version != job.scene_version) solver = std::make_unique<HiddenSurfaceSolver>(job.scene);
        solver_version = job.scene_version;
        auto made = std::make_shared<const HiddenAnswer>(answer_hidden_question(*solver, job.question, &progress_));
        lock.lock();
        if (!is_dropped_) {
            answer_ = std::move(made);
            answer_version_ = job.scene_version;
        }
        current_.reset();
        changed_.notify_all();
    }
}

}  // namespace viewing
