// The sandbox's GL programs with their uniforms, compiled on first use. See uniforms.h for the tables of uniforms.
#pragma once

#include <compare>
#include <map>
#include <memory>
#include <string>

#include "frame/depth_colors.h"
#include "frame/ground.h"
#include "frame/plan/plan.h"
#include "gl/objects.h"
#include "render/uniforms.h"
#include "state/fields.h"

namespace viewing {

inline constexpr std::size_t patch_tone_count = 3;  ///< light square, dark square, line

/// The properties of a surface that select its program.
struct SurfaceKind {
    /// The source of colors and ids: the object, its vertices, or textures with surface points.
    enum class Source { object, vertices, picture };

    Shading shading = Shading::lit;
    bool is_patch = false;
    bool clips = false;
    bool write_depth = false;
    Source source = Source::object;
    bool mask_test = false;  ///< render/masks.h
    bool mask_write = false;
    bool logarithm_per_vertex = false;
    std::size_t lights = 0;  ///< for Shading::lit: number of lights, at least 1
    bool has_gloss = false;
    bool forces_sign = false;
    bool depth_of_plane = false;  ///< with write_depth: writes the depth of the plane on which a shadow lies
    auto operator<=>(const SurfaceKind&) const = default;
};

/// The program of shaders/surface.*. "Relative" coordinates have the world's axes and the origin from relative_origin()
/// in surface_uniforms.h. `WRITE_DEPTH` is for depths that the fixed pipeline cannot store by itself: those with few
/// bits, logarithmic ones, and those from a software method.
struct SurfaceProgram : ShaderProgram {
    Uniform<glm::mat4> clip_from_model{*this, "clip_from_model"};
    Uniform<glm::mat4> relative_from_model{*this, "relative_from_model"};
    Uniform<glm::mat3> world_from_normal{*this, "world_from_normal"};
    Uniform<glm::vec3> depth_in_plane{*this, "depth_in_plane"};
    Uniform<glm::vec4, most_clip_planes> clip_plane_model{*this, "clip_plane_model"};

    Uniform<glm::vec4, most_lights> lights_relative{*this, "lights_relative"};
    Uniform<float> light_strength{*this, "light_strength"};
    Uniform<glm::vec4> eye_relative{*this, "eye_relative"};
    Uniform<glm::vec3> sky_world{*this, "sky_world"};
    Uniform<glm::vec4> base_color{*this, "base_color"};
    Uniform<float> alpha{*this, "alpha"};
    Uniform<glm::vec3, patch_tone_count> patch_tones{*this, "patch_tones"};
    Uniform<float> patch_extent{*this, "patch_extent"};
    Uniform<glm::vec3> patch_normal{*this, "patch_normal"};
    Uniform<glm::vec3> front_color{*this, "front_color"};
    Uniform<glm::vec3> back_color{*this, "back_color"};

    Uniform<glm::vec4> view_z_of_model{*this, "view_z_of_model"};
    Uniform<glm::vec4> view_w_of_model{*this, "view_w_of_model"};
    Uniform<float> depth_levels{*this, "depth_levels"};
    Uniform<glm::vec2> logarithmic_range{*this, "logarithmic_range"};
    Uniform<glm::vec2> depth_offset{*this, "depth_offset"};
    Uniform<bool> reverses_depth{*this, "reverses_depth"};
    Uniform<glm::vec2> vertex_near_far{*this, "vertex_near_far"};

    Uniform<Sampler> surface_positions{*this, "surface_positions"};
    Uniform<Sampler> surface_normals{*this, "surface_normals"};
    Uniform<Sampler> surface_colors{*this, "surface_colors"};
    Uniform<Sampler> surface_counts{*this, "surface_counts"};
    Uniform<glm::vec2> picture_share{*this, "picture_share"};

    Uniform<Sampler> mask_texture{*this, "mask_texture"};
    Uniform<int> mask_func{*this, "mask_func"};
    Uniform<int> mask_reference{*this, "mask_reference"};
    Uniform<int> mask_read_bits{*this, "mask_read_bits"};
    Uniform<int> mask_write_bits{*this, "mask_write_bits"};
    Uniform<int> mask_op{*this, "mask_op"};

    Uniform<glm::vec4> caster_w{*this, "caster_w"};
    Uniform<glm::vec4> caster_side{*this, "caster_side"};
    Uniform<glm::vec3, caster_colors.size()> caster_tones{*this, "caster_tones"};

    Uniform<glm::mat4> heat_view_from_relative{*this, "heat_view_from_relative"};
    Uniform<glm::vec2> heat_near_far{*this, "heat_near_far"};
    Uniform<glm::vec4, HeatMap::entry_count / 4> heat_onsets{*this, "heat_onsets"};
    Uniform<glm::vec3, heat_colors.size()> heat_tones{*this, "heat_tones"};
    Uniform<glm::vec4> heat_gap{*this, "heat_gap"};
};

struct ShowDepthProgram : ShaderProgram {
    Uniform<Sampler> depth_texture{*this, "depth_texture"};
    Uniform<int> mapping{*this, "mapping"};
    Uniform<bool> linear_scale{*this, "linear_scale"};
    Uniform<bool> orthographic{*this, "orthographic"};
    Uniform<glm::vec2> near_far{*this, "near_far"};
    Uniform<float> shown_first{*this, "shown_first"};
    Uniform<float> shown_slope{*this, "shown_slope"};
    Uniform<bool> shows_bands{*this, "shows_bands"};
    Uniform<glm::vec3, depth_bands.size()> bands{*this, "bands"};
    Uniform<float> cleared{*this, "cleared"};
    Uniform<glm::vec3> unwritten_color{*this, "unwritten_color"};
};

struct ShowStencilProgram : ShaderProgram {
    Uniform<Sampler> value_texture{*this, "value_texture"};
    Uniform<glm::vec3, stencil_colors.size()> colors{*this, "colors"};
};

struct ShowOverdrawProgram : ShaderProgram {
    Uniform<Sampler> value_texture{*this, "value_texture"};
    Uniform<glm::vec3, overdraw_colors.size()> colors{*this, "colors"};
};

struct ShowPictureProgram : ShaderProgram {
    Uniform<Sampler> picture{*this, "picture"};
    Uniform<glm::vec2> picture_share{*this, "picture_share"};
};

struct ReadDepthProgram : ShaderProgram {
    Uniform<Sampler> depth_texture{*this, "depth_texture"};
};

struct ConstantProgram : ShaderProgram {
    Uniform<glm::vec4> value{*this, "value"};
};

/// shaders/fill_changed.frag: the second step described in render/masks.h.
struct FillProgram : ShaderProgram {
    Uniform<Sampler> previous_mask{*this, "previous_mask"};
    Uniform<Sampler> changed_mask{*this, "changed_mask"};
    Uniform<glm::vec4> value{*this, "value"};
};

class Programs {
public:
    explicit Programs(const gl::Capabilities& capabilities) : capabilities_(capabilities) {}

    Result<const SurfaceProgram*> surface(const SurfaceKind& kind);
    Result<const ShowDepthProgram*> show_depth() { return over_picture(show_depth_, "show_depth.frag"); }
    Result<const ShowStencilProgram*> show_stencil() { return over_picture(show_stencil_, "show_stencil.frag"); }
    Result<const ShowOverdrawProgram*> show_overdraw() { return over_picture(show_overdraw_, "show_overdraw.frag"); }
    Result<const ShowPictureProgram*> show_picture() { return over_picture(show_picture_, "show_picture.frag"); }
    Result<const ReadDepthProgram*> read_depth() { return over_picture(read_depth_, "read_depth.frag"); }
    Result<const ConstantProgram*> constant() { return over_picture(constant_, "constant.frag"); }
    Result<const FillProgram*> fill() { return over_picture(fill_, "fill_changed.frag"); }

private:
    /// Returns a program that draws over the whole target.
    template <typename Kept>
    Result<const Kept*> over_picture(std::unique_ptr<Kept>& kept, const char* fragment) {
        if (kept) return kept.get();
        Result<gl::Program> program = load("fullscreen.vert", fragment, "");
        if (!program) return Error{program.error()};
        kept = std::make_unique<Kept>();
        kept->take(*std::move(program));
        return kept.get();
    }
    static Result<gl::Program> load(const char* vertex, const char* fragment, const std::string& defines);
    /// Returns surface.vert as a stage, shared by all programs with the same defines.
    Result<const gl::Program*> vertex_stage(const std::string& defines);

    gl::Capabilities capabilities_;
    std::map<std::string, gl::Program> vertex_stages_;  ///< keyed by their defines
    std::map<SurfaceKind, SurfaceProgram> surfaces_;
    std::unique_ptr<ShowDepthProgram> show_depth_;
    std::unique_ptr<ShowStencilProgram> show_stencil_;
    std::unique_ptr<ShowOverdrawProgram> show_overdraw_;
    std::unique_ptr<ShowPictureProgram> show_picture_;
    std::unique_ptr<ReadDepthProgram> read_depth_;
    std::unique_ptr<ConstantProgram> constant_;
    std::unique_ptr<FillProgram> fill_;
};

}  // namespace viewing
