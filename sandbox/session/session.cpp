#include "session/session.h"

#include <algorithm>
#include <cmath>

#include "geometry/framing.h"
#include "geometry/plane.h"
#include "platform/background.h"
#include "platform/file.h"
#include "state/fields.h"
#include "state/json.h"
#include "text/catalogue.h"

namespace viewing {
namespace {

/// Most scenes are there at once: a short wait spares a frame with the old one.
constexpr double a_moment_s = 0.02;

}  // namespace

/// A scene being loaded off the user interface's thread.
struct Session::LoadJob {
    SceneSource source;
    std::filesystem::path base;
    BackgroundTask<Scene> task;

    LoadJob(SceneSource wanted, std::filesystem::path folder, const CoplanarParams& coplanar,
            std::string origin = "scene")
        : source(std::move(wanted)), base(std::move(folder)) {
        task.start([source = source, base = base, coplanar, origin = std::move(origin)](WorkProgress& progress) {
            return load_scene(source, base, coplanar, &progress, origin);
        });
    }
};

Session::Session(const LoadedState& state, Scene scene)
    : params(state.params),
      base_(state.base),
      scene_(std::move(scene)),
      loaded_source_(state.params.scene),
      loaded_base_(state.base),
      preset_(state.preset),
      history_(Step{state.params, state.preset}),
      at_rest_(state.params),
      before_(state.params) {
    begin_here();
}

Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;
Session::~Session() = default;

Result<Session> Session::make(const LoadedState& state) {
    Result<Scene> scene = load_scene(state.params.scene, state.base, state.params.coplanar);
    if (!scene) return Error{scene.error()};
    return Session(state, std::move(*scene));
}

Result<Session> Session::begin(const LoadedState& state, double patience_s) {
    auto job = std::make_unique<LoadJob>(state.params.scene, state.base, state.params.coplanar, state.scene_origin);
    job->task.wait(patience_s);
    if (std::optional<Result<Scene>> loaded = job->task.take()) {
        if (!*loaded) return Error{loaded->error()};
        return Session(state, **std::move(loaded));
    }
    const Params opening;
    Result<Scene> scene = load_scene(opening.scene, {}, opening.coplanar);
    if (!scene) return Error{scene.error()};
    Session session(state, *std::move(scene));
    session.loaded_source_ = opening.scene;
    session.loaded_base_.clear();
    session.job_ = std::move(job);
    return session;
}

void Session::update_scene() {
    const bool wanted = awaits_scene();
    if (job_ && (!wanted || job_->source != params.scene || job_->base != base_)) job_.reset();
    if (!wanted) {
        before_replacing_.reset();
        remake_scene();
        return;
    }
    if (!job_) job_ = std::make_unique<LoadJob>(params.scene, base_, params.coplanar);
    job_->task.wait(a_moment_s);
    std::optional<Result<Scene>> loaded = job_->task.take();
    if (!loaded) return;
    if (*loaded) {
        scene_ = std::move(**loaded);
        loaded_source_ = job_->source;
        loaded_base_ = job_->base;
        ++scene_version_;
        job_.reset();
        before_replacing_.reset();
    } else {
        message = {loaded->error(), true};
        keep_scene();
    }
}

void Session::remake_scene() {
    if (!scene_.made_from || *scene_.made_from == params.coplanar) return;
    Result<Scene> made = load_scene(SceneDescription{{}, SceneFormula::coplanar}, {}, params.coplanar);
    if (!made) return report(Error{made.error()});
    scene_ = std::move(*made);
    ++scene_version_;
}

void Session::keep_scene() {
    if (before_replacing_) {
        params = before_replacing_->params;
        preset_ = before_replacing_->preset;
    }
    params.scene = loaded_source_;
    base_ = loaded_base_;
    before_replacing_.reset();
    job_.reset();
}

void Session::finish_loading() {
    update_scene();
    while (job_) {
        job_->task.wait(-1.0);
        update_scene();
    }
}

std::optional<float> Session::loading_fraction() const {
    if (!job_) return std::nullopt;
    return job_->task.fraction();
}

std::string Session::loading_name() const {
    if (!job_) return {};
    if (const auto* name = std::get_if<std::string>(&job_->source)) return *name;
    const SceneDescription& scene = std::get<SceneDescription>(job_->source);
    return scene.objects.empty() ? tr("scene") : scene.objects.front().name;
}

void Session::cancel_loading() {
    if (!job_) return;
    keep_scene();
    message = {tr("loading cancelled: the scene is as it was"), false};
}

void Session::aim_at_target() {
    CameraParams& camera = params.camera;
    const glm::dvec3 to_target = camera.target - camera.position;
    const glm::dvec3 forward = -glm::dvec3(rotation_from_angles(camera.angles())[2]);
    const double half_view_deg =
        params.projection.type == ProjectionType::perspective ? params.projection.fovy * 0.5 : 20.0;
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
    home_height_ = params.projection.height;
}

void Session::go_home() {
    const Navigation mode = params.camera.navigation;
    params.camera = home_;
    params.camera.navigation = mode;
    params.projection.height = home_height_;
    motion_ = {};
}

void Session::frame_all(double aspect) {
    Bounds all = scene_.bounds_world;
    for (const PlaneParams& plane : params.planes)
        for (const glm::dvec3& corner : plane_patch(plane.equation, plane.extent).corners()) all.add(corner);
    CameraParams& camera = params.camera;
    const Framing found = framing(all, camera.angles(), params.projection.lens(), aspect);
    camera.position = found.eye;
    camera.target = all.center();
    if (params.projection.type == ProjectionType::orthographic) params.projection.height = found.height;
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

void Session::rest() {
    if (awaits_scene() || !history_.rest({params, preset_})) return;
    before_ = at_rest_;
    at_rest_ = params;
}

void Session::undo() {
    if (awaits_scene() && params != at_rest_) return keep_scene();  // no step yet
    rest();
    if (const std::optional<Step> earlier = history_.undo()) take_over(*earlier);
}

void Session::redo() {
    rest();
    if (const std::optional<Step> later = history_.redo()) take_over(*later);
}

void Session::take_over(const Step& step) {
    before_ = params;
    params = at_rest_ = step.params;
    preset_ = step.preset;
    motion_ = {};
}

bool Session::departs_from_preset() const {
    if (!preset_) return false;
    Params as_it_was = preset_->params;
    as_it_was.ui = params.ui;
    return as_it_was != params;
}

void Session::return_to_preset() {
    if (!preset_) return;
    const UiParams ui = params.ui;
    params = preset_->params;
    params.ui = ui;
    motion_ = {};
}

void Session::reset() {
    if (const Result<LoadedState> opening = load_state("")) preset_ = opening->preset;
    const UiParams ui = params.ui;
    params = Params{};
    params.ui = ui;
    begin_here();
    motion_ = {};
    message = {tr("everything is as at the start; Ctrl+Z brings the state back"), false};
}

void Session::replace(const LoadedState& state) {
    if (!before_replacing_) before_replacing_ = Step{params, preset_};
    params = state.params;
    preset_ = state.preset;
    base_ = state.base;
    begin_here();
    motion_ = {};
}

Status Session::open(const std::string& argument) {
    if (is_obj_file(argument)) {
        params.scene = std::filesystem::absolute(argument).string();
        return std::monostate{};
    }
    Result<LoadedState> state = load_state(argument);
    if (!state) return Error{state.error()};
    // A state that says nothing of its looks keeps the ones that the person has chosen.
    if (state->params.ui == UiParams{}) state->params.ui = params.ui;
    replace(*state);
    message = {say("opened {file}", "file"_a = argument), false};
    return std::monostate{};
}

Status Session::paste(const std::string& text) {
    Result<Params> pasted = parse_state(text, "clipboard");
    if (!pasted) return Error{pasted.error()};
    replace({*pasted, base_});
    message = {tr("state pasted from the clipboard"), false};
    return std::monostate{};
}

std::string Session::text() const {
    // A relative name that is a file beside the state means nothing elsewhere; names of assets stay.
    const auto from_root = [this](std::string& name) {
        const std::filesystem::path file = base_ / name;
        std::error_code ignored;
        if (std::filesystem::is_regular_file(file, ignored))
            name = std::filesystem::absolute(file).lexically_normal().string();
    };
    Params portable = params;
    if (auto* name = std::get_if<std::string>(&portable.scene))
        from_root(*name);
    else
        for (ObjectDescription& object : std::get<SceneDescription>(portable.scene).objects)
            if (object.shape == ShapeKind::mesh) from_root(object.file);
    return write_state(portable);
}

Status Session::save(const std::filesystem::path& file) {
    const std::string whole = text();
    Status written = write_file(file, {reinterpret_cast<const std::uint8_t*>(whole.data()), whole.size()});
    if (written) message = {say("saved {file}", "file"_a = file.string()), false};
    return written;
}

}  // namespace viewing
