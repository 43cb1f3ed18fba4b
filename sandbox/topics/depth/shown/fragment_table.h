// The surfaces along a pixel's ray, listed in drawing order: their depths and the results of the tests.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "frame/pixel_report.h"
#include "state/scene.h"
#include "topics/depth/numbers/fragments.h"

namespace viewing {

/// Draws the table, which fills the rest of the window. The table scrolls by itself if at least a few rows fit;
/// otherwise the window must scroll. Marks the visible fragment. Draws a test in the trouble color if it is a tie or if
/// rounding decides it. Drops columns that do not fit: facing first, then the code, then eye z, and last the
/// comparison. A narrow column may remain even though a wider, more important one is dropped. Returns the index of the
/// clicked row. `on_click` describes the effect of a click, or is empty.
std::optional<std::size_t> draw_fragment_table(const std::vector<Fragment>& fragments, const DepthPrecision& precision,
                                               const Scene& scene, bool is_large, const std::string& on_click);

}  // namespace viewing
