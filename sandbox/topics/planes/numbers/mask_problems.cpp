// Reports errors of the masks that keep an image inside its mirror. Part of problems.h.
#include <algorithm>
#include <array>
#include <cmath>

#include "frame/box_tree.h"
#include "frame/cleared_code.h"
#include "frame/object_reach.h"
#include "frame/say.h"
#include "text/words.h"
#include "topics/planes/numbers/drawn_mirrors.h"

namespace viewing {

bool mask_hides(const Params& params, const Derived& derived, const Mirror& mirror, const Scene& scene) {
    const ReflectionParams& reflection = params.reflection;
    if (!lets_nearer_win(params) || !reflection.mask_writes_depth || !reflection.stencil || reflection.after_objects)
        return false;
    const bool is_wrong_side = !reflection.side_of_eye && reflection.clip != MirrorClip::none;
    if (is_wrong_side && mirror.is_seen_from_behind()) return false;
    const auto before =
        std::span(derived.planes).first(static_cast<std::size_t>(&mirror.plane - derived.planes.data()));
    return std::all_of(before.begin(), before.end(), [](const DerivedPlane& plane) { return plane.eye_side == 0.0; }) &&
           !objects_at_most(scene, -mirror.towards_eye(), 0.0).empty();
}

namespace {

/// Returns forms that are positive where the image lies in front of its mirror, as the picture shows it, by more than
/// `standing`. An image lies there only if nothing is clipped, or if R or P is wrong.
std::vector<glm::dvec4> forms_in_front(const Params& params, const Derived& derived, const Mirror& mirror) {
    Params in_patch = params;  // outside the patch, the image is visible for another reason
    in_patch.reflection.stencil = true;
    std::vector<glm::dvec4> forms = forms_of_drawn_image(in_patch, derived, mirror, mirror.clip_from_scene);
    forms.push_back(mirror.towards_eye() * (glm::inverse(derived.clip_from_world) * mirror.clip_from_scene));
    forms.back().w -= standing;
    return forms;
}

}  // namespace

bool mask_hides_all(const Params& params, const Derived& derived, const Mirror& mirror, const Scene& scene) {
    if (!mask_hides(params, derived, mirror, scene) || params.reflection.clip == MirrorClip::oblique) return false;
    const glm::dmat4 drawn_at = glm::inverse(derived.clip_from_world) * mirror.clip_from_scene;
    std::vector<glm::dvec4> forms = forms_in_front(params, derived, mirror);
    forms.push_back(glm::transpose(drawn_at)[3]);
    return !may_see(params, derived, scene, forms, drawn_at);
}

namespace {

/// Returns the smallest gap, along the mirror's normal, that depth reliably resolves at an object's center, if that gap
/// in eye distance is a visible fraction of the picture's height there; otherwise 0.
double coarse_gap(const Params& params, const Derived& derived, const Mirror& mirror, const SceneObject& object) {
    const Lens lens = params.lens();
    const glm::dvec3 center = object.world_from_model * glm::dvec4(vertex_tree(object.mesh)->bounds().center(), 1.0);
    const double z = std::clamp(-(derived.view_from_world * glm::dvec4(center, 1.0)).z, std::max(lens.near, 1e-9),
                                lens.far),
                 gap = resolvable_depth_step(lens, params.depth.mapping, derived.stored_depth.precision, z);
    if (gap <= visible_share / 5.0 * picture_height(lens, z)) return 0.0;
    return gap * std::abs(glm::dot(glm::dvec3(mirror.towards_eye()), line_of_sight(derived.eye_world, center)));
}

/// Reports images that the mirror should be blended over but does not cover, because there is no stencil and depth
/// alone decides.
void say_uncovered(Sayer& tell, const Params& params, const Derived& derived, const std::vector<Mirror>& mirrors,
                   const Scene& scene) {
    if (!lets_nearer_win(params) || !params.depth.write) return;
    const bool is_oblique = params.reflection.clip == MirrorClip::oblique;
    const bool fits = params.reflection.same_projection && params.mirror_picture_scale() == 1.0;
    for (const Mirror& mirror : mirrors) {
        if (is_oblique && may_show_image(params, derived, mirror, scene))
            return tell.broken(
                true,
                sentence("reflection.oblique_uncovered",
                         "without the stencil, depth decides where the mirror covers its image, but the oblique near "
                         "plane gives the image different depths: it appears in front of the mirror"),
                "reflection.stencil");
        // Beyond the start of the cleared code, GL_LESS rejects the image.
        glm::dvec4 before_cleared_code =
            glm::transpose(derived.view_from_world * mirror.plane.mirrored_world_from_world)[2];
        before_cleared_code.w += std::min(start_of_cleared_code(params), 2.0 * params.lens().shown_far());
        std::vector<Message> in_front, touching;
        for (const SceneObject& object : scene.objects) {
            std::vector<glm::dvec4> forms = {before_cleared_code};
            for (const glm::dvec4& form : forms_in_front(params, derived, mirror)) forms.push_back(form);
            const bool is_in_front = may_reach(object, forms);
            // An object hides the spot where it touches its image, unless the image is drawn elsewhere.
            const double gap = std::max(coarse_gap(params, derived, mirror, object), fits ? 0.0 : standing);
            forms.back().w += standing + gap;
            if (is_in_front || (gap > 0.0 && may_reach(object, forms)))
                (is_in_front ? in_front : touching).push_back(object_message(object.description.name));
        }
        if (!in_front.empty())
            return tell.broken(true,
                               sentence("reflection.image_in_front",
                                        "without the stencil, the mirror does not cover the image of {objects}, which "
                                        "lies in front of it",
                                        "objects"_a = enumerated(in_front)),
                               "reflection.stencil");
        if (!touching.empty())
            return tell.broken(true,
                               sentence("reflection.image_touches",
                                        "without the stencil, depth decides where the mirror covers its image: where "
                                        "{objects} nearly touch the mirror, image and mirror have the same code",
                                        "objects"_a = enumerated(touching)),
                               "reflection.stencil");
    }
}

/// Returns forms that are positive for points in the picture, on the given side of the mirror's plane, whose view ray
/// passes through the patch.
std::vector<glm::dvec4> forms_over_patch(const Derived& derived, const Mirror& mirror, const glm::dvec4& side) {
    std::vector<glm::dvec4> forms = {side - glm::dvec4(0.0, 0.0, 0.0, standing)};
    for (const glm::dvec4& side_of_view : forms_of_frustum(derived.clip_from_world)) forms.push_back(side_of_view);
    const glm::dmat4 seen = seen_on_plane(mirror.plane.unit_plane, derived.eye_world);
    for (const glm::dvec4& edge : forms_of_edges(seen, mirror.plane.patch)) forms.push_back(edge);
    return forms;
}

/// Returns the planes in front of a mirror that is drawn last, and so covers them. Of two mirrors, the second is drawn
/// over the first.
std::vector<std::size_t> planes_under(const Params& params, const Derived& derived, const Mirror& mirror) {
    const std::vector<glm::dvec4> forms = forms_over_patch(derived, mirror, mirror.towards_eye());
    const std::span<const DerivedPlane> planes = drawn_planes(params, derived);
    std::vector<std::size_t> under;
    for (std::size_t index = 0; index < planes.size(); ++index) {
        const bool is_later = planes[index].mirrors && &planes[index] >= &mirror.plane;
        if (&planes[index] == &mirror.plane || is_later || planes[index].eye_side == 0.0) continue;
        if (may_reach(planes[index].patch, forms)) under.push_back(index);
    }
    return under;
}

/// Reports images outside their mirrors, and mirrors that cover too much.
void say_masks(Sayer& tell, const Params& params, const Derived& derived, const std::vector<Mirror>& mirrors,
               const Scene& scene) {
    const ReflectionParams& reflection = params.reflection;
    const auto image_is_wider = [&](const Mirror& mirror) {
        return lands_beyond(scene, {.plane_from_world = on_mirror_from_scene(derived, mirror, mirror.clip_from_scene),
                                    .clip_from_world = derived.clip_from_world,
                                    .side = mirror.kept_side(reflection),
                                    .patch = mirror.plane.patch,
                                    .is_image = true});
    };
    const auto is_covered = [&](const Mirror& mirror) {
        return may_reach(scene, forms_over_patch(derived, mirror, mirror.towards_eye()));
    };
    const bool is_blended_over =
        is_drawn_by_gl_alone(params.visibility.method) && (reflection.stencil || last_fragment_wins(params));
    // Where the depth test rejects the patch, the stencil would not be marked and would exclude the image. Without the
    // stencil, an image may appear there, because an oblique near plane gives it other depths.
    const bool is_unmarked = reflection.clip == MirrorClip::oblique &&
                             std::any_of(mirrors.begin(), mirrors.end(), [&](const Mirror& mirror) {
                                 return loses_part(mirror.plane.patch, params, derived);
                             });
    tell.broken(
        !reflection.stencil && (is_unmarked || std::any_of(mirrors.begin(), mirrors.end(), image_is_wider)),
        sentence("reflection.beyond_edge",
                 "R reflects across the infinite plane, not just its patch: without the stencil, the image shows "
                 "beyond the mirror's edge"),
        "reflection.stencil");
    if (!reflection.stencil) say_uncovered(tell, params, derived, mirrors, scene);
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
    if (!reflection.after_objects || !is_blended_over) return;
    const bool covers_objects = !culls_all(params) && std::any_of(mirrors.begin(), mirrors.end(), is_covered);
    tell.broken(covers_objects,
                sentence("reflection.covers_objects",
                         "the mirror is drawn last and without a depth test: it covers the objects in front of it"),
                "reflection.after_objects");
    for (const Mirror& mirror : mirrors) {
        const std::vector<std::size_t> under = planes_under(params, derived, mirror);
        if (covers_objects || under.empty()) continue;
        return tell.broken(
            true,
            sentence("reflection.covers_planes",
                     "a mirror is drawn last and without a depth test: it covers the part of {planes} in "
                     "front of it",
                     "planes"_a = planes_name(under, derived.planes.size())),
            "reflection.after_objects");
    }
}

/// Reports objects behind a mirror that is blended over them, because it is drawn last and without the stencil, so its
/// part of the picture is not cleared.
void say_shown_through(Sayer& tell, const Params& params, const Derived& derived, const std::vector<Mirror>& mirrors,
                       const Scene& scene) {
    if (!params.reflection.after_objects || params.reflection.stencil) return;
    for (const Mirror& mirror : mirrors) {
        const std::vector<glm::dvec4> forms = forms_over_patch(derived, mirror, -mirror.towards_eye());
        std::vector<Message> behind;
        for (const SceneObject& object : scene.objects)
            if (may_reach(object, forms)) behind.push_back(object_message(object.description.name));
        if (!behind.empty())
            return tell.broken(true,
                               sentence("reflection.shows_through",
                                        "the mirror is drawn last and blended: without the stencil, what is behind it "
                                        "shows through: {objects}",
                                        "objects"_a = enumerated(behind)),
                               "reflection.after_objects");
    }
}

/// Reports a mirror whose picture is cleared and drawn over earlier patches as well, because they share its stencil
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
            return tell.broken(
                true,
                sentence("reflection.shared_stencil",
                         "the planes share one stencil value: the image in plane {plane} is also drawn over "
                         "{planes}",
                         "plane"_a = index + 1, "planes"_a = planes_name(covered, planes.size())),
                "shadow.own_stencil");
    }
}

}  // namespace

void find_mask_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived,
                        const std::vector<Mirror>& mirrors, const Scene& scene) {
    Sayer tell(problems, "reflection");
    say_masks(tell, params, derived, mirrors, scene);
    say_shown_through(tell, params, derived, mirrors, scene);
    say_shared_value(tell, params, derived, mirrors);
}

}  // namespace viewing
