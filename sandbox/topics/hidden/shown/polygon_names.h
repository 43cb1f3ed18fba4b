// The names of polygons in lists and sentences, and the color of their objects. Read order_rows.h next.
#pragma once

#include <imgui.h>

#include <string>

#include "topics/hidden/numbers/scene_surface.h"

namespace viewing {

/// Returns "polygon 12 of box", counted from 1 within the object. For an exact curved shape, returns only the object's
/// name. Returns "" if the surface has no such source; `surface` may be null.
std::string polygon_name(const SceneSurface* surface, int source);

/// Returns the same name with the object first, for columns: "box, polygon 12".
std::string listed_name(const SceneSurface* surface, int source);
/// Returns the same name for narrow columns: "box 12".
std::string brief_name(const SceneSurface* surface, int source);

/// Returns the color of the polygon's object, opaque; 0 if the surface has no such source.
ImU32 polygon_color(const SceneSurface* surface, int source);

}  // namespace viewing
