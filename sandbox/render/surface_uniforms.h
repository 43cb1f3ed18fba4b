// What shaders/surface.* are told of a frame, a pass and an object. The program must be in use. Read renderer.cpp next.
#pragma once

#include "frame/plan.h"
#include "gl/target.h"
#include "render/programs.h"

namespace viewing {

/// What stays the same for all passes of a frame.
struct FrameState {
    const FramePlan& plan;
    const Scene& scene;
    const gl::Target& target;
    bool writes_depth;                ///< fragments bring their own: few bits, or a logarithm
    std::optional<Shading> identify;  ///< numbers in place of colours, for reading back

    Shading shading_of(const Pass& pass) const { return identify.value_or(pass.shading); }
};

/// What relative positions are relative to, world space: the eye, of an orthographic camera its place. Any point near
/// what is seen would do; the origin for a view without an inverse.
glm::dvec3 relative_origin(const Pass& pass);

/// Light, colours and depth: what all objects of a pass share.
void set_uniforms(const SurfaceProgram& program, const FrameState& frame, const Pass& pass);

/// The matrices and clip planes of one object.
void set_placement(const SurfaceProgram& program, const FrameState& frame, const Pass& pass,
                   const glm::dmat4& world_from_model);

/// Normals that point towards the eye already, of surface points that a method found: a mirror's cofactors would turn
/// them around.
void set_turned_normals(const SurfaceProgram& program, const Pass& pass);

/// The polygon offset, by GL or by the fragments themselves.
void set_offset(const SurfaceProgram& program, const FrameState& frame, const DepthOffset& offset);

/// The number of what is drawn, below 2^16, in the bytes of red and green.
void set_identity(const SurfaceProgram& program, int identity);

/// The gap of one object, by its index in the scene: for Shading::heat.
void set_heat_gap(const SurfaceProgram& program, const FramePlan& plan, std::size_t object);

}  // namespace viewing
