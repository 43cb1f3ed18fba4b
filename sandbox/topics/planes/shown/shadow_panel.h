// Panel sections for lights, planes, shadows and mirror images.
#pragma once

#include "frame/problems.h"
#include "session/session.h"

namespace viewing {

void draw_light_section(Session& session, const std::vector<Problem>& problems);
void draw_plane_section(Session& session, const Derived& derived, const std::vector<Problem>& problems);
void draw_shadow_and_reflection_section(Session& session, const std::vector<Problem>& problems);

}  // namespace viewing
