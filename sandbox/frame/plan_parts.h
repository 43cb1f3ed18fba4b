// What the parts of plan() share: the world as it is drawn, be it the real one or what a mirror shows of it.
// Read plan.cpp first; plan_mirror.cpp and plan_shadow.cpp after it.
#pragma once

#include "frame/plan.h"
#include "text/catalogue.h"

namespace viewing {

/// Where ambient light is strongest.
inline constexpr glm::dvec3 sky_scene{0.0, 1.0, 0.0};

/// What a pass over a patch is called, looked up when it is: where there is one plane, and where there are several.
struct PatchName {
    const char *alone, *numbered;  ///< "Patch", "Patch {plane}"
};

/// Level 0 is the real world; a mirror in it opens level 1, a mirror seen in that mirror level 2, and so on. "Scene" is
/// space before the mirrors, "world" after them: where the image seems to be.
struct Level {
    const Params& params;
    const Derived& derived;
    glm::dmat4 projection;      ///< P, or what the mirrored camera has in its place
    glm::dmat4 clip_from_view;  ///< the projection, with the mirror for its near plane if that is asked for
    glm::dmat4 view_from_world;
    glm::dmat4 world_from_scene{1.0};  ///< the product of the mirrors' R; I if it is the camera that is mirrored
    glm::dmat4 scene_from_world{1.0};  ///< of the true mirrors, whatever has been put in the place of R
    std::string mirrors_name{};    ///< "2, 1": those it is seen in, the last one last; empty where there is one plane
    std::string matrices = "P V";  ///< "P V R" inside a mirror, "F P F V R" if it is the camera that is mirrored
    std::string mirror_symbols{};  ///< " R₂ R₁": those it is seen in, the last one last
    glm::dvec4 eye_world{}, eye_scene{};  ///< w = 0: parallel lines of sight, from this direction
    std::vector<glm::dvec4> lights_world;
    glm::dvec3 sky_world = sky_scene;
    bool flips_winding = false;
    int deepest = 0;  ///< reflection_depth()
    int mirrors_met = 0;
    int region = 0;                       ///< the stencil's low bits inside which it is drawn; 0 for level 0
    std::optional<std::size_t> mirror{};  ///< the last one met
    std::optional<ClipPlane> clip{};      ///< of the scene: what lies before the last mirror
    bool is_fresh = true;                 ///< nothing has been drawn here yet

    const DerivedPlane& plane(std::size_t index) const { return derived.planes[index]; }
    double eye_side(std::size_t index) const { return glm::dot(plane(index).unit_plane, eye_scene); }
    glm::dvec4 plane_towards_eye(std::size_t index) const { return plane_facing(plane(index).unit_plane, eye_scene); }
    bool is_real() const { return mirrors_met == 0; }
    /// What is uploaded for a plane, or a light and a plane, in the lecture's letters, numbered where there are
    /// several: "R₂", "Rᵀ" as its code fills it, "(−S₁₂)" of plane 1 and light 2 with the sign that makes w positive.
    std::string mirror_symbol(std::size_t plane_index) const;
    std::string shadow_symbol(std::size_t plane_index, std::size_t light) const;
    bool mirrors(std::size_t index) const;                             ///< an image is drawn for it
    std::vector<std::size_t> casting_lights(std::size_t index) const;  ///< whose shadows are drawn on it
    int region_of(std::size_t index) const;                            ///< the stencil's low bits inside its patch

    /// "Objects in mirror 2" for "Objects".
    std::string placed(std::string name) const;
    Pass pass(std::string name, std::string reason, Subject subject) const;
    Pass patch_pass(const PatchName& name, std::string reason, std::size_t index) const;
};

// The stencil of each pass: plan_stencil.cpp.

/// Inside its mirror; anywhere in the real world.
StencilState stencil_of_level(const Level& level);

/// Marks a patch as a mirror or receiver.
StencilState stencil_of_mask(const Level& level, std::size_t plane);

/// Inside a patch that is marked already.
StencilState stencil_of_patch(const Level& level, std::size_t plane);

/// Of the patch itself: inside its mask where it blends over a mirror image, else it is its own mask.
StencilState stencil_of_surface(const Level& level, std::size_t plane, bool blends);

/// Of a shadow on the patch. As paint: once a pixel and on the patch alone, unless a switch says otherwise. As missing
/// light: marks where the light is missing.
StencilState stencil_of_shadow(const Level& level, std::size_t plane, std::size_t light);

/// Inside a patch, where exactly these lights are marked as missing.
StencilState stencil_of_patch_without(const Level& level, std::size_t plane, std::span<const std::size_t> missing);

/// Takes the marks of missing lights, and the patch's own, back: in a mirror the next patch has the same values.
StencilState stencil_of_forgetting_lights(const Level& level, std::size_t plane);
StencilState stencil_of_leaving(const Level& level, std::size_t plane);

/// Off the patch that this pass has marked: what stands behind a mirror must not show through it.
StencilState stencil_of_objects_beyond(const Pass& mask);

/// Objects that decals lie on, and decals on what is seen of them: each with its object's mark in place of 0.
StencilState stencil_of_decal_bases();
StencilState stencil_of_decals();

/// Leaves no mark of patches where objects are to be marked.
StencilState stencil_of_wiping();

/// Makes a pass draw a square that fills the picture, at a depth of clip space that has this eye distance.
void fill_picture(Pass& pass, double clip_z, double eye_distance);

/// The scene itself, or its mirror image.
Pass objects_pass(const Level& level);

/// Marks a patch in the stencil, without colour or depth.
Pass patch_mask(const Level& level, std::size_t plane, const PatchName& name, std::string reason);

/// The patch with some of the lights. `blends` over a mirror image, of which it lets `reflectance` through.
Pass patch_surface(const Level& level, std::size_t plane, std::span<const std::size_t> lights, bool blends);

/// Mask, a fresh picture inside it, and the world that the mirror shows.
void add_mirror_image(std::vector<Pass>& passes, const Level& level, std::size_t plane);

/// The shadows of the lights, painted over the patch.
void add_shadows(std::vector<Pass>& passes, const Level& level, std::size_t plane);

/// Missing light: shadows go into the stencil first, then the patch is drawn once for each set of missing lights.
void add_missing_light(std::vector<Pass>& passes, const Level& level, std::size_t plane);

/// The planes and objects of a level: part of plan.cpp.
void add_world(std::vector<Pass>& passes, Level level);

}  // namespace viewing
