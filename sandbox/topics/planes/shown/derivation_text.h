// Equations as lines of a derivation: symbols in the colors of their roles, numbers with fixed decimals.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "widgets/widgets.h"

namespace viewing {

/// Roles of the letters. Light: l, L and s. Plane: n, Π, a, b, c and d. Point: p, q, x, y and z. Primed symbols (q′,
/// x₀′) belong to the mirror.
std::span<const widgets::LetterRole> derivation_roles();

/// Formats a number for a derivation: "5.200", "−0.125".
std::string derivation_number(double value);

/// Formats a vector: "(  1.400,  1.300, −0.650)". The columns of successive lines align.
std::string derivation_vector(const glm::dvec3& value);

/// Draws the parts of one equation in a row: {"t", "= l_y/(l_y - p_y)", "= 5.200/3.900", "= 1.333"}, each a
/// widgets::Formula. Parts that do not fit wrap to the next line, aligned with the second part. Uses the small number
/// font if `is_small` is set or the line is narrow, otherwise the number font. Translates marked() parts, but records
/// them in English. A `width_px` of 0 means the available width.
void equation(const std::vector<std::string>& parts, float width_px = 0.0F, bool is_small = false);

/// Returns the height in pixels of equation() in this width, without the space below it; infinity if a part is wider.
float equation_height(const std::vector<std::string>& parts, float width_px, bool is_small);

/// Draws a heading above the equations that follow, semibold unless it is small; translates its text.
void derivation_heading(const char* text, bool is_small = false);

/// Returns the height in pixels of derivation_heading() in this width, without the space below it.
float heading_height(const char* text, float width_px, bool is_small);

}  // namespace viewing
