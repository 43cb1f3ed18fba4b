// Equations as lines of a derivation: symbols in the colours of what they stand for, numbers with fixed decimals.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "widgets/widgets.h"

namespace viewing {

/// l, L and s are the light's, n, P, a, b, c and d the plane's, p, q, x, y and z the point's. What is primed (q′, x₀′)
/// is the mirror's.
std::span<const widgets::LetterRole> derivation_roles();

/// "5.200", "−0.125": what a derivation shows of a number.
std::string derivation_number(double value);

/// "(  1.400,  1.300, −0.650)": the columns of all lines stand below each other.
std::string derivation_vector(const glm::dvec3& value);

/// The parts of one equation behind each other: {"t", "= l_y/(l_y - p_y)", "= 5.200/3.900", "= 1.333"}, each of them a
/// widgets::Formula. A part for which the line has no more room stands on the next one, below the second part. The
/// number font where the line is wide, else the small one. Parts that are marked() are looked up; recorded in English.
/// `width_px` 0: what is there.
void equation(const std::vector<std::string>& parts, float width_px = 0.0F);

/// A line in semibold above the equations that follow; looks its text up.
void derivation_heading(const char* text);

}  // namespace viewing
