// Why a field has no effect in a state. A field's declaration lists its reasons; frame/effect.cpp says when each holds.
#pragma once

namespace viewing {

enum class Idle {
    p_by_hand,
    v_by_hand,
    orthographic,
    not_orthographic,
    has_window,
    no_field_of_view,
    no_window,
    no_gl_depth_test,
    no_depth_buffer,
    no_depth_test,
    not_reversed,
    not_logarithmic,
    no_depth_clear,
    no_decals,
    no_decal_offset,
    no_pairs,
    gl_resolution,
    no_culling,
    no_facing,
    no_shadow,
    no_receiver,
    missing_light,
    no_shadow_offset,
    no_lift,
    no_reflection,
    no_mirror,
    no_ab,
    unit_normals,
    not_oblique,
    scene_mirrored,
    not_painter,
    not_bsp,
    no_splits,
    not_ray_cast,
    culling,
    no_difference,
    ray_cast,
    no_second_picture,
    same_depth,
    same_settings,
    halves,
    no_orbiting_light,
    not_walking,
    flying,
    not_orbiting
};

}  // namespace viewing
