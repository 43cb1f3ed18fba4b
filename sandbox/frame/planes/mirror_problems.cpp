// Reports why each switch of the planar mirror breaks the picture, but only if that is visible. Part of problems.h;
// shadow_problems.cpp is its counterpart.
#include <algorithm>
#include <cmath>
#include <limits>

#include "frame/hidden/hidden_drawing.h"
#include "frame/object_reach.h"
#include "frame/planes/oblique_depth.h"
#include "frame/say.h"
#include "text/numbers.h"

namespace viewing {
namespace {

/// A mirror that has an image in the frame.
struct Mirror {
    const DerivedPlane& plane;
    double eye_side;
    bool is_in_view;

    glm::dvec4 towards_eye() const { return (eye_side < 0.0 ? -1.0 : 1.0) * plane.unit_plane; }
    bool is_seen_from_behind() const { return is_in_view && eye_side < 0.0; }
    /// Returns a plane; the objects on its positive side are mirrored.
    glm::dvec4 kept_side(const ReflectionParams& reflection) const {
        if (reflection.clip == MirrorClip::none) return {0.0, 0.0, 0.0, 1.0};
        return reflection.side_of_eye ? towards_eye() : plane.unit_plane;
    }
    double distance_from_origin() const { return std::abs(plane.unit_plane.w); }
};

/// Returns all mirrors if any of them is in the picture, since the others may be seen in it; otherwise none.
std::vector<Mirror> drawn_mirrors(const Params& params, const Derived& derived) {
    std::vector<Mirror> mirrors;
    for (const DerivedPlane& plane : drawn_planes(params, derived))
        if (const double side = plane.eye_side; plane.mirrors && side != 0.0)
            mirrors.push_back({plane, side, is_in_view(plane.patch, derived.clip_from_world)});
    const bool sees_any =
        std::any_of(mirrors.begin(), mirrors.end(), [](const Mirror& mirror) { return mirror.is_in_view; });
    return sees_any ? mirrors : std::vector<Mirror>{};
}

/// Reports how much depth precision is lost or gained by using the mirror as the near plane.
void say_oblique(Sayer& tell, const Params& params, const Derived& derived, const Scene& scene,
                 const FramePlan& frame) {
    constexpr double alike = 1.05;
    const bool tests = params.depth.tests() && params.visibility.method == VisibilityMethod::depth_buffer;
    if (!tests) return;
    const std::optional<ObliqueDepth> depth = oblique_depth(params, derived, scene, frame);
    if (!depth) return;
    const std::string coarser =
        say("the mirror is the image's near plane, which makes depth up to {factor} times coarser, at z = {z}",
            "factor"_a = figures(depth->greatest), "z"_a = figures(depth->coarsest_distance));
    const Lens lens = params.lens();
    const double z = depth->coarsest_distance,
                 step = resolvable_depth_step(lens, params.depth.mapping, derived.stored_depth.precision, z);
    const bool is_visible = depth->greatest * step > visible_share * picture_height(lens, z);
    tell.broken(depth->greatest > alike && is_visible, coarser, "reflection.clip");
    tell(depth->greatest > alike && !is_visible, coarser);
    const std::string least = figures(1.0 / depth->greatest), most = figures(1.0 / depth->least);
    tell(depth->greatest <= alike && 1.0 / depth->least > alike,
         least == most ? say("the mirror is the image's near plane, which makes depth about {factor} times finer",
                             "factor"_a = most)
                       : say("the mirror is the image's near plane, which makes depth {least} to {most} times finer",
                             "least"_a = least, "most"_a = most));
}

/// Reports what clipping removes from the image, and what it fails to remove.
void say_clipping(Sayer& tell, const Params& params, const std::vector<Mirror>& mirrors, const Scene& scene) {
    const ReflectionParams& reflection = params.reflection;
    tell.broken(
        reflection.clip == MirrorClip::oblique && params.depth.logarithm_per_vertex &&
            params.depth.mapping == DepthMapping::logarithmic,
        tr("the per-vertex logarithm overwrites the z that the oblique near plane clips against: nothing is clipped"),
        "reflection.clip");
    const bool is_wrong_side =
        !reflection.side_of_eye &&
        std::any_of(mirrors.begin(), mirrors.end(), [](const Mirror& mirror) { return mirror.is_seen_from_behind(); });
    tell.broken(
        is_wrong_side && reflection.clip == MirrorClip::oblique,
        tr("the mirror is seen from behind, but the oblique near plane keeps the side that the normal points to: "
           "nothing of the image is left for this eye"),
        "reflection.side_of_eye");
    tell.broken(is_wrong_side && reflection.clip != MirrorClip::oblique,
                tr("the mirror is seen from behind, but the side that the normal points to is mirrored: the eye sees "
                   "the image of the objects behind the mirror"),
                "reflection.side_of_eye");
    if (reflection.clip != MirrorClip::none) return;
    for (const Mirror& mirror : mirrors) {
        const std::string across = objects_across(scene, mirror.towards_eye(), -standing);
        if (!across.empty())
            return tell.broken(true,
                               say("the mirror's plane cuts {objects}: the part behind it is mirrored too, and its "
                                   "image sticks out of the mirror",
                                   "objects"_a = across),
                               "reflection.clip");
        const std::string behind = objects_at_most(scene, mirror.towards_eye(), -standing);
        if (!behind.empty())
            return tell.broken(
                true,
                say("{objects} behind the mirror: without clipping, the mirror image appears in front of the mirror",
                    "objects"_a = behind),
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
    const bool is_distorted = (reflection.mirrored == MirroredThing::camera && !reflection.same_projection) ||
                              params.mirror_picture_scale() != 1.0;
    tell.broken(!reflection.stencil && (is_distorted || std::any_of(mirrors.begin(), mirrors.end(), image_is_wider)),
                tr("R reflects across the infinite plane, not just its patch: without the stencil, the image shows "
                   "beyond the mirror's edge"),
                "reflection.stencil");
    const bool is_unmasked = !reflection.stencil && reflection.clip == MirrorClip::none;
    std::string in_front;
    for (const Mirror& mirror : mirrors)
        if (is_unmasked && in_front.empty()) in_front = objects_at_most(scene, mirror.towards_eye(), -standing);
    tell.broken(!in_front.empty(),
                say("without the stencil, the mirror does not cover the image of {objects}, which lies in front of it",
                    "objects"_a = in_front),
                "reflection.stencil");
    tell.broken(
        std::any_of(mirrors.begin(), mirrors.end(),
                    [&](const Mirror& mirror) { return mask_hides(params, derived, mirror, scene); }),
        tr("the mask writes the mirror's own depth: the image lies beyond it, fails the depth test and is hidden"),
        "reflection.mask_writes_depth");
    tell.broken(!reflection.stencil && drawn_planes(params, derived).size() > 1,
                tr("without the stencil, the mirror image shows no other plane and no other mirror"),
                "reflection.stencil");
    tell.broken(reflection.after_objects && reflection.stencil && is_drawn_by_gl_alone(params.visibility.method) &&
                    std::any_of(mirrors.begin(), mirrors.end(), is_covered),
                tr("the mirror is drawn last and without a depth test: it covers the objects in front of it"),
                "reflection.after_objects");
}

/// Reports a mirror whose picture is cleared and drawn over the patches before it too, because they share its stencil
/// value.
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
            return tell.broken(true,
                               say("the planes share one stencil value: the image in plane {plane} is also drawn over "
                                   "{planes}",
                                   "plane"_a = index + 1, "planes"_a = planes_name(covered, planes.size())),
                               "shadow.own_stencil");
    }
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
        tell.broken(slips.plus_2ab && std::abs(entry) > least,
                    say("mistake: row 2, column 1 of R is +2ab = {wrong} instead of −2ab = {right}: R R is not I, and "
                        "the image does not fit its mirror",
                        "wrong"_a = figures(entry, 3), "right"_a = figures(-entry, 3)),
                    "slips.plus_2ab");
        tell.broken(slips.normal_not_unit && std::abs(length - 1.0) > least,
                    say("mistake: R uses (a, b, c, d) as entered, but |n| is {length}, not 1: every point moves |n|² = "
                        "{factor} times the distance to its mirror image",
                        "length"_a = figures(length, 3), "factor"_a = figures(length * length, 3)),
                    "slips.normal_not_unit");
        return;
    }
}

/// Reports errors in the image: its winding, its light, the mirrored camera's projection, and an R filled by rows.
void say_images(Sayer& tell, const Params& params, const Derived& derived, const std::vector<Mirror>& mirrors,
                const Scene& scene) {
    const ReflectionParams& reflection = params.reflection;
    const bool culls = params.cull.enabled && params.cull.face != CullFace::front_and_back;
    tell.broken(!reflection.flip_winding && (culls || params.view.shows == Shows::facing),
                culls ? tr("R turns counterclockwise winding clockwise (det R = −1): without the flip, the image's "
                           "front faces are culled, and the image appears inside out")
                      : tr("R turns counterclockwise winding clockwise (det R = −1): without the flip, the image's "
                           "front faces count as back-facing"),
                "reflection.flip_winding");
    const bool is_hidden = std::all_of(mirrors.begin(), mirrors.end(), [&](const Mirror& mirror) {
        return mask_hides(params, derived, mirror, scene);
    });
    tell.broken(!reflection.reflect_light && !is_hidden,
                tr("the light is not mirrored with the scene: the image is lit from the light's position, not from "
                   "that of the light's image"),
                "reflection.reflect_light");
    tell.broken(reflection.mirrored == MirroredThing::camera && !reflection.same_projection && derived.aspect != 1.0,
                tr("the mirrored camera uses the aspect ratio of a square picture: the image does not fit its mirror"),
                "reflection.same_projection");
    const double scale = params.mirror_picture_scale();
    tell.broken(std::abs(scale - 1.0) > 1e-3,
                say("the picture in the mirror is drawn with fovy {wrong}° instead of the camera's {right}°: the image "
                    "is {scale} times as large as it should be and does not fit its mirror",
                    "wrong"_a = figures(params.reflection.fovy), "right"_a = figures(params.lens().fovy_deg),
                    "scale"_a = figures(scale, 3)),
                "reflection.fovy");

    const auto is_moved = [](const Mirror& mirror) {
        return mirror.distance_from_origin() > 1e-9 && !mirror.plane.mirror_by_hand;
    };
    tell.broken(reflection.printed_by_rows && std::any_of(mirrors.begin(), mirrors.end(), is_moved),
                tr("R is filled row by row as printed, but OpenGL reads columns: Rᵀ has −2d n in its last row, where "
                   "it changes w instead of moving the image"),
                "reflection.printed_by_rows");
}

/// The most reflections to follow along a view ray; no state requests that many bounces.
constexpr int most_followed = 17;

bool are_endless(const Mirror& one, const Mirror& other) {
    return glm::dot(glm::dvec3(one.towards_eye()), glm::dvec3(other.towards_eye())) < -1.0 + 1e-12;
}

/// Returns how often mirrors reflect a view ray that meets `first` at the point `at`. A mirror reflects only on the
/// eye's side.
int reflections_of(const std::vector<Mirror>& mirrors, const Mirror& first, glm::dvec3 at, glm::dvec3 direction) {
    const Mirror* met = &first;
    int count = 0;
    while (met && ++count < most_followed) {
        const glm::dvec3 normal(met->towards_eye());
        direction -= 2.0 * glm::dot(normal, direction) * normal;
        const Mirror* next = nullptr;
        double nearest = std::numeric_limits<double>::infinity();
        for (const Mirror& mirror : mirrors) {
            const double approach = glm::dot(glm::dvec3(mirror.towards_eye()), direction);
            const double way = -glm::dot(mirror.towards_eye(), glm::dvec4(at, 1.0)) / approach;
            if (&mirror == met || !(approach < 0.0) || !(way > 0.0) || way >= nearest) continue;
            if (!mirror.plane.patch.holds(at + way * direction)) continue;
            nearest = way;
            next = &mirror;
        }
        if (next) at += nearest * direction;
        met = next;
    }
    return count;
}

/// Returns the largest number of reflections among a grid of view rays through each mirror's patch.
int most_reflections(const std::vector<Mirror>& mirrors, const glm::dvec4& eye_world) {
    constexpr int grid = 24;
    int most = 0;
    for (const Mirror& mirror : mirrors)
        for (int cell = 0; cell < grid * grid; ++cell) {
            const glm::dvec2 place = (glm::dvec2(cell % grid, cell / grid) + 0.5) * (2.0 / grid) - 1.0;
            const PlanePatch& patch = mirror.plane.patch;
            const glm::dvec3 at = patch.center + patch.extent * (place.x * patch.u + place.y * patch.v);
            most = std::max(most, reflections_of(mirrors, mirror, at, line_of_sight(eye_world, at)));
        }
    return most;
}

/// Reports mirrors that show each other.
void say_bounces(Sayer& tell, const Params& params, const Derived& derived, const std::vector<Mirror>& mirrors,
                 int depth) {
    if (mirrors.size() < 2) return;
    if (!params.reflection.stencil)
        return tell.broken(params.reflection.bounces > 1,
                           say("without the stencil, only the first of {bounces} bounces is drawn",
                               "bounces"_a = params.reflection.bounces),
                           "reflection.stencil");
    bool is_endless = false;
    for (std::size_t one = 0; one < mirrors.size(); ++one)
        for (std::size_t other = one + 1; other < mirrors.size(); ++other)
            is_endless = is_endless || are_endless(mirrors[one], mirrors[other]);
    const int most = is_endless ? most_followed : most_reflections(mirrors, derived.eye_world);
    if (!is_endless && most <= depth) return;
    if (depth < params.reflection.bounces)
        return tell(true, say("{depth} of {bounces} bounces are drawn: more would redraw the scene too often or exceed "
                              "the stencil's range",
                              "depth"_a = depth, "bounces"_a = params.reflection.bounces));
    if (depth == 1) {
        tell.broken(
            is_endless,
            tr("mirrors facing each other reflect endlessly: a mirror seen in a mirror is drawn without its image"),
            "reflection.bounces=8");
        tell(!is_endless && most < most_followed, say("a line of sight hits up to {count} mirrors in a row: a mirror "
                                                      "seen in a mirror is drawn without its image",
                                                      "count"_a = most));
        tell(!is_endless && most == most_followed,
             tr("a line of sight hits mirrors again and again: a mirror seen in a mirror is drawn without its image"));
    } else {
        tell.broken(is_endless, say("mirrors facing each other reflect endlessly: the mirror after {depth} bounces is "
                                    "drawn without its image",
                                    "depth"_a = depth));
        tell(!is_endless && most < most_followed, say("a line of sight hits up to {count} mirrors in a row: the mirror "
                                                      "after {depth} bounces is drawn without its image",
                                                      "count"_a = most, "depth"_a = depth));
        tell(!is_endless && most == most_followed, say("a line of sight hits mirrors again and again: the mirror after "
                                                       "{depth} bounces is drawn without its image",
                                                       "depth"_a = depth));
    }
}

/// Reports missing shadows in the mirror image.
void say_shadows_inside(Sayer& tell, const Params& params, const Derived& derived, const std::vector<Mirror>& mirrors) {
    if (params.reflection.shadows || !params.shadow.enabled) return;
    const auto shows_receiver = [&](const Mirror& mirror) {
        const auto planes = drawn_planes(params, derived);
        return std::any_of(planes.begin(), planes.end(), [&](const DerivedPlane& plane) {
            return &plane != &mirror.plane && plane.receives_shadow &&
                   std::any_of(plane.shadows.begin(), plane.shadows.end(),
                               [](const CastShadow& cast) { return !cast.light_in_plane; });
        });
    };
    tell.broken(std::any_of(mirrors.begin(), mirrors.end(), shows_receiver),
                tr("the mirror image is drawn without shadows: inside the mirror, the objects seem to float"),
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
    if (params.reflection.clip == MirrorClip::oblique) say_oblique(tell, params, derived, scene, frame);
    say_clipping(tell, params, mirrors, scene);
    say_slips(tell, params, derived, mirrors);
    say_images(tell, params, derived, mirrors, scene);
    say_bounces(tell, params, derived, mirrors, frame.reflection_depth);
    say_shadows_inside(tell, params, derived, mirrors);
}

}  // namespace viewing
