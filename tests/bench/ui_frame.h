// Runs one frame of the user interface, with the numbers computed for it but without GL, to measure the cost of our own
// code before any driver call. It does the same as Studio::frame between two edits.
#pragma once

#include <algorithm>
#include <stdexcept>

#include "frame/problems.h"
#include "ui/window/fonts.h"
#include "ui/window/theme.h"
#include "ui/window/workbench.h"

namespace viewing::bench {

/// Returns the value or throws the error, since a benchmark with a broken state has nothing to measure.
template <typename T>
T value_of(Result<T> result) {
    if (!result) throw std::runtime_error(result.error());
    return *std::move(result);
}

/// Changes values that every picture, every matrix and the panel depend on.
inline void edit(Params& params, int step) {
    params.camera.yaw += step % 2 == 0 ? 0.5 : -0.4;
    params.lights.front().position.x += step % 2 == 0 ? 0.02 : -0.02;
}

class UiFrame {
public:
    explicit UiFrame(const LoadedState& state, glm::ivec2 size_px) : session_(value_of(Session::make(state))) {
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = {static_cast<float>(size_px.x), static_cast<float>(size_px.y)};
        io.DeltaTime = 1.0F / 60.0F;
        widgets::Context& context = workbench_.widgets;
        context.palette = palette_of(session_.params.ui.theme);
        context.scale = context.palette.type_scale;
        context.fonts = load_fonts(context.scale);
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        io.Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
        widgets::ApplyStyle(context);
    }
    ~UiFrame() { ImGui::DestroyContext(); }
    UiFrame(const UiFrame&) = delete;
    UiFrame& operator=(const UiFrame&) = delete;

    Session& session() { return session_; }

    /// Computes everything that a redraw of all views needs from derive and plan: the camera's view twice (now and
    /// before the latest edit), the observer's, and the depth view's.
    void derive_and_plan() {
        const Layout layout = workbench_.layout(ImGui::GetIO().DisplaySize, session_);
        const Params& params = session_.params;
        const Scene& scene = session_.scene();
        const Viewport camera{glm::max(layout.camera.size_px(), glm::ivec2(1)), true};
        derived_ = derive(params, scene, camera);
        before_ = derive(session_.before_latest_edit(), scene, camera);
        plan_ = plan(params, derived_);
        problems_ = find_problems(params, derived_, scene, plan_);
        observed_ = plan_observer(params, derived_, derive_observer(params.observer, {layout.lower_left.size_px()}));
        Params depth = params;
        depth.view.shows = Shows::depth;
        depth_ = plan(depth, derive(depth, scene, {layout.lower_right.size_px(), true}));
    }

    /// Draws the windows twice, as Studio::frame does: first to handle the input, then to show its effects.
    void draw() {
        const Pictures pictures{};
        const StatusLine status{"OpenGL 3.3 core", "–", {}};
        const WindowContent content{derived_, before_, plan_, problems_, pictures, status};
        ImGui::NewFrame();
        workbench_.draw(session_, content, {});
        ImGui::EndFrame();
        ImGui::NewFrame();
        workbench_.show(session_, content, {});
        ImGui::Render();
    }

private:
    Session session_;
    Workbench workbench_;
    Derived derived_, before_;
    FramePlan plan_, observed_, depth_;
    std::vector<Problem> problems_;
};

}  // namespace viewing::bench
