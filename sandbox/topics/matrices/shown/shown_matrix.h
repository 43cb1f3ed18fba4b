// A matrix with its header, note, buttons, and entries. The parts that a lesson covers are neither shown nor copied.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "frame/derive.h"
#include "ui/parts/links.h"

namespace viewing {

/// Says how well an identity holds numerically: "S² = (Π·L)S ± 0", "… ± 10⁻¹⁴", or "S² ≠ (Π·L)S".
std::string identity_text(const char* identity, double residual);

/// Returns the left edge of a small button at the right end of a row.
float place_at_right(const char* button);

/// Draws "Shadow S   rank 3 · S² = (Π·L) S" up to `right`. Returns false if the note does not fit and has to go below.
bool matrix_heading(const char* title, const char* letter, const std::string& note, widgets::Role role, float right);

/// A matrix with the contents of its heading, tooltip and entries.
struct ShownMatrix {
    const char* title;
    const char* letter;
    const char* name;  ///< its name in C++, GLSL and JSON
    const char* explains;
    widgets::Role role;
    glm::dmat4 now, before;
    MatrixCells cells;
    std::span<const widgets::LetterRole> roles;
    glm::dmat4 derived{1.0};    ///< the computed value, which applies unless one is entered by hand
    std::string heading = "";   ///< replaces the letter unless it is empty
    std::string property = "";  ///< for an S or R entered by hand: says how far it moves points on the plane
    std::span<const char* const> facts = {};  ///< the lessons' names for the facts in the note
};

/// Draws a matrix with buttons to the left of Copy. Returns the pressed button, or null. `fact`: the text of the note;
/// `pastes` receives the matrix's letter if the user wants to replace the matrix by pasting.
const char* show_matrix(ShownMatrix shown, const std::string& fact, std::span<const char* const> buttons, char& pastes,
                        std::optional<glm::dmat4>* by_hand = nullptr);

/// Draws V, P, S or R with a button that starts or ends editing by hand and, if given, another button; returns whether
/// the latter was pressed.
bool show_overridable(const ShownMatrix& shown, const std::string& fact, std::optional<glm::dmat4>& by_hand,
                      char& pastes, const char* other_button = nullptr);

}  // namespace viewing
