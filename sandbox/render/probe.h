// Reports the values at a pixel: they are read back from the buffers, not recomputed. Once the frame is drawn, any of
// its pixels can be reported, so that the status bar can follow the pointer.
#pragma once

#include <optional>

#include "render/buffer_read.h"

namespace viewing {

class PixelProbe {
public:
    /// Draws the frame without multisampling, once with its colors and once with identities. Always pass the same
    /// renderer.
    Status prepare(Renderer& renderer, FramePlan plan, const Scene& scene, const Derived& derived, glm::ivec2 size_px);

    /// Reports a pixel, which must be inside the prepared size; `scene` must be the prepared one.
    PixelReport at(glm::ivec2 pixel, const Scene& scene) const;

    /// Requests a report without waiting. take() returns the latest requested report a single time, once it is ready.
    void ask(glm::ivec2 pixel);
    bool is_asked() const { return asked_.has_value(); }
    std::optional<PixelReport> take(const Scene& scene);

    /// Returns the part of a block that is inside the prepared size; it may be empty.
    CellBlock block(glm::ivec2 first_pixel, glm::ivec2 size) const;

    /// Counts the depths of the whole frame on its plan's depth scale.
    DepthCounts count_depths() const;

private:
    PixelReport report(glm::ivec2 pixel, const ReadPixel& read, const Scene& scene) const;
    /// Returns the point in view space that P sends to `ndc` and whose stored depth is `window_depth`.
    glm::dvec3 unprojected(const glm::dvec2& ndc, double window_depth) const;
    void locate_without_lens(PixelReport& report, const glm::dvec2& ndc) const;

    FramePlan plan_;
    glm::dmat4 world_from_view_{1.0}, view_from_clip_{1.0};
    double aspect_ = 1.0;
    View colors_, identities_;
    mutable std::optional<BufferReader> reader_;  ///< set by prepare()
    std::optional<glm::ivec2> asked_;
};

}  // namespace viewing
