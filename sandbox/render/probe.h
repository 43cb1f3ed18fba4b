// What is at a pixel: read back from the buffers, not computed again. Draws the frame once and then answers for
// every pixel of it, so that the status bar can follow the pointer.
#pragma once

#include <optional>

#include "render/buffer_read.h"

namespace viewing {

class PixelProbe {
public:
    /// Draws the frame without samples, once with its colours and once with identities; always with one renderer.
    Status prepare(Renderer& renderer, FramePlan plan, const Scene& scene, const Derived& derived, glm::ivec2 size_px);

    /// The pixel must lie inside the prepared size; `scene` is the one that was prepared.
    PixelReport at(glm::ivec2 pixel, const Scene& scene) const;

    /// The same without waiting: what was asked for last, once, when it has come.
    void ask(glm::ivec2 pixel);
    bool is_asked() const { return asked_.has_value(); }
    std::optional<PixelReport> take(const Scene& scene);

    /// What lies inside the prepared size; where nothing does the block is empty.
    CellBlock block(glm::ivec2 first_pixel, glm::ivec2 size) const;

    /// Of the whole frame, on its plan's depth scale.
    DepthCounts count_depths() const;

private:
    PixelReport report(glm::ivec2 pixel, const ReadPixel& read, const Scene& scene) const;

    FramePlan plan_;
    glm::dmat4 world_from_view_{1.0};
    double aspect_ = 1.0;
    View colors_, identities_;
    mutable std::optional<BufferReader> reader_;  ///< once prepared
    std::optional<glm::ivec2> asked_;
};

}  // namespace viewing
