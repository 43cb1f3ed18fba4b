// The buffer values shown in the views below the camera view. They are read back when one of these views needs them and
// something has changed.
#pragma once

#include <memory>

#include "render/probe.h"
#include "topics/depth/numbers/depth_data.h"

namespace viewing {

/// The data that the views need from the current picture.
struct DepthWishes {
    std::optional<glm::ivec2> pixel{};  ///< inside the picture
    bool fragments = false;             ///< all surfaces along the pixel's ray
    bool calls = false;                 ///< the frame's draw calls, and those that touch the pixel
    glm::ivec2 cells{0};                ///< columns and rows of the block around the pixel; 0: no block
    bool counts = false;                ///< the histogram
    bool operator==(const DepthWishes&) const = default;
};

class DepthInspector {
public:
    /// Forgets the data, since the picture has changed.
    void forget() {
        fresh_ = {};
        told_.reset();
        rests_ = false;
    }

    /// Reads the data that are needed and not known yet. `frame` is the camera view's plan, without overdraw or
    /// difference. With `at_once`, waits for GL. Otherwise, if the picture has been read before and no block of cells
    /// is needed, the pixel may arrive a few calls later; until then, the data stay unchanged.
    Status update(Renderer& renderer, const FramePlan& frame, const Scene& scene, int scene_version,
                  const Derived& derived, glm::ivec2 size_px, const DepthWishes& wishes, bool at_once = true);

    const DepthData& data() const { return data_; }

    /// Returns the scene's fragment finder, made once for each version of the scene.
    const FragmentFinder& finder(const Scene& scene, int scene_version);

    /// Returns another pixel of the current picture, for the status bar.
    Result<PixelReport> at(Renderer& renderer, const FramePlan& frame, const Scene& scene, const Derived& derived,
                           glm::ivec2 size_px, glm::ivec2 pixel);

    /// Like at(), but does not wait; call it once a frame. Returns the latest pixel that is known for this picture, or
    /// nothing while the picture changes from frame to frame.
    Result<std::optional<PixelReport>> follow(Renderer& renderer, const FramePlan& frame, const Scene& scene,
                                              const Derived& derived, glm::ivec2 size_px, glm::ivec2 pixel);
    /// Whether another frame would bring a newer pixel.
    bool is_following() const { return is_following_; }

private:
    Status prepare(Renderer& renderer, const FramePlan& frame, const Scene& scene, const Derived& derived,
                   glm::ivec2 size_px, const DepthWishes& wishes);
    /// Requests the pixel of the prepared picture, or takes the one that has arrived. Returns whether the requested
    /// pixel has arrived.
    bool is_told(const Scene& scene, glm::ivec2 pixel);
    void find_touches(FramePlan frame, const Scene& scene, glm::ivec2 pixel, glm::ivec2 size_px);
    void read_cells(const FramePlan& frame, glm::ivec2 size_px, const DepthWishes& wishes);

    /// The data that have been read already.
    struct Fresh {
        bool now = false, before = false;
        std::optional<DepthCounts> counts;
        std::optional<DepthWishes> told;  ///< the request that the data answer
    };
    Fresh fresh_;
    DepthData data_;
    std::optional<PixelReport> told_;  ///< the latest pixel that has arrived
    bool rests_ = false;               ///< the picture is the same as in the previous frame
    bool is_following_ = false;
    PixelProbe now_, before_;  ///< at the current step, and one step earlier
    std::unique_ptr<FragmentFinder> finder_;
    int finder_version_ = -1;
};

}  // namespace viewing
