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

/// Whether `names`, for example those of the shown matrices, contains `name`.
bool is_named(std::span<const std::string> names, std::string_view name);
/// Whether this part of the matrix column is a matrix. The other parts are the followed point and the lecture's code.
bool is_matrix(std::string_view name);

/// Returns the transformations to show beside these matrices: the camera's if V or P is listed, but neither S nor R;
/// otherwise the plane's. If only shadows or only mirrors are drawn, omits the plane's other transformation.
PointNumbers point_numbers(std::span<const std::string> listed, bool has_shadow, bool has_mirror);

/// Returns the number of lines, without the heading.
int lines_of(PointNumbers numbers);

/// Returns the height of what draw_followed_point() draws.
float followed_point_height(const Session& session, PointNumbers numbers);

/// Draws the numbers; without a point, one line that says how to choose one.
void draw_followed_point(Session& session, const Derived& derived, PointNumbers numbers);

}  // namespace viewing
