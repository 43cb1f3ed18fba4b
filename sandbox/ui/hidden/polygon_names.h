// What polygons are called in lists and sentences, and the colour of their objects. Read order_rows.h next.
#pragma once

#include <imgui.h>

#include <string>

#include "frame/hidden/scene_surface.h"

namespace viewing {

/// "polygon 12 of box": counted from 1 within the object. An exact curved shape is its object's name alone. A number
/// that the surface does not have gives an empty string; `surface` may be null.
std::string polygon_name(const SceneSurface* surface, int source);

/// The same with the object first, for columns: "box, polygon 12".
std::string listed_name(const SceneSurface* surface, int source);
/// The same where a column is narrow: "box 12".
std::string brief_name(const SceneSurface* surface, int source);

/// The object's colour, opaque; 0 where there is none.
ImU32 polygon_color(const SceneSurface* surface, int source);

}  // namespace viewing
