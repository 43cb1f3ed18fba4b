#include "app/studio.h"

#include <backends/imgui_impl_opengl3.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "gl/dialect.h"
#include "measure/hidden_answers.h"
#include "measure/mirror_measure.h"
#include "state/fields.h"
#include "text/catalogue.h"
#include "ui/window/fonts.h"
#include "ui/window/theme.h"

namespace viewing {
namespace {

ImTextureID texture_id(const View& view) {
    return reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(view.texture()));
}

/// Of several views.
template <std::size_t count>
std::array<ImTextureID, count> texture_ids(const std::array<View, count>& views) {
    std::array<ImTextureID, count> ids{};
    std::transform(views.begin(), views.end(), ids.begin(), texture_id);
    return ids;
}

std::string renderer_name() {
    std::string name(reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
    name = name.substr(0, name.find(" ("));
    return "OpenGL 3.3 core · " + name;
}

/// Each part can be left out where the bar is narrow.
std::vector<std::string> describe(const PixelReport& pixel) {
    std::vector<std::string> parts;
    parts.push_back(say("pixel ({x}, {y})", "x"_a = pixel.pixel.x, "y"_a = pixel.pixel.y) +
                    fmt::format("  #{:02x}{:02x}{:02x}", pixel.color.r, pixel.color.g, pixel.color.b));
    const std::string& object = pixel.object;
    parts.push_back(!pixel.written       ? tr("background")
                    : pixel.front_facing ? say("{object}, front face", "object"_a = object)
                                         : say("{object}, back face", "object"_a = object));
    if (pixel.written && pixel.has_depth) parts.push_back(say("eye z {z}", "z"_a = number_text(pixel.eye_z, 3)));
    if (pixel.written && !pixel.has_depth) parts.emplace_back(tr("depth as cleared"));
    parts.push_back("z_window " + plain_decimals(pixel.window_depth, 6));
    const std::string stored = grouped_number(pixel.stored);
    parts.push_back(pixel.precision.is_float ? say("stored {code} (float bits)", "code"_a = stored)
                                             : say("stored {code} of 2{bits}−1", "code"_a = stored,
                                                   "bits"_a = raised_text(pixel.precision.bits)));
    parts.push_back(say("stencil {value}", "value"_a = pixel.stencil));
    return parts;
}

}  // namespace

Studio::Studio(Renderer& renderer, Session opened)
    : session(std::move(opened)), renderer_(renderer), renderer_name_(renderer_name()) {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // no file is touched that was not named
    io.LogFilename = nullptr;
    io.ConfigWindowsMoveFromTitleBarOnly = true;
    ImGui_ImplOpenGL3_Init(gl::shader_version());
}

Studio::~Studio() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext();
}

void Studio::apply_looks(double device_scale) {
    const UiParams& ui = session.params.ui;
    const widgets::Palette& palette = palette_of(ui.theme);
    const auto scale = static_cast<float>(device_scale * ui.scale) * palette.type_scale;
    if (scale == looks_scale_ && ui.theme == theme_) return;
    widgets::Context& context = workbench.widgets;
    context.palette = palette;
    context.scale = scale;
    if (scale != looks_scale_) {
        context.fonts = load_fonts(scale);
        ImGui_ImplOpenGL3_DestroyFontsTexture();
        ImGui_ImplOpenGL3_CreateFontsTexture();
    }
    widgets::ApplyStyle(context);
    looks_scale_ = scale;
    theme_ = ui.theme;
    settling_ = 3;
}

Status Studio::draw_camera_view(const Layout& layout) {
    if (layout.camera.empty()) return std::monostate{};
    return renderer_.draw(plan_, session.scene(), layout.camera.size_px(), camera_);
}

Status Studio::draw_beside_view(const Layout& layout) {
    const BesideParams& beside = params_.view.beside;
    const glm::ivec2 size = layout.camera.size_px();
    if (beside.shows == Beside::nothing || layout.camera.empty()) return std::monostate{};
    if (beside.shows == Beside::depth) return draw_depth_below(size, beside_);
    Params other = params_;
    other.depth.format = beside.format;
    other.depth.mapping = beside.mapping;
    const Viewport viewport{size, renderer_.capabilities().clip_control};
    const FramePlan frame = plan(other, derive(other, session.scene(), viewport), pictures_by_gl());
    return renderer_.draw(frame, session.scene(), size, beside_);
}

HiddenPictures Studio::pictures_by_gl() const {
    const bool has_steps = hidden_ && is_drawn_by_gl_alone(params_.visibility.method);
    return has_steps ? hidden_->pictures : HiddenPictures{};
}

Status Studio::draw_depth_below(glm::ivec2 size_px, View& view) {
    Params params = params_;
    params.view.shows = Shows::depth;
    const Scene& scene = session.scene();
    const Derived derived = derive(params, scene, {size_px, renderer_.capabilities().clip_control});
    FramePlan frame = plan(params, derived, pictures_by_gl());
    frame.shown_range = contrast_range(params, derived, scene);
    return renderer_.draw(frame, scene, size_px, view);
}

Status Studio::draw_after_pass(glm::ivec2 size_px) {
    static constexpr Shows buffers[] = {Shows::color, Shows::depth, Shows::stencil};
    FramePlan frame = inspected_;
    frame.shown_range = contrast_range(params_, derived_, session.scene());
    frame.samples = 0;
    for (std::size_t buffer = 0; buffer < after_pass_.size(); ++buffer) {
        frame.shows = buffers[buffer];
        if (Status done = renderer_.draw(frame, session.scene(), size_px, after_pass_[buffer]); !done) return done;
    }
    return std::monostate{};
}

Status Studio::draw_mirror_ways() {
    // Small enough to keep up with a light or a plane that is dragged.
    constexpr int most_px = 480;
    const double shrunk = std::min(1.0, static_cast<double>(most_px) / std::max(camera_px_.x, camera_px_.y));
    const glm::ivec2 size_px = glm::max(glm::ivec2(glm::dvec2(camera_px_) * shrunk), 1);
    Result<MirrorWays> ways = compare_mirror_ways(renderer_, params_, session.scene(), size_px, &mirror_way_views_);
    if (!ways) return Error{ways.error()};
    mirror_ways_ = std::make_shared<const MirrorWays>(*ways);
    return std::monostate{};
}

Status Studio::draw_lower_view(Slot slot, const Layout& layout) {
    const Rect& rect = slot == Slot::left ? layout.lower_left : layout.lower_right;
    if (rect.empty()) return std::monostate{};
    const glm::ivec2 size = rect.size_px();
    View& view = lower_[static_cast<std::size_t>(slot)];
    const auto draw_outside = [&](const ObserverView& observer) {
        return renderer_.draw(plan_observer(params_, derived_, observer), session.scene(), size, view);
    };
    switch (topic_of(params_, slot)) {
        case Topic::observer:
            return draw_outside(derive_observer(params_.observer, {size}));
        case Topic::moving_world:
            return draw_outside(derive_moving_world(params_.observer, derived_, {size}));
        case Topic::from_light:
            return draw_outside(derive_light_view(derived_, {size}));
        case Topic::depth:
            return draw_depth_below(size, view);
        case Topic::passes:
            return draw_after_pass(pass_picture_size(rect, derived_.aspect));
        case Topic::mirror_ways:
            return draw_mirror_ways();
        default:
            return std::monostate{};  // drawn by the user interface alone
    }
}

Status Studio::draw_views(const Layout& layout, bool is_interactive) {
    // With a scene that is slow to draw, only the view that is being moved follows; the others catch up at rest.
    constexpr double slow_ms = 80.0;
    const bool is_held = session.is_moving() || ImGui::IsAnyItemActive();
    views_are_behind_ = is_interactive && frame_ms_ > slow_ms && is_held;
    for (const Slot slot : {Slot::left, Slot::right}) {
        const ViewName name = slot == Slot::left ? ViewName::lower_left : ViewName::lower_right;
        const bool is_moved = workbench.views.hovered == name && topic_of(params_, slot) == Topic::observer;
        if (views_are_behind_ && is_moved) return draw_lower_view(slot, layout);
    }
    if (Status done = draw_camera_view(layout); !done || views_are_behind_) return done;
    if (Status done = draw_beside_view(layout); !done) return done;
    if (Status done = draw_lower_view(Slot::left, layout); !done) return done;
    return draw_lower_view(Slot::right, layout);
}

std::vector<std::string> Studio::pixel_parts() {
    const std::optional<glm::ivec2> pixel = workbench.views.hovered_pixel;
    const glm::ivec2 size = camera_.size_px();
    if (!pixel || session.is_moving() || ImGui::IsAnyItemActive()) return {};
    if (pixel->x < 0 || pixel->y < 0 || pixel->x >= size.x || pixel->y >= size.y) return {};
    const auto report = inspector_.at(renderer_, inspected_, session.scene(), derived_, size, *pixel);
    return report ? describe(*report) : std::vector<std::string>{};
}

Status Studio::inspect() {
    DepthWishes wishes;
    const bool tells_pixel = is_shown(params_, Topic::pixel), tells_cells = is_shown(params_, Topic::cells);
    if (tells_pixel || tells_cells || is_shown(params_, Topic::precision)) {
        wishes.pixel = params_.view.pixel;
        if (const auto pointed = workbench.views.told_pixel; pointed && !wishes.pixel)
            wishes.pixel = glm::min(*pointed, camera_px_ - 1);  // it may have shrunk since
        if (wishes.pixel && !glm::all(glm::lessThan(*wishes.pixel, camera_px_))) wishes.pixel.reset();
    }
    wishes.fragments = tells_pixel;
    wishes.calls = tells_cells;
    if (tells_cells && wishes.pixel) wishes.cells = workbench.views.cells;
    wishes.counts = is_shown(params_, Topic::histogram);
    return inspector_.update(renderer_, inspected_, session.scene(), session.scene_version(), derived_, camera_px_,
                             wishes);
}

Status Studio::update_hidden(glm::ivec2 camera_px, bool is_interactive) {
    const std::optional<HiddenQuestion> question = hidden_question(params_, derived_, camera_px);
    if (!question) {
        hidden_worker_.forget();
        hidden_.reset();
        hidden_is_behind_ = false;
        return std::monostate{};
    }
    constexpr double a_moment_s =
        0.025;  // quick methods keep up with the camera; slow ones must not hold the window up
    hidden_worker_.ask(*question, session.scene(), session.scene_version());
    hidden_worker_.wait(!is_interactive ? -1.0 : hidden_is_behind_ ? 0.0 : a_moment_s);
    const std::shared_ptr<const HiddenAnswer> answer = hidden_worker_.answer(session.scene_version());
    hidden_is_behind_ = !answer || answer->question != *question;
    if (!answer) hidden_.reset();  // it was of another scene
    // GL's part of a difference depends on the depth buffer too, and is made for the camera that is asked for.
    const bool is_shown =
        answer && hidden_ && answer->camera == hidden_->camera && answer->question == hidden_->question;
    if (!answer || (is_shown && hidden_depth_ == session.params.depth)) return std::monostate{};
    auto completed = std::make_shared<HiddenAnswer>(*answer);
    Status done = std::monostate{};
    if (!hidden_is_behind_) done = complete_difference(renderer_, params_, derived_, session.scene(), *completed);
    hidden_depth_ = session.params.depth;
    hidden_ = std::move(completed);
    return done;
}

Requests Studio::frame(const Surroundings& surroundings) {
    const auto started = std::chrono::steady_clock::now();
    apply_looks(surroundings.device_scale);
    session.update_scene();
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(surroundings.size_px.x), static_cast<float>(surroundings.size_px.y)};
    io.DeltaTime = static_cast<float>(std::max(surroundings.input.dt_s, 1e-4));

    const bool moves = surroundings.shows_time && is_animated(session.params);
    const bool has_begun =
        surroundings.shows_time && (session.params.animation.jiggle || session.params.animation.light_orbit);
    moment_ = moves ? advanced(moment_, session.params, surroundings.input.dt_s) : has_begun ? moment_ : Moment{};
    params_ = animated(session.params, moment_);

    const Layout layout = workbench.layout(io.DisplaySize, params_);
    if (!layout.camera.empty()) camera_px_ = layout.camera.size_px();  // else another view has the whole window
    const Viewport viewport{camera_px_, renderer_.capabilities().clip_control};
    const auto report = [this](const Status& done) {
        if (!done) session.message = {done.error(), true};
    };
    Drawn wanted{session.params,
                 session.scene_version(),
                 params_,
                 layout.camera.size_px(),
                 layout.beside.size_px(),
                 layout.lower_left.size_px(),
                 layout.lower_right.size_px(),
                 drawn_.hidden};
    if (wanted != drawn_) derived_ = derive(params_, session.scene(), viewport);
    if (wanted != drawn_ || hidden_is_behind_) report(update_hidden(camera_px_, surroundings.shows_time));
    wanted.hidden = hidden_;
    const bool catch_up = views_are_behind_ && !session.is_moving() && !ImGui::IsAnyItemActive();
    if (wanted != drawn_ || catch_up) {
        before_ = derive(animated(session.before_latest_edit(), moment_), session.scene(), viewport);
        const HiddenPictures found = hidden_ ? hidden_->pictures : HiddenPictures{};
        plan_ = plan(params_, derived_, found);
        problems_ = find_problems(params_, derived_, session.scene(), plan_);
        inspected_ = plan(probed(params_), derived_, found);
        report(draw_views(layout, surroundings.shows_time));
        drawn_ = wanted;
        inspector_.forget();
        if (!moves) settling_ = std::max(settling_, 2);
    }

    if (!views_are_behind_) report(inspect());
    DepthData depth = inspector_.data();
    const bool tells_fighting = is_shown(params_, Topic::fighting);
    if (tells_fighting)  // of the state at rest, also while something moves by itself
        depth.fighting =
            fighting_.update(renderer_, session.params, session.scene(), session.scene_version(), camera_px_,
                             !surroundings.shows_time, !session.is_moving() && !ImGui::IsAnyItemActive());
    if (window_.size_px() != surroundings.size_px) window_ = gl::ColorTarget(surroundings.size_px);
    const std::string time = fmt::format("{:5.1f} ms", frame_ms_);
    const StatusLine status{renderer_name_, surroundings.shows_time ? time : "–", pixel_parts()};
    const Pictures pictures{texture_id(camera_),
                            texture_id(beside_),
                            texture_ids(lower_),
                            texture_ids(after_pass_),
                            {texture_ids(mirror_way_views_), mirror_ways_},
                            {hidden_, hidden_worker_.fraction(), surroundings.shows_time},
                            std::move(depth)};

    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
    const Requests requests =
        workbench.draw(session, derived_, before_, plan_, problems_, pictures, status, surroundings.input);
    if (requests.cancel_hidden) hidden_worker_.cancel();
    if (requests.restart_hidden) {
        hidden_worker_.forget();
        hidden_is_behind_ = true;
    }
    ImGui::Render();
    glBindFramebuffer(GL_FRAMEBUFFER, window_.framebuffer());
    glViewport(0, 0, surroundings.size_px.x, surroundings.size_px.y);
    const ImVec4 ground = ImGui::ColorConvertU32ToFloat4(workbench.widgets.palette.ground);
    glClearColor(ground.x, ground.y, ground.z, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());

    if (settling_ > 0) --settling_;
    const bool behind = views_are_behind_ && !ImGui::IsAnyItemActive();
    const bool busy = session.is_moving() || settling_ > 0 || behind || session.params != drawn_.params ||
                      is_playing(workbench.views) || moves;
    const bool works = session.loading_fraction() || hidden_is_behind_ || workbench.views.hidden.is_busy() ||
                       (tells_fighting && fighting_.wants_frames());
    redraw_in_s_ = busy ? 0.0 : works ? 0.05 : widgets::RedrawIn(workbench.widgets);
    if (surroundings.shows_time) {
        const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - started;
        frame_ms_ = frame_ms_ == 0.0 ? took.count() : frame_ms_ * 0.6 + took.count() * 0.4;
    }
    return requests;
}

Image Studio::read() const {
    return {window_.size_px().x, window_.size_px().y, gl::read_pixels(window_.framebuffer(), window_.size_px())};
}

}  // namespace viewing
