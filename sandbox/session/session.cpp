#include "session/session.h"

#include <algorithm>
#include <cmath>

#include "geometry/framing.h"
#include "geometry/plane.h"
#include "state/fields.h"
#include "text/catalogue.h"

namespace viewing {

Session::Session(const LoadedState& state, Scene scene)
    : params(state.params),
      base_(state.base),
      scene_(std::move(scene)),
      loaded_source_(state.params.scene),
      loaded_base_(state.base),
      preset_(state.preset),
      history_(now()),
      at_rest_(state.params),
      before_(state.params) {
    for (const std::filesystem::path& file : scene_.read) allowed_.add(file);
    begin_here();
}

Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;
Session::~Session() = default;

Result<Session> Session::make(const LoadedState& state) {
    Result<Scene> scene = load_scene(state.params.scene, state.base, state.params.coplanar,
                                     {.origin = state.scene_origin, .reach = state.reach});
    if (!scene) return Error{scene.error()};
    return Session(state, std::move(*scene));
}

void Session::remake_scene() {
    if (!scene_.made_from || *scene_.made_from == params.coplanar) return;
    Result<Scene> made = load_scene(SceneDescription{{}, SceneFormula::coplanar}, {}, params.coplanar);
    if (!made) return report(Error{made.error()});
    scene_ = std::move(*made);
    ++scene_version_;
}

void Session::aim_at_target() {
    CameraParams& camera = params.camera;
    const glm::dvec3 to_target = camera.target - camera.position;
    const glm::dvec3 forward = -glm::dvec3(rotation_from_angles(camera.angles())[2]);
    const double half_view_deg =
        params.projection.type == ProjectionType::perspective ? std::abs(params.lens().fovy_deg) * 0.5 : 20.0;
    const double distance = glm::length(to_target);
    if (distance == 0.0 || glm::dot(forward, to_target) >= distance * std::cos(glm::radians(half_view_deg))) return;
    const Angles angles = angles_looking_at(camera.position, camera.target);
    camera.yaw = angles.yaw_deg;
    camera.pitch = angles.pitch_deg;
    camera.roll = angles.roll_deg;
}

void Session::navigate(const MotionInput& input, double dt_s) {
    const bool begins = motion_.at_rest() && !input.idle();
    if (begins && params.camera.navigation == Navigation::orbit && !params.slips.pole_flip) aim_at_target();
    const Pose before{params.camera.position, params.camera.angles(), params.camera.target};
    const MotionSlips slips{params.slips.walk_slows, params.slips.creeping_roll, params.slips.pole_flip};
    const Navigation mode = params.camera.navigation;
    const Pose after = step(before, motion_, input, mode, slips, tuning_, dt_s);
    moving_ = viewing::moving_freedoms(motion_, input, mode);
    asked_ = viewing::asked_freedoms(input);
    params.camera.position = after.position;
    params.camera.yaw = after.angles.yaw_deg;
    params.camera.pitch = after.angles.pitch_deg;
    params.camera.roll = after.angles.roll_deg;
    params.camera.target = after.target;
    clamp_to_ranges(params);
}

void Session::set_speed(double speed) {
    tuning_.speed = std::clamp(speed, least_speed, greatest_speed);
}

void Session::begin_here() {
    home_ = params.camera;
    home_projection_ = params.projection;
}

void Session::go_home() {
    const Navigation mode = params.camera.navigation;
    params.camera = home_;
    params.camera.navigation = mode;
    params.projection.height = home_projection_.height;
    params.projection.set_window(home_projection_.window());
    motion_ = {};
}

void Session::frame_all(double aspect) {
    Bounds all = scene_.bounds_world;
    for (const PlaneParams& plane : params.planes)
        for (const glm::dvec3& corner : plane_patch(plane.equation, plane.extent).corners()) all.add(corner);
    // Include a point light unless the scene would then be a speck in the picture.
    constexpr double most_scene_sizes = 3.0;
    const glm::dvec3 center = all.center();
    const double farthest = most_scene_sizes * glm::length(all.size());
    for (const LightParams& light : params.lights) {
        if (is_parallel_light(light.position)) continue;
        const glm::dvec3 at = glm::dvec3(light.position) / light.position.w;
        if (glm::distance(at, center) <= farthest) all.add(at);
    }
    CameraParams& camera = params.camera;
    const Framing found = framing(all, camera.angles(), params.lens(), aspect);
    camera.position = found.eye;
    camera.target = all.center();
    if (params.projection.is_orthographic())
        params.projection.scale_picture(found.height / params.lens().edges_at(1.0, aspect).height());
    motion_ = {};
    clamp_to_ranges(params);
}

void Session::level() {
    params.camera.roll = 0.0;
    motion_.turn_rate_deg.z = 0.0;
}

void Session::look_along(int axis) {
    static constexpr Angles from_front[] = {{90.0, 0.0, 0.0}, {0.0, -90.0, 0.0}, {0.0, 0.0, 0.0}};
    static constexpr Angles from_behind[] = {{-90.0, 0.0, 0.0}, {0.0, 90.0, 0.0}, {180.0, 0.0, 0.0}};
    CameraParams& camera = params.camera;
    const Angles angles = camera.angles() == from_front[axis] ? from_behind[axis] : from_front[axis];
    const double distance = std::max(glm::distance(camera.position, camera.target), params.projection.near);
    const glm::dvec3 back(rotation_from_angles(angles)[2]);
    camera.position = camera.target + distance * back;
    camera.yaw = angles.yaw_deg;
    camera.pitch = angles.pitch_deg;
    camera.roll = angles.roll_deg;
    motion_ = {};
    clamp_to_ranges(params);
}

Session::Step Session::now() const {
    Step step{params, preset_, base_};
    step.params.ui.language = UiParams{}.language;
    return step;
}

void Session::rest() {
    at_rest_.ui.language = params.ui.language;
    if (awaits_scene() || !history_.rest(now())) return;
    before_ = at_rest_;
    at_rest_ = params;
}

void Session::undo() {
    if (wanted_ && wanted_->is_whole) return cancel_loading();      // the state being read is not a step yet
    if (awaits_scene() && params != at_rest_) return keep_scene();  // nor is a change that awaits its scene
    rest();
    if (const std::optional<Step> earlier = history_.undo()) {
        ++steps_back_;
        take_over(*earlier);
    }
}

void Session::redo() {
    rest();
    if (const std::optional<Step> later = history_.redo()) {
        --steps_back_;
        take_over(*later);
    }
}

void Session::take_over(const Step& step) {
    before_ = params;
    const Language language = params.ui.language;
    params = at_rest_ = step.params;
    params.ui.language = at_rest_.ui.language = language;
    preset_ = step.preset;
    base_ = step.base;
    motion_ = {};
}

Params Session::in_own_looks(Params other) const {
    other.ui = params.ui;
    return other;
}

bool Session::departs_from_preset() const {
    if (!preset_) return false;
    Params as_it_was = in_own_looks(preset_->params);
    as_it_was.view.layout = params.view.layout;
    return as_it_was != params;
}

void Session::return_to_preset() {
    if (!preset_) return;
    const LayoutParams layout = params.view.layout;
    params = in_own_looks(preset_->params);
    params.view.layout = layout;
    motion_ = {};
}

void Session::reset() {
    if (const Result<LoadedState> opening = load_state("")) preset_ = opening->preset;
    const UiParams own = own_looks();
    params = {};
    params.ui = own;
    begin_here();
    motion_ = {};
    message = {tr("everything was reset; Ctrl+Z brings the state back"), false};
}

}  // namespace viewing
