// The whole user interface without a window or GL: a session, its workbench and simulated mouse, keys and clipboard.
// Each frame derives and plans, then takes the input, so an edit shows in the next frame. The studio (app/studio.cpp)
// shows it in the same one. Read widgets/harness.h first.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "frame/problems.h"
#include "state/fields.h"
#include "state/file/state_json.h"
#include "state/person/language.h"
#include "state/scene.h"
#include "text/catalogue.h"
#include "text/po.h"
#include "ui/window/fonts.h"
#include "ui/window/theme.h"
#include "ui/window/workbench.h"
#include "widgets/harness.h"

namespace viewing::test {

using widgets::RecordedItem;

/// Returns every text of the program, with its Korean translation.
inline std::vector<PoEntry> catalogue() {
    std::ifstream file(assets_directory() / "text" / "ko.po", std::ios::binary);
    Result<std::vector<PoEntry>> entries = read_po(std::string{std::istreambuf_iterator<char>(file), {}});
    if (!entries) throw std::runtime_error(entries.error());
    return *std::move(entries);
}

inline Session session_of(const std::string& state) {
    const Result<LoadedState> loaded = load_state(state);
    if (!loaded) throw std::runtime_error(loaded.error());
    Result<Session> session = Session::make(*loaded);
    if (!session) throw std::runtime_error(session.error());
    return std::move(*session);
}

/// An area of the window, and how much of its content is cut off beyond its edges.
struct AreaFacts {
    std::string name;
    Rect rect;
    float overflow_x = 0.0F;
    float overflow_y = 0.0F;
};

class Desk {
public:
    /// By default the window is so tall that the panel does not scroll. `state` is written as on the command line.
    explicit Desk(ImVec2 size = {1600, 1500}, const std::string& state = "opening") : session(session_of(state)) {
        ImGuiIO& io = ImGui::GetIO();
        io.ConfigWindowsMoveFromTitleBarOnly = true;
        io.DisplaySize = size;
        io.ClipboardUserData = this;
        io.SetClipboardTextFn = [](void* desk, const char* text) { static_cast<Desk*>(desk)->clipboard = text; };
        io.GetClipboardTextFn = [](void* desk) { return static_cast<const Desk*>(desk)->clipboard.c_str(); };
        apply_looks();
        ui.frames(5);
    }
    ~Desk() {
        keep_fonts();
        // A test may select a language, such as the pseudo-language; English is restored here.
        if (spoken_language() == Language::en) return;
        EXPECT_TRUE(speak(Language::en));
    }
    Desk(const Desk&) = delete;
    Desk& operator=(const Desk&) = delete;

    Session session;
    Workbench workbench;
    FrameInput input;
    Derived derived;
    FramePlan frame_plan;
    std::vector<Problem> problems;
    std::string clipboard;
    std::vector<AreaFacts> areas;
    widgets::test::Harness ui{workbench.widgets, [this] { draw(); }};

    Params& params() { return session.params; }
    Layout layout() const { return workbench.layout(ImGui::GetIO().DisplaySize, session); }
    const std::vector<RecordedItem>& recorded() const { return workbench.widgets.recorded; }

    /// Applies the state's fonts, style and language, as the studio does between frames.
    void apply_looks() {
        const UiParams& looks = session.params.ui;
        widgets::Context& context = workbench.widgets;
        context.palette = palette_of(looks.theme);
        const float scale = static_cast<float>(looks.scale) * context.palette.type_scale;
        context.scale = scale * enlargement(ImGui::GetIO().DisplaySize, scale, workbench.arranged(session));
        if (looks.language != spoken_language()) {
            if (const Status spoken = speak(looks.language); !spoken) throw std::runtime_error(spoken.error());
            workbench.korean.want(spoken_texts());
        }
        context.fonts = load_fonts(context.scale, workbench.korean, type_sizes(workbench.arranged(session)));
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
        widgets::ApplyStyle(context);
    }

    /// Runs frames until nothing moves or loads.
    void settle() {
        ui.frame();
        session.finish_loading();
        for (int i = 0; i < 600 && session.is_moving(); ++i) ui.frame();
        ui.frames(3);
    }

    // ---- keys: sent to the sandbox and to ImGui together, as GLFW reports them ---------------------------

    void hold(Key key) {
        set_down(key, true);
        input.pressed.push_back({key, input.is_down(Key::ctrl), input.is_down(Key::shift)});
        ui.frame();
    }
    void let_go(Key key) {
        set_down(key, false);
        ui.frame();
    }
    void press(Key key) {
        hold(key);
        let_go(key);
        ui.frames(2);
    }
    void press_with(Key modifier, Key key) {
        hold(modifier);
        press(key);
        let_go(modifier);
    }
    void undo() { press_with(Key::ctrl, Key::z); }
    void redo() {
        hold(Key::ctrl);
        press_with(Key::shift, Key::z);
        let_go(Key::ctrl);
    }
    /// Sends a letter as the keyboard does: a key and a character.
    void press_letter(Key key, char letter) {
        ImGui::GetIO().AddInputCharacter(static_cast<unsigned>(letter));
        press(key);
    }

    // ---- controls by label, scrolled into view when needed -----------------------------------------------

    /// Returns the column (panel or matrices) that contains an item; nothing for items elsewhere.
    std::optional<Rect> area_of(const RecordedItem& item) const {
        const Layout now = layout();
        if (item.window == "panel") return now.panel;
        if (item.window == "matrices") return now.matrices;
        return std::nullopt;
    }
    void reveal(std::string_view label) {
        for (int i = 0; i < 200; ++i) {
            const RecordedItem item = ui.find(label);
            const std::optional<Rect> area = area_of(item);
            if (!area || (item.min.y >= area->min.y && item.max.y <= area->max.y)) return;
            ui.move_to({area->min.x + 3.0F, area->max.y - 3.0F});
            ImGui::GetIO().MouseWheel = item.min.y < area->min.y ? 1.0F : -1.0F;
            ui.frame();
            ImGui::GetIO().MouseWheel = 0.0F;
            ui.frame();
        }
        FAIL() << label << " cannot be scrolled to";
    }
    void click(std::string_view label) {
        reveal(label);
        ui.click(label);
    }
    /// Clicks one of several items with the same label, counted from 0 in the order in which they are drawn.
    void click_one_of(std::string_view label, std::size_t place) {
        std::vector<RecordedItem> found;
        std::copy_if(recorded().begin(), recorded().end(), std::back_inserter(found),
                     [&](const RecordedItem& item) { return item.label == label; });
        const RecordedItem& item = found.at(place);
        click_at({0.5F * (item.min.x + item.max.x), 0.5F * (item.min.y + item.max.y)});
    }
    void right_click(std::string_view label) {
        reveal(label);
        ui.right_click(label);
    }
    void drag(std::string_view label, float dx, float dy = 0.0F, int steps = 5, float from_x = 0.5F) {
        reveal(label);
        ui.drag(label, dx, dy, steps, from_x);
    }
    /// Replaces a number by typing another one.
    void enter(std::string_view label, const char* text) {
        reveal(label);
        ui.double_click(label);
        ui.type(text);
        ui.key(ImGuiKey_Enter);
    }
    /// Opens a combo or menu button and picks one of its items.
    void choose(std::string_view combo, std::string_view item) {
        click(combo);
        ui.frames(2);
        ui.click(item);
        ui.frames(2);
    }
    void fold_out_all() {
        for (const char* label : {"camera/Common mistakes", "projection/Window, far, aspect, radians", "Depth buffer",
                                  "shadow/Shadow: style and offset", "shadow/Shadow: clip at light, sign, stencil",
                                  "reflection/Mirror: drawing method"})
            if (!is_folded_out(label)) click(label);
        for (const char* label : {"Second picture", "Observer"})
            if (ui.text_of(label) == "folded") click(label);
    }

    // ---- the views -----------------------------------------------------------------------------------

    /// Returns the position of a world point in the camera's picture.
    ImVec2 in_camera_view(const glm::dvec3& world) const {
        return place(layout().camera, derived.clip_from_world, world);
    }
    ImVec2 in_observer_view(const glm::dvec3& world) const {
        const Rect rect = layout().lower_left;
        return place(rect, derive_observer(session.params.observer, {rect.size_px()}).clip_from_world, world);
    }
    void drag_from(ImVec2 from, float dx, float dy, int steps = 5, int button = 0) {
        ui.frame(1.0F);
        ui.move_to(from);
        ui.press(button);
        for (int i = 1; i <= steps; ++i) {
            const float share = static_cast<float>(i) / static_cast<float>(steps);
            ui.move_to({from.x + dx * share, from.y + dy * share});
        }
        ui.release(button);
        ui.frame();
    }
    void click_at(ImVec2 place) { drag_from(place, 0.0F, 0.0F, 1); }

private:
    static ImVec2 place(const Rect& rect, const glm::dmat4& clip_from_world, const glm::dvec3& world) {
        const glm::dvec4 clip = clip_from_world * glm::dvec4(world, 1.0);
        return {rect.min.x + rect.width() * static_cast<float>(clip.x / clip.w + 1.0) * 0.5F,
                rect.min.y + rect.height() * static_cast<float>(1.0 - clip.y / clip.w) * 0.5F};
    }
    bool is_folded_out(std::string_view details) const {
        struct Inside {
            std::string_view details, item;
        };
        static constexpr Inside all[] = {
            {"camera/Common mistakes", "camera/C sent as V"},
            {"projection/Window, far, aspect, radians", "projection/aspect (0: from view)"},
            {"projection/Window, far, aspect, radians", "projection/aspect (0: from view)"},
            {"Depth buffer", "buffer/depth format"},
            {"shadow/Shadow: style and offset", "shadow/style/Blend"},
            {"shadow/Shadow: clip at light, sign, stencil", "shadow/Own stencil"},
            {"reflection/Mirror: drawing method", "reflection/Mirror last"}};
        const std::string_view inside = std::ranges::find(all, details, &Inside::details)->item;
        return ui.has(inside);
    }
    void set_down(Key key, bool down) {
        input.down[static_cast<std::size_t>(key)] = down;
        ImGuiIO& io = ImGui::GetIO();
        if (key == Key::ctrl) io.KeyCtrl = down;
        if (key == Key::shift) io.KeyShift = down;
        if (key == Key::escape) widgets::test::key_down(ImGuiKey_Escape) = down;
    }

    void draw() {
        session.update_scene();
        const Layout now = layout();
        const Viewport viewport{glm::max(now.camera.size_px(), glm::ivec2(1)), true};
        derived = derive(session.params, session.scene(), viewport);
        const Derived before = derive(session.before_latest_edit(), session.scene(), viewport);
        frame_plan = plan(session.params, derived);
        problems = find_problems(session.params, derived, session.scene(), frame_plan);
        workbench.views.pinned = pinned_pixel(session.params, derived, frame_plan, session.scene(), viewport.size_px);
        input.dt_s = ImGui::GetIO().DeltaTime;
        workbench.recorder.pass(input.dt_s);
        workbench.recorder.note(session.params);
        Pictures pictures;
        pictures.hidden = {hidden_answer(viewport.size_px), std::nullopt, false};
        const StatusLine status{"OpenGL 3.3 core · none", "888.8 ms", {}};
        requests = workbench.draw(session, {derived, before, frame_plan, problems, pictures, status}, input);
        input.pressed.clear();
        input.dropped_files.clear();
        measure_areas();
    }

    /// Returns the hidden-surface answer for the camera view, computed synchronously.
    std::shared_ptr<const HiddenAnswer> hidden_answer(glm::ivec2 size_px) {
        const std::optional<HiddenQuestion> question = hidden_question(session.params, derived, size_px);
        if (!question) return nullptr;
        if (solver_version_ != session.scene_version())
            solver_ = std::make_unique<HiddenSurfaceSolver>(session.scene());
        if (!answer_ || answer_->question != *question || solver_version_ != session.scene_version())
            answer_ = std::make_shared<const HiddenAnswer>(answer_hidden_question(*solver_, *question));
        solver_version_ = session.scene_version();
        return answer_;
    }
    std::unique_ptr<HiddenSurfaceSolver> solver_;
    int solver_version_ = -1;
    std::shared_ptr<const HiddenAnswer> answer_;

    /// Measures how far the content of each area extends beyond its edges. ImGui reports these distances only between
    /// Begin() and End(), so this reopens each window after it is drawn.
    void measure_areas() {
        areas.clear();
        for (const char* name : {"top", "panel", "matrices", "views", "lower views"}) {
            bool is_drawn = false;
            for (const RecordedItem& item : recorded()) is_drawn |= item.window == name;
            if (!is_drawn) continue;
            ImGui::Begin(name);
            const ImVec2 min = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
            areas.push_back(
                {name, {min, {min.x + size.x, min.y + size.y}}, ImGui::GetScrollMaxX(), ImGui::GetScrollMaxY()});
            ImGui::End();
        }
    }

public:
    Requests requests;
    const std::shared_ptr<const HiddenAnswer>& answer() const { return answer_; }
};

inline std::array<PlaneOverrides, most_planes> further_of(std::array<PlaneOverrides, most_planes> overrides) {
    overrides[0].mirrored_world_from_world.reset();
    overrides[0].shadowed_world_from_world[0].reset();
    return overrides;
}

/// Returns the paths of the fields in which two states differ.
inline std::vector<std::string> differing_fields(Params a, Params b) {
    std::vector<std::string> paths;
    for (const Field& field : fields()) {
        const FieldRef right = field.in(b);
        const bool same = std::visit(
            [&right](const auto& left) {
                using Ref = std::decay_t<decltype(left)>;
                if constexpr (std::is_same_v<Ref, EnumRef>)
                    return left.index() == std::get<EnumRef>(right).index();
                else if constexpr (std::is_same_v<Ref, FurtherOverrides>)
                    return further_of(*left.all) == further_of(*std::get<Ref>(right).all);
                else if constexpr (requires { left.elements(); })
                    return std::ranges::equal(left.elements(), std::get<Ref>(right).elements());
                else
                    return *left == *std::get<Ref>(right);
            },
            field.in(a));
        if (!same) paths.emplace_back(field.path);
    }
    return paths;
}

using Paths = std::vector<std::string>;

class UiTest : public ::testing::Test {
protected:
    Desk desk;
    widgets::test::Harness& ui = desk.ui;
    Params& params = desk.session.params;
};

}  // namespace viewing::test
