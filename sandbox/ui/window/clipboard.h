// The clipboard commands: states, links and answers.
#pragma once

#include <string>

#include "session/guide.h"

namespace viewing {

class MatrixDialog;

/// Copies the whole state to the clipboard.
void copy(Session& session);

/// Copies a link to the state (state/file/link.h). While the question of a built-in lesson's step is open and the state
/// is still the step's, copies a link to the step instead. `address`: the part of the link before its #.
void copy_link(const Guide& guide, Session& session, const std::string& address);

/// Returns the link for a QR code. It leads to the current step of a built-in lesson, even once its question has been
/// answered; without such a step, or if the state differs from the step's, to the state. The error says in one sentence
/// why there is no link: the page has no address on the web, or the state would reveal covered parts.
Result<std::string> link_for_code(const Guide& guide, Session& session, const std::string& address);

/// Pastes from the clipboard: an answer to the current question, a matrix, a state, a link to a state, or a link to a
/// lesson, which it opens. Reports an error if the clipboard holds none of these.
void paste(Guide& guide, MatrixDialog& dialog, Session& session);

/// Pastes numbers as the answer to a question about a matrix or vector.
void paste_answer(Guide& guide);

}  // namespace viewing
