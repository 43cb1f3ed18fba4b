// A matrix with everything around it: headline with what holds for it, buttons, the entries. What a lesson covers of it
// is neither shown nor copied.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "frame/derive.h"
#include "ui/parts/links.h"

namespace viewing {

/// How well an identity holds, measured: "S² = (Π·L)S ± 0", "… ± 10⁻¹⁴", "S² ≠ (Π·L)S".
std::string identity_text(const char* identity, double residual);

/// Where a small button at the right end of a row begins.
float place_at_right(const char* button);

/// "Shadow S   rank 3 · S² = (Π·L) S" up to `right`. False where the note has no room there and has to stand below.
bool matrix_heading(const char* title, const char* letter, const std::string& note, widgets::Role role, float right);

/// A matrix with everything around it.
struct ShownMatrix {
    const char* title;
    const char* letter;
    const char* name;  ///< as in C++, GLSL and JSON
    const char* explains;
    widgets::Role role;
    glm::dmat4 now, before;
    MatrixCells cells;
    std::span<const widgets::LetterRole> roles;
    glm::dmat4 derived{1.0};                  ///< what it would be without an entry by hand
    std::string heading = "";                 ///< in place of the letter
    std::string property = "";                ///< what one by hand should have, and how far it is from that
    std::span<const char* const> facts = {};  ///< what the note tells, by its names for a lesson
};

/// Buttons beside Copy, from the right; returns which one was pressed. `fact` is the note.
const char* show_matrix(ShownMatrix shown, const std::string& fact, std::span<const char* const> buttons,
                        std::optional<glm::dmat4>* by_hand = nullptr);

/// S or R with a button to enter it by hand, or to go back.
void show_overridable(const ShownMatrix& shown, const std::string& fact, std::optional<glm::dmat4>& by_hand);

}  // namespace viewing
