// Every matrix and number that is shown or uploaded, computed once from the parameters.
// derive is pure: no GL, no clock, no files. Read derive.cpp, then plan.h.
#pragma once

#include <optional>
#include <vector>

#include "frame/depth/driver_depth.h"
#include "frame/depth/heat_map.h"
#include "geometry/plane.h"
#include "state/params.h"
#include "state/scene.h"

namespace viewing {

struct Viewport {
    glm::ivec2 size_px{1280, 720};
    bool clip_control = true;  ///< the driver has glClipControl, which reversed depth wants
    /// What the driver makes of the depth format, where it was measured (render/driver_depth.h).
    std::optional<StoredDepth> stored_depth{};

    double aspect() const { return size_px.y > 0 ? static_cast<double>(size_px.x) / size_px.y : 1.0; }
};

/// The followed vertex on its way through S and R.
struct FollowedPoint {
    glm::dvec3 point_world{0.0};
    glm::dvec4 shadow_homogeneous{0.0};      ///< S p, before the division by w
    std::optional<glm::dvec3> shadow_world;  ///< s = S p ÷ w; none where w = 0
    double plane_distance = 0.0;             ///< k = n·p + d
    glm::dvec3 foot_world{0.0};              ///< p − k n
    glm::dvec3 mirrored_world{0.0};          ///< R p
};

/// Measured, not promised. What there is to say of S and R is measured where it is shown: matrix_facts.h.
struct Facts {
    double view_residual = 0.0;              ///< largest absolute entry of V C − I
    double depth_step_at_target = 0.0;       ///< depth_step() at the camera's target
    double resolvable_step_at_target = 0.0;  ///< resolvable_depth_step() there
    double target_distance = 0.0;            ///< eye distance of the target, kept within near … far
};

/// The shadow that one light throws on one plane.
struct CastShadow {
    glm::dvec4 light_world{0.0, 1.0, 0.0, 0.0};
    double plane_dot_light = 0.0;               ///< Π·L of the unit plane
    bool light_in_plane = false;                ///< Π·L counts as zero: no shadow is defined
    glm::dmat4 shadowed_world_from_world{1.0};  ///< S
    double sign = 1.0;                          ///< uploaded: sign · S
    bool by_hand = false;                       ///< S does not come from plane and light

    /// Whether the light shines on the side of the plane that an eye with P·eye = `eye_side` sees.
    bool reaches(double eye_side) const { return !light_in_plane && plane_dot_light * eye_side > 0.0; }
};

/// One of the planes, with the shadow of each light on it.
struct DerivedPlane {
    glm::dvec4 unit_plane{0.0, 1.0, 0.0, 0.0};  ///< sign kept
    PlanePatch patch{};
    double eye_side = 1.0;  ///< P·eye: its sign is the side that is seen
    bool receives_shadow = true, mirrors = true, gloss = false;
    glm::dmat4 mirrored_world_from_world{1.0};  ///< R
    bool mirror_by_hand = false;                ///< R does not come from the plane
    bool mirror_has_slip = false;               ///< plus_2ab or normal_not_unit makes R another matrix
    std::vector<CastShadow> shadows;            ///< of each light, in order
};

struct Derived {
    double aspect = 1.0;                       ///< of P
    double view_aspect = 1.0;                  ///< of the picture, to which it is stretched
    glm::dmat4 world_from_view{1.0};           ///< C
    glm::dmat4 view_from_world{1.0};           ///< V, as uploaded (the slips included)
    glm::dmat4 clip_from_view{1.0};            ///< P, as uploaded
    glm::dmat4 clip_from_world{1.0};           ///< P V
    bool clip_zero_to_one = false;             ///< glClipControl(…, GL_ZERO_TO_ONE)
    StoredDepth stored_depth{};                ///< as measured, or else as asked for
    glm::dvec4 eye_world{0.0, 0.0, 0.0, 1.0};  ///< orthographic: w = 0 and the direction towards the eye, as of a light

    std::vector<DerivedPlane> planes;      ///< as many as in Params, so at least one
    std::vector<glm::dvec4> lights_world;  ///< at least one
    Choice chosen;

    const DerivedPlane& chosen_plane() const { return planes[chosen.plane]; }
    const CastShadow& chosen_shadow() const { return chosen_plane().shadows[chosen.light]; }  ///< on that plane
    const glm::dvec4& chosen_light() const { return lights_world[chosen.light]; }

    std::optional<FollowedPoint> followed;
    std::vector<int> object_marks;  ///< of decals by stencil: decal_marks(); empty otherwise
    std::optional<HeatMap> heat;    ///< where the picture shows depth fighting
    Facts facts;
};

Derived derive(const Params& params, const Scene& scene, const Viewport& viewport);

/// The observer's camera, and what it sees, for a viewport of its own.
struct ObserverView {
    glm::dmat4 world_from_view{1.0};
    glm::dmat4 view_from_world{1.0};
    glm::dmat4 clip_from_world{1.0};
    glm::dvec4 eye_world{0.0, 0.0, 0.0, 1.0};
};
ObserverView derive_observer(const ObserverParams& observer, const Viewport& viewport);

/// What the chosen light sees of all that casts a shadow, framed wherever the light is: every shadow is hidden behind
/// its caster. A parallel light looks along parallel lines; a light among the casters sees those that lie before it.
/// Without objects it looks at the chosen plane's patch.
ObserverView derive_light_view(const Derived& derived, const Scene& scene, const Viewport& viewport);

/// The lecture's other reading of the same picture: the camera stays at the origin and the world is moved by V.
ObserverView derive_moving_world(const ObserverParams& observer, const Derived& derived, const Viewport& viewport);

/// The precision of a depth format.
DepthPrecision precision_of(DepthFormat format);

/// A format that GL does not have: the sandbox's shader rounds to its codes, which are kept exactly inside 24 bits.
bool stores_fewer_bits(DepthFormat format);

/// Then it is the shader that writes depths and moves them by an offset, each unit one code, not glPolygonOffset.
bool writes_depth_by_shader(DepthFormat format, DepthMapping mapping, bool logarithm_per_vertex);

/// Whether what is told of this state's depths depends on what GL leaves to the driver: the unit of an offset that
/// moves decals, or how 24 bits are stored where that shows.
bool depends_on_stored_depth(const Params& params, const Scene& scene);

/// The width in eye z of one stored code at the eye distance z, for this state's projection, mapping and format.
/// Positive and finite; what is nearer than near counts as at near.
double depth_step(const Params& params, double z);

/// Where the camera's numbers put it: C without slips.
glm::dmat4 placed_camera(const Params& params);

/// Where the matrix that is uploaded really puts the eye: V⁻¹. The same as placed_camera but for the slips.
glm::dmat4 effective_camera(const Derived& derived);

/// The eight corners of what a camera with this state's projection sees, in world space: near then far, each
/// counter-clockwise from bottom left as the camera sees them.
std::array<glm::dvec3, 8> frustum_corners(const Params& params, const Derived& derived,
                                          const glm::dmat4& world_from_view);
/// Of the placed camera: it shows where the camera is even while a slip breaks V.
std::array<glm::dvec3, 8> frustum_corners(const Params& params, const Derived& derived);

}  // namespace viewing
