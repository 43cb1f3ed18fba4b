// The fixed areas of the window and what their owners share.
#pragma once

#include "session/session.h"
#include "ui/parts/layout.h"

namespace viewing {

/// A window without chrome that fills a rectangle.
bool begin_area(const char* name, const Rect& rect, ImGuiWindowFlags extra = 0);

/// Puts the whole state into the clipboard.
void copy(Session& session);

/// Puts a link to it there (state/link.h).
void copy_link(Session& session);

/// Takes the state that the clipboard holds, or that of a link; says why when it holds none.
void paste(Session& session);

}  // namespace viewing
