// Sets the uniforms of shaders/surface.* for a frame, a pass and an object. The program must be current. Read
// renderer.cpp next.
#pragma once

#include "frame/plan/plan.h"
#include "gl/target.h"
#include "render/programs.h"

namespace viewing {

/// The state that all passes of a frame share.
struct FrameState {
    const FramePlan& plan;
    const Scene& scene;
    const gl::Target& target;
    bool writes_depth;                ///< fragments write their own depth, which has few bits or is logarithmic
    std::optional<Shading> identify;  ///< draws numbers instead of colors, for reading back

    Shading shading_of(const Pass& pass) const { return identify.value_or(pass.shading); }

    /// Whether the shader computes the depth of the plane on which a shadow lies, for shadows that are clipped around
    /// their patch: near w = 0, float32 is too coarse for the positions of S p.
    bool takes_depth_of_plane(const Pass& pass) const {
        constexpr std::size_t planes_of_other_passes = 2;
        return pass.shading == Shading::flat && pass.clip_planes.size() > planes_of_other_passes &&
               plan.depth_mapping != DepthMapping::logarithmic;
    }
    bool shader_writes_depth(const Pass& pass) const {
        return writes_depth || pass.subject == Subject::pixels || takes_depth_of_plane(pass);
    }
};

/// Returns the origin of relative positions, in world space: the eye, or the position of an orthographic camera. Any
/// point near the visible objects would do; the result is the world's origin if the view has no inverse.
glm::dvec3 relative_origin(const Pass& pass);

/// Sets the light, colors and depth uniforms, which all objects of a pass share.
void set_uniforms(const SurfaceProgram& program, const FrameState& frame, const Pass& pass);

/// Sets the matrices and clip planes of one object.
void set_placement(const SurfaceProgram& program, const FrameState& frame, const Pass& pass,
                   const glm::dmat4& world_from_model);

/// Sets the normal matrix for surface points that a hidden-surface method found. Their normals already point toward the
/// eye, but the cofactors of a mirror's matrix would flip them.
void set_turned_normals(const SurfaceProgram& program, const Pass& pass);

/// Sets the polygon offset, which either GL or the fragment shader applies.
void set_offset(const SurfaceProgram& program, const FrameState& frame, const Pass& pass, const DepthOffset& offset);

/// Sets the identity of the next object drawn, as the red and green bytes. It must be below 2^16.
void set_identity(const SurfaceProgram& program, int identity);

/// Sets the gap of one object, given by its index in the scene, for Shading::heat.
void set_heat_gap(const SurfaceProgram& program, const FramePlan& plan, std::size_t object);

}  // namespace viewing
