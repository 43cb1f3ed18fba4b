// Finds every surface on a pixel's ray, in drawing order, each with its stored depth and the test that decides its
// fate. Everything is computed, not read back. Read fragments.cpp next.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "frame/box_tree.h"
#include "frame/plan/plan.h"

namespace viewing {

/// The object index of a pass that fills the picture.
inline constexpr int no_object = std::numeric_limits<int>::min();

/// The purpose of a pass.
enum class PassRole { objects, patch, shadow, mask, backdrop };
PassRole role_of(const Pass& pass);
/// Returns whether a pass draws surfaces, not shadows, masks or squares over the picture.
bool is_surface(const Pass& pass);

struct Fragment {
    std::string object;     ///< "plane" for the patch
    std::size_t pass = 0;   ///< index in FramePlan::passes
    int object_index = -1;  ///< in the scene; −1 − i: the patch of plane i; no_object: a square over the picture
    int triangle = 0;       ///< index in the object's mesh, or in a sorting method's order
    double eye_z = 0.0;     ///< negative in front of the camera
    double window_depth = 0.0;  ///< 0 … 1, with a decal's offset, before rounding to a code
    double depth_error = 0.0;   ///< how far GL's window depth may differ: depth_error()
    std::uint32_t stored = 0;   ///< the integer code, or the bits of the float
    double within = 1.0;        ///< how far GL's code may differ: stored_within()
    bool front_facing = true;
    bool is_sent = true;  ///< false: the method found another surface here, and GL never gets this one
    bool culled = false;  ///< rejected because of the way it faces
    bool passes = false;  ///< not culled, and depth and stencil tests pass
    bool drawn = false;   ///< writes its color; the last fragment that does is visible
    bool tie = false;     ///< its code equals the code that it is compared with
    double step = 0.0;    ///< depth_step() at its distance

    DepthState depth;                  ///< the depth state of its pass: the rules of its test
    std::uint32_t compared_with = 0;   ///< the code in the buffer when this fragment is tested
    bool stencil_fails = false;        ///< its pass's stencil test rejects it
    bool decided_by_rounding = false;  ///< GL's decision contradicts these codes: see reconcile()

    glm::dvec3 weights{0.0};      ///< of the triangle's corners, sum 1
    glm::dvec3 point_scene{0.0};  ///< in world space, before the pass's S or R
    bool cut_off = false;         ///< a clip plane of the pass rejects it: only everything_at() lists it
    int stencil_before = 0, stencil_after = 0;
    std::uint32_t depth_after = 0;  ///< the code in the buffer after this fragment
};

/// Keeps a scene's triangles in box trees for fast repeated queries; make one finder per scene.
class FragmentFinder {
public:
    /// Shares the scene's meshes.
    explicit FragmentFinder(const Scene& scene);

    /// Returns everything that covers the pixel's center between near and far. `plan` must belong to this scene; pixel
    /// (0, 0) is top left. The buffers start cleared or, without clearing, as one previous frame left them.
    ///
    /// If the frame stops at a draw call, the result leaves out everything after that call.
    ///
    /// Mirror images and shadows are left out; the depth that a mirror image without stencil writes outside the patch
    /// does not count here. Depths are exact until they are stored, so if two codes are closer than their errors, GL
    /// may decide differently (see reconcile()). Methods that sort draw their own pieces in their own order. If a
    /// method finds one surface per pixel in software, only that surface passes, as at the method's last step.
    std::vector<Fragment> at(const FramePlan& plan, glm::ivec2 pixel, glm::ivec2 size_px) const;

    /// Returns the fragments of all passes, including mirror images, shadows, masks and squares over the picture, and
    /// also the fragments that a clip plane rejects. The stencil and the depth are those of the whole frame.
    /// `as_rounded` lists fragments, by index in the result, whose depth comparison has the opposite outcome, because
    /// GL's rounding decides it.
    std::vector<Fragment> everything_at(const FramePlan& plan, glm::ivec2 pixel, glm::ivec2 size_px,
                                        std::span<const std::size_t> as_rounded = {}) const;

    const Scene& scene() const { return scene_; }
    /// The box tree over an object's triangles.
    const BoxTree& triangles_of(std::size_t object) const { return *trees_[object]; }

private:
    enum class Scope { surfaces, everything };
    std::vector<Fragment> replayed(const FramePlan& plan, glm::ivec2 pixel, glm::ivec2 size_px, Scope scope,
                                   std::span<const std::size_t> as_rounded) const;
    std::string name_of(int object) const;

    Scene scene_;
    std::vector<std::shared_ptr<const BoxTree>> trees_;  ///< one per object
};

}  // namespace viewing
