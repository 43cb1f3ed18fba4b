// The distance beyond which surfaces get the depth code of the cleared buffer, so that GL_LESS rejects them. Pure.
#pragma once

#include "frame/derive.h"
#include "state/scene.h"

namespace viewing {

/// Returns the eye distance beyond which depth has the code of the cleared buffer and GL_LESS rejects everything;
/// infinite if it rejects nothing for that reason.
double start_of_cleared_code(const Params& params);

/// Returns whether GL's depth buffer decides what is visible, and lets nearer surfaces win.
bool lets_nearer_win(const Params& params);

/// Returns whether the last fragment drawn wins, for objects or for what is drawn after them.
bool last_fragment_wins(const Params& params);

/// Returns whether the depths left by an identical previous frame hide this frame (see hides_next_frame()).
bool previous_frame_hides(const Params& params);

/// Returns whether GL_LESS, in a buffer cleared to the farthest depth, rejects everything in view, because depth has
/// the code of the cleared buffer everywhere.
bool has_only_cleared_code(const Params& params, const Derived& derived, const Scene& scene);

/// Returns whether part of a patch is in the picture, between near and far, and nearer than start_of_cleared_code().
bool may_show(const PlanePatch& patch, const Params& params, const Derived& derived);

/// Returns whether part of a patch is in the picture, between near and far, but beyond start_of_cleared_code().
bool loses_part(const PlanePatch& patch, const Params& params, const Derived& derived);

/// Returns whether anything may be in the picture: part of an object or of a patch, at any distance.
bool shows_anything(const glm::dmat4& clip_from_world, const Derived& derived, const Scene& scene);

}  // namespace viewing
