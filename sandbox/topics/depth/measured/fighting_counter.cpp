#include "topics/depth/measured/fighting_counter.h"

#include <chrono>

#include "topics/depth/measured/fighting_measure.h"

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
    task_.drop();  // otherwise the counts for the previous question would be used for this one
    derived_ = derive(question.params, scene, renderer.viewport(question.size_px, question.params.depth.format));
    search_.emplace(renderer, question.params, derived_.facts.target_distance);
    picture_ = -1;
    const Result<IdImage> drawn = objects_by_gl(renderer, question.params, scene, question.size_px);
    if (!drawn) return take(Error{drawn.error()}, scene);
    if (may_wait) {
        take(count_wrong(*drawn, question.params, scene, near_coplanar_pairs(scene)), scene);
        Status done = count_cures(*report_, renderer, scene);
        if (done) done = count_spread(*report_, renderer, question.params, scene);
        give_up(done ? report_->problem : done.error());
    } else {
        task_.start(counting(*drawn, question.params, scene));
    }
}

/// Ends the counting for this question.
void FightingCounter::give_up(std::string problem) {
    report_->problem = std::move(problem);
    picture_ = cure_count() + spread_cameras;
}

void FightingCounter::take(Result<FightingCounts> counts, const Scene& scene) {
    if (picture_ >= 0) {
        if (!counts) return give_up(counts.error());
        if (picture_ >= cure_count()) return take_spread(*report_, *counts);
        report_->cured[picture_].counts = *std::move(counts);
        return;
    }
    const std::optional<MinimumGap> gap = report_ ? report_->minimum_gap : std::nullopt;
    const std::string problem = counts ? "" : counts.error();
    report_ = std::make_shared<FightingReport>(fighting_report(counts ? *std::move(counts) : FightingCounts{},
                                                               asked_->params, derived_, scene, asked_->size_px));
    report_->minimum_gap = gap;
    predicted_ = asked_;
    if (!problem.empty() || report_->rows.empty()) give_up(problem);
}

void FightingCounter::predict(const Renderer& renderer, const Scene& scene, const Question& question) {
    if (predicted_ == question) return;
    predicted_ = question;
    const std::vector<FlatPair> pairs = near_coplanar_pairs(scene);
    if (pairs.empty()) return;
    const Derived derived =
        derive(question.params, scene, renderer.viewport(question.size_px, question.params.depth.format));
    if (!report_ || report_->rows.size() != pairs.size()) {  // there are no counts for these pairs
        FightingCounts none;
        for (const FlatPair& pair : pairs) none.pairs.push_back({.pair = pair});
        report_ = std::make_shared<FightingReport>(
            fighting_report(std::move(none), question.params, derived, scene, question.size_px));
        if (asked_ != question) {
            asked_.reset();
            task_.drop();
            search_.reset();
            picture_ = spread_cameras + cure_count();
        }
        return;
    }
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        report_->counts.pairs[i].pair = pairs[i];
        report_->rows[i].predicted = predict_pair(pairs[i], question.params, derived, question.size_px);
    }
}

void FightingCounter::count_next(Renderer& renderer, const Scene& scene) {
    ++picture_;
    if (!has_more_pictures()) return;
    const bool is_cure = picture_ < cure_count();
    const Params params =
        is_cure ? report_->cured[picture_].cure.params : jittered(asked_->params, picture_ - cure_count());
    const Result<IdImage> drawn =
        objects_by_gl(renderer, params, scene, is_cure ? asked_->size_px : spread_size(asked_->size_px));
    if (!drawn) return give_up(drawn.error());
    task_.start(counting(*drawn, params, scene));
}

void FightingCounter::search(Renderer& renderer, bool may_wait) {
    using Clock = std::chrono::steady_clock;
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
        if (!search_ && !task_.is_running() && may_work && has_more_pictures()) count_next(renderer, scene);
    }
    predict(renderer, scene, question);
    if (report_) {
        report_->counts_are_behind = !is_asked || (picture_ < 0 && task_.is_running());
        report_->gap_is_behind = report_->counts_are_behind || search_;
        report_->spread_is_behind = report_->gap_is_behind || has_more_pictures();
    }
    return report_;
}

}  // namespace viewing
