// Depth fighting counted: GL's picture by object identities, read back, against exact visibility by ray casting.
// Read minimum_gap.h next: from which gap on a depth buffer tells two surfaces apart.
#pragma once

#include <span>

#include "frame/depth/fighting_report.h"
#include "platform/progress.h"
#include "render/renderer.h"
#include "visibility/id_image.h"

namespace viewing {

/// The part of the state that the counts depend on, the rest as it is by default: nothing is drawn but the objects,
/// wholly, by GL's depth buffer.
Params counted_params(const Params& state);

/// GL's picture of the objects, by their indices.
Result<IdImage> objects_by_gl(Renderer& renderer, const Params& state, const Scene& scene, glm::ivec2 size_px);

/// Counts these pairs, near_coplanar_pairs(scene) as a rule, in such a picture of the same state, by casting rays.
/// Knows no GL: can run in a thread. The error says that the work was cancelled.
Result<FightingCounts> count_wrong(const IdImage& drawn, const Params& state, const Scene& scene,
                                   std::span<const FlatPair> pairs, WorkProgress* progress = nullptr);

/// Both: draws the scene's objects, alone, with the depth buffer of the state, whatever its hidden-surface method, and
/// counts. The error is GL's, or says that the work was cancelled.
Result<FightingCounts> count_fighting(Renderer& renderer, const Params& state, const Scene& scene,
                                      std::span<const FlatPair> pairs, glm::ivec2 size_px,
                                      WorkProgress* progress = nullptr);

/// The size of the pictures that a spread is counted in: that of the report's, but no wider than 480 pixels.
glm::ivec2 spread_size(glm::ivec2 size_px);

/// Adds what was counted from one of the trembling() cameras to the rows' spreads.
void take_spread(FightingReport& report, const FightingCounts& counts);

/// Counts with each of the report's cures. The error is GL's, or says that the work was cancelled.
Status count_cures(FightingReport& report, Renderer& renderer, const Scene& scene, WorkProgress* progress = nullptr);

/// Counts from all of the trembling cameras. The error is GL's, or says that the work was cancelled.
Status count_spread(FightingReport& report, Renderer& renderer, const Params& state, const Scene& scene,
                    WorkProgress* progress = nullptr);

}  // namespace viewing
