// The lower view "The path of a point": the followed point goes from the world through eye space, clip space, and NDC
// to the window. Beside the picture is the matrix that maps the point.
#pragma once

#include "frame/derive.h"
#include "session/session.h"
#include "ui/views/views.h"

namespace viewing {

/// The parts of the view. They do not depend on the type size, which is not yet known when pictures are drawn.
struct WayPlaces {
    Rect picture, numbers;
};
WayPlaces way_places(const Rect& rect);

/// Returns the part of a picture filling `rect` that the view's text leaves free, in the picture's NDC.
Edges free_of_numbers(const Rect& rect);

/// Advances view.way by `dt_s`. The point rests in each space for a moment, and then moves to the next one or, if
/// `moves` is false, jumps to it. Playback ends at the window.
void play_way(double& way, widgets::StepPlayer& player, double dt_s, bool moves);

}  // namespace viewing
