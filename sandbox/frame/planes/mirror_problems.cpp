// Reports why each switch of the planar mirror breaks the picture, but only if that is visible. Part of problems.h;
// shadow_problems.cpp is its counterpart.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "frame/cleared_code.h"
#include "frame/hidden/hidden_drawing.h"
#include "frame/object_reach.h"
#include "frame/planes/drawn_mirrors.h"
#include "frame/planes/oblique_depth.h"
#include "frame/say.h"
#include "text/numbers.h"
#include "text/words.h"

namespace viewing {

std::vector<Mirror> drawn_mirrors(const Params& params, const Derived& derived) {
    std::vector<Mirror> mirrors;
    for (const DerivedPlane& plane : drawn_planes(params, derived))
        if (const double side = plane.eye_side; plane.mirrors && side != 0.0)
            mirrors.push_back({plane, side,
                               params.reflection.stencil ? may_show(plane.patch, params, derived)
                                                         : is_in_view(plane.patch, derived.clip_from_world)});
    const bool sees_any =
        std::any_of(mirrors.begin(), mirrors.end(), [](const Mirror& mirror) { return mirror.is_in_view; });
    return sees_any ? mirrors : std::vector<Mirror>{};
}

namespace {

/// Reports how much depth precision is lost or gained by using the mirror as the near plane.
void say_oblique(Sayer& tell, const Params& params, const Derived& derived, const Scene& scene,
                 const FramePlan& frame) {
    constexpr double alike = 1.05;
    const bool tests = params.depth.tests() && params.visibility.method == VisibilityMethod::depth_buffer;
    if (!tests) return;
    const std::optional<ObliqueDepth> depth = oblique_depth(params, derived, scene, frame);
    if (!depth) return;
    const Sentence coarser =
        sentence("reflection.oblique_depth",
                 "the mirror is the image's near plane, which makes depth up to {factor} times coarser, at z = {z}",
                 "factor"_a = figures(depth->greatest), "z"_a = figures(depth->coarsest_distance));
    const Lens lens = params.lens();
    const double z = depth->coarsest_distance,
                 step = resolvable_depth_step(lens, params.depth.mapping, derived.stored_depth.precision, z);
    const bool is_visible = depth->greatest * step > visible_share * picture_height(lens, z);
    tell.broken(depth->greatest > alike && is_visible, coarser, "reflection.clip");
    tell(depth->greatest > alike && !is_visible, coarser);
    const std::string least = figures(1.0 / depth->greatest), most = figures(1.0 / depth->least);
    tell(depth->greatest <= alike && 1.0 / depth->least > alike,
         least == most
             ? sentence("reflection.oblique_finer",
                        "the mirror is the image's near plane, which makes depth about {factor} times finer",
                        "factor"_a = most)
             : sentence("reflection.oblique_finer",
                        "the mirror is the image's near plane, which makes depth {least} to {most} times finer",
                        "least"_a = least, "most"_a = most));
}

/// Returns forms that are positive where a mirror shows a point that is behind it, unless that is clipped.
std::vector<glm::dvec4> forms_behind(const Params& params, const Derived& derived, const Mirror& mirror) {
    const glm::dmat4& mirrored = mirror.plane.mirrored_world_from_world;
    const glm::dmat4 on_mirror = seen_on_plane(mirror.plane.unit_plane, derived.eye_world) * mirrored;
    const glm::dmat4 clip_from_world = derived.clip_from_world * mirrored, clip = glm::transpose(clip_from_world);
    glm::dvec4 behind = -mirror.towards_eye();
    behind.w -= standing;
    std::vector<glm::dvec4> forms = {behind, clip[3] + clip[2]};
    for (const glm::dvec4& side : forms_of_sides(clip_from_world)) forms.push_back(side);
    if (!params.reflection.stencil) return forms;
    forms.push_back(glm::transpose(on_mirror)[3]);
    for (const glm::dvec4& edge : forms_of_edges(on_mirror, mirror.plane.patch)) forms.push_back(edge);
    return forms;
}

/// Reports other planes' patches behind a mirror, which shows them if nothing is clipped.
void say_patches_behind(Sayer& tell, const Params& params, const Derived& derived, const std::vector<Mirror>& mirrors) {
    if (!params.reflection.stencil) return;
    const std::span<const DerivedPlane> planes = drawn_planes(params, derived);
    for (const Mirror& mirror : mirrors) {
        std::vector<std::size_t> behind;
        for (std::size_t other = 0; other < planes.size(); ++other)
            if (&planes[other] != &mirror.plane && mirror.is_in_view &&
                may_reach(planes[other].patch, forms_behind(params, derived, mirror)))
                behind.push_back(other);
        if (!behind.empty())
            return tell.broken(
                true,
                sentence("reflection.plane_behind",
                         "part of {planes} is behind the mirror of plane {mirror}: without clipping, its "
                         "image appears in front of the mirror",
                         "planes"_a = planes_name(behind, planes.size()),
                         "mirror"_a = static_cast<std::size_t>(&mirror.plane - planes.data()) + 1),
                "reflection.clip");
    }
}

/// Reports what clipping removes from the image, and what it fails to remove.
void say_clipping(Sayer& tell, const Params& params, const Derived& derived, const std::vector<Mirror>& mirrors,
                  const Scene& scene) {
    const ReflectionParams& reflection = params.reflection;
    tell.broken(
        reflection.clip == MirrorClip::oblique && params.depth.logarithm_per_vertex &&
            params.depth.mapping == DepthMapping::logarithmic,
        sentence(
            "reflection.oblique_with_logarithm",
            "the per-vertex logarithm overwrites the z that the oblique near plane clips against: nothing is clipped"),
        "reflection.clip");
    const bool is_wrong_side =
        !reflection.side_of_eye &&
        std::any_of(mirrors.begin(), mirrors.end(), [](const Mirror& mirror) { return mirror.is_seen_from_behind(); });
    tell.broken(
        is_wrong_side && reflection.clip == MirrorClip::oblique,
        sentence("reflection.behind_clipped",
                 "the mirror is seen from behind, but the oblique near plane keeps the side that the normal points to: "
                 "nothing of the image is left for this eye"),
        "reflection.side_of_eye");
    tell.broken(
        is_wrong_side && reflection.clip != MirrorClip::oblique,
        sentence("reflection.wrong_side",
                 "the mirror is seen from behind, but the side that the normal points to is mirrored: the eye sees "
                 "the image of the objects behind the mirror"),
        "reflection.side_of_eye");
    if (reflection.clip != MirrorClip::none) return;
    say_patches_behind(tell, params, derived, mirrors);
    for (const Mirror& mirror : mirrors) {
        const std::vector<glm::dvec4> forms = forms_behind(params, derived, mirror);
        const bool is_single = mirrors.size() == 1;  // otherwise, images of images show it
        std::vector<std::string> across, behind;
        for (const SceneObject& object : scene.objects) {
            if (is_single && !may_reach(object, forms)) continue;
            const glm::dvec4 in_front = mirror.towards_eye() + glm::dvec4(0.0, 0.0, 0.0, standing);
            const glm::dvec4 beyond = -mirror.towards_eye() - glm::dvec4(0.0, 0.0, 0.0, standing);
            if (!may_reach(object, {&beyond, 1})) continue;
            (may_reach(object, {&in_front, 1}) ? across : behind).push_back(object_text(object.description.name));
        }
        if (!across.empty())
            return tell.broken(true,
                               sentence("reflection.object_across",
                                        "the mirror's plane cuts {objects}: the part behind it is mirrored too, and "
                                        "its image sticks out of the mirror",
                                        "objects"_a = joined(across)),
                               "reflection.clip");
        if (!behind.empty())
            return tell.broken(
                true,
                sentence(
                    "reflection.object_behind",
                    "{objects} behind the mirror: without clipping, the mirror image appears in front of the mirror",
                    "objects"_a = joined(behind)),
                "reflection.clip");
    }
}

/// Returns whether a mirror's mask hides its image, which is beyond the mirror unless the wrong side is mirrored. If
/// the mirror is drawn after another plane, depth is cleared inside the mask, so the mask hides nothing.
bool mask_hides(const Params& params, const Derived& derived, const Mirror& mirror, const Scene& scene) {
    const ReflectionParams& reflection = params.reflection;
    const bool tests = params.depth.tests() && params.visibility.method == VisibilityMethod::depth_buffer;
    if (!tests || !reflection.mask_writes_depth || !reflection.stencil || reflection.after_objects) return false;
    if (!reflection.side_of_eye && mirror.is_seen_from_behind()) return false;
    const auto before =
        std::span(derived.planes).first(static_cast<std::size_t>(&mirror.plane - derived.planes.data()));
    return std::all_of(before.begin(), before.end(), [](const DerivedPlane& plane) { return plane.eye_side == 0.0; }) &&
           !objects_at_most(scene, -mirror.towards_eye(), 0.0).empty();
}

/// Reports errors of the masks, which keep the image inside the mirror and the mirror in its place among the objects.
void say_masks(Sayer& tell, const Params& params, const Derived& derived, const std::vector<Mirror>& mirrors,
               const Scene& scene) {
    const ReflectionParams& reflection = params.reflection;
    const auto image_is_wider = [&](const Mirror& mirror) {
        return lands_beyond(
            scene, {seen_on_plane(mirror.plane.unit_plane, derived.eye_world) * mirror.plane.mirrored_world_from_world,
                    derived.clip_from_world, mirror.kept_side(reflection), mirror.plane.patch});
    };
    const auto is_covered = [&](const Mirror& mirror) {
        return lands_inside(scene, {seen_on_plane(mirror.plane.unit_plane, derived.eye_world), derived.clip_from_world,
                                    mirror.towards_eye(), mirror.plane.patch});
    };
    // The sentence about reflection.fovy already reports an image that is drawn larger.
    const bool is_distorted = reflection.mirrored == MirroredThing::camera && !reflection.same_projection;
    // Where depth hides the patch, it does not mark the stencil either.
    const bool is_unmarked = std::any_of(mirrors.begin(), mirrors.end(), [&](const Mirror& mirror) {
        return loses_part(mirror.plane.patch, params, derived);
    });
    tell.broken(
        !reflection.stencil &&
            (is_distorted || is_unmarked || std::any_of(mirrors.begin(), mirrors.end(), image_is_wider)),
        sentence("reflection.beyond_edge",
                 "R reflects across the infinite plane, not just its patch: without the stencil, the image shows "
                 "beyond the mirror's edge"),
        "reflection.stencil");
    std::vector<std::string> in_front;
    for (const Mirror& mirror : mirrors) {
        if (reflection.stencil || !in_front.empty()) break;
        // Only without clipping, or with a wrong R, is an image in front of its mirror.
        glm::dvec4 image_in_front = mirror.towards_eye() * mirror.plane.mirrored_world_from_world;
        image_in_front.w -= standing;
        const std::array shown = {image_in_front, mirror.kept_side(reflection)};
        for (const SceneObject& object : scene.objects)
            if (may_reach(object, shown)) in_front.push_back(object_text(object.description.name));
    }
    tell.broken(
        !in_front.empty(),
        sentence("reflection.image_in_front",
                 "without the stencil, the mirror does not cover the image of {objects}, which lies in front of it",
                 "objects"_a = joined(in_front)),
        "reflection.stencil");
    tell.broken(
        std::any_of(mirrors.begin(), mirrors.end(),
                    [&](const Mirror& mirror) { return mask_hides(params, derived, mirror, scene); }),
        sentence(
            "reflection.hides_image",
            "the mask writes the mirror's own depth: the image lies beyond it, fails the depth test and is hidden"),
        "reflection.mask_writes_depth");
    tell.broken(!reflection.stencil && drawn_planes(params, derived).size() > 1,
                sentence("reflection.no_planes_inside",
                         "without the stencil, the mirror image shows no other plane and no other mirror"),
                "reflection.stencil");
    tell.broken(reflection.after_objects && reflection.stencil && is_drawn_by_gl_alone(params.visibility.method) &&
                    std::any_of(mirrors.begin(), mirrors.end(), is_covered),
                sentence("reflection.covers_objects",
                         "the mirror is drawn last and without a depth test: it covers the objects in front of it"),
                "reflection.after_objects");
}

/// Reports a mirror whose picture is cleared and drawn over earlier patches too, because they share its stencil value.
void say_shared_value(Sayer& tell, const Params& params, const Derived& derived, const std::vector<Mirror>& mirrors) {
    if (params.shadow.own_stencil || !params.reflection.stencil) return;
    const std::span<const DerivedPlane> planes = drawn_planes(params, derived);
    for (const Mirror& mirror : mirrors) {
        const auto index = static_cast<std::size_t>(&mirror.plane - derived.planes.data());
        std::vector<std::size_t> covered;
        for (std::size_t before = 0; before < index; ++before)
            if (planes[before].eye_side != 0.0 && is_in_view(planes[before].patch, derived.clip_from_world))
                covered.push_back(before);
        if (!covered.empty())
            return tell.broken(
                true,
                sentence("reflection.shared_stencil",
                         "the planes share one stencil value: the image in plane {plane} is also drawn over "
                         "{planes}",
                         "plane"_a = index + 1, "planes"_a = planes_name(covered, planes.size())),
                "shadow.own_stencil");
    }
}

/// Reports an oblique near plane that was not transformed to view space.
void say_oblique_in_world(Sayer& tell, const Derived& derived, const std::vector<Mirror>& mirrors) {
    const Mirror& mirror = mirrors.front();
    const glm::dvec4 world = mirror.towards_eye(), view = world * glm::inverse(derived.view_from_world);
    const auto text = [](glm::dvec4 plane) {
        for (int i = 0; i < 4; ++i)
            if (std::abs(plane[i]) < 1e-9) plane[i] = 0.0;
        return figures_of({&plane.x, 4});
    };
    tell.broken(
        glm::length(world - view) > 1e-9,
        sentence("reflection.oblique_in_world",
                 "mistake: the oblique near plane is {given}, in world space, but P needs it in view space, {right}: "
                 "the image is cut at another plane",
                 "given"_a = text(world), "right"_a = text(view)),
        "slips.oblique_in_world");
}

/// Reports the mistakes in R, for the first mirror that shows them.
void say_slips(Sayer& tell, const Params& params, const Derived& derived, const std::vector<Mirror>& mirrors) {
    constexpr double least = 1e-9;
    const SlipParams& slips = params.slips;
    for (const Mirror& mirror : mirrors) {
        if (!mirror.plane.mirror_has_slip) continue;
        const auto index = static_cast<std::size_t>(&mirror.plane - derived.planes.data());
        const glm::dvec3 n(slips.normal_not_unit ? params.planes[index].equation : mirror.plane.unit_plane);
        const double length = glm::length(n), entry = 2.0 * n.x * n.y;
        tell.broken(
            slips.plus_2ab && std::abs(entry) > least,
            sentence("reflection.plus_2ab",
                     "mistake: row 2, column 1 of R is +2ab = {wrong} instead of −2ab = {right}: R R is not I, and "
                     "the image does not fit its mirror",
                     "wrong"_a = figures(entry, 3), "right"_a = figures(-entry, 3)),
            "slips.plus_2ab");
        tell.broken(
            slips.normal_not_unit && std::abs(length - 1.0) > least,
            sentence("reflection.normal_not_unit",
                     "mistake: R uses (a, b, c, d) as entered, but |n| is {length}, not 1: every point moves |n|² = "
                     "{factor} times the distance to its mirror image",
                     "length"_a = figures(length, 3), "factor"_a = figures(length * length, 3)),
            "slips.normal_not_unit");
        return;
    }
}

/// Reports errors in the image: its winding, its light, the mirrored camera's projection, and an R filled by rows.
void say_images(Sayer& tell, const Params& params, const Derived& derived, const std::vector<Mirror>& mirrors,
                const Scene& scene, bool shows_images) {
    const ReflectionParams& reflection = params.reflection;
    const bool culls = params.cull.enabled && params.cull.face != CullFace::front_and_back;
    tell.broken(!reflection.flip_winding && (culls || params.view.shows == Shows::facing),
                culls
                    ? sentence("reflection.winding",
                               "R turns counterclockwise winding clockwise (det R = −1): without the flip, the image's "
                               "front faces are culled, and the image appears inside out")
                    : sentence("reflection.winding",
                               "R turns counterclockwise winding clockwise (det R = −1): without the flip, the image's "
                               "front faces count as back-facing"),
                "reflection.flip_winding");
    const bool is_hidden = std::all_of(mirrors.begin(), mirrors.end(), [&](const Mirror& mirror) {
        return mask_hides(params, derived, mirror, scene);
    });
    tell.broken(
        !reflection.reflect_light && !is_hidden && shows_images,
        sentence("reflection.light_not_mirrored",
                 "the light is not mirrored with the scene: the image is lit from the light's position, not from "
                 "that of the light's image"),
        "reflection.reflect_light");
    tell.broken(
        reflection.mirrored == MirroredThing::camera && !reflection.same_projection && derived.aspect != 1.0,
        sentence("reflection.other_projection",
                 "the mirrored camera uses the aspect ratio of a square picture: the image does not fit its mirror"),
        "reflection.same_projection");
    const double scale = params.mirror_picture_scale();
    tell.broken(std::abs(scale - 1.0) > 1e-3,
                sentence("reflection.other_fovy",
                         "the picture in the mirror is drawn with fovy {wrong}° instead of the camera's {right}°: the "
                         "image is {scale} times as large as it should be and does not fit its mirror",
                         "wrong"_a = figures(params.reflection.fovy), "right"_a = figures(params.lens().fovy_deg),
                         "scale"_a = figures(scale, 3)),
                "reflection.fovy");

    const auto is_moved = [](const Mirror& mirror) {
        return mirror.distance_from_origin() > 1e-9 && !mirror.plane.mirror_by_hand;
    };
    tell.broken(
        reflection.printed_by_rows && std::any_of(mirrors.begin(), mirrors.end(), is_moved),
        sentence("reflection.by_rows",
                 "R is filled row by row as printed, but OpenGL reads columns: Rᵀ has −2d n in its last row, where "
                 "it changes w instead of moving the image"),
        "reflection.printed_by_rows");
}

/// Reports missing shadows in the mirror image.
void say_shadows_inside(Sayer& tell, const Params& params, const Derived& derived, const std::vector<Mirror>& mirrors) {
    if (params.reflection.shadows || !params.shadow.enabled || !params.reflection.stencil) return;
    const auto shows_receiver = [&](const Mirror& mirror) {
        const auto planes = drawn_planes(params, derived);
        return std::any_of(planes.begin(), planes.end(), [&](const DerivedPlane& plane) {
            return &plane != &mirror.plane && plane.receives_shadow &&
                   std::any_of(plane.shadows.begin(), plane.shadows.end(),
                               [](const CastShadow& cast) { return !cast.light_in_plane; });
        });
    };
    tell.broken(std::any_of(mirrors.begin(), mirrors.end(), shows_receiver),
                sentence("reflection.no_shadows_inside",
                         "the mirror image is drawn without shadows: inside the mirror, the objects seem to float"),
                "reflection.shadows");
}

}  // namespace

void find_mirror_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived,
                          const Scene& scene, const FramePlan& frame) {
    if (frame.reflection_depth < 1 || !shows_effects(params)) return;
    const std::vector<Mirror> mirrors = drawn_mirrors(params, derived);
    if (mirrors.empty()) return;
    Sayer tell(problems, "reflection");
    say_masks(tell, params, derived, mirrors, scene);
    say_shared_value(tell, params, derived, mirrors);
    const bool is_in_world = params.slips.oblique_in_world && params.reflection.clip == MirrorClip::oblique;
    if (is_in_world) say_oblique_in_world(tell, derived, mirrors);
    if (params.reflection.clip == MirrorClip::oblique && !is_in_world) say_oblique(tell, params, derived, scene, frame);
    say_clipping(tell, params, derived, mirrors, scene);
    say_slips(tell, params, derived, mirrors);
    const std::vector<SeenImage> images = seen_images(derived, scene, frame);
    const bool is_usual =
        params.reflection.side_of_eye && !params.reflection.printed_by_rows && params.slips == SlipParams{};
    const bool shows_images =
        !is_usual || std::any_of(images.begin(), images.end(), [](const SeenImage& image) { return image.is_shown; });
    say_images(tell, params, derived, mirrors, scene, shows_images);
    find_bounce_problems(problems, params, derived, mirrors, frame.reflection_depth);
    say_shadows_inside(tell, params, derived, mirrors);
}

}  // namespace viewing
