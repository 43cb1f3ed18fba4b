// The parts of the observer's overlay: light, planes, camera and mirror. observer_view.cpp draws them over its picture.
#pragma once

#include <vector>

#include "frame/derive.h"
#include "session/session.h"
#include "topics/planes/numbers/outline.h"
#include "ui/parts/overlay.h"

namespace viewing {

/// Rays from the chosen light past the outlines of the scene's first objects to their shadows on the chosen plane.
/// Cached until the scene, the light or the plane changes.
class LightRays {
public:
    const std::vector<OutlineVertex>& of(const Session& session, const Derived& derived);

private:
    int scene_version_ = -1;
    glm::dvec4 plane_{0.0}, light_{0.0};
    std::vector<OutlineVertex> found_;
};

void draw_light_rays(Overlay& overlay, const std::vector<OutlineVertex>& rays, const glm::dvec4& light_world);

/// Draws the outlines of all planes' patches.
void draw_patches(Overlay& overlay, const Derived& derived);

/// Draws a camera's view volume with its eye: a frustum, or a box if orthographic.
void draw_frustum(Overlay& overlay, const Params& params, const Derived& derived, const glm::dmat4& world_from_view);

/// If V does not match the camera's position and direction, draws the frustum a second time, where V puts it.
void draw_effective_eye(Overlay& overlay, const Params& params, const Derived& derived);

/// Draws eye′ = R eye and the mirrored frustum. Seen from eye′, the objects look as they do in the mirror.
void draw_mirrored_eye(Overlay& overlay, const Params& params, const Derived& derived);

/// Labels the space behind the mirror, where the image appears to be.
void label_image_space(Overlay& overlay, const Derived& derived);

}  // namespace viewing
