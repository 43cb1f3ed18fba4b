// The code shared by the parts of plan(): the world to draw, either the real one or its image in a mirror. Read
// plan.cpp first; plan_mirror.cpp and plan_shadow.cpp after it.
#pragma once

#include "frame/plan/plan.h"

namespace viewing {

/// Direction of the strongest ambient light.
inline constexpr glm::dvec3 sky_scene{0.0, 1.0, 0.0};

/// The two names of a pass over a patch: for a single plane, and for several planes.
struct PatchName {
    const char *alone, *numbered;  ///< "Patch", "Patch {plane}"
};

/// Level 0 is the real world; a mirror in it opens level 1, a mirror seen in that mirror level 2, and so on. "Scene" is
/// the space before the mirrors, "world" the space after them, where the image appears to be.
struct Level {
    const Params& params;
    const Derived& derived;
    glm::dmat4 projection;      ///< P, or the mirrored camera's projection
    glm::dmat4 clip_from_view;  ///< the projection, with the mirror as its near plane if requested
    glm::dmat4 view_from_world;
    glm::dmat4 world_from_scene{1.0};     ///< the product of the mirrors' R; I if the camera is mirrored
    glm::dmat4 scene_from_world{1.0};     ///< the product of the true mirror matrices, even if R was replaced
    std::string matrices = "P V";         ///< "P V R" inside a mirror, "F P F V R" if the camera is mirrored
    std::string mirror_symbols{};         ///< " R₂ R₁": the mirrors on the way, in order
    glm::dvec4 eye_world{}, eye_scene{};  ///< w = 0: parallel view rays, from this direction
    std::vector<glm::dvec4> lights_world;
    glm::dvec3 sky_world = sky_scene;
    bool flips_winding = false;
    int deepest = 0;                         ///< reflection_depth()
    int region = 0;                          ///< the stencil's low bits where the level is drawn; 0 for level 0
    std::vector<std::size_t> mirrors_met{};  ///< the mirrors on the way, in order
    std::optional<ClipPlane> clip{};         ///< in scene space: keeps everything in front of the last mirror
    bool is_fresh = true;                    ///< nothing has been drawn here yet

    const DerivedPlane& plane(std::size_t index) const { return derived.planes[index]; }
    double eye_side(std::size_t index) const { return glm::dot(plane(index).unit_plane, eye_scene); }
    glm::dvec4 plane_towards_eye(std::size_t index) const { return plane_facing(plane(index).unit_plane, eye_scene); }
    bool is_real() const { return mirrors_met.empty(); }
    int bounces() const { return static_cast<int>(mirrors_met.size()); }
    /// Return the uploaded matrix in the lecture's letters, numbered if there are several: "R₂"; "Rᵀ" if it is filled
    /// as in the lecture's code; "(−S₁₂)" for plane 1 and light 2, with the sign that makes w positive.
    std::string mirror_symbol(std::size_t plane_index) const;
    std::string shadow_symbol(std::size_t plane_index, std::size_t light) const;
    bool mirrors(std::size_t index) const;                             ///< whether the plane's mirror image is drawn
    std::vector<std::size_t> casting_lights(std::size_t index) const;  ///< the lights whose shadows the plane shows
    int region_of(std::size_t index) const;                            ///< the stencil's low bits in the plane's patch

    /// Returns "Objects in mirror 2" for "Objects".
    Message placed(const Message& name) const;
    Pass pass(const Message& name, const Message& reason, Subject subject) const;
    Pass patch_pass(const PatchName& name, const Message& reason, std::size_t index) const;
};

// The stencil of each pass: plan_stencil.cpp.

/// Passes only inside the level's mirror or, in the real world, anywhere.
StencilState stencil_of_level(const Level& level);

/// Marks a patch as a mirror or receiver.
StencilState stencil_of_mask(const Level& level, std::size_t plane);

/// Passes inside a patch that is already marked.
StencilState stencil_of_patch(const Level& level, std::size_t plane);

/// Used to draw the patch itself. Passes only inside the patch's mask if the patch blends over a masked mirror image;
/// otherwise, marks the patch, unless it is seen in a mirror and no shadow is drawn on it.
StencilState stencil_of_surface(const Level& level, std::size_t plane, bool blends);

/// Used to draw a shadow on the patch. A painted shadow passes once per pixel and only on the patch, unless a switch
/// says otherwise. For missing light, the shadow marks the pixels that the light does not reach.
StencilState stencil_of_shadow(const Level& level, std::size_t plane, std::size_t light);

/// Passes inside a patch where exactly these lights are marked as missing.
StencilState stencil_of_patch_without(const Level& level, std::size_t plane, std::span<const std::size_t> missing);

/// Undo the marks of missing lights and the patch's own mark, because in a mirror the next patch uses the same values.
StencilState stencil_of_forgetting_lights(const Level& level, std::size_t plane);
StencilState stencil_of_leaving(const Level& level, std::size_t plane);

/// Passes only outside the patch that `mask` has marked: objects behind a mirror must not show through it.
StencilState stencil_of_objects_beyond(const Pass& mask);

/// Used to draw the objects under decals, and then the decals on those objects' visible pixels. Each object's own mark
/// replaces the reference 0.
StencilState stencil_of_decal_bases();
StencilState stencil_of_decals();

/// Clears the marks of patches before objects are marked.
StencilState stencil_of_wiping();

/// Makes a pass draw a square that fills the picture, at the clip-space depth `clip_z` and the eye distance
/// `eye_distance`.
void fill_picture(Pass& pass, double clip_z, double eye_distance);

/// Returns the pass that draws the scene itself or its mirror image.
Pass objects_pass(const Level& level);

/// Returns a pass that marks a patch in the stencil, without color or depth.
Pass patch_mask(const Level& level, std::size_t plane, const PatchName& name, const Message& reason);

/// Returns the pass that draws the patch, lit by `lights`. With `blends`, the mirror image below shows through with the
/// weight `reflectance`.
Pass patch_surface(const Level& level, std::size_t plane, std::span<const std::size_t> lights, bool blends);

/// Adds the mask, a pass that resets the picture inside it, and the world that the mirror shows.
void add_mirror_image(std::vector<Pass>& passes, const Level& level, std::size_t plane);

/// Adds the lights' shadows, painted over the patch.
void add_shadows(std::vector<Pass>& passes, const Level& level, std::size_t plane);

/// Adds missing light: shadows mark the stencil first, then the patch is drawn once for each set of missing lights.
void add_missing_light(std::vector<Pass>& passes, const Level& level, std::size_t plane);

/// Adds the planes and objects of a level; defined in plan.cpp.
void add_world(std::vector<Pass>& passes, Level level);

}  // namespace viewing
