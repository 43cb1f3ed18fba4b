#include "topics/camera/numbers/clip_space.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

namespace viewing {
namespace {

constexpr double usual_distance = 5.8;  ///< from the outside camera to the cube's middle

double mixed(double from, double to, double share) {
    return from + share * (to - from);
}

/// Returns the map that moves and scales eye space so that the frustum fits the cube.
glm::dmat4 centered_from_view(const Lens& lens, double aspect) {
    const double n = lens.near, f = lens.shown_far();
    const Edges edges = lens.edges_at(f, aspect);
    const double scale = 2.0 / std::max({f - n, std::abs(edges.width()), std::abs(edges.height())});
    glm::dmat4 centered(scale);
    centered[3] = {-scale * edges.center().x, -scale * edges.center().y, 0.5 * scale * (n + f), 1.0};
    return centered;
}

/// Returns the map from eye space to (x, y, −w) of clip space, scaled to fit the cube. For an orthographic P, whose w
/// is 1, eye z replaces −w.
glm::dmat4 centered_clip_from_view(const Lens& lens, const glm::dmat4& clip_from_view, double aspect) {
    const double scale = lens.orthographic ? 1.0 : 1.0 / lens.shown_far();
    glm::dmat4 centered = centered_from_view(lens, aspect);
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 2; ++row) centered[column][row] = scale * clip_from_view[column][row];
    if (lens.orthographic) return centered;
    centered[2][2] = scale;
    centered[3][2] = 0.5 * scale * (lens.near + lens.shown_far());
    return centered;
}

/// Returns the map that centers the z range of NDC at 0, with near toward +z.
glm::dmat4 centered_from_ndc(const Lens& lens, const glm::dmat4& clip_from_view) {
    const auto ndc_z = [&](const glm::dvec4& point_view) {
        const glm::dvec4 clip = clip_from_view * point_view;
        return clip.z / clip.w;
    };
    const double at_near = ndc_z({0.0, 0.0, -lens.near, 1.0});
    const double at_far = ndc_z({0.0, 0.0, lens.is_infinite() ? -1.0 : -lens.far, lens.is_infinite() ? 0.0 : 1.0});
    glm::dmat4 centered(1.0);
    centered[2][2] = at_near < at_far ? -1.0 : 1.0;
    centered[3][2] = -0.5 * (at_near + at_far) * centered[2][2];
    return centered;
}

/// Returns the clip w in the middle of the frustum. It weights the matrix that is blended with P, so that the two
/// contribute equally.
double middle_w(const Lens& lens) {
    return lens.orthographic ? 1.0 : std::sqrt(lens.near * lens.shown_far());
}

double outside_fovy(double aspect) {
    constexpr double usual_fovy_deg = 40.0, usual_aspect = 1.3;
    return widened_fovy(usual_fovy_deg, aspect, usual_aspect);
}

double outside_distance(const Params& params) {
    return usual_distance * params.observer.distance / ObserverParams{}.distance;
}

/// Returns the map from the world to the cube's space, at the size that the observer's view shows.
glm::dmat4 centered_from_world(const ObserverParams& observer) {
    const double scale = usual_distance / ObserverParams{}.distance;
    glm::dmat4 centered(scale);
    centered[3] = glm::dvec4(-scale * observer.target, 1.0);
    return centered;
}

/// Interpolates between two similarities: scale, rotation and the position of `fixed` change steadily.
glm::dmat4 between(const glm::dmat4& from, const glm::dmat4& to, double share, const glm::dvec3& fixed) {
    const double from_scale = glm::length(glm::dvec3(from[0])), to_scale = glm::length(glm::dvec3(to[0]));
    const glm::dquat from_turn = glm::quat_cast(glm::dmat3(from) / from_scale);
    const glm::dquat to_turn = glm::quat_cast(glm::dmat3(to) / to_scale);
    const double scale = from_scale * std::pow(to_scale / from_scale, share);
    const glm::dmat3 turned = scale * glm::mat3_cast(glm::slerp(from_turn, to_turn, share));
    const auto image = [&fixed](const glm::dmat4& map) { return glm::dvec3(map * glm::dvec4(fixed, 1.0)); };
    glm::dmat4 map(turned);
    map[3] = glm::dvec4(glm::mix(image(from), image(to), share) - turned * fixed, 1.0);
    return map;
}

/// The camera that looks at the cube from outside.
struct Outside {
    Angles angles;
    double fovy_deg, distance;
};

/// Derives the view from outside, in the part `free` of the picture.
ObserverView seen_from_outside(const Outside& outside, const Derived& derived, const glm::dmat4& cube_from_world,
                               const Viewport& viewport, const Edges& free) {
    const double aspect = viewport.aspect() * free.aspect();
    const glm::dvec3 back(rotation_from_angles(outside.angles)[2]);
    const glm::dmat4 outside_from_cube = view_from_world(world_from_view(outside.distance * back, outside.angles));
    const Lens lens{false, outside.fovy_deg, 6.0, outside.distance * 0.01, outside.distance * 100.0};
    glm::dmat4 picture_from_free(1.0);
    picture_from_free[0][0] = 0.5 * free.width();
    picture_from_free[1][1] = 0.5 * free.height();
    picture_from_free[3] = glm::dvec4(free.center(), 0.0, 1.0);
    ObserverView view;
    view.view_from_world = derived.view_from_world;
    view.world_from_view = effective_camera(derived);
    view.eye_world = derived.eye_world;
    view.clip_from_world = picture_from_free * clip_from_view(lens, aspect) * outside_from_cube * cube_from_world;
    return view;
}

}  // namespace

glm::dmat4 division_from_view(const Params& params, const Derived& derived) {
    const Lens lens = params.lens();
    const double t = params.view.division;
    const glm::dmat4& p = derived.clip_from_view;
    return (1.0 - t) * middle_w(lens) * centered_from_view(lens, derived.aspect) + t * centered_from_ndc(lens, p) * p;
}

ObserverView derive_clip_view(const Params& params, const Derived& derived, const Viewport& viewport) {
    // The picture's upper part; a sentence and the slider are below.
    constexpr Edges free{-0.85, 0.85, -0.7, 1.0};
    const Outside outside{{params.observer.yaw, params.observer.pitch, 0.0},
                          outside_fovy(viewport.aspect() * free.aspect()),
                          outside_distance(params)};
    return seen_from_outside(outside, derived, division_from_view(params, derived) * derived.view_from_world, viewport,
                             free);
}

glm::dmat4 way_from_world(const Params& params, const Derived& derived) {
    const Lens lens = params.lens();
    const double way = std::clamp(params.view.way, 0.0, static_cast<double>(way_steps));
    const glm::dmat4 &v = derived.view_from_world, &p = derived.clip_from_view;
    const glm::dmat4 eye = centered_from_view(lens, derived.aspect);
    if (way < 1.0)
        return between(centered_from_world(params.observer), eye * v, way, glm::dvec3(effective_camera(derived)[3]));
    const glm::dmat4 clip = centered_clip_from_view(lens, p, derived.aspect);
    if (way < 2.0) return (eye + (way - 1.0) * (clip - eye)) * v;
    const glm::dmat4 ndc = centered_from_ndc(lens, p) * p;
    if (way < 3.0) return ((3.0 - way) * middle_w(lens) * clip + (way - 2.0) * ndc) * v;
    glm::dmat4 window(1.0);
    window[0][0] = mixed(1.0, derived.view_aspect, way - 3.0);
    return window * ndc * v;
}

ObserverView derive_way_view(const Params& params, const Derived& derived, const Viewport& viewport,
                             const Edges& free) {
    const double share = std::clamp(params.view.way - 3.0, 0.0, 1.0);  // how much of the turn to the front is done
    constexpr double front_fovy_deg = 2.0, margin = 1.25;
    const double aspect = viewport.aspect() * free.aspect();
    const double from_fovy_deg = outside_fovy(aspect), fovy_deg = mixed(from_fovy_deg, front_fovy_deg, share);
    // `half` is half the height that the picture shows at the cube's middle; for the view from the front, it becomes
    // `front_half`, just enough for the whole window. The camera is nearer than in the view "Clip space", since the
    // numbers leave the cube less room.
    constexpr std::array nearer{0.75, 0.6, 0.68, 0.78, 0.78};
    const auto space = static_cast<std::size_t>(std::clamp(params.view.way, 0.0, way_steps - 1e-9));
    const double near_share = mixed(nearer[space], nearer[space + 1], params.view.way - static_cast<double>(space));
    const double half = near_share * outside_distance(params) * std::tan(glm::radians(0.5 * from_fovy_deg));
    const double front_half = margin * std::max(1.0, derived.view_aspect / aspect);
    const Outside outside{
        {mixed(std::remainder(params.observer.yaw, 360.0), 0.0, share), mixed(params.observer.pitch, 0.0, share), 0.0},
        fovy_deg,
        mixed(half, front_half, share) / std::tan(glm::radians(0.5 * fovy_deg))};
    return seen_from_outside(outside, derived, way_from_world(params, derived), viewport, free);
}

}  // namespace viewing
