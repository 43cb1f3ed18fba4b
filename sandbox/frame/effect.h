// Which fields change nothing in a state, and why: so that a control that does nothing can say so. Pure.
#pragma once

#include <string_view>

#include "state/params.h"
#include "state/scene.h"

namespace viewing {

/// Why changing the field at `path` alone, to whatever it may be, changes neither what is drawn nor any number, in one
/// sentence to be looked up; empty where it may have an effect, and for every field that always has. A field of the
/// groups "light" and "plane" stands for all elements of its list. `scene` null: a scene that has everything.
std::string_view why_without_effect(const Params& params, const Scene* scene, std::string_view path);

}  // namespace viewing
