// Keeps the numbers of the depth fighting view up to date without blocking the window. GL draws the pictures while
// nothing is being dragged, a background thread computes exact visibility, and the search for the smallest gap draws a
// few pictures per frame. Then the counter counts everything again with each cure (topics/depth/numbers/cures.h)
// applied, and from jittered cameras. See fighting_measure.h for the counts.
#pragma once

#include <memory>
#include <optional>

#include "platform/background.h"
#include "topics/depth/measured/minimum_gap.h"

namespace viewing {

class FightingCounter {
public:
    /// Returns the report so far; null while there is none. Its predictions belong to `state`; counts_are_behind marks
    /// counts from an earlier state. With `may_wait`, counts everything before it returns; otherwise, work starts
    /// and continues only while nothing moves.
    std::shared_ptr<const FightingReport> update(Renderer& renderer, const Params& state, const Scene& scene,
                                                 int scene_version, glm::ivec2 size_px, bool may_wait, bool is_at_rest);

    /// Whether more frames are needed even if nothing is edited.
    bool wants_frames() const { return task_.is_running() || search_.has_value() || has_more_pictures(); }

private:
    /// The inputs of the counts.
    struct Question {
        Params params;
        int scene_version = -1;
        glm::ivec2 size_px{0};
        bool operator==(const Question&) const = default;
    };

    void start(Renderer& renderer, const Scene& scene, const Question& question, bool may_wait);
    void take(Result<FightingCounts> counts, const Scene& scene);
    /// Immediately predicts the numbers that have a formula, even while the counts are outdated.
    void predict(const Renderer& renderer, const Scene& scene, const Question& question);
    void search(Renderer& renderer, bool may_wait);
    void count_next(Renderer& renderer, const Scene& scene);
    void give_up(std::string problem);

    /// Returns the number of pictures with a cure. They are counted after the state's own picture and before those from
    /// the jittered cameras.
    int cure_count() const { return report_ ? static_cast<int>(report_->cured.size()) : 0; }
    bool has_more_pictures() const { return picture_ < cure_count() + spread_cameras; }

    std::optional<Question> asked_, predicted_;
    Derived derived_;  ///< for asked_
    std::shared_ptr<FightingReport> report_;
    BackgroundTask<FightingCounts> task_;
    std::optional<MinimumGapSearch> search_;
    /// The index of the picture that task_ is counting or counted last; −1 is the state's own.
    int picture_ = spread_cameras;
};

}  // namespace viewing
