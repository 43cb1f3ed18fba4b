// The numbers of the followed point p, which are part of the matrix column: its shadow and its mirror image, or its
// path through V and P into the depth buffer.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "frame/derive.h"
#include "session/session.h"

namespace viewing {

/// The transformations of the point to show: the chosen plane's S and R, one of these, V alone, the camera's V and P,
/// or all of them.
enum class PointNumbers { plane, shadow, mirror, view, camera, both };

/// Whether a list of names, such as those of the shown matrices, has this one.
bool is_named(std::span<const std::string> names, std::string_view name);
/// Whether the part of the matrix column is a matrix, not the followed point or the lecture's display().
bool is_matrix(std::string_view name);

/// Returns the transformations to show beside these matrices: those of the camera's matrices if S and R are not listed,
/// otherwise those of the plane, without the shadow's or the mirror's if nothing draws it.
PointNumbers point_numbers(std::span<const std::string> listed, bool has_shadow = true, bool has_mirror = true);

/// Returns the number of lines, without the heading.
int lines_of(PointNumbers numbers);

/// Returns the height of what draw_followed_point() draws.
float followed_point_height(const Session& session, PointNumbers numbers = PointNumbers::plane);

/// Draws the numbers; without a point, one line that says how to choose one.
void draw_followed_point(Session& session, const Derived& derived, PointNumbers numbers = PointNumbers::plane);

}  // namespace viewing
