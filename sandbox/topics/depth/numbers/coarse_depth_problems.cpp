// Reports surfaces that the depth buffer cannot tell apart: it is too coarse for the objects in view, two surfaces are
// nearly coplanar, or an object lies in one of the drawn planes. Part of problems.h.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "frame/box_tree.h"
#include "frame/depth_switches.h"
#include "frame/object_reach.h"
#include "frame/say.h"
#include "topics/depth/numbers/fighting.h"
#include "topics/depth/numbers/near_advice.h"
#include "topics/depth/numbers/pair_prediction.h"

namespace viewing {
namespace {

/// Returns the largest gap that depth may fail to resolve at an eye distance, as a fraction of the picture's height
/// there.
double unresolved_share(const Params& params, const Derived& derived, double distance) {
    return fighting_onset(depth_coding(params, derived), distance).gap() / picture_height(params.lens(), distance);
}

/// Returns the setting that makes depth fine enough for the objects in view: a larger near or, without perspective, a
/// smaller far; "" if that is not enough.
std::string finer_depth(const Params& params, const Derived& derived, const std::vector<SeenThing>& seen, double z) {
    Params finer = params;
    std::string setting;
    if (params.lens().orthographic && z > 0.0) {
        finer.projection.far = 2.0 * rounded_down(z);
        setting = "projection.far=" + plain_number(finer.projection.far);
    } else if (const std::optional<double> near = largest_near(seen); near && !params.lens().orthographic) {
        finer.projection.move_near(*near);
        setting = near_setting(params.projection, *near);
    }
    return unresolved_share(finer, derived, z) < visible_share ? setting : "";
}

/// Reports that depth is too coarse for the objects in view.
void say_coarse_depth(Sayer& tell, const Params& params, const Derived& derived, const Scene& scene,
                      const std::vector<SeenImage>& images) {
    if (has_bent_depth(params.depth) || scene.objects.empty()) return;
    const Lens lens = params.lens();
    const glm::dvec4 distance = -glm::transpose(derived.view_from_world)[2];
    const glm::dvec3 center = 0.5 * (scene.bounds_world.min + scene.bounds_world.max);
    const double reach = 0.5 * glm::length(scene.bounds_world.max - scene.bounds_world.min);
    double farthest = glm::dot(distance, glm::dvec4(center, 1.0)) + reach;
    for (const SeenImage& image : images) farthest = std::max(farthest, image.farthest);
    farthest = std::clamp(farthest, lens.near, lens.far);
    if (unresolved_share(params, derived, farthest) < visible_share) return;
    const std::vector<SeenThing> seen = seen_things(params, derived, scene);
    std::vector<SeenThing> mirrored;
    // An oblique near plane changes the depth of images: mirror_problems.cpp reports that.
    for (const SeenImage& image : images)
        if (image.is_shown && params.reflection.clip != MirrorClip::oblique)
            mirrored.push_back({image.name, image.nearest, std::min(image.farthest, lens.far)});
    const auto farthest_of = [](const std::vector<SeenThing>& things) {
        const SeenThing* found = nullptr;
        for (const SeenThing& thing : things)
            if (!thing.is_plane && (!found || thing.farthest > found->farthest)) found = &thing;
        return found;
    };
    const SeenThing* worst = farthest_of(seen);
    const bool is_image = !worst || unresolved_share(params, derived, worst->farthest) < visible_share;
    if (is_image) worst = farthest_of(mirrored);
    if (!worst) return;
    const double share = unresolved_share(params, derived, worst->farthest);
    if (share < visible_share) return;
    const double gap = fighting_onset(depth_coding(params, derived), worst->farthest).gap();
    const Message object = object_message(worst->name);
    tell.broken(
        true,
        sentence("depth.too_coarse",
                 "at {object} (z = {z}), depth does not resolve gaps below {gap}, {percent} of the picture's height "
                 "there: where surfaces meet, the wrong one may win",
                 "object"_a = is_image ? message("the mirror image of {object}", "object"_a = object) : object,
                 "z"_a = figures(worst->farthest, 3), "gap"_a = figures(gap, 2), "percent"_a = percent(share)),
        finer_depth(params, derived, seen, worst->farthest));
}

/// A pair of flat surfaces that fight, or that may fight because no prediction rules this out.
struct FightingPair {
    const FlatPair* pair;
    double needed, distance;  ///< gap along the normal that depth reliably resolves; eye distance of the pair's center
};

/// Returns whether parts of both surfaces are in the picture and beyond near.
bool is_seen(const FlatPair& pair, const Derived& derived, const Scene& scene) {
    const glm::dmat4 clip = glm::transpose(derived.clip_from_world);
    std::vector<glm::dvec4> forms = {clip[3] + clip[2]};
    for (const glm::dvec4& side : forms_of_sides(derived.clip_from_world)) forms.push_back(side);
    return may_reach(scene.objects[pair.first], forms) && may_reach(scene.objects[pair.second], forms);
}

/// The size of the picture for which problems predict.
glm::ivec2 predicted_size(const Derived& derived) {
    constexpr int height_px = 720;
    return {std::lround(height_px * derived.view_aspect), height_px};
}

/// Returns the pairs in view that fight. Decals that are moved by an offset count as fighting only if the offset is
/// certainly too small.
std::vector<FightingPair> fighting_pairs(const Params& params, const Derived& derived, const Scene& scene,
                                         std::span<const FlatPair> pairs) {
    const glm::ivec2 size_px = predicted_size(derived);
    std::vector<FightingPair> found;
    for (const FlatPair& pair : pairs) {
        const bool is_moved = pair.has_one_decal() && params.depth.offset != DepthOffset{};
        if (pair.has_one_decal() && params.depth.decals != DecalMethod::offset) continue;
        if (!is_seen(pair, derived, scene)) continue;
        const PairPrediction predicted = predict_pair(pair, params, derived, size_px);
        if (derived.has_distances && !predicted.is_seen) continue;
        const std::optional<ShareInterval>& share = predicted.wrong_share;
        const double needed = predicted.onset.gap() * predicted.slant;
        const bool may_fight = !share || share->most > 0.0;
        if (is_moved ? share && share->least > 0.0 : may_fight && pair.gap() < needed)
            found.push_back({&pair, needed, predicted.distance});
    }
    return found;
}

/// Returns the setting of the smallest polygon offset with which certainly no decal in view fights; "" if a small one
/// is not enough.
std::string sufficient_offset(const Params& params, const Derived& derived, std::span<const FlatPair> pairs) {
    constexpr double most_units = 16.0;
    Params moved = params;
    for (double units = 1.0; units <= most_units; units *= 2.0) {
        moved.depth.offset = {-1.0, -units};
        const bool is_enough = std::all_of(pairs.begin(), pairs.end(), [&](const FlatPair& pair) {
            if (!pair.has_one_decal()) return true;
            const PairPrediction predicted = predict_pair(pair, moved, derived, predicted_size(derived));
            return !predicted.is_seen || (predicted.wrong_share && predicted.wrong_share->most == 0.0);
        });
        if (is_enough) return "depth.offset={\"factor\": -1, \"units\": " + plain_number(-units) + "}";
    }
    return "";
}

/// Reports a polygon offset that moves coplanar decals by less than one code. Needs the size of a unit, which the
/// driver decides.
void say_small_offset(Sayer& tell, const Params& params, const Derived& derived, const Scene& scene,
                      std::span<const FlatPair> pairs) {
    const DepthParams& depth = params.depth;
    const std::optional<double>& unit = derived.stored_depth.unit_codes;
    if (!unit || derived.stored_depth.precision.is_float || depth.decals != DecalMethod::offset) return;
    const double codes = std::abs(depth.offset.units) * *unit;
    const bool is_there = std::any_of(pairs.begin(), pairs.end(), [&](const FlatPair& pair) {
        return pair.has_one_decal() && pair.gap() == 0.0 && is_seen(pair, derived, scene);
    });
    tell.broken(
        is_there && depth.offset.factor == 0.0 && codes > 0.0 && codes < 1.0,
        sentence("depth.offset_too_small",
                 "{units} offset units amount to {codes} of a depth code on this driver: where rounding removes the "
                 "offset, a decal fights with the surface below",
                 "units"_a = figures(depth.offset.units, 3), "codes"_a = figures(codes, 2)),
        "depth.offset.units=" + plain_number(std::copysign(1.0, depth.offset.units) / *unit * 1.5));
}

/// Reports nearly coplanar surfaces that fight, naming the pair whose gap is smallest relative to the gap that would be
/// enough.
void say_pairs(Sayer& tell, const Params& params, const Derived& derived, const Scene& scene,
               std::span<const FlatPair> pairs) {
    if (culls_all(params) || !is_cleared_to_farthest(params.depth) || has_bent_depth(params.depth)) return;
    say_small_offset(tell, params, derived, scene, pairs);
    const std::vector<FightingPair> fighting = fighting_pairs(params, derived, scene, pairs);
    if (fighting.empty()) return;
    const FightingPair& worst =
        *std::min_element(fighting.begin(), fighting.end(), [](const FightingPair& a, const FightingPair& b) {
            return a.pair->gap() * b.needed < b.pair->gap() * a.needed;
        });
    const auto name = [&](int object) { return object_message(scene.objects[object].description.name); };
    const Message first = name(worst.pair->first), second = name(worst.pair->second);
    const bool is_decal = worst.pair->has_one_decal();
    Params finer = params;
    if (const std::optional<double> near = largest_near(seen_things(params, derived, scene)))
        finer.projection.move_near(std::max(finer.projection.near, *near));
    const bool is_near_enough = !is_decal && worst.pair->gap() > 0.0 && !params.lens().orthographic &&
                                fighting_pairs(finer, derived, scene, pairs).empty();
    // Where a code is a large part of the distance, a few codes more or less make no difference.
    const bool is_hopeless = worst.needed > 0.05 * worst.distance;
    const std::string fix = is_hopeless      ? ""
                            : is_decal       ? sufficient_offset(params, derived, pairs)
                            : is_near_enough ? near_setting(params.projection, finer.projection.near)
                                             : "";
    tell.broken(worst.pair->gap() == 0.0,
                sentence("depth.coplanar",
                         "{object} and {other} lie in the same plane: rounding decides which of the two is visible",
                         "object"_a = first, "other"_a = second),
                fix);
    tell.broken(worst.pair->gap() > 0.0,
                sentence("depth.fighting",
                         "{object} and {other} are {gap} apart, but at z = {z}, depth reliably resolves only gaps of "
                         "{needed} or more: where their codes are equal, the two fight",
                         "object"_a = first, "other"_a = second, "gap"_a = figures(worst.pair->gap(), 2),
                         "z"_a = figures(worst.distance, 3), "needed"_a = figures(worst.needed, 2)),
                fix);
}

/// Reports objects that lie in one of the drawn planes, or have a face there, so that the two fight wherever both are
/// in the picture.
void say_in_plane(Sayer& tell, const Params& params, const Derived& derived, const Scene& scene) {
    const Lens lens = params.lens();
    const std::array<glm::dvec4, 4> sides = forms_of_sides(derived.clip_from_world);
    const std::span<const DerivedPlane> planes = drawn_planes(params, derived);
    for (std::size_t index = 0; index < planes.size(); ++index) {
        const DerivedPlane& plane = planes[index];
        if (plane.eye_side == 0.0) continue;
        const std::array<glm::dvec4, 4> edges = forms_of_edges(glm::dmat4(1.0), plane.patch);
        const double least_apart = 1e-3 * plane.patch.extent;
        std::vector<Message> lying, touching;
        double apart = least_apart;  // enough for all of them
        for (const SceneObject& object : scene.objects) {
            if (object.description.decal) continue;
            const bool lies = lies_in(object, plane.unit_plane, least_apart);
            if (!lies && !has_seen_face_in(object, plane.unit_plane, least_apart, params, derived)) continue;
            const glm::dvec4 center =
                object.world_from_model * glm::dvec4(vertex_tree(object.mesh)->bounds().center(), 1.0);
            const glm::dvec3 towards_eye = glm::dvec3(derived.eye_world) - derived.eye_world.w * glm::dvec3(center);
            const double cosine =
                std::abs(glm::dot(glm::dvec3(plane.unit_plane), towards_eye)) / glm::length(towards_eye);
            const double z = std::clamp(-(derived.view_from_world * center).z, std::max(lens.near, 1e-9), lens.far);
            const double fights = fighting_onset(depth_coding(params, derived), z).gap() * cosine;
            const bool is_near = lies ? lies_in(object, plane.unit_plane, fights)
                                      : has_seen_face_in(object, plane.unit_plane, fights, params, derived);
            if (!is_near || !may_reach(object, sides) || !may_reach(object, edges) || is_too_thin(object, derived))
                continue;
            apart = std::max(apart, 8.0 * fights / std::max(cosine, 1e-3));
            (lies ? lying : touching).push_back(object_message(object.description.name));
        }
        glm::dvec4 equation = params.planes[index].equation;
        equation.w += std::copysign(rounded_down(apart), plane.eye_side) * glm::length(glm::dvec3(equation));
        // A plane that has to move far would change the scene; then only a finer buffer helps.
        const bool stays = apart <= 0.05 * plane.patch.extent;
        const std::string fix = index > 0 ? ""
                                : stays
                                    ? "plane.equation=[" + plain_number(equation.x) + "," + plain_number(equation.y) +
                                          "," + plain_number(equation.z) + "," + plain_number(equation.w) + "]"
                                : stores_fewer_bits(params.depth.format) ? "depth.format"
                                                                         : "";
        const Message plane_name = planes_name(std::array{index}, planes.size());
        for (const Message& object : lying)
            tell.broken(true,
                        sentence("depth.object_in_plane",
                                 "{object} lies in {plane} itself: where their depths round to the same code, the two "
                                 "fight",
                                 "object"_a = object, "plane"_a = plane_name),
                        fix);
        tell.broken(!touching.empty(),
                    sentence("depth.face_in_plane",
                             "a side of {objects} lies in {plane}: where their depths round to the same code, the two "
                             "fight",
                             "objects"_a = enumerated(touching), "plane"_a = plane_name),
                    fix);
    }
}

}  // namespace

void find_coarse_depth_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived,
                                const Scene& scene, const std::vector<SeenImage>& images) {
    const DepthParams& depth = params.depth;
    if (!wants_nearer(depth) || rejects_all(depth) || !depth.write) return;
    Sayer tell(problems, "depth");
    // Nearly coplanar surfaces have their own view and sentences.
    const std::vector<FlatPair> pairs = near_coplanar_pairs(scene);
    if (pairs.empty())
        say_coarse_depth(tell, params, derived, scene, images);
    else
        say_pairs(tell, params, derived, scene, pairs);
    say_in_plane(tell, params, derived, scene);
}

}  // namespace viewing
