// Helpers for the fixed areas of the window, and the clipboard commands.
#pragma once

#include "session/guide.h"
#include "session/session.h"
#include "ui/parts/layout.h"

namespace viewing {

/// Begins an undecorated window that fills a rectangle.
bool begin_area(const char* name, const Rect& rect, ImGuiWindowFlags extra = 0);

/// Copies the whole state to the clipboard.
void copy(Session& session);

/// Copies a link to the state (state/file/link.h) or, if the state is still that of the current lesson step, a link to
/// that step.
void copy_link(const Guide& guide, Session& session);

/// Pastes from the clipboard: a state, a link to a state, or a link to a lesson, which it opens. Reports an error if
/// the clipboard holds none of these.
void paste(Guide& guide, Session& session);

}  // namespace viewing
