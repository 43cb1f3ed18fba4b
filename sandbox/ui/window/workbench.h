// The whole window: bars, columns and views, keys, and requests to the program around it. The same code runs on screen
// and in a headless snapshot.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "session/flight_recorder.h"
#include "state/file/link.h"
#include "topics/camera/shown/camera_tab.h"
#include "topics/matrices/shown/matrices.h"
#include "ui/lesson/end_card.h"
#include "ui/lesson/step_editor.h"
#include "ui/panel/section_links.h"
#include "ui/window/bars.h"
#include "ui/window/exercises.h"
#include "ui/window/help.h"
#include "ui/window/matrix_dialog.h"
#include "ui/window/preset_caption.h"
#include "ui/window/search_box.h"

namespace viewing {

/// What the windows show of a frame: its numbers, pictures and texts.
struct WindowContent {
    const Derived &derived, &before;  ///< `before` belongs to the state before the latest edit
    const FramePlan& plan;
    const std::vector<Problem>& problems;  ///< the plan's
    const Pictures& pictures;
    const StatusLine& status;
};

/// Requests that only the surrounding program can fulfill.
struct Requests {
    bool snapshot = false;
    bool toggle_full_screen = false;
    std::optional<bool> full_screen;  ///< the requested state, whatever the current one is
    bool check_answer = false;        ///< judge the answer to the lesson's question
    bool restart_hidden = false;      ///< restart the canceled work of the hidden-surface methods
    bool cancel_hidden = false;       ///< cancel the current work of the hidden-surface methods
    std::optional<ViewPicture> view_picture;
    std::optional<Theme> chosen_theme;        ///< set by the user: remember it for the next start
    std::optional<double> chosen_scale;       ///< likewise
    std::optional<Language> chosen_language;  ///< likewise
};

class Workbench {
public:
    Arrangement arrangement;
    ViewState views;
    Stage stage;  ///< parts that a lesson covers, highlights and marks
    Guide guide;  ///< runs the current lesson, if any
    PresenterMode presenter;
    StartPage start_page;
    Exercises exercises;
    FlightRecorder recorder;   ///< receives each frame from the program's draw loop
    Replay replay;             ///< the replay of a flight or a hand-in, while it plays
    bool is_checking = false;  ///< an answer is being judged in the background
    Past past;
    std::string link_address = link_base();  ///< the part of a link before its #
    Syllables korean;                        ///< Korean characters shown so far, for the next frame's fonts
    widgets::Context widgets;

    /// Returns the window's layout for this session, with the widgets' current fonts.
    Layout layout(ImVec2 window_px, const Session& session) const;
    /// Returns the user's arrangement, combined with the state's (view.layout).
    Arrangement arranged(const Session& session) const;

    /// Returns what the open search offers; empty while it is closed.
    const std::vector<SearchEntry>& searched() const { return search_.entries(); }
    /// Returns the lesson and step pictures to render into Pictures.
    std::vector<CardPicture> wanted_cards();
    /// Returns the preset whose thumbnail should be rendered into Pictures; "" for none.
    const std::string& wanted_preset_picture() const { return presets_.wanted_picture(); }

    /// Covers, marks and arranges what the lesson's current step says, or what a stage without a lesson needs. Call it
    /// before layout().
    void set_stage(const Session& session);
    /// Draws the windows of one ImGui frame (between NewFrame and EndFrame), edits the session and moves its camera.
    Requests draw(Session& session, const WindowContent& content, const FrameInput& input);
    /// Draws the same windows in one more ImGui frame, after draw() has handled the input and `content` has been
    /// updated for the edits. Takes nothing but the state of held keys and buttons from `input`.
    void show(Session& session, const WindowContent& content, const FrameInput& input);

private:
    friend std::span<const WindowCommand> window_commands();
    Place place() const;
    /// Commits typed text before a key or a dropped file moves the focus away: returns the input without that key or
    /// file, which is held back for one frame. Also commits the text when the window loses focus.
    FrameInput after_typing(const FrameInput& input);
    Open open_now(const Session& session) const;
    void handle_keys(const CommandContext& context, const FrameInput& input);
    /// Hands a key to what lies over the window: a dialog of an exercise, the list of lessons, or presenter mode.
    /// Returns true if one of them used it.
    bool take_key_of_page(const KeyPress& press, Session& session);
    void save_as_step();
    void open_step_editor(Session& session);
    /// The layout without the links below the panel.
    Layout layout_of_areas(ImVec2 window_px, float strip_width, const Session& session) const;
    /// The width in pixels that the step editor takes from the views; 0 while it is closed.
    float width_of_editor(float window_px) const;
    /// Returns the matrices to show; empty for all. A stage without a lesson has space for two.
    std::vector<std::string> listed_matrices(const Session& session) const;
    void draw_windows(Session& session, const WindowContent& content, const FrameInput& input, MotionInput& motion,
                      Requests& requests);
    void draw_columns(Session& session, const WindowContent& content, const Layout& layout);
    void draw_views(Session& session, const WindowContent& content, const Layout& layout, const FrameInput& input,
                    MotionInput& motion);
    void leave_lesson(Session& session);
    void follow_lesson(Session& session, const FrameInput& input);
    void draw_lesson(Session& session, const Layout& layout, const Pictures& pictures, Requests& requests);
    /// Draws the card that ends the lesson, if it is shown.
    void draw_end(Session& session, const Pictures& pictures);
    std::vector<SearchEntry> offered_to_search(const Session& session);
    /// Draws the search and carries out what the user chooses in it.
    void draw_search(const CommandContext& context, const Layout& layout);
    /// Collects text that may be Korean whatever the window's language is: file and object names, lessons, typed text.
    void want_korean(const Session& session);

    PresetPicker presets_;
    CaptionFold caption_fold_;
    TopBar top_bar_;
    FrameInput waiting_;  ///< keys and files held back until typed text is committed
    FileDialog file_dialog_;
    HelpDialog help_;
    MatrixDialog matrix_dialog_;
    MatrixChoice matrix_choice_;
    SectionLinks section_links_;
    CameraTab camera_tab_;
    StepEditor step_editor_;
    EndCard end_card_;
    std::size_t strip_step_ = 0;  ///< the step that the strip showed last
    SearchBox search_;
    std::optional<std::vector<ExerciseTitle>> exercise_titles_;  ///< read when the search first opens
    LongTexts long_texts_;
    /// Dear ImGui puts each new window of the fixed layout behind the others. The panel may lie over the views, so its
    /// window is created first.
    bool has_panel_window_ = false;
};

}  // namespace viewing
