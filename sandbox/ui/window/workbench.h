// The whole window: bars, columns and views in their places, keys, and what is asked of the program around it.
// The same code runs on screen and in a headless snapshot.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "frame/problems.h"
#include "state/presets.h"
#include "ui/matrices/matrices.h"
#include "ui/views/views.h"
#include "ui/window/dialogs.h"

namespace viewing {

/// What the status bar says beside what the sandbox itself knows.
struct StatusLine {
    std::string renderer;            ///< "OpenGL 3.3 · llvmpipe"
    std::string frame_time;          ///< "–" in a picture that has to repeat
    std::vector<std::string> pixel;  ///< what is under the pointer, the most wanted first
};

/// What only the program around can do.
struct Requests {
    bool snapshot = false;
    bool toggle_full_screen = false;
    bool restart_hidden = false;  ///< their work on the current question, which was cancelled
    bool cancel_hidden = false;   ///< what the hidden-surface methods are working on
    std::optional<ViewPicture> view_picture;
};

class Workbench {
public:
    /// Reads the lists of presets and scenes once.
    Workbench();

    Arrangement arrangement;
    ViewState views;
    widgets::Context widgets;

    /// Where everything is for these parameters.
    Layout layout(ImVec2 window_px, const Params& params) const {
        Arrangement now = arrangement;
        now.halves = params.view.beside.shows != Beside::nothing && params.view.beside.layout == BesideLayout::halves;
        return lay_out(window_px, widgets.scale, now);
    }

    /// Draws one ImGui frame's windows (between NewFrame and Render), edits the session and moves its camera.
    /// `problems` are those of the plan.
    Requests draw(Session& session, const Derived& derived, const Derived& before, const FramePlan& plan,
                  const std::vector<Problem>& problems, const Pictures& pictures, const StatusLine& status,
                  const FrameInput& input);

private:
    void handle_keys(Session& session, const FrameInput& input, Requests& requests);
    void draw_top_bar(Session& session, const Layout& layout, Requests& requests);
    void draw_file_menu(Session& session, Requests& requests);
    void draw_look_menu(Session& session, Requests& requests);
    void draw_status_bar(const Session& session, const Layout& layout, const StatusLine& status);
    void draw_columns(Session& session, const Derived& derived, const Derived& before,
                      const std::vector<Problem>& problems, const HiddenStatus& hidden, const Layout& layout);
    void draw_views(Session& session, const Derived& derived, const FramePlan& plan,
                    const std::vector<Problem>& problems, const Pictures& pictures, const Layout& layout,
                    const FrameInput& input, MotionInput& motion);
    void draw_splitters(const Layout& layout, const Rect& between);
    void draw_loading(Session& session, const Layout& layout);
    void draw_message(Session& session, const Layout& layout);

    std::vector<NamedFile> presets_, scenes_;
    FileDialog file_dialog_;
    const NamedFile* preset_ = nullptr;  ///< opened last, and the parameters as it left them
    Params preset_params_;
    std::optional<double> pending_scale_;
    bool help_open_ = false;
    MatrixChoice matrix_choice_;
};

}  // namespace viewing
