// A frame of the window. Except in the very first frame, the interface draws its windows twice. The first drawing takes
// the input and edits the session, and is never shown. The second drawing shows the result. In between, the frame is
// derived, planned and drawn once, so pictures, overlays, panels and matrices all belong to the state that this frame's
// input made. The second drawing is an ImGui frame of its own in which no time passes, no pointer moves, and no button
// or key changes, so widgets only show. It costs less than a millisecond and saves splitting the interface's rows, most
// of which both edit and show. A result of background work that arrives during the second drawing waits for the next
// frame.
#include "app/studio.h"

#include <backends/imgui_impl_opengl3.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "gl/dialect.h"
#include "grading/state_numbers.h"
#include "platform/background.h"
#include "state/file/state_json.h"
#include "text/catalogue.h"
#include "topics/depth/shown/pixel_words.h"
#include "ui/views/lower_view.h"
#include "ui/window/fonts.h"
#include "ui/window/recording.h"

namespace viewing {
namespace {

constexpr double slow_ms = 80.0;  // a frame this slow no longer keeps up with a drag

/// Returns the shorter of two delays until a redraw; a negative delay means never.
double sooner(double a_s, double b_s) {
    return a_s < 0.0 || b_s < 0.0 ? std::max(a_s, b_s) : std::min(a_s, b_s);
}

/// Returns a lens that shows as much width as at the least aspect ratio; 0: the same lens.
ProjectionParams widened(ProjectionParams lens, double aspect, double least_aspect) {
    if (least_aspect <= 0.0) return lens;
    lens.fovy = widened_fovy(lens.fovy, aspect, least_aspect);
    lens.height *= std::max(1.0, least_aspect / aspect);
    return lens;
}

}  // namespace

Studio::Studio(Renderer& renderer, Session opened)
    : session(std::move(opened)),
      renderer_(renderer),
      renderer_name_(gl::driver_name()),
      pictures_(renderer),
      inspection_(renderer),
      preset_pictures_(renderer),
      judge_(renderer) {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // write no file that the user did not name
    io.LogFilename = nullptr;
    io.ConfigWindowsMoveFromTitleBarOnly = true;
    ImGui_ImplOpenGL3_Init(gl::shader_version());
}

Studio::~Studio() {
    ImGui_ImplOpenGL3_Shutdown();
    keep_fonts();
    ImGui::DestroyContext();
}

void Studio::set_ground(Color color) {
    ground_ = IM_COL32(color.r, color.g, color.b, 255);
    pictures_.set_background(color);
}

Status Studio::draw_views(const Layout& layout, const Scene& scene, bool is_interactive) {
    // If the scene is slow to draw, update only the view that is being dragged; the others catch up at rest.
    views_are_behind_ = is_interactive && frame_ms_ > slow_ms && is_held();
    camera_is_behind_ = layout.camera.empty() || &scene != &session.scene();
    if (!views_are_behind_) return pictures_.draw(shown_, scene, layout);
    for (const Slot slot : {Slot::left, Slot::right}) {
        const ViewName name = slot == Slot::left ? ViewName::lower_left : ViewName::lower_right;
        const bool is_moved = workbench.views.hovered == name && lower_view(shown_.params, slot).turns;
        if (!is_moved) continue;
        camera_is_behind_ = true;
        return pictures_.draw_lower(slot, shown_, scene, layout);
    }
    return pictures_.draw_camera(shown_, scene, layout);
}

const View& Studio::camera_view() {
    if (std::exchange(camera_is_behind_, false)) session.report(pictures_.draw_unseen_camera(shown_, session.scene()));
    return pictures_.camera();
}

Params Studio::shown_params() const {
    Params shown = session.portable(shown_.params);
    shown.projection = session.params.projection;                  // on stage, the projection shown may be wider
    shown.animation.jiggle = shown.animation.light_orbit = false;  // their motion is already applied
    return shown;
}

std::string Studio::shown_state() const {
    return write_state(shown_params());
}

bool Studio::is_held() const {
    return session.is_moving() || ImGui::IsAnyItemActive();
}

void Studio::update(const Layout& layout, const Surroundings& surroundings) {
    if (!layout.camera.empty()) shown_.camera_px = layout.camera.size_px();  // otherwise another view fills the window
    const bool is_interactive = surroundings.shows_time;
    // For the user's first picture, measure the driver's depth format only if the picture depends on it.
    const bool knows_driver = is_interactive && drawn_.scene_version >= 0;
    const Viewport viewport = knows_driver ? renderer_.viewport(shown_.camera_px, shown_.params.depth.format)
                                           : renderer_.viewport(shown_.camera_px, shown_.params, session.scene());
    shown_.params.projection = widened(session.params.projection, viewport.aspect(), workbench.stage.least_aspect);
    Drawn wanted{session.params,
                 session.scene_version(),
                 shown_.params,
                 layout.camera.size_px(),
                 layout.beside.size_px(),
                 layout.lower_left.size_px(),
                 layout.lower_right.size_px(),
                 drawn_.hidden,
                 drawn_.is_coarse,
                 knows_driver};
    derive_before(viewport);
    if (wanted != drawn_) shown_.derived = derive(shown_.params, session.scene(), viewport);
    if (wanted != drawn_ || answer_.is_behind())
        session.report(
            answer_.update(renderer_, shown_.params, shown_.derived, session, shown_.camera_px, is_interactive));
    wanted.hidden = shown_.hidden = answer_.get();
    if (is_interactive) stand_ins_.follow(session.scene(), session.scene_version());
    const Scene* const coarse = stand_ins_.choose(is_interactive && is_held(), frame_ms_ > slow_ms);
    wanted.is_coarse = coarse != nullptr;
    const bool catches_up = views_are_behind_ && !is_held();
    if (wanted == drawn_ && !catches_up) return;
    const HiddenPictures found = shown_.hidden ? shown_.hidden->pictures : HiddenPictures{};
    shown_.plan = plan(shown_.params, shown_.derived, found);
    shown_.problems = find_problems(shown_.params, shown_.derived, session.scene(), shown_.plan);
    if (shown_.hidden && !answer_.is_behind())
        if (const std::optional<Problem> wrong = painter_problem(*shown_.hidden)) shown_.problems.push_back(*wrong);
    shown_.pinned = pinned_pixel(shown_.params, shown_.derived, shown_.plan, session.scene(), shown_.camera_px);
    const Params inspected = probed(shown_.params);
    shown_.inspected = inspected == shown_.params ? shown_.plan : plan(inspected, shown_.derived, found);
    session.report(draw_views(layout, coarse ? *coarse : session.scene(), is_interactive));
    drawn_ = wanted;
    inspection_.forget();
    if (!moves_) settling_ = std::max(settling_, 2);
}

void Studio::derive_before(const Viewport& viewport) {
    Params before = animated(session.before_latest_edit(), moment_);
    before.projection = widened(before.projection, viewport.aspect(), workbench.stage.least_aspect);
    const bool is_same_room = session.scene_version() == drawn_.scene_version && viewport == before_of_.viewport;
    if (is_same_room && before == before_of_.params) return;
    // When an edit begins, the state before the edit is the one that was last drawn.
    const bool is_drawn = is_same_room && before == drawn_.animated;
    shown_.before = is_drawn ? shown_.derived : derive(before, session.scene(), viewport);
    before_of_ = {before, viewport};
}

StatusLine Studio::status(bool shows_time) {
    StatusLine status{renderer_name_, shows_time ? fmt::format("{:5.1f} ms", frame_ms_) : "–", {}};
    if (drawn_.is_coarse) status.told = {stand_ins_.sentence()};
    const auto& pixel = workbench.views.hovered_pixel;
    if (!pixel || is_held()) {
        inspection_.leave_pixel();
        return status;
    }
    if (const auto report = inspection_.at(shown_, session, pictures_.camera().size_px(), *pixel, !shows_time))
        status.told = pixel_words(*report);
    return status;
}

void Studio::gather_content(const Surroundings& surroundings) {
    shown_pictures_ = pictures_.textures();
    shown_pictures_.hidden = {shown_.hidden, answer_.fraction(), surroundings.shows_time};
    shown_pictures_.depth = inspection_.data(shown_, session, !surroundings.shows_time, is_held());
    const bool waits = !surroundings.shows_time;
    shown_pictures_.preset = preset_pictures_.of(workbench.wanted_preset_picture(), waits);
    for (const CardPicture& card : workbench.wanted_cards())
        shown_pictures_.cards.push_back(preset_pictures_.of(card.key, card.load, card.size_px, waits));
    shown_status_ = status(surroundings.shows_time);
    workbench.views.pinned = shown_.pinned;
    workbench.views.why.told = inspection_.why();
}

WindowContent Studio::content() const {
    return {shown_.derived, shown_.before, shown_.plan, shown_.problems, shown_pictures_, shown_status_};
}

Requests Studio::react(const Surroundings& surroundings) {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
    const Requests requests = workbench.draw(session, content(), surroundings.input);
    const bool may_wait = surroundings.shows_time;
    if (judge_.update(workbench, session, {requests.check_answer, is_held(), may_wait}))
        settling_ = std::max(settling_, 2);
    if (requests.cancel_hidden) answer_.cancel();
    if (requests.restart_hidden) answer_.restart();
    return requests;
}

void Studio::paint() {
    if (std::exchange(is_painted_, true)) return;
    ImDrawData* const data = ImGui::GetDrawData();
    const glm::ivec2 size_px(data->DisplaySize.x, data->DisplaySize.y);
    if (window_.size_px() != size_px) window_ = gl::ColorTarget(size_px);
    glBindFramebuffer(GL_FRAMEBUFFER, window_.framebuffer());
    glViewport(0, 0, size_px.x, size_px.y);
    const ImVec4 ground = ImGui::ColorConvertU32ToFloat4(workbench.widgets.palette.ground);
    glClearColor(ground.x, ground.y, ground.z, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(data);
}

void Studio::make_exercises() {
    using Clock = std::chrono::steady_clock;
    ExerciseDesk& exercises = workbench.exercises.desk;
    const Clock::time_point end = Clock::now() + a_moment;
    while (const std::optional<std::size_t> next = exercises.next_to_make()) {
        const ExerciseDesk::Entry& entry = exercises.entries()[*next];
        exercises.take_step(*next, variant_step(entry.exercise, entry.variant, numbers_at_start(&renderer_)));
        settling_ = std::max(settling_, 2);
        if (Clock::now() > end) return;
    }
}

void Studio::record(double dt_s) {
    FlightRecorder& recorder = workbench.recorder;
    recorder.pass(dt_s);
    if (!recorder.is_recording() || session.awaits_scene()) return;
    recorder.note(shown_params());
}

double Studio::next_redraw_in_s() const {
    const bool behind = (views_are_behind_ || drawn_.is_coarse) && !ImGui::IsAnyItemActive();
    const bool leads = workbench.guide.is_revealing() || workbench.guide.is_reading() ||
                       workbench.replay.is_playing() || workbench.exercises.desk.next_to_make().has_value();
    const bool busy = workbench.korean.has_new() || leads || session.is_moving() || settling_ > 0 || behind ||
                      session.params != drawn_.params || is_playing(workbench.views) || moves_;
    const bool works = session.loading_fraction() || answer_.is_behind() || workbench.views.hidden.is_busy() ||
                       inspection_.wants_frames() || preset_pictures_.is_busy() || workbench.is_checking ||
                       judge_.computes_model();
    if (busy) return 0.0;
    if (inspection_.reads_back()) return 0.05;
    if (works) return 0.1;  // shows the progress; the end of background work wakes the window
    const double recorded_s = workbench.recorder.seconds();
    double in_s = static_cast<double>(widgets::RedrawIn(workbench.widgets));
    in_s = sooner(in_s, message_ends_in_s(session.message));
    in_s = sooner(in_s, workbench.exercises.desk.update_due_in_s(ImGui::GetTime()));
    if (workbench.recorder.is_recording()) in_s = sooner(in_s, std::floor(recorded_s) + 1.0 - recorded_s);
    if (workbench.guide.watches_file()) in_s = sooner(in_s, 1.0);
    const PresenterMode& presenter = workbench.presenter;
    if (presenter.has_running_clock()) in_s = sooner(in_s, 0.5);
    if (presenter.is_on()) in_s = sooner(in_s, 60.0 - std::fmod(presenter.presented_s(), 60.0));  // notes show minutes
    return in_s;
}

void Studio::follow_looks(const Surroundings& surroundings) {
    if (!looks_.follow(session.params.ui, surroundings.device_scale, ImGui::GetIO().DisplaySize,
                       workbench.arranged(session), workbench.korean, workbench.widgets))
        return;
    settling_ = 3;
    if (ground_) {
        widgets::Palette& palette = workbench.widgets.palette;
        palette.ground = palette.view_ground = palette.raised = *ground_;
        ImGui::GetStyle().Colors[ImGuiCol_WindowBg] = ImGui::ColorConvertU32ToFloat4(*ground_);
    }
    if (!looks_.trouble().empty()) session.message = {looks_.trouble(), true};
}

void Studio::animate(const Surroundings& surroundings) {
    const AnimationParams& animation = session.params.animation;
    const bool has_begun = surroundings.shows_time && (animation.jiggle || animation.light_orbit);
    moves_ = surroundings.shows_time && is_animated(session.params);
    moment_ = moves_ ? advanced(moment_, session.params, surroundings.input.dt_s) : has_begun ? moment_ : Moment{};
    shown_.params = animated(session.params, moment_);
}

void Studio::prepare(const Surroundings& surroundings) {
    session.update_scene();
    make_exercises();
    workbench.set_stage(session);
    follow_looks(surroundings);
    animate(surroundings);
    update(workbench.layout(ImGui::GetIO().DisplaySize, session), surroundings);
    if (!views_are_behind_ && !drawn_.is_coarse)
        session.report(inspection_.read(shown_, session, workbench.views, !surroundings.shows_time));
    record(surroundings.input.dt_s);
    gather_content(surroundings);
}

Requests Studio::frame(const Surroundings& surroundings) {
    const auto started = std::chrono::steady_clock::now();
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(surroundings.size_px.x), static_cast<float>(surroundings.size_px.y)};
    io.DeltaTime = static_cast<float>(std::max(surroundings.input.dt_s, 1e-4));
    const bool is_first = drawn_.scene_version < 0;  // nothing has been shown to which the user could have reacted
    Requests requests;
    if (!is_first) {
        requests = react(surroundings);
        ImGui::EndFrame();
        io.DeltaTime = 1e-6F;  // ImGui wants some time to pass
    }
    prepare(surroundings);
    if (is_first) {
        requests = react(surroundings);
    } else {
        ImGui::NewFrame();
        workbench.show(session, content(), surroundings.input);
    }
    ImGui::Render();
    // A frozen picture stays on screen. The first frozen frame is the exception: its message says that it is frozen.
    const bool was_frozen = std::exchange(is_frozen_, workbench.presenter.is_frozen());
    if (!was_frozen || !is_frozen_) is_painted_ = false;
    if (surroundings.shows_time) paint();

    if (settling_ > 0) --settling_;
    redraw_in_s_ = next_redraw_in_s();
    if (surroundings.shows_time) {
        const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - started;
        frame_ms_ = frame_ms_ == 0.0 ? took.count() : frame_ms_ * 0.6 + took.count() * 0.4;
    }
    return requests;
}

Drawing Studio::record() const {
    Drawing drawing = recorded(*ImGui::GetDrawData(), [this](ImTextureID texture) -> std::shared_ptr<const Image> {
        const View* const view = pictures_.view_of(texture);
        return view ? std::make_shared<const Image>(renderer_.read(*view)) : nullptr;
    });
    const DrawingBox whole{glm::vec2(0.0F), drawing.size_px};
    const Ring corners{whole.min, {whole.max.x, 0.0F}, whole.max, {0.0F, whole.max.y}};
    drawing.marks.insert(drawing.marks.begin(), {whole, Shape{{corners}, ink_of(workbench.widgets.palette.ground)}});
    return drawing;
}

void Studio::present() {
    paint();
    const glm::ivec2 size_px = window_.size_px();
    glBindFramebuffer(GL_READ_FRAMEBUFFER, window_.framebuffer());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, size_px.x, size_px.y, 0, 0, size_px.x, size_px.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

Image Studio::read() {
    paint();
    return {window_.size_px().x, window_.size_px().y, gl::read_pixels(window_.framebuffer(), window_.size_px())};
}

}  // namespace viewing
