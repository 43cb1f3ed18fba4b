#include "frame/effect.h"

#include <algorithm>
#include <span>

#include "frame/depth/decals.h"
#include "state/fields.h"
#include "text/catalogue.h"

namespace viewing {
namespace {

double product_of_x_and_y(const glm::dvec4& equation) {
    return equation.x * equation.y;
}
double excess_of_length(const glm::dvec4& equation) {
    return glm::length(glm::dvec3(equation)) - 1.0;
}

/// The state to examine.
struct State {
    const Params& params;
    const Scene* scene;

    bool has_decals() const { return !scene || viewing::has_decals(*scene); }
    bool has_pairs() const { return !scene || scene->made_from; }
    bool compares_with(VisibilityMethod method) const {
        return params.view.shows == Shows::difference && params.visibility.compare_with == method;
    }
    bool uses(VisibilityMethod method) const { return params.visibility.method == method || compares_with(method); }
    bool receives() const {
        return std::any_of(params.planes.begin(), params.planes.end(), [](const auto& p) { return p.receives_shadow; });
    }
    bool mirrors() const {
        return std::any_of(params.planes.begin(), params.planes.end(), [](const auto& p) { return p.mirrors; });
    }
    /// Returns whether `quantity` is nonzero for any plane.
    bool mirrors_with(double (*quantity)(const glm::dvec4& equation)) const {
        return std::any_of(params.planes.begin(), params.planes.end(),
                           [&](const PlaneParams& plane) { return quantity(plane.equation) != 0.0; });
    }
    /// Returns whether the picture or a number that is shown distinguishes front and back faces, as culling, the facing
    /// view, and the counts of a hidden-surface method do.
    bool tells_faces() const {
        return params.cull.enabled || params.view.shows == Shows::facing || params.view.shows == Shows::difference ||
               params.visibility.step >= 0 || params.visibility.numbers ||
               !is_drawn_by_gl_alone(params.visibility.method);
    }
};

/// A reason, and the fields that have no effect while it holds: single fields, or a whole group ("coplanar.").
struct Reason {
    bool (*holds)(const State& state);
    const char* sentence;
    std::initializer_list<std::string_view> fields;
};

bool is_named(const Reason& reason, std::string_view path) {
    return std::any_of(reason.fields.begin(), reason.fields.end(), [path](std::string_view name) {
        return name.ends_with('.') ? path.starts_with(name) : path == name;
    });
}

/// Returns all reasons, from the broadest to the narrowest.
std::span<const Reason> reasons() {
    static const Reason all[] = {
        {[](const State& s) { return s.params.camera_overrides.clip_from_view.has_value(); },
         marked("P is entered by hand: Release beside its name computes it from the projection again."),
         {"projection.", "slips.degrees_as_radians"}},
        {[](const State& s) { return s.params.camera_overrides.view_from_world.has_value(); },
         marked("V is entered by hand: Release beside its name computes it from the camera again."),
         {"slips.swapped_order", "slips.camera_as_view"}},
        {[](const State& s) { return s.params.projection.is_orthographic(); },
         marked("An orthographic view is defined by a height, not an angle."),
         {"projection.fovy", "slips.degrees_as_radians"}},
        {[](const State& s) { return !s.params.projection.is_orthographic(); },
         marked("A perspective view is defined by an angle, not a height."),
         {"projection.height"}},
        {[](const State& s) { return s.params.projection.has_window(); },
         marked("The window's four edges decide the size and the shape of the picture."),
         {"projection.fovy", "projection.height", "projection.aspect", "slips.degrees_as_radians"}},
        {[](const State& s) { return s.params.projection.type != ProjectionType::perspective; },
         marked("The camera's projection has no field of view, so a mirror's cannot differ from it."),
         {"reflection.fovy"}},
        {[](const State& s) { return !s.params.projection.has_window(); },
         marked("Only a projection with an explicit window has edges: glFrustum or glOrtho."),
         {"projection.left", "projection.right", "projection.bottom", "projection.top"}},

        {[](const State& s) { return !s.uses(VisibilityMethod::depth_buffer); },
         marked("This method draws with GL's depth test off."),
         {"depth.buffer", "depth.test", "depth.func", "depth.write", "depth.clear", "depth.clear_value"}},
        {[](const State& s) { return !s.params.depth.buffer; },
         marked("The window has no depth buffer."),
         {"depth.test", "depth.func", "depth.write", "depth.clear", "depth.clear_value", "depth.write_while_clearing",
          "depth.reversed_clear"}},
        {[](const State& s) { return !s.params.depth.test; },
         marked("Without the depth test, nothing is compared and no depth is written."),
         {"depth.func", "depth.write"}},
        {[](const State& s) { return s.params.depth.mapping != DepthMapping::reversed; },
         marked("Depth is not reversed."),
         {"depth.reversed_zero_to_one", "depth.reversed_clear", "depth.reversed_offset"}},
        {[](const State& s) { return s.params.depth.mapping != DepthMapping::logarithmic; },
         marked("Depth is not logarithmic."),
         {"depth.logarithm_per_vertex"}},
        {[](const State& s) { return !s.params.depth.clear; },
         marked("Depth is not cleared at all."),
         {"depth.clear_value", "depth.write_while_clearing", "depth.reversed_clear"}},
        {[](const State& s) { return !s.has_decals(); },
         marked("This scene has no decals: open coplanar or decals."),
         {"depth.decals", "depth.offset.factor", "depth.offset.units"}},
        {[](const State& s) { return s.params.depth.decals != DecalMethod::offset; },
         marked("Decals are not separated by an offset."),
         {"depth.offset.factor", "depth.offset.units"}},
        {[](const State& s) { return !s.has_pairs(); },
         marked("Only the scene coplanar has pairs to place."),
         {"coplanar."}},

        {[](const State& s) { return is_drawn_by_gl_alone(s.params.visibility.method); },
         marked("GL always draws at the view's own resolution."),
         {"visibility.raster", "visibility.pixel"}},

        {[](const State& s) { return !s.params.cull.enabled; }, marked("No face is culled."), {"cull.face"}},
        {[](const State& s) { return !s.tells_faces(); },
         marked("Front and back matter only while faces are culled or their facing is shown."),
         {"cull.front_face", "reflection.flip_winding"}},

        {[](const State& s) { return !s.params.shadow.enabled; },
         marked("Shadows are off."),
         {"shadow.color", "shadow.opacity", "shadow.stencil_once", "shadow.clip_to_receiver", "shadow.clip_casters",
          "shadow.offset", "shadow.offset_factor", "shadow.offset_units", "shadow.lift", "shadow.style",
          "shadow.clip_at_light", "shadow.write_depth", "shadow.own_stencil", "plane.receives_shadow",
          "reflection.shadows"}},
        {[](const State& s) { return !s.receives(); },
         marked("No plane receives shadows."),
         {"shadow.enabled", "shadow.color", "shadow.opacity", "shadow.stencil_once", "shadow.clip_to_receiver",
          "shadow.clip_casters", "shadow.offset", "shadow.offset_factor", "shadow.offset_units", "shadow.lift",
          "shadow.style", "shadow.clip_at_light", "shadow.write_depth", "shadow.own_stencil", "reflection.shadows"}},
        {[](const State& s) { return s.params.shadow.style == ShadowStyle::missing_light; },
         marked("A shadow drawn as missing light has no color and no depth: the light is simply not added where it "
                "does not arrive."),
         {"shadow.color", "shadow.opacity", "shadow.offset", "shadow.offset_factor", "shadow.offset_units",
          "shadow.lift", "shadow.write_depth"}},
        {[](const State& s) { return s.params.shadow.offset != ShadowOffset::polygon_offset; },
         marked("The shadow has no polygon offset."),
         {"shadow.offset_factor", "shadow.offset_units"}},
        {[](const State& s) { return s.params.shadow.offset != ShadowOffset::lift; },
         marked("The shadow is not lifted."),
         {"shadow.lift"}},

        {[](const State& s) { return !s.params.reflection.enabled; },
         marked("Reflections are off."),
         {"reflection.reflectance", "reflection.stencil", "reflection.clip", "reflection.flip_winding",
          "reflection.reflect_light", "reflection.bounces", "reflection.mirrored", "reflection.same_projection",
          "reflection.fovy", "reflection.mask_writes_depth", "reflection.after_objects", "reflection.shadows",
          "plane.mirrors", "slips.oblique_in_world"}},
        {[](const State& s) { return !s.mirrors(); },
         marked("No plane is a mirror."),
         {"reflection.enabled", "reflection.reflectance", "reflection.stencil", "reflection.clip",
          "reflection.flip_winding", "reflection.reflect_light", "reflection.bounces", "reflection.mirrored",
          "reflection.same_projection", "reflection.fovy", "reflection.mask_writes_depth", "reflection.after_objects",
          "reflection.shadows", "slips.oblique_in_world"}},
        {[](const State& s) { return !s.mirrors_with(product_of_x_and_y); },
         marked("No plane's normal has both an x and a y component: 2ab is 0."),
         {"slips.plus_2ab"}},
        {[](const State& s) { return !s.mirrors_with(excess_of_length); },
         marked("Every plane's normal already has length 1."),
         {"slips.normal_not_unit"}},
        {[](const State& s) { return s.params.reflection.clip != MirrorClip::oblique; },
         marked("The near plane is not oblique."),
         {"slips.oblique_in_world"}},
        {[](const State& s) { return s.params.reflection.mirrored != MirroredThing::camera; },
         marked("The scene is mirrored, not the camera."),
         {"reflection.same_projection"}},

        {[](const State& s) { return !s.uses(VisibilityMethod::painter); },
         marked("Only the painter's algorithm uses a sort key."),
         {"visibility.sort_key"}},
        {[](const State& s) { return !s.uses(VisibilityMethod::bsp); },
         marked("Only the BSP tree has splitting planes and a walk."),
         {"visibility.splitter", "visibility.walk"}},
        {[](const State& s) { return !s.uses(VisibilityMethod::bsp) && !s.uses(VisibilityMethod::newell); },
         marked("Only Newell's algorithm and the BSP tree split polygons."),
         {"visibility.epsilon"}},
        {[](const State& s) { return !s.uses(VisibilityMethod::ray_cast); },
         marked("Only ray casting intersects curved surfaces exactly."),
         {"visibility.exact_curves"}},
        {[](const State& s) { return s.params.cull.enabled; },
         marked("Culling needs front and back faces: while it is on, curved surfaces are drawn as triangles."),
         {"visibility.exact_curves"}},
        {[](const State& s) { return s.params.view.shows != Shows::difference; },
         marked("Nothing is being compared: choose 'difference' above the picture."),
         {"visibility.compare_with"}},
        {[](const State& s) { return s.params.visibility.method == VisibilityMethod::ray_cast; },
         marked("Ray casting draws no polygons that could be numbered."),
         {"visibility.numbers"}},

        {[](const State& s) { return s.params.view.beside.shows == Beside::nothing; },
         marked("There is no second picture."),
         {"view.beside.layout", "view.beside.share", "view.beside.format", "view.beside.mapping", "view.beside.set"}},
        {[](const State& s) { return s.params.view.beside.shows != Beside::other_depth; },
         marked("The second picture has the same depth buffer."),
         {"view.beside.format", "view.beside.mapping"}},
        {[](const State& s) { return s.params.view.beside.shows != Beside::settings; },
         marked("The second picture has the same settings."),
         {"view.beside.set"}},
        {[](const State& s) { return s.params.view.beside.layout != BesideLayout::divider; },
         marked("Each picture takes up one half."),
         {"view.beside.share"}},
        {[](const State& s) { return !s.params.animation.light_orbit; },
         marked("No light orbits."),
         {"animation.light_speed"}},

        {[](const State& s) { return s.params.camera.navigation != Navigation::walk; },
         marked("Visible only while walking."),
         {"slips.walk_slows"}},
        {[](const State& s) { return s.params.camera.navigation == Navigation::fly; },
         marked("Visible only while walking or orbiting."),
         {"slips.creeping_roll"}},
        {[](const State& s) { return s.params.camera.navigation != Navigation::orbit; },
         marked("Visible only while orbiting."),
         {"slips.pole_flip"}},
    };
    return all;
}

}  // namespace

std::string_view why_without_effect(const Params& params, const Scene* scene, std::string_view path) {
    const State state{params, scene};
    for (const Reason& reason : reasons())
        if (is_named(reason, path) && reason.holds(state)) return reason.sentence;
    return {};
}

}  // namespace viewing
