// The second picture of the camera view (view.beside): the state of the first, with some fields changed.
#pragma once

#include <string_view>

#include "state/params.h"

namespace viewing {

/// Returns whether view.beside.set may change a path: a whole field or camera.look_at. The scene, the appearance, the
/// layout and the second picture itself are common to both pictures.
bool may_differ_beside(std::string_view path);

/// Returns the parameters of the second picture: those of the first with the changes of view.beside, clamped to
/// their ranges (for instance, if view.beside.set raises near above far). Without a second picture, returns `params`.
Params beside_params(const Params& params);

/// Makes the second picture show `other`: the fields in which it differs become view.beside.set. Differences in fields
/// that both pictures must share are ignored. Returns whether any difference is left; if none is, changes nothing.
bool show_beside(Params& params, Params other);

}  // namespace viewing
