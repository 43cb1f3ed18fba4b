// What is at a pixel: read back from the buffers, not computed again. Draws the frame once and then answers for
// every pixel of it, so that the status bar can follow the pointer.
#pragma once

#include "render/renderer.h"

namespace viewing {

/// What `inspect` and the status bar say about one pixel.
struct PixelReport {
    glm::ivec2 pixel{0};  ///< (0, 0) is the top left one
    Color color;
    bool written = false;  ///< some surface was drawn here
    std::string object;    ///< "" for the background, "plane" for the patch
    bool front_facing = true;
    bool has_depth = false;     ///< depth was written here too; else eye_z, step and world say nothing
    double window_depth = 1.0;  ///< as read back
    std::uint32_t stored = 0;   ///< the integer code, or the bits of the float
    DepthPrecision precision;
    double ndc_z = 0.0;
    double eye_z = 0.0;  ///< negative in front of the camera; like step and world 0 where no depth was written
    double step = 0.0;   ///< width in eye z that can be told apart there: resolvable_depth_step()
    int stencil = 0;
    glm::dvec3 world{0.0};
};

class PixelProbe {
public:
    /// Draws the frame without samples, once with its colours and once with identities.
    Status prepare(Renderer& renderer, FramePlan plan, const Scene& scene, const Derived& derived, glm::ivec2 size_px);

    /// The pixel must lie inside the prepared size; `scene` is the one that was prepared.
    PixelReport at(glm::ivec2 pixel, const Scene& scene) const;

private:
    FramePlan plan_;
    glm::dmat4 world_from_view_{1.0};
    double aspect_ = 1.0;
    View colors_, identities_;
};

}  // namespace viewing
