// Counts depth fighting by comparing GL's picture of object ids, read back, with exact visibility from ray casting.
// Read minimum_gap.h next: it finds the smallest gap at which a depth buffer resolves two surfaces.
#pragma once

#include <span>

#include "image/id_image.h"
#include "platform/progress.h"
#include "render/renderer.h"
#include "topics/depth/numbers/fighting_report.h"

namespace viewing {

/// Returns the part of the state that the counts depend on, with defaults for the rest, so that GL draws all objects
/// completely, with its depth buffer, and nothing else.
Params counted_params(const Params& state);

/// Returns the picture that GL draws, as the index of the object at each pixel.
Result<IdImage> objects_by_gl(Renderer& renderer, const Params& state, const Scene& scene, glm::ivec2 size_px);

/// Counts the wrong pixels of these pairs, usually near_coplanar_pairs(scene), and elsewhere, by casting rays. `drawn`
/// is the picture from objects_by_gl() for the same state. Needs no GL, so it can run in a thread. The error says that
/// the scene is too large, or that the work was canceled.
Result<FightingCounts> count_wrong(const IdImage& drawn, const Params& state, const Scene& scene,
                                   std::span<const FlatPair> pairs, WorkProgress* progress = nullptr);

/// Calls objects_by_gl() and then count_wrong(). GL draws with the state's depth buffer, whatever the state's
/// hidden-surface method is. The error comes from GL or from count_wrong().
Result<FightingCounts> count_fighting(Renderer& renderer, const Params& state, const Scene& scene,
                                      std::span<const FlatPair> pairs, glm::ivec2 size_px,
                                      WorkProgress* progress = nullptr);

/// Returns the size of the pictures for a spread: that of the report, but at most 480 pixels wide.
glm::ivec2 spread_size(glm::ivec2 size_px);

/// Adds the counts for one of the jittered() cameras to the spreads of the rows.
void take_spread(FightingReport& report, const FightingCounts& counts);

/// Calls count_fighting() with each of the report's cures applied, and puts the counts into the report. The error is
/// that of count_fighting().
Status count_cures(FightingReport& report, Renderer& renderer, const Scene& scene, WorkProgress* progress = nullptr);

/// Calls count_fighting() for each of the jittered() cameras, and take_spread() with the counts. The error is that of
/// count_fighting().
Status count_spread(FightingReport& report, Renderer& renderer, const Params& state, const Scene& scene,
                    WorkProgress* progress = nullptr);

}  // namespace viewing
