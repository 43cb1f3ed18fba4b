// For each switch of the planar mirror that visibly breaks the picture, reports why. Part of problems.h;
// shadow_problems.cpp is its counterpart.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "frame/cleared_code.h"
#include "frame/object_reach.h"
#include "frame/say.h"
#include "text/numbers.h"
#include "text/words.h"
#include "topics/planes/numbers/drawn_mirrors.h"
#include "topics/planes/numbers/oblique_depth.h"

namespace viewing {

namespace {

/// Returns whether the coarsest depth step in an image is a visible fraction of the picture's height there.
bool is_visibly_coarse(const ObliqueDepth& depth, const Params& params, const Derived& derived) {
    const double z = depth.coarsest_distance,
                 step = resolvable_depth_step(params.lens(), params.depth.mapping, derived.stored_depth.precision, z);
    return depth.greatest * step > visible_share * picture_height(params.lens(), z);
}

/// Reports how much depth precision is lost or gained by using the mirror as the near plane.
void say_oblique(Sayer& tell, const Params& params, const Derived& derived, const Scene& scene,
                 const FramePlan& frame) {
    constexpr double alike = 1.05;
    if (!params.tests_depth()) return;
    const std::optional<ObliqueDepth> depth = oblique_depth(params, derived, scene, frame);
    if (!depth) return;
    const Sentence coarser =
        sentence("reflection.oblique_depth",
                 "the mirror is the image's near plane, which makes depth up to {factor} times coarser, at z = {z}",
                 "factor"_a = figures(depth->greatest), "z"_a = figures(depth->coarsest_distance));
    const bool is_visible = is_visibly_coarse(*depth, params, derived);
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

/// Returns whether the last mirror on the way shows part of another plane's patch that is behind the mirror. If the
/// patch is perpendicular to the mirror, its image lies in the patch's own plane, and the patch covers the image
/// between the patch's edges. The mirror before the last one covers nothing, since it is not drawn in its own image.
bool shows_part_behind(const WayThroughMirrors& way, std::span<const DerivedPlane> planes, std::size_t other) {
    const DerivedPlane &patch = planes[other], &mirror = planes[way.mirrors.back()];
    std::vector<glm::dvec4> forms = way.forms_behind(standing);
    const double cosine = glm::dot(glm::dvec3(patch.unit_plane), glm::dvec3(mirror.unit_plane));
    const bool is_before = way.mirrors.size() > 1 && way.mirrors[way.mirrors.size() - 2] == other;
    if (std::abs(cosine) > 1e-9 || is_before) return may_reach(patch.patch, forms);
    const std::array<glm::dvec4, 4> edges = forms_of_edges(mirror_matrix(mirror.unit_plane), patch.patch);
    return std::any_of(edges.begin(), edges.end(), [&](const glm::dvec4& edge) {
        forms.push_back(-edge);
        const bool reaches = may_reach(patch.patch, forms);
        forms.pop_back();
        return reaches;
    });
}

/// Reports what is behind a mirror but appears in it if nothing is clipped: other planes' patches or, if there are
/// none, objects.
void say_behind(Sayer& tell, const Params& params, const Derived& derived, std::span<const WayThroughMirrors> ways,
                const Scene& scene) {
    const std::span<const DerivedPlane> planes = drawn_planes(params, derived);
    // If the wrong side is mirrored, clipping would keep what is behind.
    const auto fix = [&](const WayThroughMirrors& way) {
        return !params.reflection.side_of_eye && way.is_from_behind ? "" : "reflection.clip";
    };
    for (const WayThroughMirrors& way : ways) {
        std::vector<std::size_t> behind;
        for (std::size_t other = 0; other < planes.size(); ++other)
            if (params.reflection.stencil && other != way.mirrors.back() && shows_part_behind(way, planes, other))
                behind.push_back(other);
        if (!behind.empty())
            return tell.broken(
                true,
                sentence("reflection.plane_behind",
                         "part of {planes} is behind the mirror of plane {mirror}: without clipping, its "
                         "image appears in front of the mirror",
                         "planes"_a = planes_name(behind, planes.size()), "mirror"_a = way.mirrors.back() + 1),
                fix(way));
    }
    for (const WayThroughMirrors& way : ways) {
        std::vector<Message> across, behind;
        for (const SceneObject& object : scene.objects) {
            if (!may_reach(object, way.forms_behind(standing))) continue;
            const glm::dvec4 in_front = way.side - glm::dvec4(0.0, 0.0, 0.0, standing);
            (may_reach(object, {&in_front, 1}) ? across : behind).push_back(object_message(object.description.name));
        }
        if (!across.empty())
            return tell.broken(true,
                               sentence("reflection.object_across",
                                        "the mirror's plane cuts {objects}: the part behind it is mirrored too, and "
                                        "its image sticks out of the mirror",
                                        "objects"_a = enumerated(across)),
                               fix(way));
        if (!behind.empty())
            return tell.broken(
                true,
                sentence(
                    "reflection.object_behind",
                    "{objects} behind the mirror: without clipping, the mirror image appears in front of the mirror",
                    "objects"_a = enumerated(behind)),
                fix(way));
    }
}

/// Returns whether a mirror would show anything behind it if nothing were clipped.
bool shows_any_behind(const Params& params, const Derived& derived, std::span<const WayThroughMirrors> ways,
                      const Scene& scene) {
    std::vector<Problem> behind;
    Sayer tell(behind, "reflection");
    say_behind(tell, params, derived, ways, scene);
    return !behind.empty();
}

/// Returns the ways that begin with a mirror in the picture.
std::vector<WayThroughMirrors> seen_ways(const Params& params, const Derived& derived, const FramePlan& frame) {
    std::vector<WayThroughMirrors> ways = ways_through_mirrors(params, derived, frame);
    if (params.reflection.stencil)
        std::erase_if(ways, [&](const WayThroughMirrors& way) {
            return !may_show(derived.planes[way.mirrors.front()].patch, params, derived);
        });
    return ways;
}

/// Returns whether a mirror is seen from behind but shows the side that its normal points to.
bool shows_wrong_side(const ReflectionParams& reflection, std::span<const WayThroughMirrors> ways) {
    return !reflection.side_of_eye &&
           std::any_of(ways.begin(), ways.end(), [](const WayThroughMirrors& way) { return way.is_from_behind; });
}

/// Reports what clipping removes from the image, and what it fails to remove.
void say_clipping(Sayer& tell, const Params& params, const Derived& derived, std::span<const WayThroughMirrors> ways,
                  const Scene& scene) {
    const ReflectionParams& reflection = params.reflection;
    tell.broken(
        reflection.clip == MirrorClip::oblique && params.depth.logarithm_per_vertex &&
            params.depth.mapping == DepthMapping::logarithmic && shows_any_behind(params, derived, ways, scene),
        sentence(
            "reflection.oblique_with_logarithm",
            "the per-vertex logarithm overwrites the z that the oblique near plane clips against: nothing is clipped"),
        "reflection.clip");
    const bool is_wrong_side = shows_wrong_side(reflection, ways);
    tell.broken(
        is_wrong_side && reflection.clip == MirrorClip::oblique,
        sentence("reflection.behind_clipped",
                 "the mirror is seen from behind, but the oblique near plane keeps the side that the normal points to: "
                 "none of the image is left for this eye"),
        params.slips.oblique_in_world ? "" : "reflection.side_of_eye");
    tell.broken(
        is_wrong_side && reflection.clip != MirrorClip::oblique,
        sentence("reflection.wrong_side",
                 "the mirror is seen from behind, but the side that the normal points to is mirrored: the eye sees "
                 "the image of the objects behind the mirror"),
        "reflection.side_of_eye");
    if (reflection.clip == MirrorClip::none) say_behind(tell, params, derived, ways, scene);
}

/// Returns whether near or far of the frame's first mirror image cuts off part of what the mirror should show.
bool cuts_image(const Params& params, const Derived& derived, const Mirror& mirror, const Scene& scene,
                const FramePlan& frame) {
    const glm::dmat4 clip = glm::transpose(mirror.clip_from_scene);
    std::vector<glm::dvec4> forms = forms_of_image(params, derived, mirror, mirror.clip_from_scene);
    forms.push_back(mirror.kept_side(params.reflection));
    const glm::dvec4 first = frame.clip_zero_to_one ? clip[2] : clip[3] + clip[2];
    for (const glm::dvec4& end : {first, clip[3] - clip[2]}) {
        forms.push_back(-end);
        if (may_reach(scene, forms)) return true;
        forms.pop_back();
    }
    return false;
}

/// Reports an oblique near plane that was not transformed to view space. `nothing_is_left`: even the right near plane
/// leaves nothing of the image, so correcting the mistake is no fix.
void say_oblique_in_world(Sayer& tell, const Params& params, const Derived& derived, const std::vector<Mirror>& mirrors,
                          const Scene& scene, const FramePlan& frame, bool nothing_is_left) {
    const Mirror& mirror = mirrors.front();
    const std::optional<ObliqueDepth> depth = oblique_depth(params, derived, scene, frame);
    const bool is_coarse =
                   lets_nearer_win(params) && params.depth.write && depth && is_visibly_coarse(*depth, params, derived),
               is_alone = drawn_planes(params, derived).size() == 1;
    if (is_alone && !is_coarse && !cuts_image(params, derived, mirror, scene, frame)) return;
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
        nothing_is_left ? "" : "slips.oblique_in_world");
}

/// Reports the mistakes in R, for the first mirror that shows them.
void say_slips(Sayer& tell, const Params& params, const Derived& derived, const std::vector<Mirror>& mirrors,
               const Scene& scene) {
    constexpr double least = 1e-9;
    const SlipParams& slips = params.slips;
    for (const Mirror& mirror : mirrors) {
        if (!mirror.plane.mirror_has_slip || !may_show_image(params, derived, mirror, scene)) continue;
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

/// Returns whether a mirror may show objects.
bool shows_objects(const Params& params, const Derived& derived, const std::vector<Mirror>& mirrors, const Scene& scene,
                   const std::vector<SeenImage>& images) {
    const ReflectionParams& reflection = params.reflection;
    const SlipParams& slips = params.slips;
    const bool fits = reflection.same_projection && params.mirror_picture_scale() == 1.0,
               has_right_images = reflection.side_of_eye && fits && !reflection.printed_by_rows && !slips.plus_2ab &&
                                  !slips.normal_not_unit && !slips.oblique_in_world;
    const bool is_by_hand =
        std::any_of(mirrors.begin(), mirrors.end(), [](const Mirror& mirror) { return mirror.plane.mirror_by_hand; });
    if (!has_right_images || is_by_hand)
        return (mirrors.size() > 1 && reflection.bounces > 1) ||
               std::any_of(mirrors.begin(), mirrors.end(), [&](const Mirror& mirror) {
                   return may_draw_image(params, derived, mirror, scene, mirror.clip_from_scene);
               });
    // An oblique near plane gives images different depth codes.
    const double start = reflection.clip == MirrorClip::oblique ? std::numeric_limits<double>::infinity()
                                                                : start_of_cleared_code(params);
    const auto is_shown = [](const SeenImage& image) { return image.is_shown; };
    const bool has_samples = std::any_of(images.begin(), images.end(), is_shown);
    if (has_samples && std::none_of(images.begin(), images.end(),
                                    [&](const SeenImage& image) { return image.is_shown && image.nearest < start; }))
        return false;
    return (has_samples && mirrors.size() > 1) ||
           std::any_of(mirrors.begin(), mirrors.end(), [&](const Mirror& mirror) {
               return may_draw_image(params, derived, mirror, scene, mirror.clip_from_scene);
           });
}

/// Reports errors in the image: its winding, its light, the mirrored camera's projection, and an R filled by rows.
void say_images(Sayer& tell, const Params& params, const Derived& derived, const std::vector<Mirror>& mirrors,
                const Scene& scene, bool shows_images, bool is_hidden) {
    const ReflectionParams& reflection = params.reflection;
    const bool culls = params.cull.enabled && params.cull.face != CullFace::front_and_back;
    tell.broken(!reflection.flip_winding && !is_hidden && shows_images && (culls || params.view.shows == Shows::facing),
                culls
                    ? sentence("reflection.winding",
                               "R turns counterclockwise winding clockwise (det R = −1): without the flip, the image's "
                               "front faces are culled, and the image appears inside out")
                    : sentence("reflection.winding",
                               "R turns counterclockwise winding clockwise (det R = −1): without the flip, the image's "
                               "front faces count as back-facing"),
                "reflection.flip_winding");
    tell.broken(
        !reflection.reflect_light && !is_hidden && shows_images,
        sentence("reflection.light_not_mirrored",
                 "the light is not mirrored with the scene: the image is lit from the light's position, not from "
                 "that of the light's image"),
        "reflection.reflect_light");
    tell.broken(
        reflection.mirrored == MirroredThing::camera && !reflection.same_projection && derived.aspect != 1.0 &&
            !is_hidden,
        sentence("reflection.other_projection",
                 "the mirrored camera uses the aspect ratio of a square picture: the image does not fit its mirror"),
        "reflection.same_projection");
    const double scale = params.mirror_picture_scale();
    tell.broken(std::abs(scale - 1.0) > 1e-3 && !is_hidden,
                sentence("reflection.other_fovy",
                         "the picture in the mirror is drawn with fovy {wrong}° instead of the camera's {right}°: the "
                         "image is {scale} times as large as it should be and does not fit its mirror",
                         "wrong"_a = figures(params.reflection.fovy, 4), "right"_a = figures(params.lens().fovy_deg, 4),
                         "scale"_a = figures(scale, 3)),
                "reflection.fovy");

    const auto is_moved = [&](const Mirror& mirror) {
        return mirror.distance_from_origin() > 1e-9 && !mirror.plane.mirror_by_hand &&
               may_show_image(params, derived, mirror, scene);
    };
    tell.broken(
        reflection.printed_by_rows && !is_hidden && std::any_of(mirrors.begin(), mirrors.end(), is_moved),
        sentence("reflection.by_rows",
                 "R is filled row by row as printed, but OpenGL reads columns: Rᵀ has −2d n in its last row, where "
                 "it changes w instead of moving the image"),
        "reflection.printed_by_rows");
}

/// Reports missing shadows in the mirror image.
void say_shadows_inside(Sayer& tell, const Params& params, const Derived& derived, const Scene& scene,
                        const FramePlan& frame) {
    if (params.reflection.shadows || !params.shadow.enabled) return;
    tell.broken(may_mirror_shadows(params, derived, scene, frame),
                sentence("reflection.no_shadows_inside",
                         "the mirror image is drawn without shadows: inside the mirror, the objects seem to float"),
                "reflection.shadows");
}

}  // namespace

void find_mirror_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived,
                          const Scene& scene, const FramePlan& frame, const std::vector<SeenImage>& images) {
    if (frame.reflection_depth < 1 || !shows_effects(params)) return;
    const std::vector<Mirror> mirrors = drawn_mirrors(params, derived, &frame);
    if (mirrors.empty()) return;
    Sayer tell(problems, "reflection");
    find_mask_problems(problems, params, derived, mirrors, scene);
    const std::vector<WayThroughMirrors> ways = seen_ways(params, derived, frame);
    const bool is_in_world = params.slips.oblique_in_world && params.reflection.clip == MirrorClip::oblique;
    if (is_in_world)
        say_oblique_in_world(tell, params, derived, mirrors, scene, frame, shows_wrong_side(params.reflection, ways));
    if (params.reflection.clip == MirrorClip::oblique && !is_in_world) say_oblique(tell, params, derived, scene, frame);
    say_clipping(tell, params, derived, ways, scene);
    say_slips(tell, params, derived, mirrors, scene);
    const bool is_hidden = std::all_of(mirrors.begin(), mirrors.end(), [&](const Mirror& mirror) {
        return !mirror.is_in_view || mask_hides_all(params, derived, mirror, scene);
    });
    const bool depends_on_images = !params.reflection.reflect_light || !params.reflection.flip_winding;
    say_images(tell, params, derived, mirrors, scene,
               depends_on_images && shows_objects(params, derived, mirrors, scene, images), is_hidden);
    find_bounce_problems(problems, params, derived, mirrors, frame.reflection_depth);
    if (!is_hidden) say_shadows_inside(tell, params, derived, scene, frame);
}

}  // namespace viewing
