#include "topics/hidden/measured/hidden_worker.h"

#include <chrono>

namespace viewing {
namespace {

/// Whether both questions use the same method with the same options; the camera, the picture's size and the step may
/// differ.
bool is_same_work(const HiddenQuestion& a, const HiddenQuestion& b) {
    VisibilityParams of_a = a.camera.visibility, of_b = b.camera.visibility;
    of_a.step = of_b.step = -1;
    return of_a == of_b && a.camera.cull == b.camera.cull && a.other.has_value() == b.other.has_value();
}

}  // namespace

struct HiddenWorker::Solver {
    std::unique_ptr<HiddenSurfaceSolver> solver;
    static constexpr int no_scene = -1;
    int scene_version = no_scene;
};

void HiddenWorker::ask(const HiddenQuestion& question, const Scene& scene, int scene_version) {
    take_over();
    const bool works_on_it = current_ && !is_dropped_ && *current_ == question && current_version_ == scene_version;
    const bool is_answered = !current_ && answer_ && answer_->question == question && answer_version_ == scene_version;
    const bool waits = waiting_ && waiting_->question == question && waiting_->scene_version == scene_version;
    if (works_on_it || is_answered || waits || (!current_ && has_failed(question, scene_version))) return;
    if (current_ && (current_version_ != scene_version || !is_same_work(*current_, question))) drop_current();
    waiting_ = Job{question, scene, scene_version};
    take_over();
}

void HiddenWorker::wait(double seconds) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point begin = Clock::now();
    for (take_over(); current_; take_over()) {
        const double left = seconds - std::chrono::duration<double>(Clock::now() - begin).count();
        if (seconds >= 0.0 && left <= 0.0) return;
        task_.wait(seconds < 0.0 ? -1.0 : left);
    }
}

std::shared_ptr<const HiddenAnswer> HiddenWorker::answer(int scene_version) {
    take_over();
    return answer_version_ == scene_version ? answer_ : nullptr;
}

bool HiddenWorker::has_failed(const HiddenQuestion& question, int scene_version) {
    take_over();
    return failed_ && *failed_ == question && failed_version_ == scene_version;
}

std::optional<std::string> HiddenWorker::take_failure() {
    take_over();
    return std::exchange(failure_, std::nullopt);
}

std::optional<float> HiddenWorker::fraction() {
    take_over();
    if (!current_) return std::nullopt;
    return task_.fraction();
}

void HiddenWorker::cancel() {
    take_over();
    waiting_.reset();
    task_.cancel();
}

void HiddenWorker::forget() {
    waiting_.reset();
    answer_.reset();
    failed_.reset();
    failure_.reset();
    drop_current();
}

void HiddenWorker::drop_current() {
    if (!current_) return;
    is_dropped_ = true;
    task_.cancel();
}

void HiddenWorker::take_over() {
    if (std::optional<Result<Answer>> made = task_.take()) {
        const std::optional<HiddenQuestion> question = std::exchange(current_, std::nullopt);
        if (!*made) solver_.reset();  // its state is unknown
        if (!is_dropped_ && *made) {
            answer_ = **std::move(made);
            answer_version_ = current_version_;
            failed_.reset();
        } else if (!is_dropped_) {
            failed_ = question;
            failed_version_ = current_version_;
            failure_ = made->error();
        }
    }
    if (!current_ && waiting_) start(*std::exchange(waiting_, std::nullopt));
}

void HiddenWorker::start(Job job) {
    current_ = job.question;
    current_version_ = job.scene_version;
    is_dropped_ = false;
    if (!solver_) solver_ = std::make_shared<Solver>();
    task_.start([kept = solver_, job = std::move(job)](WorkProgress& progress) -> Result<Answer> {
        if (const Message why = beyond_hidden_budget(job.scene, job.question); !why.empty()) return Error{say(why)};
        if (kept->scene_version != job.scene_version) {
            kept->solver = std::make_unique<HiddenSurfaceSolver>(job.scene, &progress);
            // If the work was canceled, the solver is incomplete.
            kept->scene_version = is_canceled(&progress) ? Solver::no_scene : job.scene_version;
        }
        return std::make_shared<const HiddenAnswer>(answer_hidden_question(*kept->solver, job.question, &progress));
    });
}

}  // namespace viewing
