// Shared parts of the views from outside: the observer's, the moving world, clip space, the path of a point.
#pragma once

#include "ui/views/views.h"

namespace viewing {

/// Turns, moves and zooms the observer with the mouse. The last item must be the view's picture.
void observer_mouse(ViewState& state, Session& session);

/// Draws the x, y and z axes at the world's origin, one unit long.
void world_axes(Overlay& overlay);

/// Draws the point on its view ray, with a label.
void draw_point_on_ray(Overlay& overlay, const Params& params, const Derived& derived, const char* label);

/// Drags the followed point, or turns and zooms the observer. Returns whether the pointer is over the point. The last
/// item must be the view's picture.
bool point_or_observer_mouse(ViewState& state, Session& session, const Derived& derived, const Overlay& overlay);

/// Marks the face of the frustum that clips the followed point away, unless a lesson covers V or P.
void mark_cutting_face(Overlay& overlay, const Params& params, const Derived& derived);

/// Draws a slider for a field in a row, between the translated names of the slider's two ends.
void slider_between(Params& params, const char* path, const Rect& row, const char* from, const char* to);

/// Returns the row at a view's lower edge for a field's slider, and draws the row's background over the picture. The
/// row has height 0 on a stage that does not offer this slider.
Rect slider_row(const Rect& rect, const char* path);

}  // namespace viewing
