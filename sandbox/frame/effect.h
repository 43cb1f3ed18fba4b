// Finds the fields that have no effect in a state, and the reason, so that a control that does nothing can say why.
// Pure.
#pragma once

#include <string_view>

#include "state/params.h"
#include "state/scene.h"

namespace viewing {

/// Returns the reason why changing the field at `path` alone, to any value, changes neither the picture nor any number:
/// one sentence, to be translated. Empty if the field may have an effect. A field of the group "light" or "plane"
/// stands for that field of every element in the list. A null `scene` means a scene that has everything.
std::string_view why_without_effect(const Params& params, const Scene* scene, std::string_view path);

}  // namespace viewing
