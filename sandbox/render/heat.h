// The heat map of depth fighting as uniforms of shaders/surface.frag. Read frame/depth/heat_map.h for its numbers.
#pragma once

#include "frame/plan.h"
#include "render/programs.h"

namespace viewing {

/// For a program with Shading::heat that is in use: what all objects of a frame share. A plan without a heat map has no
/// pairs either.
void set_heat(const SurfaceProgram& program, const FramePlan& plan, const Pass& pass);

/// The gap of one object, by its index in the scene.
void set_heat_gap(const SurfaceProgram& program, const FramePlan& plan, std::size_t object);

}  // namespace viewing
