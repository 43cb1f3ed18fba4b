// Hidden-surface methods as passes. The plane's patch is not one of their polygons, so it divides the scene like the
// root of a BSP tree: first the part beyond its plane, then the patch, then the part in front. Read gl_text.cpp next.
#include "frame/plan/plan_parts.h"
#include "text/catalogue.h"

namespace viewing {
namespace {

bool shows_the_scene(const Pass& pass) {
    return pass.subject != Subject::patch && pass.subject != Subject::difference && pass.shading != Shading::flat;
}

/// Returns whether a corner of the bounds is on the negative side of the plane.
bool reaches_beyond(const Bounds& bounds, const glm::dvec4& plane) {
    if (bounds.empty()) return false;
    const glm::dvec3 nearest_to_back(plane.x > 0.0 ? bounds.min.x : bounds.max.x,
                                     plane.y > 0.0 ? bounds.min.y : bounds.max.y,
                                     plane.z > 0.0 ? bounds.min.z : bounds.max.z);
    return glm::dot(plane, glm::dvec4(nearest_to_back, 1.0)) < 0.0;
}

/// A surface that a method found for a pixel has already won its comparisons.
constexpr DepthState found_depth{.test = true, .func = CompareFunc::always, .write = true};

Message reason_of(Subject subject) {
    return subject == Subject::pixels
               ? message(
                     "shades the surface that the method found for each pixel, and stores its "
                     "depth")
               : message("draws the polygons over one another, in the order that the method found");
}

void divide_by_the_patch(std::vector<Pass>& passes, const Derived& derived) {
    const glm::dvec4 towards_eye = plane_facing(derived.planes.front().unit_plane, derived.eye_world);
    Pass beyond = passes.back();
    beyond.name = message("Objects beyond the plane");
    beyond.clip_planes = {-towards_eye};
    passes.back().name = message("Objects in front of the plane");
    passes.back().clip_planes = {towards_eye};
    // A mirror's patch lets the mirror image show through, but must hide the objects behind the mirror: the mask
    // excludes these objects.
    const bool has_mask = passes.front().stencil.on_pass == StencilOp::replace && !passes.front().color_write;
    if (has_mask) beyond.stencil = stencil_of_objects_beyond(passes.front());
    passes.insert(passes.begin() + (has_mask ? 1 : 0), beyond);
}

}  // namespace

Pass difference_pass(const Message& reason) {
    Pass pass;
    pass.name = message("Difference");
    pass.reason = reason;
    pass.subject = Subject::difference;
    pass.shading = Shading::flat;
    pass.depth = without_depth;
    pass.blend = Blend::alpha;
    return pass;
}

void use_hidden_surfaces(FramePlan& frame, const Params& params, const Derived& derived, const HiddenPictures& hidden) {
    frame.hidden = hidden;
    // Until the method has a result, the passes that would show the scene are left out.
    if (!hidden.camera && !is_drawn_by_gl_alone(params.visibility.method)) std::erase_if(frame.passes, shows_the_scene);
    const auto subject_of = [](const HiddenDrawing& drawing) {
        return drawing.pixels.empty() ? Subject::ordered : Subject::pixels;
    };
    for (Pass& pass : frame.passes) {
        const auto& drawing = pass.is_mirror_image ? hidden.mirrored : hidden.camera;
        if (!drawing || !shows_the_scene(pass)) continue;
        pass.subject = subject_of(*drawing);
        pass.reason = reason_of(pass.subject);
        if (pass.subject == Subject::pixels) pass.depth = found_depth;
    }
    // In a picture of large pixels, GL would draw the patch at too fine a resolution.
    if (has_raster(params.visibility))
        std::erase_if(frame.passes, [](const Pass& pass) { return pass.subject == Subject::patch; });
    const bool sorts_itself = hidden.camera && !is_drawn_by_gl_alone(params.visibility.method);
    const DerivedPlane& plane = derived.planes.front();
    const glm::dvec4 towards_eye = plane.unit_plane * plane.eye_side;
    if (sorts_itself && plane.eye_side != 0.0 && reaches_beyond(hidden.bounds_world, towards_eye))
        divide_by_the_patch(frame.passes, derived);

    if (params.view.shows != Shows::difference || !hidden.difference) return;
    frame.passes.push_back(difference_pass(
        message("colors a pixel red where the two methods see different polygons, and dims all others")));
}

void count_overdraw(FramePlan& frame) {
    frame.samples = 0;
    for (Pass& pass : frame.passes) {
        if (pass.is_mirror_image || !shows_the_scene(pass)) {
            pass.color_write = false;
            continue;
        }
        pass.shading = Shading::flat;
        pass.color = {1.0 / 255.0, 0.0, 0.0, 0.0};
        pass.blend = Blend::add;
        pass.stencil = {};
    }
}

}  // namespace viewing
