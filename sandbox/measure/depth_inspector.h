// What the views below the camera's tell of its buffers, read back when one of them wants it and something changed.
#pragma once

#include <memory>

#include "frame/depth/depth_data.h"
#include "render/probe.h"

namespace viewing {

/// What is wanted of the picture that is shown.
struct DepthWishes {
    std::optional<glm::ivec2> pixel{};  ///< inside the picture
    bool fragments = false;             ///< all surfaces on its ray
    bool calls = false;                 ///< the frame's draw calls, and those that touch the pixel
    glm::ivec2 cells{0};                ///< columns and rows of the block around it; 0: none
    bool counts = false;                ///< the histogram
    bool operator==(const DepthWishes&) const = default;
};

class DepthInspector {
public:
    /// The picture has changed: everything is read again when it is wanted.
    void forget() {
        fresh_ = {};
        told_.reset();
        rests_ = false;
    }

    /// Reads what is wanted and not known yet. `frame`: of the camera's view, not of its overdraw or difference.
    /// `at_once`: waits for GL. Else another pixel of a picture that is read already may come some calls later, unless
    /// its block of cells is wanted; until then the data stay as they are.
    Status update(Renderer& renderer, const FramePlan& frame, const Scene& scene, int scene_version,
                  const Derived& derived, glm::ivec2 size_px, const DepthWishes& wishes, bool at_once = true);

    const DepthData& data() const { return data_; }

    /// One more pixel of the same picture, for the status bar.
    Result<PixelReport> at(Renderer& renderer, const FramePlan& frame, const Scene& scene, const Derived& derived,
                           glm::ivec2 size_px, glm::ivec2 pixel);

    /// The same without waiting, to be called once a frame: the newest of these pixels that is known of this picture.
    /// Where the picture changes from frame to frame there is none.
    Result<std::optional<PixelReport>> follow(Renderer& renderer, const FramePlan& frame, const Scene& scene,
                                              const Derived& derived, glm::ivec2 size_px, glm::ivec2 pixel);
    /// Whether a further frame would tell more.
    bool is_following() const { return is_following_; }

private:
    Status prepare(Renderer& renderer, const FramePlan& frame, const Scene& scene, const Derived& derived,
                   glm::ivec2 size_px, const DepthWishes& wishes);
    /// Asks for the pixel of the prepared picture, or takes the one that has come; whether that is this one.
    bool is_told(const Scene& scene, glm::ivec2 pixel);
    void find_touches(FramePlan frame, const Scene& scene, glm::ivec2 pixel, glm::ivec2 size_px);
    void read_cells(const FramePlan& frame, glm::ivec2 size_px, const DepthWishes& wishes);

    /// What the buffers hold already.
    struct Fresh {
        bool now = false, before = false;
        std::optional<DepthCounts> counts;
        std::optional<DepthWishes> told;  ///< that the data answer
    };
    Fresh fresh_;
    DepthData data_;
    std::optional<PixelReport> told_;  ///< by follow()
    bool rests_ = false;               ///< the picture is that of the frame before
    bool is_following_ = false;
    PixelProbe now_, before_;  ///< at the step that is shown, and one step earlier
    std::unique_ptr<FragmentFinder> finder_;
    int finder_version_ = -1;
};

}  // namespace viewing
