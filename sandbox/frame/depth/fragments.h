// Every surface that lies on a pixel's ray, in drawing order, each with its depth as the buffer stores it and the test
// that decides about it. Computed, not read back. Read fragments.cpp next.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "frame/box_tree.h"
#include "frame/plan.h"

namespace viewing {

struct Fragment {
    std::string object;         ///< "plane" for the patch
    std::size_t pass = 0;       ///< index in FramePlan::passes
    int object_index = -1;      ///< in the scene; −1 − i: the patch of plane i
    int triangle = 0;           ///< index in the object's mesh, or in the order that a method found
    double eye_z = 0.0;         ///< negative in front of the camera
    double window_depth = 0.0;  ///< 0 … 1, a decal's offset included, not rounded to a code yet
    double depth_error = 0.0;   ///< how far GL's window depth may be from it: depth_error()
    std::uint32_t stored = 0;   ///< the integer code, or the bits of the float
    double within = 1.0;        ///< how far GL's code may be from it: stored_within()
    bool front_facing = true;
    bool is_sent = true;  ///< false: the method has found another surface here, and GL never gets this one
    bool culled = false;  ///< left out because of its facing
    bool passes = false;  ///< not culled, and depth and stencil let it through
    bool drawn = false;   ///< its colour is written at its turn: the last one of these is what is seen
    bool tie = false;     ///< its code is the one that it is compared with
    double step = 0.0;    ///< depth_step() at its place

    DepthState depth;                  ///< of its pass: how it is tested
    std::uint32_t compared_with = 0;   ///< the code that stands in the buffer at its turn
    bool stencil_fails = false;        ///< its pass's stencil test stops it
    bool decided_by_rounding = false;  ///< GL does what these codes do not say: reconcile()
};

/// Keeps a scene's triangles sorted, so that asking again is quick: made once per scene.
class FragmentFinder {
public:
    /// Shares the scene's meshes.
    explicit FragmentFinder(const Scene& scene);

    /// The plan is one of this scene; pixel (0, 0) is the top left one. What covers the pixel's centre between near and
    /// far; the buffers are as they are cleared or, without clearing, as one frame before has left them.
    ///
    /// Of a frame that stops at a draw call what comes after it is left out.
    ///
    /// Mirror image and shadows are left out; a mirror image without stencil leaves depth beside the patch that is not
    /// counted here. Depths are exact until they are stored: where two codes are closer than what they are right
    /// within, GL may decide otherwise: see reconcile(). Methods that sort have their own order and pieces. Of a method
    /// that finds one surface for each pixel in software only that one passes, as at the method's last step.
    std::vector<Fragment> at(const FramePlan& plan, glm::ivec2 pixel, glm::ivec2 size_px) const;

private:
    std::string name_of(int object) const;

    Scene scene_;
    std::vector<std::shared_ptr<const BoxTree>> trees_;  ///< of each object's triangles
};

/// One pixel of a frame whose method draws the scene as it comes. A FragmentFinder is for asking often.
std::vector<Fragment> fragments_at(const Params& params, const Derived& derived, const Scene& scene, glm::ivec2 pixel,
                                   glm::ivec2 size_px);

}  // namespace viewing
