// Computes every matrix and number that is shown or uploaded, each of them once, from the parameters. derive() is pure:
// no GL, no clock, no files. Read derive.cpp next, then plan.h.
#pragma once

#include <optional>
#include <vector>

#include "frame/driver_depth.h"
#include "geometry/plane.h"
#include "state/params.h"
#include "state/scene.h"
#include "topics/depth/numbers/heat_map.h"

namespace viewing {

struct Viewport {
    glm::ivec2 size_px{1280, 720};
    bool clip_control = true;  ///< the driver has glClipControl, which reversed depth needs
    /// The depth format as the driver stores it; none if it was not measured (render/stored_depth.h).
    std::optional<StoredDepth> stored_depth{};

    double aspect() const { return size_px.y > 0 ? static_cast<double>(size_px.x) / size_px.y : 1.0; }
    bool operator==(const Viewport&) const = default;
};

/// The followed point, which may be a vertex, and its images under S and R.
struct FollowedPoint {
    glm::dvec3 point_world{0.0};
    glm::dvec4 shadow_homogeneous{0.0};      ///< S p, before the division by w
    std::optional<glm::dvec3> shadow_world;  ///< s = S p ÷ w; none if w = 0
    double plane_distance = 0.0;             ///< k = n·p + d
    glm::dvec3 foot_world{0.0};              ///< p − k n
    glm::dvec3 mirrored_world{0.0};          ///< R p
};

/// Residuals and depth steps. Facts about S and R are not kept here; they are measured where they are shown
/// (matrix_facts.h).
struct Facts {
    double view_residual = 0.0;              ///< largest absolute entry of V C − I
    double depth_step_at_target = 0.0;       ///< depth_step() at the camera's target
    double resolvable_step_at_target = 0.0;  ///< resolvable_depth_step() there
    double target_distance = 0.0;            ///< eye distance of the target, clamped to near … far
};

/// The shadow that one light casts on one plane.
struct CastShadow {
    glm::dvec4 light_world{0.0, 1.0, 0.0, 0.0};
    double plane_dot_light = 0.0;               ///< Π·L of the unit plane
    bool light_in_plane = false;                ///< Π·L counts as zero: the shadow is undefined
    glm::dmat4 shadowed_world_from_world{1.0};  ///< S
    bool has_slip = false;                      ///< shadow_by_rows changes S
    double sign = 1.0;                          ///< the uploaded matrix is sign · S
    bool by_hand = false;                       ///< S was entered by hand
    bool lands_far = false;                     ///< some triangles may land many patch sizes away: plan_shadow.cpp

    /// Returns whether the light shines on the side of the plane that an eye with Π·eye = `eye_side` sees.
    bool reaches(double eye_side) const { return !light_in_plane && plane_dot_light * eye_side > 0.0; }
};

/// A plane, with the shadow that each light casts on it.
struct DerivedPlane {
    glm::dvec4 unit_plane{0.0, 1.0, 0.0, 0.0};  ///< keeps the equation's sign
    PlanePatch patch{};
    double eye_side = 1.0;  ///< Π·eye: its sign gives the visible side
    bool receives_shadow = true, mirrors = true, gloss = false;
    glm::dmat4 mirrored_world_from_world{1.0};  ///< R
    bool mirror_by_hand = false;                ///< R was entered by hand
    bool mirror_has_slip = false;               ///< plus_2ab or normal_not_unit changes R
    std::vector<CastShadow> shadows;            ///< one per light, in order
};

/// Returns the w that the uploaded matrix gives a point between the light and the plane.
double w_between(const DerivedPlane& plane, const CastShadow& cast);

struct Derived {
    double aspect = 1.0;                       ///< aspect ratio of P
    glm::ivec2 view_px{1, 1};                  ///< size of the view
    double view_aspect = 1.0;                  ///< aspect ratio of the view; the picture is stretched to it
    glm::dmat4 world_from_view{1.0};           ///< C
    glm::dmat4 view_from_world{1.0};           ///< V, as uploaded (mistakes included)
    LookAt look_at;                            ///< the camera as eye, center and up, without mistakes
    glm::dmat4 clip_from_view{1.0};            ///< P, as uploaded
    glm::dmat4 clip_from_world{1.0};           ///< P V
    bool has_distances = true;                 ///< false if a V or P entered by hand makes near and far meaningless
    bool clip_zero_to_one = false;             ///< glClipControl(…, GL_ZERO_TO_ONE)
    StoredDepth stored_depth{};                ///< as measured or, without a measurement, as requested
    glm::dvec4 eye_world{0.0, 0.0, 0.0, 1.0};  ///< orthographic: direction toward the eye, with w = 0 as for a light

    std::vector<DerivedPlane> planes;      ///< one per plane of Params, so at least one
    std::vector<glm::dvec4> lights_world;  ///< at least one
    Choice chosen;

    const DerivedPlane& chosen_plane() const { return planes[chosen.plane]; }
    const CastShadow& chosen_shadow() const { return chosen_plane().shadows[chosen.light]; }  ///< on the chosen plane
    const glm::dvec4& chosen_light() const { return lights_world[chosen.light]; }

    std::optional<FollowedPoint> followed;
    bool has_decals = false;
    std::vector<int> object_marks;  ///< decal_marks() if decals use the stencil; else empty
    std::optional<HeatMap> heat;    ///< set if the picture shows depth fighting
    Facts facts;
};

Derived derive(const Params& params, const Scene& scene, const Viewport& viewport);

/// The observer's camera, for its own viewport.
struct ObserverView {
    glm::dmat4 world_from_view{1.0};
    glm::dmat4 view_from_world{1.0};
    glm::dmat4 clip_from_world{1.0};
    glm::dvec4 eye_world{0.0, 0.0, 0.0, 1.0};
};
ObserverView derive_observer(const ObserverParams& observer, const Viewport& viewport);

/// Derives the chosen light's view of everything that casts a shadow, framed to fit the picture wherever the light is.
/// In this view, each caster hides its own shadow. For a parallel light, the view rays are parallel; a light among the
/// casters sees only those in front of it. Without objects, the light looks at the chosen plane's patch.
ObserverView derive_light_view(const Derived& derived, const Scene& scene, const Viewport& viewport);

/// Derives the lecture's other interpretation of the same picture: the camera stays at the origin and V moves the
/// world.
ObserverView derive_moving_world(const ObserverParams& observer, const Derived& derived, const Viewport& viewport);

/// Returns the precision of a depth format.
DepthPrecision precision_of(DepthFormat format);

/// Returns whether GL lacks the format. If so, the sandbox's shader rounds depths to the format's codes, which a 24-bit
/// buffer stores without loss.
bool stores_fewer_bits(DepthFormat format);

/// Returns whether the shader writes depths. It then also applies the offset, one code per unit, instead of
/// glPolygonOffset.
bool writes_depth_by_shader(DepthFormat format, DepthMapping mapping, bool logarithm_per_vertex);

/// Returns whether this state's reported depths depend on the driver: on its offset unit, if an offset moves decals, or
/// on how it stores 24-bit depth, if the depth mapping makes that visible.
bool depends_on_stored_depth(const Params& params, const Scene& scene);

/// Returns the width in eye z of one stored code at the eye distance z, for this state's projection, mapping and
/// format. The result is positive and finite; a distance below near counts as near.
double depth_step(const Params& params, double z);

/// Returns the camera's pose as its numbers define it: C without mistakes.
glm::dmat4 placed_camera(const Params& params);

/// Returns P as the projection's own numbers define it: as uploaded, unless P is entered by hand.
glm::dmat4 projection_without_hand(const Params& params, const Derived& derived);

/// Returns the pose at which the uploaded matrix really puts the eye: V⁻¹. Without mistakes, it equals placed_camera();
/// if a V entered by hand has no inverse, it is C.
glm::dmat4 effective_camera(const Derived& derived);

/// Returns, in world space, the eight frustum corners of a camera with this state's projection: first the four near
/// ones, then the four far ones, each counterclockwise from the bottom left as the camera sees them. If P is entered by
/// hand and no lens produces it, returns the points that it sends to the corners of the clip range, where such points
/// exist.
std::array<glm::dvec3, 8> frustum_corners(const Params& params, const Derived& derived,
                                          const glm::dmat4& world_from_view);
/// Returns the frustum corners of the placed camera, to show the camera even while a mistake breaks V.
std::array<glm::dvec3, 8> frustum_corners(const Params& params, const Derived& derived);

}  // namespace viewing
