#include "frame/effect.h"

#include <algorithm>
#include <cassert>
#include <iterator>

#include "state/fields.h"
#include "text/catalogue.h"
#include "topics/depth/numbers/decals.h"
#include "topics/hidden/numbers/hidden_method.h"

namespace viewing {
namespace {

double product_of_x_and_y(const glm::dvec4& equation) {
    return equation.x * equation.y;
}
double excess_of_length(const glm::dvec4& equation) {
    return glm::length(glm::dvec3(equation)) - 1.0;
}

/// Returns whether a hidden-surface method has a property of its entry.
template <bool HiddenMethod::*property>
bool has(VisibilityMethod method) {
    return hidden_method(method).*property;
}

/// The state to examine.
struct State {
    const Params& params;
    const Scene* scene;

    bool has_decals() const { return !scene || viewing::has_decals(*scene); }
    bool has_pairs() const { return !scene || scene->made_from; }
    /// Returns whether one of the methods that are shown or compared has a property.
    bool uses(bool (*property)(VisibilityMethod)) const {
        return property(params.visibility.method) ||
               (params.view.shows == Shows::difference && property(params.visibility.compare_with));
    }
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

struct Reason {
    Idle idle;
    bool (*holds)(const State& state);
    const char* sentence;
};

const Reason& reason_of(Idle idle) {
    static const Reason all[] = {
        {Idle::p_by_hand, [](const State& s) { return s.params.camera_overrides.clip_from_view.has_value(); },
         marked("P is entered by hand: press Release beside its name to compute it from the projection again.")},
        {Idle::v_by_hand, [](const State& s) { return s.params.camera_overrides.view_from_world.has_value(); },
         marked("V is entered by hand: press Release beside its name to compute it from the camera again.")},
        {Idle::orthographic, [](const State& s) { return s.params.projection.is_orthographic(); },
         marked("An orthographic view is defined by a height, not an angle.")},
        {Idle::not_orthographic, [](const State& s) { return !s.params.projection.is_orthographic(); },
         marked("A perspective view is defined by an angle, not a height.")},
        {Idle::has_window, [](const State& s) { return s.params.projection.has_window(); },
         marked("The window's four edges decide the size and the shape of the picture.")},
        {Idle::no_field_of_view, [](const State& s) { return s.params.projection.type != ProjectionType::perspective; },
         marked("The camera's projection has no field of view, so a mirror's cannot differ from it.")},
        {Idle::no_window, [](const State& s) { return !s.params.projection.has_window(); },
         marked("Only a projection with an explicit window has edges: glFrustum or glOrtho.")},
        {Idle::no_gl_depth_test, [](const State& s) { return !s.uses(uses_gl_depth_test); },
         marked("This method draws with GL's depth test off.")},
        {Idle::no_depth_buffer, [](const State& s) { return !s.params.depth.buffer; },
         marked("The window has no depth buffer.")},
        {Idle::no_depth_test, [](const State& s) { return !s.params.depth.test; },
         marked("Without the depth test, nothing is compared and no depth is written.")},
        {Idle::not_reversed, [](const State& s) { return s.params.depth.mapping != DepthMapping::reversed; },
         marked("Depth is not reversed.")},
        {Idle::not_logarithmic, [](const State& s) { return s.params.depth.mapping != DepthMapping::logarithmic; },
         marked("Depth is not logarithmic.")},
        {Idle::no_depth_clear, [](const State& s) { return !s.params.depth.clear; },
         marked("Depth is not cleared at all.")},
        {Idle::no_decals, [](const State& s) { return !s.has_decals(); },
         marked("This scene has no decals: open the scene coplanar or the scene decals.")},
        {Idle::no_decal_offset, [](const State& s) { return s.params.depth.decals != DecalMethod::offset; },
         marked("Decals are not separated by an offset.")},
        {Idle::no_pairs, [](const State& s) { return !s.has_pairs(); },
         marked("Only the scene coplanar has pairs to place.")},
        {Idle::gl_resolution, [](const State& s) { return is_drawn_by_gl_alone(s.params.visibility.method); },
         marked("GL always draws at the view's own resolution.")},
        {Idle::no_culling, [](const State& s) { return !s.params.cull.enabled; }, marked("No face is culled.")},
        {Idle::no_facing, [](const State& s) { return !s.tells_faces(); },
         marked("Front and back matter only while faces are culled or their facing is shown.")},
        {Idle::no_shadow, [](const State& s) { return !s.params.shadow.enabled; }, marked("Shadows are off.")},
        {Idle::no_receiver, [](const State& s) { return !s.receives(); }, marked("No plane receives shadows.")},
        {Idle::missing_light, [](const State& s) { return s.params.shadow.style == ShadowStyle::missing_light; },
         marked("A shadow drawn as missing light has no color and no depth: the light is simply not added where it "
                "does not arrive.")},
        {Idle::no_shadow_offset, [](const State& s) { return s.params.shadow.offset != ShadowOffset::polygon_offset; },
         marked("The shadow has no polygon offset.")},
        {Idle::no_lift, [](const State& s) { return s.params.shadow.offset != ShadowOffset::lift; },
         marked("The shadow is not lifted.")},
        {Idle::no_reflection, [](const State& s) { return !s.params.reflection.enabled; },
         marked("Reflections are off.")},
        {Idle::no_mirror, [](const State& s) { return !s.mirrors(); }, marked("No plane is a mirror.")},
        {Idle::no_ab, [](const State& s) { return !s.mirrors_with(product_of_x_and_y); },
         marked("No plane's normal has both an x and a y component: 2ab is 0.")},
        {Idle::unit_normals, [](const State& s) { return !s.mirrors_with(excess_of_length); },
         marked("Every plane's normal already has length 1.")},
        {Idle::not_oblique, [](const State& s) { return s.params.reflection.clip != MirrorClip::oblique; },
         marked("The near plane is not oblique.")},
        {Idle::scene_mirrored, [](const State& s) { return s.params.reflection.mirrored != MirroredThing::camera; },
         marked("The scene is mirrored, not the camera.")},
        {Idle::not_painter, [](const State& s) { return !s.uses(has<&HiddenMethod::sorts_by_key>); },
         marked("Only the painter's algorithm uses a sort key.")},
        {Idle::not_bsp, [](const State& s) { return !s.uses(has<&HiddenMethod::has_tree>); },
         marked("Only the BSP tree has splitting planes and a walk.")},
        {Idle::no_splits, [](const State& s) { return !s.uses(has<&HiddenMethod::splits>); },
         marked("Only Newell's algorithm and the BSP tree split polygons.")},
        {Idle::not_ray_cast, [](const State& s) { return !s.uses(has<&HiddenMethod::casts_rays>); },
         marked("Only ray casting intersects curved surfaces exactly.")},
        {Idle::culling, [](const State& s) { return s.params.cull.enabled; },
         marked("Culling needs front and back faces: while it is on, curved surfaces are drawn as triangles.")},
        {Idle::no_difference, [](const State& s) { return s.params.view.shows != Shows::difference; },
         marked("Nothing is being compared: choose 'difference' above the picture.")},
        {Idle::ray_cast, [](const State& s) { return has<&HiddenMethod::casts_rays>(s.params.visibility.method); },
         marked("Ray casting draws no polygons that could be numbered.")},
        {Idle::no_second_picture, [](const State& s) { return s.params.view.beside.shows == Beside::nothing; },
         marked("There is no second picture.")},
        {Idle::same_depth, [](const State& s) { return s.params.view.beside.shows != Beside::other_depth; },
         marked("The second picture has the same depth buffer.")},
        {Idle::same_settings, [](const State& s) { return s.params.view.beside.shows != Beside::settings; },
         marked("The second picture has the same settings.")},
        {Idle::halves, [](const State& s) { return s.params.view.beside.layout != BesideLayout::divider; },
         marked("Each picture takes up one half.")},
        {Idle::no_orbiting_light, [](const State& s) { return !s.params.animation.light_orbit; },
         marked("No light orbits.")},
        {Idle::not_walking, [](const State& s) { return s.params.camera.navigation != Navigation::walk; },
         marked("Visible only while walking.")},
        {Idle::flying, [](const State& s) { return s.params.camera.navigation == Navigation::fly; },
         marked("Visible only while walking or orbiting.")},
        {Idle::not_orbiting, [](const State& s) { return s.params.camera.navigation != Navigation::orbit; },
         marked("Visible only while orbiting.")},
    };
    const auto found =
        std::find_if(std::begin(all), std::end(all), [&](const Reason& one) { return one.idle == idle; });
    assert(found != std::end(all));
    return *found;
}

}  // namespace

std::string_view why_without_effect(const Params& params, const Scene* scene, std::string_view path) {
    const State state{params, scene};
    for (const Idle idle : field(path).idle)
        if (const Reason& reason = reason_of(idle); reason.holds(state)) return reason.sentence;
    return {};
}

}  // namespace viewing
