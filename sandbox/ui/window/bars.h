// The bars of the window, and the windows of its fixed areas.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lesson/lesson.h"
#include "state/presets.h"
#include "ui/window/preset_picker.h"
#include "ui/window/window_commands.h"

namespace viewing {

/// Begins an undecorated window that fills a rectangle. `padding`: the usual one, unless given.
void begin_area(const char* name, const Rect& rect, ImGuiWindowFlags extra = 0,
                std::optional<ImVec2> padding = std::nullopt);

class TopBar {
public:
    /// Draws the bar. Returns true if the user asks for help.
    bool draw(Workbench& window, PresetPicker& presets, const CommandContext& context, const Layout& layout,
              const PresetPicture& picture);

private:
    /// Draws the menu of the commands that belong there, and of the lectures.
    void draw_file_menu(Workbench& window, const CommandContext& context) const;
    void draw_look_menu(Workbench& window, Params& params, Requests& requests);

    std::vector<NamedFile> scenes_ = scenes();
    std::vector<LessonFile> lectures_ = lectures();
    std::optional<double> pending_scale_;  ///< while the user drags the slider
};

/// Text for the status bar that only the surrounding program knows.
struct StatusLine {
    std::string renderer;           ///< "OpenGL 3.3 · llvmpipe"
    std::string frame_time;         ///< "–" in pictures that must be reproducible
    std::vector<std::string> told;  ///< about the pixel under the pointer or about coarse drawing; most important first
};

/// Draws the status bar. `recording`: the sign of a recording, which is drawn even without a bar; "" for none.
void draw_status_bar(const Session& session, const Layout& layout, const StatusLine& status,
                     const std::string& recording);

/// Returns the seconds until a success message disappears from the status bar; negative: there is none.
double message_ends_in_s(const StatusMessage& message);

}  // namespace viewing
