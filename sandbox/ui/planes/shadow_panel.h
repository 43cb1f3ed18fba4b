// The panel's sections on lights, planes, shadows and mirror images.
#pragma once

#include "frame/derive.h"
#include "session/session.h"

namespace viewing {

void draw_light_section(Session& session, const Derived& derived);
void draw_plane_section(Session& session, const Derived& derived);
void draw_shadow_and_reflection_section(Session& session, const Derived& derived);

}  // namespace viewing
