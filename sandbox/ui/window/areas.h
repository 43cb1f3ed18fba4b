// Helpers for the fixed areas of the window, and the clipboard commands.
#pragma once

#include <string>

#include "session/guide.h"
#include "session/session.h"
#include "ui/parts/layout.h"

namespace viewing {

/// Begins an undecorated window that fills a rectangle.
bool begin_area(const char* name, const Rect& rect, ImGuiWindowFlags extra = 0);

/// Copies the whole state to the clipboard.
void copy(Session& session);

/// Copies a link to the state (state/file/link.h). While the question of a built-in lesson's step is open and the state
/// is still the step's, copies a link to the step instead. `address`: the part of the link before its #.
void copy_link(const Guide& guide, Session& session, const std::string& address);

/// Returns the link for a QR code. It leads to the current step of a built-in lesson, even once its question has been
/// answered; without such a step, or if the state differs from the step's, to the state. The error says in one sentence
/// why there is no link: the page has no address on the web, or the state would reveal covered parts.
Result<std::string> link_for_code(const Guide& guide, Session& session, const std::string& address);

/// Pastes from the clipboard: a state, a link to a state, or a link to a lesson, which it opens. Reports an error if
/// the clipboard holds none of these.
void paste(Guide& guide, Session& session);

}  // namespace viewing
