// What the state says of the window's arrangement (view.layout): which view is large, what small things stand beside
// it, what is folded away. The keys and the Look menu change it through these.
#pragma once

#include <string_view>

#include "state/params.h"
#include "ui/parts/layout.h"

namespace viewing {

/// Whether a column, "panel" or "matrices", is folded away, and to fold it or bring it back.
bool is_folded(const Params& params, std::string_view column);
void fold(Params& params, std::string_view column, bool folded);

/// What M makes of the view under the pointer: the camera's where there is none.
BigView big_view(ViewName hovered);

/// Puts what the state says into the arrangement.
void arrange(Arrangement& arrangement, const Params& params);

/// What the views' window takes.
Rect views_area(const Layout& layout, const Arrangement& arrangement);

/// What the lower views take of it and of what is below the panel, where they have the whole width.
Rect wide_lower_area(const Layout& layout);

}  // namespace viewing
