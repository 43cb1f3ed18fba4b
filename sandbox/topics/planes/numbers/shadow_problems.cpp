// For each switch of the planar shadow that visibly breaks the picture, reports why. Part of problems.h;
// mirror_problems.cpp is its counterpart.
#include <algorithm>
#include <array>
#include <cmath>

#include "frame/cleared_code.h"
#include "frame/depth_switches.h"
#include "frame/lighting.h"
#include "frame/object_reach.h"
#include "frame/say.h"
#include "text/words.h"
#include "topics/planes/numbers/drawn_mirrors.h"

namespace viewing {
namespace {

/// Returns S without the mistake of filling it by rows.
glm::dmat4 right_shadow(const DerivedPlane& plane, const CastShadow& cast) {
    return cast.has_slip ? shadow_matrix(plane.unit_plane, cast.light_world) : cast.shadowed_world_from_world;
}

/// Returns sign · S. If S is filled by rows, or the shadow is lifted, points do not land on the plane: a projection
/// from the eye then sends them to where the eye sees them on the plane.
glm::dmat4 seen_on_patch(const ShadowParams& shadow, const DerivedPlane& plane, const CastShadow& cast, double sign,
                         const glm::dvec4& eye_world) {
    const glm::dmat4 landed = sign * cast.shadowed_world_from_world;
    const bool is_lifted = shadow.style == ShadowStyle::blend && shadow.offset == ShadowOffset::lift;
    if (!cast.has_slip && !is_lifted) return landed;
    glm::dmat4 lifted_from_plane(1.0);
    if (is_lifted)
        lifted_from_plane[3] = glm::dvec4(shadow.lift * glm::dvec3(plane_facing(plane.unit_plane, eye_world)), 1.0);
    return seen_on_plane(plane.unit_plane, eye_world) * lifted_from_plane * landed;
}

/// A shadow that the frame draws.
struct Thrown {
    const DerivedPlane& plane;
    const CastShadow& cast;
    Message light_name, plane_name;
    bool has_anti_shadow = false;  ///< and the anti-shadow may be seen
    bool is_drawn = true;          ///< false: an S filled by rows sends it out of the picture

    double side() const { return cast.plane_dot_light < 0.0 ? -1.0 : 1.0; }
    glm::dvec4 towards_light() const { return side() * plane.unit_plane; }
    /// Returns a vector whose dot product with p is the correct w of p's projection: positive between the light and the
    /// plane.
    glm::dvec4 right_w() const { return side() * glm::transpose(right_shadow(plane, cast))[3]; }
    bool is_from_point() const { return cast.light_world.w > 0.0; }
};

/// The part of a shadow to judge. For `shadow`, w has its correct, positive sign, even if nothing corrects a negative
/// w. `anti_shadow`: thrown by casters beyond the light if the sign of w is forced.
enum class Part { shadow, anti_shadow };

/// Where a part of a shadow lies, and forms that are positive at the points of the casters that throw it.
struct Landed {
    glm::dmat4 world_from_world;
    std::vector<glm::dvec4> forms;
};

/// Returns the part of a shadow where all forms in `seen` are positive; none for an S entered by hand. The forms take a
/// point of the plane. `on_patch`: returns only the part on the plane's patch.
std::optional<Landed> landed_part(const ShadowParams& shadow, const DerivedPlane& plane, const CastShadow& cast,
                                  Part part, std::span<const glm::dvec4> seen, bool on_patch) {
    if (cast.by_hand) return std::nullopt;
    const double side = cast.plane_dot_light < 0.0 ? -1.0 : 1.0, sign = part == Part::shadow ? 1.0 : -1.0;
    // If S is filled by rows, judge the right shadow, which that mistake may move out of the picture.
    Landed landed{sign * side * right_shadow(plane, cast), {}};
    landed.forms.push_back(glm::transpose(landed.world_from_world)[3]);
    for (const glm::dvec4& form : seen) landed.forms.push_back(form * landed.world_from_world);
    if (shadow.clip_casters) landed.forms.push_back(side * plane.unit_plane);
    if (on_patch)
        for (const glm::dvec4& edge : forms_of_edges(landed.world_from_world, plane.patch))
            landed.forms.push_back(edge);
    return landed;
}

/// Returns whether part of a shadow may be in the picture, on a patch that is drawn.
bool may_be_seen(const Params& params, const Derived& derived, const Scene& scene, const DerivedPlane& plane,
                 const CastShadow& cast, Part part) {
    const bool on_patch = params.shadow.clip_to_receiver;
    if (on_patch && !may_show(plane.patch, params, derived)) return false;
    const std::vector<glm::dvec4> frustum = forms_of_frustum(derived.clip_from_world);
    const std::optional<Landed> landed = landed_part(params.shadow, plane, cast, part, frustum, on_patch);
    return !landed || may_see(params, derived, scene, landed->forms, landed->world_from_world);
}

/// Returns whether part of a shadow may be seen in a mirror, which shows the shadow only on the plane's patch.
bool may_be_mirrored(const Params& params, const Derived& derived, const Scene& scene, const DerivedPlane& plane,
                     const CastShadow& cast, Part part, std::span<const WayThroughMirrors> ways) {
    constexpr std::size_t most_forms = 32;
    const auto index = static_cast<std::size_t>(&plane - derived.planes.data());
    return params.reflection.stencil && std::any_of(ways.begin(), ways.end(), [&](const WayThroughMirrors& way) {
               if (way.mirrors.back() == index) return false;
               const std::optional<Landed> landed = landed_part(params.shadow, plane, cast, part, way.inside, true);
               // Through so many mirrors that there are more forms, hardly a pixel shows the shadow.
               return !landed || (landed->forms.size() <= most_forms && may_reach(scene, landed->forms));
           });
}

/// Returns whether the shadow that S really draws may be in the picture.
bool is_drawn_in_picture(const Params& params, const Derived& derived, const Scene& scene, const DerivedPlane& plane,
                         const CastShadow& cast) {
    const glm::dmat4 drawn = cast.sign * cast.shadowed_world_from_world,
                     seen = seen_on_patch(params.shadow, plane, cast, cast.sign, derived.eye_world);
    std::vector<glm::dvec4> forms = forms_of_frustum(derived.clip_from_world * drawn);
    if (params.shadow.clip_casters) forms.push_back(plane_facing(plane.unit_plane, cast.light_world));
    if (params.shadow.clip_to_receiver)
        for (const glm::dvec4& edge : forms_of_edges(seen, plane.patch)) forms.push_back(edge);
    return may_reach(scene, forms);
}

/// Returns the shadows that may be in the picture, either directly or in a mirror.
std::vector<Thrown> thrown_shadows(const Params& params, const Derived& derived, const Scene& scene,
                                   const FramePlan& frame) {
    std::vector<Thrown> thrown;
    const ShadowParams& shadow = params.shadow;
    if (!shadow.enabled) return thrown;
    const std::span<const DerivedPlane> planes = drawn_planes(params, derived);
    const std::vector<WayThroughMirrors> ways = ways_through_mirrors(params, derived, frame);
    const bool is_forced = shadow.sign == ShadowSign::forced && !shadow.clip_at_light;
    for (std::size_t plane = 0; plane < planes.size(); ++plane) {
        const std::vector<CastShadow>& shadows = planes[plane].shadows;
        for (std::size_t light = 0; light < shadows.size(); ++light) {
            if (!planes[plane].receives_shadow || !shadows[light].reaches(planes[plane].eye_side)) continue;
            const auto is_seen = [&](Part part) {
                return may_be_seen(params, derived, scene, planes[plane], shadows[light], part) ||
                       (params.reflection.shadows &&
                        may_be_mirrored(params, derived, scene, planes[plane], shadows[light], part, ways));
            };
            Thrown one{planes[plane], shadows[light], light_name(light, shadows.size()),
                       planes_name(std::array{plane}, planes.size())};
            if (shadows[light].has_slip)
                one.is_drawn = is_drawn_in_picture(params, derived, scene, planes[plane], shadows[light]);
            // Triangles that cross w = 0 stretch to infinity, through the picture.
            one.has_anti_shadow =
                is_forced && (is_seen(Part::anti_shadow) || !objects_across(scene, one.right_w(), 0.0).empty());
            if (one.has_anti_shadow || is_seen(Part::shadow)) thrown.push_back(one);
        }
    }
    return thrown;
}

/// Reports casters beyond a point light. Returns whether there are any. A −S entered by hand has its own sentence:
/// by_hand.negative_w.
bool say_beyond(Sayer& tell, const ShadowParams& shadow, const Thrown& one, const Scene& scene) {
    if (one.cast.by_hand && w_between(one.plane, one.cast) < 0.0) return false;
    const Message beyond = one.is_from_point() ? objects_at_most(scene, one.right_w(), 0.0) : Message();
    if (beyond.empty()) return false;
    const Message across = shadow.clip_at_light ? Message() : objects_across(scene, one.right_w(), 0.0);
    if (one.has_anti_shadow)
        across.empty()
            ? tell.broken(
                  true,
                  sentence("shadow.anti_shadow",
                           "the part of {objects} beyond the light has w ≤ 0: the sign of w is forced, so this part "
                           "casts an anti-shadow",
                           "objects"_a = beyond),
                  "shadow.sign")
            : tell.broken(
                  true,
                  sentence("shadow.anti_shadow",
                           "the part of {objects} beyond the light has w ≤ 0: the sign of w is forced, so this part "
                           "casts an anti-shadow, and triangles that cross w = 0 stretch to infinity",
                           "objects"_a = beyond),
                  "shadow.clip_at_light");
    else if (!across.empty())
        tell(true,
             sentence("shadow.to_infinity",
                      "the plane w = 0 through the light cuts {objects}: the shadow extends to infinity, and only "
                      "GL's clipping removes the part beyond (w ≤ 0)",
                      "objects"_a = across));
    else
        tell(true,
             sentence("shadow.beyond_light",
                      "the part of {objects} that is not between {light} and {plane} (w ≤ 0 there) casts no shadow",
                      "objects"_a = beyond, "light"_a = one.light_name, "plane"_a = one.plane_name));
    return true;
}

/// Reports casters that are not between the light and the plane, and the effects of the switches on them. Returns
/// whether any shadow is left.
bool say_casters(Sayer& tell, const ShadowParams& shadow, const std::vector<Thrown>& thrown, const Derived& derived,
                 const Scene& scene) {
    std::vector<Message> vanishing;
    for (const Thrown& one : thrown)
        if (shadow.sign == ShadowSign::none && one.side() < 0.0 &&
            lands_inside(scene, {seen_on_patch(shadow, one.plane, one.cast, one.side(), derived.eye_world),
                                 derived.clip_from_world, one.towards_light(), one.plane.patch}))
            vanishing.push_back(message("{light} on {plane}", "light"_a = one.light_name, "plane"_a = one.plane_name));
    const bool vanishes = !vanishing.empty(), all_vanish = vanishing.size() == thrown.size();
    tell.broken(
        vanishes && all_vanish,
        sentence("shadow.vanishes",
                 "S is uploaded unchanged, and n·ℓ + d < 0: every caster gets a negative w, so clipping removes "
                 "every shadow"),
        "shadow.sign");
    tell.broken(
        vanishes && !all_vanish,
        sentence("shadow.vanishes",
                 "S is uploaded unchanged, and n·ℓ + d < 0 for {shadows}: every caster gets a negative w, so clipping "
                 "removes that shadow",
                 "shadows"_a = enumerated(vanishing)),
        "shadow.sign");
    for (const Thrown& one : thrown) {
        const Message names = shadow.clip_casters ? Message() : objects_at_most(scene, one.towards_light(), -standing);
        if (names.empty()) continue;
        tell.broken(
            true,
            sentence("shadow.false_shadow",
                     "behind the plane, w is positive too: the part of {objects} there is not clipped and casts a "
                     "false shadow",
                     "objects"_a = names),
            "shadow.clip_casters");
        break;
    }
    if (all_vanish && vanishes) return false;
    for (const Thrown& one : thrown)
        if (say_beyond(tell, shadow, one, scene)) break;
    return true;
}

/// Returns by how many codes a polygon offset moves a surface that lies in a plane, away from the eye if positive. The
/// window depth of a plane grows evenly over the picture.
double codes_of_offset(const DepthOffset& offset, const Derived& derived, const glm::dvec4& plane) {
    const glm::dvec4 in_clip = plane * glm::inverse(derived.clip_from_world);
    const glm::dvec2 picture = glm::dvec2(derived.view_px) * (derived.clip_zero_to_one ? 0.5 : 1.0);
    const double slope = std::max(std::abs(in_clip.x / picture.x), std::abs(in_clip.y / picture.y)) /
                         std::abs(in_clip.z);  // in window depths per pixel
    const StoredDepth& stored = derived.stored_depth;
    return (offset.factor == 0.0 ? 0.0 : offset.factor * slope / code_width(stored.precision, 1.0)) +
           offset.units * stored.unit_codes.value_or(1.0);
}

constexpr double least_rounding = 1.5, most_rounding = 2.0;  ///< in codes, as seen in pictures

/// Reports a polygon offset no greater than rounding.
void say_weak_offset(Sayer& tell, const Params& params, const Derived& derived, const std::vector<Thrown>& thrown) {
    const DepthOffset offset{params.shadow.offset_factor, params.shadow.offset_units};
    // A slope's share covers the rounding of the slope, and a unit that of the depth itself.
    const bool covers_rounding = offset.factor <= -0.5 && offset.units <= -1.0;
    if (covers_rounding || has_bent_depth(params.depth) || derived.stored_depth.precision.is_float) return;
    for (const Thrown& one : thrown) {
        const double codes = codes_of_offset(offset, derived, one.plane.unit_plane);
        if (one.cast.has_slip || codes <= -least_rounding || codes > most_rounding) continue;
        return tell.broken(true,
                           sentence("shadow.weak_offset",
                                    "the polygon offset of {codes}, in codes of depth, is no greater than rounding: "
                                    "shadow and plane may fight",
                                    "codes"_a = figures(codes, 2)),
                           offset.units <= -1.0    ? "shadow.offset_factor"
                           : offset.factor <= -0.5 ? "shadow.offset_units"
                                                   : "shadow.offset=no_depth_test");
    }
}

/// Reports problems with the offset that keeps a painted shadow from fighting with its plane.
void say_offset(Sayer& tell, const Params& params, const Derived& derived, const std::vector<Thrown>& thrown) {
    const ShadowParams& shadow = params.shadow;
    const bool tests = params.tests_depth() && params.depth.func != CompareFunc::always;
    if (!tests) return;
    const bool by_polygon = shadow.offset == ShadowOffset::polygon_offset,
               by_lift = shadow.offset == ShadowOffset::lift;
    const double factor = shadow.offset_factor, units = shadow.offset_units;
    const bool is_nothing = shadow.offset == ShadowOffset::none || (by_polygon && factor == 0.0 && units == 0.0) ||
                            (by_lift && shadow.lift == 0.0);
    // An S filled by rows lifts the shadow off the plane.
    const bool lies_in_plane =
        std::any_of(thrown.begin(), thrown.end(), [](const Thrown& one) { return !one.cast.has_slip; });
    const bool hides = params.depth.write;  // otherwise, no plane hides its shadow
    if (is_nothing)
        return tell.broken(lies_in_plane && hides,
                           sentence("shadow.fights",
                                    "nothing lifts the shadow off its plane: the two depths differ only by rounding, "
                                    "so the surfaces fight"),
                           shadow.offset == ShadowOffset::none ? "shadow.offset" : "shadow.offset=no_depth_test");
    const auto pushes = [&](const DepthOffset& offset) {
        const auto is_pushed = [&](const Thrown& one) {
            return codes_of_offset(offset, derived, one.plane.unit_plane) > most_rounding;
        };
        const bool is_even = !has_bent_depth(params.depth) && !thrown.empty();
        return (offset.factor >= 0.0 && offset.units >= 0.0) ||
               (is_even && std::all_of(thrown.begin(), thrown.end(), is_pushed));
    };
    // Then it pulls nearer what it should push away, and the other way round: depth.reversed_offset says so.
    const bool keeps_sign = keeps_offset_sign(params.depth);
    const bool is_pushed = hides && by_polygon && !keeps_sign && pushes({factor, units});
    const bool helps = is_pushed && !pushes({ShadowParams{}.offset_factor, units});  // the usual factor
    tell.broken(
        is_pushed,
        sentence("shadow.pushed_away", "the polygon offset pushes the shadow away from the eye: the plane hides it"),
        helps ? "shadow.offset_factor" : "");
    if (hides && by_polygon && !is_pushed && !keeps_sign) say_weak_offset(tell, params, derived, thrown);
    tell.broken(
        hides && shadow.write_depth && shadow.offset != ShadowOffset::no_depth_test,
        sentence("shadow.writes_depth",
                 "the shadow writes its depth, offset included: the stored depths are no longer the plane's own"),
        "shadow.write_depth");
    // The smallest shift that shows in a large picture, as a fraction of its height.
    constexpr double least_shift = 2e-4;
    const auto is_seen_floating = [&](const Thrown& one) {
        const double z = -(derived.view_from_world * glm::dvec4(one.plane.patch.center, 1.0)).z;
        const glm::dvec3 sight = line_of_sight(derived.eye_world, one.plane.patch.center);
        const double sine =
            derived.eye_world.w == 0.0 ? glm::length(glm::cross(glm::dvec3(one.plane.unit_plane), sight)) : 1.0;
        return !one.cast.has_slip &&
               sine * shadow.lift >
                   least_shift * std::abs(picture_height(params.lens(), std::max(z, params.projection.near)));
    };
    tell.broken(
        by_lift && std::any_of(thrown.begin(), thrown.end(), is_seen_floating),
        sentence("shadow.floats",
                 "the shadow floats {height} above the plane: at a grazing angle it slides away from its caster",
                 "height"_a = figures(shadow.lift, 3)),
        // The offset that then applies may push the shadow away.
        shadow.offset_factor < 0.0 && shadow.offset_units < 0.0
            ? "shadow.offset"
            : R"(shadow={"offset": "polygon_offset", "offset_factor": -1, "offset_units": -1})");
}

/// Returns whether part of a shadow in the picture may fall where the light's highlight is bright enough to see.
bool may_reach_highlight(const Derived& derived, const Thrown& one, const Scene& scene) {
    constexpr int most = 24;
    constexpr double least = 1.0 / 512.0;
    const PlanePatch& patch = one.plane.patch;
    const glm::dvec3 normal(plane_facing(one.plane.unit_plane, derived.eye_world));
    const auto point = [&patch](const glm::dvec2& place) {
        return patch.center + patch.extent * (place.x * patch.u + place.y * patch.v);
    };
    glm::dvec2 low(2.0), high(-2.0);
    for (int cell = 0; cell < (2 * most + 1) * (2 * most + 1); ++cell) {
        const glm::dvec2 place = glm::dvec2(cell % (2 * most + 1), cell / (2 * most + 1)) / double{most} - 1.0;
        const glm::dvec3 at = point(place);
        const glm::dvec3 to_light = glm::normalize(glm::dvec3(one.cast.light_world) - one.cast.light_world.w * at);
        const double shine = glm::dot(normal, glm::normalize(to_light - line_of_sight(derived.eye_world, at)));
        if (highlight_light * std::pow(std::max(shine, 0.0), shininess) < least) continue;
        low = glm::min(low, place);
        high = glm::max(high, place);
    }
    if (low.x > high.x) return false;
    PlanePatch bright = patch;
    bright.center = point(0.5 * (low + high));
    bright.extent *= 0.5 * std::max(high.x - low.x, high.y - low.y) + 1.0 / most;
    const glm::dmat4 landed = one.cast.sign * one.cast.shadowed_world_from_world;
    std::vector<glm::dvec4> forms = {glm::transpose(landed)[3]};
    for (const glm::dvec4& side : forms_of_sides(derived.clip_from_world * landed)) forms.push_back(side);
    for (const glm::dvec4& edge : forms_of_edges(landed, bright)) forms.push_back(edge);
    return may_reach(scene, forms);
}

/// Reports errors of painted shadows that would not occur with shadows drawn as missing light.
void say_paint(Sayer& tell, const ShadowParams& shadow, const Derived& derived, const std::vector<Thrown>& thrown,
               const Scene& scene) {
    tell.broken(
        !shadow.stencil_once && shadow.opacity > 0.0 && shadow.opacity < 1.0 &&
            std::any_of(thrown.begin(), thrown.end(), [](const Thrown& one) { return one.is_drawn; }),
        sentence("shadow.blended_twice",
                 "each face of each caster is blended separately: unless the stencil counts them, the shadow is "
                 "darker wherever faces overlap"),
        "shadow.stencil_once");
    const bool has_gloss = std::any_of(thrown.begin(), thrown.end(), [&](const Thrown& one) {
        return one.plane.gloss && may_reach_highlight(derived, one, scene);
    });
    tell.broken(
        has_gloss && shadow.opacity > 0.0,
        sentence(
            "shadow.keeps_highlight",
            "blending only darkens the highlight, which should be gone: where no light arrives, nothing can shine"),
        "shadow.style=missing_light");
    tell.broken(shadow.opacity >= 1.0,
                sentence("shadow.opaque",
                         "opacity 1 covers the plane's pattern: in a true shadow, ambient light still shows it"),
                "shadow.style=missing_light");
}

/// Returns whether another plane's patch covers a point beyond the edge of a shadow's own patch, as the eye sees it. A
/// patch that is drawn later covers the point, since shadows write no depth; one that is drawn earlier does so only if
/// it is nearer.
bool is_under_patch(const Params& params, const Derived& derived, const DerivedPlane& receiver,
                    const glm::dvec3& point) {
    bool is_earlier = true;
    for (const DerivedPlane& other : drawn_planes(params, derived)) {
        if (&other == &receiver) {
            is_earlier = false;
            continue;
        }
        if (other.eye_side == 0.0) continue;
        const glm::dvec4 at(point, 1.0), seen = seen_on_plane(other.unit_plane, derived.eye_world) * at;
        const bool is_behind = glm::dot(plane_facing(other.unit_plane, derived.eye_world), at) < 0.0;
        if (seen.w > 0.0 && (!is_earlier || is_behind) && other.patch.holds(glm::dvec3(seen) / seen.w)) return true;
    }
    return false;
}

/// Returns whether the picture shows a part of a shadow that is beyond its patch. If the depths of the previous frame
/// hide the patch, the whole shadow counts as beyond it, unless the patch is drawn without a depth test.
bool is_seen_beyond(const Params& params, const Derived& derived, const Thrown& one, const Scene& scene) {
    const ReflectionParams& reflection = params.reflection;
    const bool is_untested = reflection.enabled && reflection.after_objects && reflection.stencil && one.plane.mirrors;
    if (previous_frame_hides(params) && !is_untested) return true;
    const glm::dmat4 landed = seen_on_patch(params.shadow, one.plane, one.cast, one.cast.sign, derived.eye_world);
    Landing landing{landed, derived.clip_from_world, one.towards_light(), one.plane.patch};
    landing.is_covered = [&](const glm::dvec3& point) { return is_under_patch(params, derived, one.plane, point); };
    return lands_beyond(scene, landing);
}

/// Returns whether a shadow may also show on another patch that was drawn before the shadow's own and has the same
/// stencil value: the shadow is in the picture and, seen from the eye, in front of that patch's plane.
bool may_leak(const Params& params, const Derived& derived, const Thrown& shadow, const Scene& scene) {
    const glm::dmat4 landed = shadow.cast.sign * shadow.cast.shadowed_world_from_world;
    const glm::dmat4 clip_from_world = derived.clip_from_world * landed;
    const bool tests = params.depth.tests() && params.shadow.offset != ShadowOffset::no_depth_test;
    for (const DerivedPlane& before : derived.planes) {
        if (&before == &shadow.plane) return false;
        if (before.eye_side == 0.0) continue;
        std::vector<glm::dvec4> forms = {glm::transpose(clip_from_world)[3]};
        for (const glm::dvec4& side : forms_of_sides(clip_from_world)) forms.push_back(side);
        if (params.shadow.clip_casters) forms.push_back(shadow.towards_light());
        if (tests) forms.push_back(plane_facing(before.unit_plane, derived.eye_world) * landed);
        const glm::dmat4 seen = seen_on_plane(before.unit_plane, derived.eye_world) * landed;
        for (const glm::dvec4& edge : forms_of_edges(seen, before.patch)) forms.push_back(edge);
        if (may_reach(scene, forms)) return true;
    }
    return false;
}

/// Reports an S filled by rows. With ℓ on the plane's normal, S is symmetric and nothing is wrong.
void say_rows(Sayer& tell, const std::vector<Thrown>& thrown) {
    for (const Thrown& one : thrown) {
        if (!one.cast.has_slip) continue;
        // The point to which Sᵀ sends the patch's center; S keeps the center in place.
        const glm::dvec4 sent = one.cast.shadowed_world_from_world * glm::dvec4(one.plane.patch.center, 1.0);
        const double height = glm::dot(one.plane.unit_plane, sent) / sent.w;
        return tell.broken(
            true,
            std::isfinite(height)
                ? sentence(
                      "shadow.by_rows",
                      "mistake: S is filled by rows, but OpenGL reads columns: Sᵀ sends the center of {plane} {height} "
                      "away from the plane, so the shadow does not lie in it",
                      "plane"_a = one.plane_name, "height"_a = figures(std::abs(height), 3))
                : sentence("shadow.by_rows",
                           "mistake: S is filled by rows, but OpenGL reads columns: Sᵀ sends the center of {plane} to "
                           "infinity, so the shadow does not lie in it",
                           "plane"_a = one.plane_name),
            "slips.shadow_by_rows");
    }
}

}  // namespace

bool may_show_shadows(const Params& params, const Derived& derived, const Scene& scene, const FramePlan& frame) {
    return !thrown_shadows(params, derived, scene, frame).empty();
}

bool may_mirror_shadows(const Params& params, const Derived& derived, const Scene& scene, const FramePlan& frame) {
    const std::span<const DerivedPlane> planes = drawn_planes(params, derived);
    const std::vector<WayThroughMirrors> ways = ways_through_mirrors(params, derived, frame);
    return std::any_of(planes.begin(), planes.end(), [&](const DerivedPlane& plane) {
        return plane.receives_shadow &&
               std::any_of(plane.shadows.begin(), plane.shadows.end(), [&](const CastShadow& cast) {
                   return !cast.light_in_plane &&
                          may_be_mirrored(params, derived, scene, plane, cast, Part::shadow, ways);
               });
    });
}

void find_shadow_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived,
                          const Scene& scene, const FramePlan& frame) {
    const std::vector<Thrown> thrown = thrown_shadows(params, derived, scene, frame);
    if (thrown.empty() || !shows_effects(params)) return;
    const ShadowParams& shadow = params.shadow;
    Sayer tell(problems, "shadow");
    if (!say_casters(tell, shadow, thrown, derived, scene)) return;
    say_rows(tell, thrown);
    if (shadow.style == ShadowStyle::blend) {
        std::vector<Thrown> beyond;
        if (!shadow.clip_to_receiver)
            std::copy_if(thrown.begin(), thrown.end(), std::back_inserter(beyond),
                         [&](const Thrown& one) { return is_seen_beyond(params, derived, one, scene); });
        // With an S filled by rows, the plane or an object may hide the part beyond the edge.
        const bool is_sure =
            std::any_of(beyond.begin(), beyond.end(), [](const Thrown& one) { return !one.cast.has_slip; });
        tell.broken(
            !beyond.empty(),
            sentence("shadow.beyond_edge",
                     "S projects onto the infinite plane, not its patch: without the stencil, the shadow continues "
                     "past the floor's edge into the air"),
            is_sure ? "shadow.clip_to_receiver" : "");
        say_paint(tell, shadow, derived, thrown, scene);
        say_offset(tell, params, derived, thrown);
    }
    if (shadow.own_stencil) return;
    const bool lights = derived.lights_world.size() > 1 && thrown.size() > 1,
               planes = shadow.style == ShadowStyle::blend &&
                        std::any_of(thrown.begin(), thrown.end(),
                                    [&](const Thrown&one) { return may_leak(params, derived, one, scene); });
    tell.broken(
        lights && !planes,
        sentence("shadow.shared_stencil",
                 "the lights share one stencil bit: where one light's shadow was counted, another's is missing"),
        "shadow.own_stencil");
    tell.broken(planes,
                lights
                    ? sentence("shadow.shared_stencil",
                               "planes and lights share one stencil value: where one shadow was counted, the next is "
                               "missing, and shadows leak from plane to plane")
                    : sentence("shadow.shared_stencil",
                               "the planes share one stencil value: where one shadow was counted, the next is missing, "
                               "and shadows leak from plane to plane"),
                "shadow.own_stencil");
}

}  // namespace viewing
