// The lower view The path of a point: the followed point goes from the world through eye space, clip space and NDC to
// the window, beside the matrix that carries it.
#pragma once

#include "frame/derive.h"
#include "session/session.h"
#include "ui/views/views.h"

namespace viewing {

/// The parts of the view; they do not depend on the size of type, since pictures are drawn before it is known.
struct WayPlaces {
    Rect picture, numbers;
};
WayPlaces way_places(const Rect& rect);

/// Returns the part of a picture that fills `rect` where the view's text leaves it free, in the picture's NDC.
Edges free_of_numbers(const Rect& rect);

/// Advances view.way by `dt_s`: it rests at each space for a moment, and then moves to the next; `moves` false: it
/// only jumps. At the window, playing ends.
void play_way(double& way, widgets::StepPlayer& player, double dt_s, bool moves);

void draw_way_view(ViewState& state, Session& session, const Derived& derived, const Rect& rect, ImTextureID picture);

}  // namespace viewing
