// What the observer sees of light, planes, camera and mirror: what observer_view.cpp draws over its picture.
#pragma once

#include <vector>

#include "frame/derive.h"
#include "frame/planes/outline.h"
#include "session/session.h"
#include "ui/parts/overlay.h"

namespace viewing {

/// The rays of the chosen light past the outlines of the scene's first objects to their shadows on the chosen plane,
/// found anew only where scene, light or plane is another one.
class LightRays {
public:
    const std::vector<OutlineVertex>& of(const Session& session, const Derived& derived);

private:
    int scene_version_ = -1;
    glm::dvec4 plane_{0.0}, light_{0.0};
    std::vector<OutlineVertex> found_;
};

void draw_light_rays(Overlay& overlay, const std::vector<OutlineVertex>& rays, const glm::dvec4& light_world);

/// The edges of all planes' patches.
void draw_patches(Overlay& overlay, const Derived& derived);

/// The pyramid that a camera sees, with its eye; orthographic: a box.
void draw_frustum(Overlay& overlay, const Params& params, const Derived& derived, const glm::dmat4& world_from_view);

/// The same once more where V really puts the eye; nothing where that is where the camera stands.
void draw_effective_eye(Overlay& overlay, const Params& params, const Derived& derived);

/// eye′ = R eye, and the frustum through which it sees the same image in the mirror.
void draw_mirrored_eye(Overlay& overlay, const Params& params, const Derived& derived);

/// Names the space behind the mirror, where the image seems to be.
void label_image_space(Overlay& overlay, const Derived& derived);

}  // namespace viewing
