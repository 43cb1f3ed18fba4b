// Applies the state's window layout (view.layout): the large view, the small parts beside it, folded columns. The keys
// and the Look menu change the layout through these functions.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "state/params.h"
#include "state/presets.h"
#include "ui/parts/layout.h"
#include "ui/parts/topics.h"

namespace viewing {

/// Returns whether a column ("panel" or "matrices") is folded; fold() folds or unfolds it.
bool is_folded(const Params& params, std::string_view column);
void fold(Params& params, std::string_view column, bool folded);

/// Height of the lamps for the degrees of freedom, in rows of the panel.
constexpr int rows_of_lamps = 2;

/// Copies the state's layout into the arrangement. `matrices`: those to show beside a large view.
void arrange(Arrangement& arrangement, const Params& params, const std::vector<std::string>& matrices);

/// For a state that lists no matrices, returns those that it is about, in lecture order: the matrices that move the
/// camera, or those that make the shadow and the mirror image. `preset`: the open one; null for none.
std::vector<std::string> matrices_about(const Params& params, const NamedFile* preset);

/// Returns those of matrices_about() that leave room on stage for the lower view `first` or, beside the last matrix
/// only, for the two views that the state names.
std::vector<std::string> matrices_on_stage(const Params& params, const NamedFile* preset, Slot first);

/// On stage, opens the lower views that fit beside the matrices; if only one fits, opens `first`.
void open_lower_views(Arrangement& arrangement, const Params& params, Slot first);

/// Returns the area of the views' window.
Rect views_area(const Layout& layout, const Arrangement& arrangement);

/// Returns the area of lower views that have their own window (lower_in_column).
Rect lower_views_area(const Layout& layout);

}  // namespace viewing
