#include "measure/fighting_counter.h"

#include <chrono>

#include "measure/fighting_measure.h"

namespace viewing {
namespace {

auto counting(IdImage drawn, const Params& params, const Scene& scene) {
    return [image = std::move(drawn), params, scene](WorkProgress& progress) {
        return count_wrong(image, params, scene, near_coplanar_pairs(scene), &progress);
    };
}

}  // namespace

void FightingCounter::start(Renderer& renderer, const Scene& scene, const Question& question, bool may_wait) {
    asked_ = question;
    task_ = {};  // what was counted for the question before would be taken for this one's
    derived_ = derive(question.params, scene, {question.size_px, renderer.capabilities().clip_control});
    search_.emplace(renderer, question.params, derived_.facts.target_distance);
    camera_ = -1;
    const Result<IdImage> drawn = objects_by_gl(renderer, question.params, scene, question.size_px);
    if (!drawn) return take(Error{drawn.error()}, scene);
    if (may_wait) {
        take(count_wrong(*drawn, question.params, scene, near_coplanar_pairs(scene)), scene);
        if (const Status done = count_spread(*report_, renderer, question.params, scene); !done)
            report_->problem = done.error();
        camera_ = spread_cameras;
    } else {
        task_.start(counting(*drawn, question.params, scene));
    }
}

void FightingCounter::take(Result<FightingCounts> counts, const Scene& scene) {
    if (camera_ >= 0) {
        if (counts) return take_spread(*report_, *counts);
        report_->problem = counts.error();
        camera_ = spread_cameras;
        return;
    }
    const std::optional<MinimumGap> gap = report_ ? report_->minimum_gap : std::nullopt;
    std::string problem = counts ? "" : counts.error();
    report_ = std::make_shared<FightingReport>(fighting_report(counts ? *std::move(counts) : FightingCounts{},
                                                               asked_->params, derived_, scene, asked_->size_px));
    report_->minimum_gap = gap;
    if (!problem.empty() || report_->rows.empty()) camera_ = spread_cameras;
    report_->problem = std::move(problem);
}

void FightingCounter::count_next_camera(Renderer& renderer, const Scene& scene) {
    if (++camera_ >= spread_cameras) return;
    const Params params = trembling(asked_->params, camera_);
    const Result<IdImage> drawn = objects_by_gl(renderer, params, scene, spread_size(asked_->size_px));
    if (drawn) return task_.start(counting(*drawn, params, scene));
    report_->problem = drawn.error();
    camera_ = spread_cameras;
}

void FightingCounter::search(Renderer& renderer, bool may_wait) {
    using Clock = std::chrono::steady_clock;
    constexpr auto a_moment = std::chrono::milliseconds(12);
    const Clock::time_point end = Clock::now() + a_moment;
    Status done = std::monostate{};
    while (done && !search_->is_done() && (may_wait || Clock::now() < end)) done = search_->step(renderer);
    if (!search_->is_done()) return;
    if (done) report_->minimum_gap = search_->found();
    if (!done) report_->problem = done.error();
    search_.reset();
}

std::shared_ptr<const FightingReport> FightingCounter::update(Renderer& renderer, const Params& state,
                                                              const Scene& scene, int scene_version, glm::ivec2 size_px,
                                                              bool may_wait, bool is_at_rest) {
    const Question question{counted_params(state), scene_version, size_px};
    const bool may_work = may_wait || is_at_rest;
    if (asked_ != question && may_work) start(renderer, scene, question, may_wait);
    const bool is_asked = asked_ == question;
    if (is_asked) {
        if (auto counts = task_.take()) take(*std::move(counts), scene);
        if (search_ && !task_.is_running() && may_work) search(renderer, may_wait);
        if (!search_ && !task_.is_running() && may_work && camera_ < spread_cameras) count_next_camera(renderer, scene);
    }
    if (report_) {
        report_->counts_are_behind = !is_asked || (camera_ < 0 && task_.is_running());
        report_->gap_is_behind = report_->counts_are_behind || search_;
        report_->spread_is_behind = report_->gap_is_behind || camera_ < spread_cameras;
    }
    return report_;
}

}  // namespace viewing
