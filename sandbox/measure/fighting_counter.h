// The numbers of the view of depth fighting, kept up with the state beside a window that must not wait: GL's pictures
// are drawn when nothing is held, exact visibility is found in a thread, and the search for the smallest gap goes on a
// few pictures a frame; then the same is counted with each cure and from trembling cameras, one after the other. Read
// fighting_measure.h
// for what is counted.
#pragma once

#include <memory>
#include <optional>

#include "measure/minimum_gap.h"
#include "platform/background.h"

namespace viewing {

class FightingCounter {
public:
    /// What is known, marked where it belongs to an earlier state; null while there is nothing. `may_wait`: everything
    /// is counted at once. Else work begins, and goes on, only at rest.
    std::shared_ptr<const FightingReport> update(Renderer& renderer, const Params& state, const Scene& scene,
                                                 int scene_version, glm::ivec2 size_px, bool may_wait, bool is_at_rest);

    /// More frames are wanted though nothing is edited.
    bool wants_frames() const { return task_.is_running() || search_.has_value() || has_more_pictures(); }

private:
    /// What the numbers depend on.
    struct Question {
        Params params;
        int scene_version = -1;
        glm::ivec2 size_px{0};
        bool operator==(const Question&) const = default;
    };

    void start(Renderer& renderer, const Scene& scene, const Question& question, bool may_wait);
    void take(Result<FightingCounts> counts, const Scene& scene);
    void search(Renderer& renderer, bool may_wait);
    void count_next(Renderer& renderer, const Scene& scene);
    void give_up(std::string problem);

    /// How many pictures are counted beside the state's own: with its cures, then from its trembling cameras.
    int cure_count() const { return report_ ? static_cast<int>(report_->cured.size()) : 0; }
    bool has_more_pictures() const { return picture_ < cure_count() + spread_cameras; }

    std::optional<Question> asked_;
    Derived derived_;  ///< of the question
    std::shared_ptr<FightingReport> report_;
    BackgroundTask<FightingCounts> task_;
    std::optional<MinimumGapSearch> search_;
    /// The one that task_ counts, or that was counted last: −1 is the state's own.
    int picture_ = spread_cameras;
};

}  // namespace viewing
