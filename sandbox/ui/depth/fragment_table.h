// The surfaces on a pixel's ray as a list in drawing order: where each lies and what the tests make of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "frame/depth/fragments.h"
#include "frame/pixel_report.h"
#include "state/scene.h"

namespace viewing {

/// Fills what is left of the window, and scrolls by itself where that is at least a few rows; else the window has to.
/// The one that is seen is marked; ties and what rounding decides are in the trouble colour. Columns for which there is
/// no room are left out: facing first, then the code, eye z, and last the compare; narrower ones may stay in place of a
/// wide one. Returns the row that was clicked; `on_click` says what that does, or is empty.
std::optional<std::size_t> draw_fragment_table(const std::vector<Fragment>& fragments, const DepthPrecision& precision,
                                               const Scene& scene, bool is_large, const std::string& on_click);

}  // namespace viewing
