// Reports what each switch of the depth buffer does to the picture. Part of problems.h.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "frame/cleared_code.h"
#include "frame/depth_switches.h"
#include "frame/object_reach.h"
#include "frame/say.h"
#include "text/words.h"
#include "topics/depth/numbers/decals.h"
#include "topics/depth/numbers/fighting.h"
#include "topics/depth/numbers/near_advice.h"

namespace viewing {
namespace {

/// The extent of a flat object in the picture and in depth.
struct FlatExtent {
    double nearest = std::numeric_limits<double>::infinity(), farthest = -nearest;
    glm::dvec2 min{nearest}, max{-nearest};

    bool overlaps(const FlatExtent& other) const {
        return min.x < other.max.x && other.min.x < max.x && min.y < other.max.y && other.min.y < max.y;
    }
};

/// Returns whether the planes, which are drawn first, need no depth test: of any two, the later one is in front, and no
/// object reaches behind a plane.
bool planes_are_painted_right(const Params& params, const Derived& derived, const Scene& scene) {
    const std::span<const DerivedPlane> planes = drawn_planes(params, derived);
    // Whether a patch is on the eye's side of another plane (`sign` 1) or on the other side (−1).
    const auto is_on_side = [](const DerivedPlane& one, const DerivedPlane& of, double sign) {
        const std::array<glm::dvec3, 4> corners = one.patch.corners();
        return std::all_of(corners.begin(), corners.end(), [&](const glm::dvec3& corner) {
            return sign * of.eye_side * glm::dot(of.unit_plane, glm::dvec4(corner, 1.0)) >= 0.0;
        });
    };
    for (std::size_t later = 0; later < planes.size(); ++later) {
        const DerivedPlane& plane = planes[later];
        const glm::dvec4 towards_eye = std::copysign(1.0, plane.eye_side) * plane.unit_plane;
        if (plane.eye_side != 0.0 && !objects_at_most(scene, towards_eye, -standing).empty()) return false;
        for (std::size_t first = 0; first < later; ++first)
            if (!is_on_side(plane, planes[first], 1.0) && !is_on_side(planes[first], plane, -1.0)) return false;
    }
    return true;
}

/// Returns whether the scene needs no depth test: it has few objects, all flat, each drawn before those in front of it.
bool is_painted_right(const Params& params, const Derived& derived, const Scene& scene) {
    constexpr std::size_t few = 64;
    if (scene.objects.size() > few || !planes_are_painted_right(params, derived, scene)) return false;
    std::vector<FlatExtent> drawn;
    for (const SceneObject& object : scene.objects) {
        if (object.mesh->triangle_count() > 2) return false;
        FlatExtent extent;
        for (const glm::vec3& position : object.mesh->positions) {
            const glm::dvec4 view = derived.view_from_world * object.world_from_model * glm::dvec4(position, 1.0);
            const glm::dvec4 clip = derived.clip_from_view * view;
            if (!(clip.w > 0.0)) return false;
            const glm::dvec2 ndc = glm::dvec2(clip) / clip.w;
            extent.nearest = std::min(extent.nearest, -view.z);
            extent.farthest = std::max(extent.farthest, -view.z);
            extent.min = glm::min(extent.min, ndc);
            extent.max = glm::max(extent.max, ndc);
        }
        for (const FlatExtent& before : drawn)
            if (extent.overlaps(before) && extent.farthest > before.nearest) return false;
        drawn.push_back(extent);
    }
    return true;
}

void say_tests(Sayer& tell, const Params& params, const Derived& derived, const Scene& scene) {
    const DepthParams& depth = params.depth;
    // If two switches let the last fragment win, fixing one of them changes nothing.
    const auto alone = [&depth](const char* fix) {
        return count_of_last_wins(depth) == 1
                   ? fix
                   : R"(depth={"buffer": true, "test": true, "write": true, "func": "less"})";
    };
    if (!depth.buffer) {
        tell.broken(
            true,
            sentence("depth.no_buffer",
                     "the window has no depth buffer (GLUT_DEPTH is missing): whatever the settings, the depth test "
                     "always passes and the last fragment drawn wins"),
            alone("depth.buffer"));
        return;
    }
    if (!depth.test) {
        tell.broken(
            true,
            sentence("depth.test_off",
                     "depth test off: the last fragment drawn wins, and no depth is written either, so the depth "
                     "buffer keeps its cleared value"),
            alone("depth.test"));
        return;
    }
    tell.broken(depth.func == CompareFunc::always && !is_painted_right(params, derived, scene),
                depth.write
                    ? sentence("depth.always",
                               "GL_ALWAYS: the last fragment drawn wins, as with the test off, but here depth is still "
                               "written")
                    : sentence("depth.always", "GL_ALWAYS: the last fragment drawn wins, as with the test off"),
                alone("depth.func"));
    tell.broken(
        depth.func == CompareFunc::notequal && !is_painted_right(params, derived, scene),
        sentence("depth.notequal", "GL_NOTEQUAL: the last fragment drawn wins, unless its depth equals the stored one"),
        alone("depth.func"));
    const bool is_closed = depth.func == CompareFunc::never || depth.func == CompareFunc::equal;
    const bool wants_farther = depth.func == CompareFunc::greater || depth.func == CompareFunc::gequal;
    const bool has_codes = !((is_closed || wants_farther) && has_only_cleared_code(params, derived, scene));
    const char* const as_usual = clears_to_nearest(depth) ? "" : has_codes ? "depth.func" : "depth.func=lequal";
    tell.broken(depth.func == CompareFunc::never, sentence("depth.never", "GL_NEVER: no fragment passes"), as_usual);
    tell.broken(
        depth.func == CompareFunc::greater && rejects_all(depth),
        sentence("depth.only_farther",
                 "only farther fragments pass, and nothing is farther than the depth that the buffer is cleared to"),
        as_usual);
    tell.broken(
        depth.func == CompareFunc::gequal && rejects_all(depth),
        sentence("depth.only_farther",
                 "only fragments at least as far as the stored depth pass, and nothing is farther than the depth that "
                 "the buffer is cleared to: only what has its code is drawn"),
        has_codes ? as_usual : "");
    tell.broken(depth.func == CompareFunc::equal && (has_codes || !is_cleared_to_farthest(depth)),
                sentence("depth.equal", "GL_EQUAL: only fragments at exactly the stored depth pass"), as_usual);
    tell.broken(
        !depth.write && !rejects_all(depth),
        sentence("depth.mask_off",
                 "depth mask off: surfaces are tested but write no depth, so they hide nothing that is drawn later"),
        alone("depth.write"));
}

/// Reports a buffer that is cleared to a depth other than the farthest.
void say_clear_value(Sayer& tell, const Params& params, const Derived& derived, const Scene& scene,
                     const std::vector<SeenImage>& images) {
    const DepthParams& depth = params.depth;
    const bool is_reversed = depth.mapping == DepthMapping::reversed;
    if (!depth.tests() || clears_to_farthest(depth)) return;
    const std::string value = figures(cleared_depth(depth), 3);
    if (depth.func == CompareFunc::greater || depth.func == CompareFunc::gequal)
        return tell.broken(true,
                           sentence("depth.farthest_wins",
                                    "depth is cleared to {value} and farther fragments pass: the farthest surface wins",
                                    "value"_a = value));
    if (!wants_nearer(depth)) return;
    const bool is_fixed =
        depth.func != CompareFunc::less || !has_only_cleared_code(params, derived, scene);  // which GL_LESS rejects
    if (clears_to_nearest(depth)) {
        if (is_reversed && !depth.reversed_clear)
            return tell.broken(true,
                               sentence("depth.reversed_clear",
                                        "reversed depth is 0 at the far plane, but the buffer is cleared to 1: nothing "
                                        "can be nearer, so nothing is drawn"),
                               is_fixed ? "depth.reversed_clear" : "");
        return tell.broken(true,
                           sentence("depth.clear_value",
                                    "glClearDepth({value}) is the nearest depth: nothing can be nearer, so nothing is "
                                    "drawn",
                                    "value"_a = value),
                           is_fixed ? "depth.clear_value" : "");
    }
    const double z = distance_of_window_depth(params.lens(), depth.mapping, cleared_depth(depth));
    const std::vector<SeenThing> seen = seen_things(params, derived, scene);
    const bool cuts =
        std::any_of(seen.begin(), seen.end(), [z](const SeenThing& thing) { return thing.farthest > z; }) ||
        std::any_of(images.begin(), images.end(), [z](const SeenImage& image) { return image.farthest > z; });
    tell.broken(cuts,
                sentence("depth.clear_value_cuts",
                         "glClearDepth({value}): every pixel starts with the depth of z = {z}, so nothing beyond is "
                         "drawn",
                         "value"_a = value, "z"_a = figures(z, 3)),
                is_reversed && !depth.reversed_clear ? "depth.clear_value=0" : "depth.clear_value");
}

/// Returns whether the only plane is a mirror that is drawn last, without a depth test, over everything in the picture;
/// the picture then shows only what is drawn inside the mask, where depth is cleared.
bool is_covered_by_mirror(const Params& params, const Derived& derived, const Scene& scene) {
    const ReflectionParams& reflection = params.reflection;
    const DerivedPlane& plane = derived.planes.front();
    if (!reflection.enabled || !reflection.after_objects || !reflection.stencil || derived.planes.size() > 1 ||
        !plane.mirrors || plane.eye_side == 0.0)
        return false;
    const std::array<glm::dvec4, 4> sides = forms_of_sides(derived.clip_from_world);
    const std::array<glm::dvec4, 4> edges =
        forms_of_edges(seen_on_plane(plane.unit_plane, derived.eye_world), plane.patch);
    std::vector<glm::dvec4> forms(sides.begin(), sides.end());
    return std::none_of(edges.begin(), edges.end(), [&](const glm::dvec4& edge) {
        forms.resize(sides.size());
        forms.push_back(-edge);
        return may_reach(scene, forms);
    });
}

void say_clears(Sayer& tell, const Params& params, const Derived& derived, const Scene& scene) {
    const DepthParams& depth = params.depth;
    const bool refuses_ties = depth.func != CompareFunc::lequal && depth.func != CompareFunc::gequal;
    const bool compares = wants_nearer(depth) || (compares_nearness(depth) && refuses_ties) ||
                          (depth.tests() && depth.func == CompareFunc::notequal);
    const bool writes = depth.write || (params.reflection.enabled && params.reflection.mask_writes_depth);
    if (!compares || rejects_all(depth) || !writes || is_covered_by_mirror(params, derived, scene) ||
        (depth.func == CompareFunc::less && has_only_cleared_code(params, derived, scene)))
        return;
    // GL_LEQUAL passes unmoved surfaces again, so old depths hide only moving surfaces, and mirror images: a mirror's
    // depth hides its image unless mirrors are drawn last.
    const bool shows = refuses_ties || (params.reflection.enabled && !params.reflection.after_objects);
    const Sentence not_cleared =
        sentence("depth.not_cleared", "depth is not cleared: depths from the previous frame keep hiding new fragments");
    const char* const fix = depth.write_while_clearing ? "depth.clear" : "";
    if (!depth.clear) shows ? tell.broken(true, not_cleared, fix) : tell(true, not_cleared, fix);
    const Sentence kept =
        sentence("depth.cleared_with_mask_off",
                 "glClear obeys the depth mask: with the mask off it clears no depth, so depths from the previous "
                 "frame keep hiding new fragments");
    const char* const mask = "depth.write_while_clearing";
    if (depth.clear && !depth.write_while_clearing) shows ? tell.broken(true, kept, mask) : tell(true, kept, mask);
}

/// Reports objects whose depth code equals that of the cleared buffer, so that GL_LESS rejects them.
void say_cleared_code(Sayer& tell, const Params& params, const Derived& derived, const Scene& scene) {
    const DepthParams& depth = params.depth;
    const bool refuses_ties = depth.tests() && depth.func == CompareFunc::less;
    if (!refuses_ties || !is_cleared_to_farthest(depth) || has_bent_depth(depth)) return;
    const double start = start_of_cleared_code(params);
    // This close to far, surfaces are clipped and rounding decides.
    if (start > params.projection.far * (1.0 - 1e-3)) return;
    if (objects_at_most(scene, glm::transpose(derived.view_from_world)[2], -start).empty()) return;
    const std::vector<SeenThing> seen = seen_things(params, derived, scene);
    std::vector<Message> names;
    for (const SeenThing& thing : seen)
        if (!thing.is_plane && thing.farthest > start) names.push_back(object_message(thing.name));
    tell.broken(
        !names.empty(),
        sentence("depth.code_of_cleared",
                 "at z = {z} and beyond, depth has the same code as the cleared buffer: GL_LESS rejects every fragment "
                 "of {objects} there",
                 "z"_a = figures(start, 3), "objects"_a = enumerated(names)),
        "depth.format");
}

/// Returns the polygon offsets that move decals, or shadows that may be seen.
std::vector<DepthOffset> used_offsets(const Params& params, const Derived& derived, const Scene& scene,
                                      const FramePlan& frame) {
    const DepthParams& depth = params.depth;
    const ShadowParams& shadow = params.shadow;
    const DepthOffset of_shadows{shadow.offset_factor, shadow.offset_units};
    std::vector<DepthOffset> used;
    if (depth.offset != DepthOffset{} && depth.decals == DecalMethod::offset && has_decals(scene))
        used.push_back(depth.offset);
    if (shadow.enabled && shadow.style == ShadowStyle::blend && shadow.offset == ShadowOffset::polygon_offset &&
        of_shadows != DepthOffset{} && may_show_shadows(params, derived, scene, frame))
        used.push_back(of_shadows);
    return used;
}

void say_mappings(Sayer& tell, const Params& params, const Derived& derived, const Scene& scene,
                  const FramePlan& frame) {
    const DepthParams& depth = params.depth;
    tell.broken(
        has_bent_depth(depth) && depth.tests() && depth.write && !rejects_all(depth),
        sentence("depth.logarithm_per_vertex",
                 "the logarithm is taken only at the vertices: inside large triangles the interpolated depth is off, "
                 "so the wrong surface can win"),
        "depth.logarithm_per_vertex");
    tell(depth.mapping == DepthMapping::logarithmic && !has_bent_depth(depth) &&
             !used_offsets(params, derived, scene, frame).empty(),
         sentence(
             "depth.offset_in_shader",
             "the shader writes the logarithm to gl_FragDepth, which glPolygonOffset does not change: the shader adds "
             "the offset"));
    if (depth.mapping != DepthMapping::reversed) return;
    const bool loses_steps =
        !derived.clip_zero_to_one && derived.stored_depth.precision.is_float && !params.lens().orthographic;
    tell.broken(loses_steps && depth.reversed_zero_to_one,
                sentence("depth.no_clip_control",
                         "this driver has no glClipControl: reversed depth keeps the clip range −1 to 1, which rounds "
                         "away a float's fine steps near 0, so little is gained"));
    tell.broken(loses_steps && !depth.reversed_zero_to_one,
                sentence("depth.reversed_range",
                         "reversed depth in a clip range of −1 to 1: halving the depth and adding a half rounds away a "
                         "float's fine steps near 0, so little is gained"),
                "depth.reversed_zero_to_one");
    if (!keeps_offset_sign(depth) || !compares_nearness(depth) || rejects_all(depth)) return;
    // A positive number should push surfaces away, and pulls them nearer: no surface that should be seen is hidden.
    const auto pulls = [](const DepthOffset& offset) { return offset.factor < 0.0 || offset.units < 0.0; };
    const std::vector<DepthOffset> used = used_offsets(params, derived, scene, frame);
    const auto pulled = std::find_if(used.begin(), used.end(), pulls);
    if (pulled == used.end()) return;
    const bool is_mixed = pulled->factor > 0.0 || pulled->units > 0.0;
    tell.broken(
        true,
        is_mixed
            ? sentence("depth.reversed_offset",
                       "with reversed depth, nearer means greater, but the offset keeps its sign: its negative number "
                       "pushes surfaces away, and its positive one pulls them nearer")
            : sentence("depth.reversed_offset",
                       "with reversed depth, nearer means greater, but the offset keeps its sign: it pushes surfaces "
                       "away instead of pulling them nearer"),
        "depth.reversed_offset");
}

/// Reports that the driver does not store the requested depth format.
void say_driver(Sayer& tell, const DepthParams& depth, const DepthPrecision& stored) {
    const DepthPrecision asked = precision_of(depth.format);
    if (stored == asked) return;
    if (stored.is_float)
        return tell(true,
                    sentence("depth.driver_format",
                             "this driver stores {bits}-bit depth as a 32-bit float, whose steps below a depth of 1/2 "
                             "are finer than {bits}-bit codes",
                             "bits"_a = asked.bits));
    tell(true,
         sentence("depth.driver_format", "this driver stores {bits} bits of depth instead of the {asked} requested",
                  "bits"_a = stored.bits, "asked"_a = asked.bits));
}

void say_decals(Sayer& tell, const Params& params, const Derived& derived, const Scene& scene) {
    const DecalMethod method = params.depth.decals;
    if (method == DecalMethod::offset || !has_decals(scene)) return;
    tell.broken(method == DecalMethod::equal,
                sentence("depth.decal_equal",
                         "GL_EQUAL: a decal passes only where its depth rounds to exactly that "
                         "of the surface below; with different triangles, it is stippled"));
    for (std::size_t i = 0; i < derived.object_marks.size(); ++i)
        if (scene.objects[i].description.decal && derived.object_marks[i] == 0)
            return tell.broken(
                true,
                sentence(
                    "depth.decal_without_base",
                    "a decal that does not lie on a flat object is left out: no mark in the stencil says where to draw "
                    "it"));
}

/// Reports what is missing from a picture that is otherwise correct.
void say_omissions(Sayer& tell, const Params& params) {
    tell.window(
        params.view.call >= 0,
        sentence("window.call",
                 "the frame is drawn only up to the step chosen in the cell view: go to the last step there, or undo"),
        "view.call");
    tell.window(
        params.view.pass >= 0,
        sentence("window.pass",
                 "the frame is drawn only up to one of its passes: click that pass in the list of passes to draw the "
                 "whole frame, or undo"),
        "view.pass");
    const bool has_masks = params.shadow.enabled || params.reflection.enabled;
    tell.window(
        params.depth.format == DepthFormat::d16 && params.view.samples > 0 && has_masks,
        sentence("window.no_multisampling",
                 "16-bit depth has no stencil: the shadow and mirror masks hold one value per pixel, so there is no "
                 "multisampling"));
}

}  // namespace

void find_depth_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived,
                         const Scene& scene, const FramePlan& frame, const std::vector<SeenImage>& images) {
    Sayer tell(problems, "depth");
    if (is_drawn_by_gl_alone(params.visibility.method)) say_omissions(tell, params);
    if (!uses_gl_depth_test(params.visibility.method) || !shows_anything(derived.clip_from_world, derived, scene))
        return;
    say_tests(tell, params, derived, scene);
    say_clears(tell, params, derived, scene);
    if (!derived.has_distances) return;
    say_clear_value(tell, params, derived, scene, images);
    say_cleared_code(tell, params, derived, scene);
    find_coarse_depth_problems(problems, params, derived, scene, images);
    say_driver(tell, params.depth, derived.stored_depth.precision);
    say_mappings(tell, params, derived, scene, frame);
    say_decals(tell, params, derived, scene);
}

}  // namespace viewing
