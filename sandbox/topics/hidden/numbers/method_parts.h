// What several hidden-surface methods do alike. See hidden_method.h for a method's entry, and painter_method.cpp for a
// simple method.
#pragma once

#include "topics/hidden/numbers/hidden_method.h"

namespace viewing {

/// Returns the winding of front faces, which a mirrored view reverses.
FrontFace winding_for(const HiddenRequest& request);

/// Returns whether polygons are drawn from front to back, so that covered pixels must stay as they are.
bool is_front_to_back(const VisibilityParams& visibility);

/// Gives the method the polygons that culling leaves.
void take_polygons(const HiddenData& data, HiddenResult& result, const WorkProgress* progress);

/// Finds the scene's own order, in which each step draws a polygon.
void find_scene_order(HiddenData& data, HiddenResult& result, WorkProgress* progress);

/// Paints the order's first polygons and records the followed pixel, but stops after `stop_after` tested pixels; −1: no
/// limit.
RasterResult painted(const HiddenResult& result, int polygons, PaintRule rule, WorkProgress* progress,
                     std::int64_t stop_after = -1);
void take_picture(HiddenResult& result, RasterResult raster);

/// Paints the polygons that the step has reached, and finds the steps that draw one over the followed pixel.
void paint_in_order(HiddenData& data, HiddenResult& result, WorkProgress* progress);

}  // namespace viewing
