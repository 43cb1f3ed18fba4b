// The sandbox's GL programs with their uniforms, compiled when first needed.
#pragma once

#include <compare>
#include <map>

#include "frame/plan.h"
#include "gl/objects.h"

namespace viewing {

/// One way to draw a surface: each has a program of its own.
struct SurfaceKind {
    static constexpr int identity = 6;          ///< more than Shading has: identities for colours, to read back
    static constexpr int polygon_identity = 7;  ///< of polygons; only with Source::vertices

    /// Where colour and numbers come from: the object, its vertices, or a picture of surface points.
    enum class Source { object, vertices, picture };

    int shading = 0;  ///< a Shading, or one of the identities
    bool is_patch = false;
    bool clips = false;
    bool write_depth = false;
    Source source = Source::object;
    bool mask_test = false;  ///< render/masks.h
    bool mask_write = false;
    bool logarithm_per_vertex = false;
    int lights = 0;  ///< with Shading::lit: how many, from 1 on
    bool has_gloss = false;
    bool forces_sign = false;
    auto operator<=>(const SurfaceKind&) const = default;
};

/// shaders/surface.*: `WRITE_DEPTH` is for depths the fixed pipeline cannot store by itself (few bits, logarithmic).
struct SurfaceProgram {
    gl::Program program;
    GLint clip_from_model, world_from_model, world_from_normal, clip_plane_model;
    GLint lights_world, light_strength, eye_world, sky_world, base_color, alpha, patch_tones, patch_extent,
        facing_colors;
    GLint view_z_of_model, view_w_of_model, depth_levels, logarithmic_range, depth_offset, vertex_near_far;
    GLint surface_positions, surface_normals, surface_colors, surface_counts;
    GLint mask_texture, mask_func, mask_reference, mask_read_bits, mask_write_bits, mask_op;
    GLint caster_w, caster_side, caster_colors;
    GLint heat_view_from_world, heat_near_far, heat_onsets, heat_colors, heat_gap;
};

struct ShowDepthProgram {
    gl::Program program;
    GLint mapping, linear_scale, orthographic, near_far, shown_first, shown_slope, shows_bands, bands;
    GLint cleared, unwritten_color;
};

struct ShowStencilProgram {
    gl::Program program;
    GLint stencil_colors;
};

struct ShowOverdrawProgram {
    gl::Program program;
    GLint overdraw_colors;
};

struct ConstantProgram {
    gl::Program program;
    GLint value;
};

/// shaders/fill_changed.frag: the second stroke of render/masks.h.
struct FillProgram {
    gl::Program program;
    GLint previous_mask, changed_mask, value;
};

class Programs {
public:
    explicit Programs(const gl::Capabilities& capabilities) : capabilities_(capabilities) {}

    Result<const SurfaceProgram*> surface(const SurfaceKind& kind);
    Result<const ShowDepthProgram*> show_depth();
    Result<const ShowStencilProgram*> show_stencil();
    Result<const ShowOverdrawProgram*> show_overdraw();
    Result<const ConstantProgram*> constant();
    Result<const FillProgram*> fill();
    Result<const gl::Program*> show_picture();
    Result<const gl::Program*> read_depth();

private:
    gl::Capabilities capabilities_;
    std::map<SurfaceKind, SurfaceProgram> surfaces_;
    ShowDepthProgram show_depth_;
    ShowStencilProgram show_stencil_;
    ShowOverdrawProgram show_overdraw_;
    ConstantProgram constant_;
    FillProgram fill_;
    gl::Program show_picture_, read_depth_;
};

}  // namespace viewing
