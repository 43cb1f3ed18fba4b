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

/// Copies a link to the state (state/file/link.h) or, if the state is still that of the current lesson step, a link to
/// that step. `address`: the part of the link before its #.
void copy_link(const Guide& guide, Session& session, const std::string& address);

/// Returns the link for a QR code: to the current step of a lesson, even once its question has been answered, or, if
/// the state has changed, to the state. If there is no link, the error says in one sentence why: no address on the web,
/// or covered parts.
Result<std::string> link_for_code(const Guide& guide, Session& session, const std::string& address);

/// Pastes from the clipboard: a state, a link to a state, or a link to a lesson, which it opens. Reports an error if
/// the clipboard holds none of these.
void paste(Guide& guide, Session& session);

}  // namespace viewing
