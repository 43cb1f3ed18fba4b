// The fixed areas of the window and what their owners share.
#pragma once

#include "session/guide.h"
#include "session/session.h"
#include "ui/parts/layout.h"

namespace viewing {

/// A window without chrome that fills a rectangle.
bool begin_area(const char* name, const Rect& rect, ImGuiWindowFlags extra = 0);

/// Puts the whole state into the clipboard.
void copy(Session& session);

/// Puts a link to it there (state/file/link.h), or to the lesson's step where that is what is seen.
void copy_link(const Guide& guide, Session& session);

/// Takes the state that the clipboard holds, or that of a link, or is led through the lesson that one names; says why
/// when it holds none.
void paste(Guide& guide, Session& session);

}  // namespace viewing
