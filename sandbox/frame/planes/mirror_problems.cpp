// The switches of the planar mirror, each with the sentence that says why it breaks the picture, told only where that
// can be seen. Part of problems.h; shadow_problems.cpp is its counterpart.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "frame/hidden/hidden_drawing.h"
#include "frame/planes/object_reach.h"
#include "frame/say.h"

namespace viewing {
namespace {

/// A mirror whose image the frame draws.
struct Mirror {
    const DerivedPlane& plane;
    double eye_side;

    glm::dvec4 towards_eye() const { return (eye_side < 0.0 ? -1.0 : 1.0) * plane.unit_plane; }
    double distance_from_origin() const { return std::abs(plane.unit_plane.w); }
};

std::vector<Mirror> drawn_mirrors(const Params& params, const Derived& derived) {
    std::vector<Mirror> mirrors;
    for (const DerivedPlane& plane : drawn_planes(params, derived))
        if (const double side = plane.eye_side; plane.mirrors && side != 0.0) mirrors.push_back({plane, side});
    return mirrors;
}

/// S with the eye for its light: sends points to where they are seen against the plane, with w > 0 before the eye.
glm::dmat4 seen_on_plane(const Mirror& mirror, const Derived& derived) {
    return shadow_sign(mirror.plane.unit_plane, derived.eye_world) *
           shadow_matrix(mirror.plane.unit_plane, derived.eye_world);
}

/// What is kept out of the image, and what is not.
void say_clipping(Sayer& tell, const Params& params, const std::vector<Mirror>& mirrors, const Scene& scene) {
    const ReflectionParams& reflection = params.reflection;
    const bool tests = params.depth.test && params.visibility.method == VisibilityMethod::depth_buffer;
    tell.broken(reflection.clip == MirrorClip::oblique && tests,
                tr("the oblique near plane bends depth: its far plane turns with it, and the codes inside the image "
                   "are spent by its own planes"),
                "reflection.clip");
    tell.broken(reflection.clip == MirrorClip::oblique && params.depth.logarithm_per_vertex &&
                    params.depth.mapping == DepthMapping::logarithmic,
                tr("the logarithm per vertex replaces the z that the oblique near plane clips by: nothing is clipped"),
                "reflection.clip");
    tell.broken(!reflection.side_of_eye && std::any_of(mirrors.begin(), mirrors.end(),
                                                       [](const Mirror& mirror) { return mirror.eye_side < 0.0; }),
                tr("the mirror is seen from behind, but what lies on the normal's side is mirrored: the eye sees the "
                   "image of what is behind the mirror"),
                "reflection.side_of_eye");
    if (reflection.clip != MirrorClip::none) return;
    for (const Mirror& mirror : mirrors) {
        const std::string across = objects_across(scene, mirror.towards_eye(), -standing);
        if (!across.empty())
            return tell.broken(true,
                               say("{objects} crosses the mirror's plane: the part behind it is mirrored, too, and its "
                                   "image sticks out of the mirror",
                                   "objects"_a = across),
                               "reflection.clip");
        const std::string behind = objects_at_most(scene, mirror.towards_eye(), -standing);
        if (!behind.empty())
            return tell.broken(
                true,
                say("{objects} lies behind the mirror: its image, which is not clipped, appears in front of it",
                    "objects"_a = behind),
                "reflection.clip");
    }
}

/// What keeps the image inside the mirror, and the mirror in its place among the objects.
void say_masks(Sayer& tell, const Params& params, const Derived& derived, const std::vector<Mirror>& mirrors,
               const Scene& scene) {
    const ReflectionParams& reflection = params.reflection;
    const auto image_is_wider = [&](const Mirror& mirror) {
        return lands_beyond(scene, seen_on_plane(mirror, derived) * mirror.plane.mirrored_world_from_world,
                            mirror.towards_eye(), mirror.plane.patch);
    };
    const auto is_covered = [&](const Mirror& mirror) {
        return lands_inside(scene, seen_on_plane(mirror, derived), mirror.towards_eye(), mirror.plane.patch);
    };
    const bool tests = params.depth.test && params.visibility.method == VisibilityMethod::depth_buffer;
    tell.broken(
        !reflection.stencil && std::any_of(mirrors.begin(), mirrors.end(), image_is_wider),
        tr("R knows the whole plane, not its patch: without the stencil the image shows beyond the mirror's edge"),
        "reflection.stencil");
    tell.broken(
        reflection.mask_writes_depth && reflection.stencil && tests && !reflection.after_objects,
        tr("the mask leaves the mirror's own depth behind: the image lies beyond it, fails the test and is hidden"),
        "reflection.mask_writes_depth");
    tell.broken(reflection.after_objects && is_drawn_by_gl_alone(params.visibility.method) &&
                    std::any_of(mirrors.begin(), mirrors.end(), is_covered),
                tr("the mirror is painted last and without a depth test: it covers what stands in front of it"),
                "reflection.after_objects");
}

/// What R, its winding and its camera make of the scene.
void say_images(Sayer& tell, const Params& params, const Derived& derived, const std::vector<Mirror>& mirrors) {
    const ReflectionParams& reflection = params.reflection;
    const bool culls = params.cull.enabled && params.cull.face != CullFace::front_and_back;
    tell.broken(!reflection.flip_winding && (culls || params.view.shows == Shows::facing),
                culls ? tr("R turns counter-clockwise into clockwise (det R = −1): without the flip the image's front "
                           "faces are culled and it is seen inside out")
                      : tr("R turns counter-clockwise into clockwise (det R = −1): without the flip the image's front "
                           "faces count as back faces"),
                "reflection.flip_winding");
    tell.broken(!reflection.reflect_light,
                tr("the light is not mirrored with the scene: its image is lit from where the light is, not from where "
                   "the light's image is"),
                "reflection.reflect_light");
    tell.broken(reflection.mirrored == MirroredThing::camera && !reflection.same_projection && derived.aspect != 1.0,
                tr("the mirrored camera sees with the aspect of a square picture: the image does not fit its mirror"),
                "reflection.same_projection");

    const auto is_moved = [](const Mirror& mirror) {
        return mirror.distance_from_origin() > 1e-9 && !mirror.plane.mirror_by_hand;
    };
    tell.broken(reflection.printed_by_rows && std::any_of(mirrors.begin(), mirrors.end(), is_moved),
                tr("R is filled by rows as printed, and OpenGL reads columns: Rᵀ has −2d n in its last row, where it "
                   "bends w instead of moving the image"),
                "reflection.printed_by_rows");
}

/// How many mirrors a line of sight may meet between two of them that enclose an angle: none where it has no end.
std::optional<int> mirrors_met(const Mirror& one, const Mirror& other) {
    const double cosine = -glm::dot(glm::dvec3(one.towards_eye()), glm::dvec3(other.towards_eye()));
    const double angle = std::acos(std::clamp(cosine, -1.0, 1.0));
    if (angle < 1e-6) return std::nullopt;
    return static_cast<int>(std::ceil(std::numbers::pi / angle - 1e-9));
}

/// Mirrors that show each other.
void say_bounces(Sayer& tell, const Params& params, const std::vector<Mirror>& mirrors, int depth) {
    bool is_endless = false;
    int most = 1;
    for (std::size_t one = 0; one < mirrors.size(); ++one)
        for (std::size_t other = one + 1; other < mirrors.size(); ++other) {
            const std::optional<int> met = mirrors_met(mirrors[one], mirrors[other]);
            is_endless = is_endless || !met;
            most = std::max(most, met.value_or(most));
        }
    if (!params.reflection.stencil || (!is_endless && most <= depth)) return;
    if (depth < params.reflection.bounces)
        return tell(true, say("{depth} of {bounces} bounces are drawn: more would draw the scene too often, or be more "
                              "than the stencil can count",
                              "depth"_a = depth, "bounces"_a = params.reflection.bounces));
    if (depth == 1) {
        tell.broken(is_endless, tr("mirrors that face each other show one another without end: a mirror seen in a "
                                   "mirror is drawn without its image"));
        tell(!is_endless, say("a line of sight can meet {count} of these mirrors: a mirror seen in a mirror is drawn "
                              "without its image",
                              "count"_a = most));
    } else {
        tell.broken(is_endless, say("mirrors that face each other show one another without end: the mirror after "
                                    "{depth} bounces is drawn without its image",
                                    "depth"_a = depth));
        tell(!is_endless, say("a line of sight can meet {count} of these mirrors: the mirror after {depth} bounces is "
                              "drawn without its image",
                              "count"_a = most, "depth"_a = depth));
    }
}

/// Shadows on what the mirror shows.
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
                tr("the mirror image is drawn without shadows: inside the mirror the objects seem to float"),
                "reflection.shadows");
}

}  // namespace

void find_mirror_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived,
                          const Scene& scene, int reflection_depth) {
    if (reflection_depth < 1 || !shows_effects(params)) return;
    const std::vector<Mirror> mirrors = drawn_mirrors(params, derived);
    if (mirrors.empty()) return;
    Sayer tell(problems, "reflection");
    say_clipping(tell, params, mirrors, scene);
    say_masks(tell, params, derived, mirrors, scene);
    say_images(tell, params, derived, mirrors);
    say_bounces(tell, params, mirrors, reflection_depth);
    say_shadows_inside(tell, params, derived, mirrors);
}

}  // namespace viewing
