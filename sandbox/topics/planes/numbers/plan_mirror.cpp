// Mirror images: draws the world again behind each mirror, inside the mirror's mask. For mirrors in mirrors, the
// stencil counts up on the way in and down on the way out. Source: lecture, Planar Reflection; Kilgard 1999.
#include <algorithm>
#include <cmath>

#include "frame/ground.h"
#include "frame/plan/plan_parts.h"

namespace viewing {
namespace {

constexpr int most_images = 64, most_drawings = 256;

/// Returns the total number of images if each of `mirrors` mirrors shows all the others, `depth` levels deep.
int image_count(int mirrors, int depth) {
    int all = 0, at_depth = mirrors;
    for (int level = 0; level < depth && all <= most_images; ++level) {
        all += at_depth;
        at_depth *= mirrors - 1;
    }
    return all;
}

/// Returns F, which swaps left and right.
glm::dmat4 flip() {
    glm::dmat4 flipped(1.0);
    flipped[0][0] = -1.0;
    return flipped;
}

/// Transforms the scene and its lights by R.
void mirror_scene(Level& inside, const glm::dmat4& mirrored_world_from_world) {
    inside.world_from_scene = inside.world_from_scene * mirrored_world_from_world;
    inside.matrices = "P V" + inside.mirror_symbols;
    if (!inside.params.reflection.reflect_light) return;
    for (std::size_t light = 0; light < inside.lights_world.size(); ++light)
        inside.lights_world[light] = inside.world_from_scene * inside.derived.lights_world[light];
    inside.sky_world = glm::normalize(glm::dmat3(inside.world_from_scene) * sky_scene + 1e-30 * sky_scene);
}

/// Transforms the camera by R and flips its picture: (F P) (F V R) = P V R. The lights keep their positions, unless
/// reflect_light is off.
void mirror_camera(Level& inside, const glm::dmat4& mirrored_world_from_world) {
    const Params& params = inside.params;
    // The mistake: the mirrored camera has an aspect ratio of 1 instead of the picture's.
    if (!params.reflection.same_projection && inside.bounces() == 1)
        for (int column = 0; column < 4; ++column) inside.projection[column][0] *= inside.derived.aspect;
    inside.projection = inside.projection * flip();
    inside.view_from_world = flip() * inside.view_from_world * mirrored_world_from_world;
    inside.matrices = (inside.bounces() % 2 == 1 ? "F P F V" : "P V") + inside.mirror_symbols;
    inside.eye_world = inside.eye_scene;
    if (params.reflection.reflect_light) return;
    for (glm::dvec4& light : inside.lights_world) light = mirrored_world_from_world * light;
    inside.sky_world = glm::dmat3(mirrored_world_from_world) * inside.sky_world;
}

/// Gives the picture in the first mirror the field of view reflection.fovy. Mirrors seen in that mirror keep its
/// projection.
void use_mirror_fovy(Level& inside) {
    const double scale = inside.params.mirror_picture_scale();
    if (scale == 1.0) return;
    if (inside.bounces() == 1)
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 2; ++row) inside.projection[column][row] *= scale;
    inside.matrices.replace(inside.matrices.find('P'), 1, "P′");
}

ClipRange clip_range(const Level& level) {
    if (level.params.depth.mapping != DepthMapping::reversed) return ClipRange::standard;
    return level.derived.clip_zero_to_one ? ClipRange::reversed_zero_to_one : ClipRange::reversed;
}

/// Keeps the part of the scene, before it is mirrored, that is on the positive side of `kept`.
void clip_at_mirror(Level& inside, const glm::dvec4& kept) {
    const ReflectionParams& reflection = inside.params.reflection;
    inside.clip_from_view = inside.projection;
    inside.clip.reset();
    // A matrix entered by hand may not be invertible.
    const bool has_view = std::abs(glm::determinant(inside.view_from_world)) > 1e-12;
    if (reflection.clip == MirrorClip::oblique && has_view) {
        const bool by_camera = reflection.mirrored == MirroredThing::camera;
        const glm::dvec4 kept_world = by_camera ? kept : kept * inside.scene_from_world;
        const glm::dvec4 kept_view =
            inside.params.slips.oblique_in_world ? kept_world : kept_world * glm::inverse(inside.view_from_world);
        inside.clip_from_view = with_oblique_near_plane(inside.projection, kept_view, clip_range(inside));
    } else if (reflection.clip != MirrorClip::none) {
        inside.clip = kept;
    }
}

Level world_inside(const Level& outside, std::size_t mirror) {
    const DerivedPlane& plane = outside.plane(mirror);
    const glm::dmat4 true_mirror = mirror_matrix(plane.unit_plane);
    Level inside = outside;
    inside.mirrors_met.push_back(mirror);
    inside.mirror_symbols += " " + outside.mirror_symbol(mirror);
    inside.region = outside.region_of(mirror);
    inside.flips_winding = !outside.flips_winding;
    inside.eye_scene = true_mirror * outside.eye_scene;
    inside.scene_from_world = true_mirror * outside.scene_from_world;
    if (inside.params.reflection.mirrored == MirroredThing::camera)
        mirror_camera(inside, plane.mirrored_world_from_world);
    else
        mirror_scene(inside, plane.mirrored_world_from_world);
    use_mirror_fovy(inside);
    clip_at_mirror(inside, inside.params.reflection.side_of_eye ? outside.plane_towards_eye(mirror) : plane.unit_plane);
    return inside;
}

/// Returns a pass that resets color and depth inside the mask to the values at the start of the frame, because
/// something has been drawn there.
Pass fresh_picture(const Level& level, std::size_t plane) {
    Pass pass = level.pass(
        message("Clear mirror"),
        message("clears color and depth inside the mask: everything drawn there so far lies behind the mirror"),
        Subject::backdrop);
    const Color background = ground_of(level.params.ui.theme).background;
    const bool reversed = level.params.depth.mapping == DepthMapping::reversed;
    const double far_clip = reversed ? (level.derived.clip_zero_to_one ? 0.0 : -1.0) : 1.0;
    fill_picture(pass, far_clip, level.params.lens().logarithmic_far());
    pass.is_mirror_image = true;
    pass.color = color_of(background, 1.0);
    pass.depth.func = CompareFunc::always;
    pass.stencil = stencil_of_patch(level, plane);
    return pass;
}

/// Returns how often the scene's objects are drawn: once per world, plus once per shadow in it.
int drawing_count(const Params& params, const Derived& derived, int images) {
    const auto receivers = static_cast<int>(std::count_if(
        derived.planes.begin(), derived.planes.end(), [](const DerivedPlane& plane) { return plane.receives_shadow; }));
    const int shadows = params.shadow.enabled ? receivers * static_cast<int>(derived.lights_world.size()) : 0;
    return (1 + images) * (1 + shadows);
}

}  // namespace

void fill_picture(Pass& pass, double clip_z, double eye_distance) {
    pass.subject = Subject::backdrop;
    pass.matrices = "I";
    pass.shading = Shading::flat;
    pass.world_from_scene = glm::dmat4(1.0);
    pass.clip_planes.clear();
    pass.cull = CullParams{};
    // Maps the patch's square, from −1 to 1 in x and z, to the whole picture.
    pass.clip_from_world = {{1, 0, 0, 0}, {0, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, clip_z, 1}};
    pass.view_from_world = glm::dmat4(0.0);
    pass.view_from_world[3] = {0.0, 0.0, -eye_distance, 1.0};
}

int reflection_depth(const Params& params, const Derived& derived) {
    if (!params.reflection.enabled) return 0;
    if (!is_drawn_by_gl_alone(params.visibility.method)) return std::min(params.reflection.bounces, 1);
    const auto mirrors = static_cast<int>(std::count_if(derived.planes.begin(), derived.planes.end(),
                                                        [](const DerivedPlane& plane) { return plane.mirrors; }));
    // Each mirror in a row uses one more value of the stencil's low bits.
    int depth = std::min(params.reflection.bounces, stencil_region_bits - static_cast<int>(derived.planes.size()));
    const auto is_too_much = [&] {
        const int images = image_count(mirrors, depth);
        return images > most_images || drawing_count(params, derived, images) > most_drawings;
    };
    while (depth > 1 && is_too_much()) --depth;
    return depth;
}

Pass patch_mask(const Level& level, std::size_t plane, const PatchName& name, const Message& reason) {
    Pass pass = level.patch_pass(name, reason, plane);
    pass.shading = Shading::flat;
    pass.color_write = false;
    pass.depth.write = false;
    pass.stencil = stencil_of_mask(level, plane);
    return pass;
}

void add_mirror_image(std::vector<Pass>& passes, const Level& level, std::size_t plane) {
    const ReflectionParams& reflection = level.params.reflection;
    Level inside = world_inside(level, plane);
    if (!reflection.stencil) {  // only the depth test limits where the image appears
        inside.region = 0;
        passes.push_back(objects_pass(inside));
        return;
    }
    Pass mask = patch_mask(level, plane, {marked("Mirror mask"), marked("Mirror mask {plane}")},
                           message("marks the patch in the stencil buffer, so that the image stays inside the mirror"));
    mask.depth.write = reflection.mask_writes_depth;
    if (reflection.after_objects) mask.depth.test = false;
    passes.push_back(mask);
    if (!level.is_fresh) passes.push_back(fresh_picture(level, plane));
    inside.is_fresh = true;
    add_world(passes, inside);
}

}  // namespace viewing
