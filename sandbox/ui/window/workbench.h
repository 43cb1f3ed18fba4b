// The whole window: bars, columns and views, keys, and requests to the program around it. The same code runs on screen
// and in a headless snapshot.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "frame/problems.h"
#include "session/flight_recorder.h"
#include "session/replay.h"
#include "state/file/link.h"
#include "state/presets.h"
#include "topics/camera/shown/camera_tab.h"
#include "topics/matrices/shown/matrices.h"
#include "ui/lesson/end_card.h"
#include "ui/lesson/exercise_page.h"
#include "ui/lesson/presenter.h"
#include "ui/lesson/start_page.h"
#include "ui/lesson/step_editor.h"
#include "ui/panel/section_links.h"
#include "ui/parts/stage.h"
#include "ui/views/views.h"
#include "ui/window/dialogs.h"
#include "ui/window/help.h"
#include "ui/window/matrix_dialog.h"
#include "ui/window/preset_caption.h"
#include "ui/window/preset_picker.h"
#include "ui/window/search_box.h"
#include "ui/window/syllables.h"
#include "ui/window/window_commands.h"

namespace viewing {

/// Text for the status bar that only the surrounding program knows.
struct StatusLine {
    std::string renderer;           ///< "OpenGL 3.3 · llvmpipe"
    std::string frame_time;         ///< "–" in pictures that must be reproducible
    std::vector<std::string> told;  ///< about the pixel under the pointer or about coarse drawing; most important first
};

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
    /// Reads the lists of presets, scenes and lectures once.
    Workbench();

    Arrangement arrangement;
    ViewState views;
    Stage stage;  ///< parts that a lesson covers, highlights and marks
    Guide guide;  ///< runs the current lesson, if any
    PresenterMode presenter;
    StartPage start_page;
    ExerciseDesk exercises;  ///< the current student's exercises
    ExercisePage exercise_page;
    FlightRecorder recorder;                 ///< receives each frame from the program's draw loop
    Replay replay;                           ///< the replay of a flight or a hand-in, while it plays
    bool is_checking = false;                ///< an answer is being judged in the background
    LessonsProgress progress;                ///< the user's progress in every lesson
    std::string last_lesson;                 ///< the id of the lesson that was open last; "" for none
    std::vector<std::string> recent;         ///< opened files, latest first
    std::string link_address = link_base();  ///< the part of a link before its #
    Syllables korean;                        ///< Korean characters shown so far, for the next frame's fonts
    widgets::Context widgets;

    /// Returns the window's layout for this session, with the widgets' current fonts.
    Layout layout(ImVec2 window_px, const Session& session) const;
    /// Returns the user's arrangement, combined with the state's (view.layout).
    Arrangement arranged(const Session& session) const;

    /// Returns what the open search offers; empty while it is closed.
    const std::vector<SearchEntry>& searched() const { return search_.entries(); }

    /// Goes to an exercise of the student's sheet once it is generated. `replays`: also plays the recorded solution.
    void go_to_exercise(const std::string& id, bool replays);

    /// Returns the lesson and step pictures to render into Pictures.
    std::vector<CardPicture> wanted_cards();
    /// Returns the preset whose thumbnail should be rendered into Pictures; "" for none.
    const std::string& wanted_preset_picture() const { return preset_picker_.wanted_picture(); }
    /// Returns the seconds until a success message disappears from the status bar; negative: there is none.
    static double message_ends_in_s(const StatusMessage& message);

    /// Covers, marks and arranges what the lesson's current step says. Call it before layout().
    void set_stage();
    /// Draws the windows of one ImGui frame (between NewFrame and EndFrame), edits the session and moves its camera.
    Requests draw(Session& session, const WindowContent& content, const FrameInput& input);
    /// Draws the same windows in one more ImGui frame, after draw() has handled the input and `content` has been
    /// updated for the edits. Takes nothing but the state of held keys and buttons from `input`.
    void show(Session& session, const WindowContent& content, const FrameInput& input);

private:
    /// Commits typed text before a key or a dropped file moves the focus away: returns the input without that key or
    /// file, which is held back for one frame. Also commits the text when the window loses focus.
    FrameInput after_typing(const FrameInput& input);
    /// When presenting, returns the switches to offer: `kinds`, the controls that the state's layout lists, and the
    /// step's highlighted parts. Otherwise returns nullopt, for all switches.
    std::optional<std::vector<std::string>> offered(const Params& params, std::vector<std::string> kinds) const;
    void follow_lesson(Session& session, const FrameInput& input);
    void set_lesson_stage();
    void show_only_named(const LessonStep& step);
    /// Covers what the question asks for, until it is answered.
    void cover_question(const LessonRun& run);
    void leave_lesson(Session& session);
    /// Hands a key to what lies over the window: a dialog of an exercise, the list of lessons, or presenter mode.
    /// Returns true if one of them used it.
    bool take_key_of_page(const KeyPress& press, Session& session);
    void draw_lesson(Session& session, const Layout& layout, const Pictures& pictures, Requests& requests);
    /// Draws the card that ends the lesson, if it is shown.
    void draw_end(Session& session, const Pictures& pictures);
    void draw_lesson_button(Session& session);
    void follow_exercises(Session& session);
    void draw_exercises(Session& session, const Pictures& pictures);
    void choose_answers(FileDialog::Purpose purpose, Session& session);
    /// Whether the current question is about a matrix or vector, so that pasted numbers are its answer.
    bool takes_pasted_answer() const;
    void paste_answer();
    friend std::span<const WindowCommand> window_commands();
    Open open_now(const Session& session) const;
    void handle_keys(const CommandContext& context, const FrameInput& input);
    /// Maximizes the view under the pointer, or shows all views again.
    void toggle_big(Session& session);
    void toggle_caption(const Session& session);
    /// Opens the preset that is `places` positions after the open one, if there is one.
    void turn_preset(int places, Session& session);
    /// Takes back the first of these that there is: the lesson's end, a replay, a maximized view, a followed point.
    void take_back(Session& session);
    void draw_top_bar(const CommandContext& context, const Layout& layout, const PresetPicture& picture);
    void draw_presets(Session& session, float width, bool has_steps, const PresetPicture& picture);
    const NamedFile* open_preset(const Session& session) const;
    /// Returns the preset that is `places` positions after the open one in lecture order; null past either end.
    const NamedFile* preset_at(const Session& session, int places) const;
    Place place() const;
    /// The layout without the links below the panel.
    Layout layout_of_areas(ImVec2 window_px, float strip_width, const Session& session) const;
    /// The width in pixels that the step editor takes from the views; 0 while it is closed.
    float width_of_editor(float window_px) const;
    /// Returns the matrices to show; empty for all. A stage without a lesson has space for two.
    std::vector<std::string> listed_matrices(const Session& session) const;
    /// Returns the matrices that the state is about, which a short column shows first.
    std::vector<std::string> matrices_about(const Session& session) const;
    std::vector<SearchEntry> offered_to_search(const Session& session);
    /// Draws the search and carries out what the user chooses in it.
    void draw_search(const CommandContext& context, const Layout& layout);
    void save_as_step();
    void open_step_editor(Session& session);
    /// Shows a topic in a lower view and makes that view visible.
    void show_topic(Topic topic, Session& session, const Layout& layout);
    void draw_file_menu(const CommandContext& context);
    void draw_look_menu(Session& session, Requests& requests);
    void draw_status_bar(const Session& session, const Layout& layout, const StatusLine& status);
    void draw_windows(Session& session, const WindowContent& content, const FrameInput& input, MotionInput& motion,
                      Requests& requests);
    void draw_columns(Session& session, const WindowContent& content, const Layout& layout);
    void draw_views(Session& session, const WindowContent& content, const Layout& layout, const FrameInput& input,
                    MotionInput& motion);
    void draw_splitters(const Layout& layout, const Rect& between);
    /// Pastes an answer, a state, a link or a matrix from the clipboard.
    void paste_anything(Session& session);
    void draw_loading(Session& session, const Layout& layout);
    void draw_message(Session& session, const Layout& layout);

    std::vector<NamedFile> presets_, scenes_;
    std::vector<LessonFile> lectures_;
    /// Collects text that may be Korean whatever the window's language is: file and object names, lessons, typed text.
    void want_korean(const Session& session);

    FrameInput waiting_;  ///< keys and files held back until typed text is committed
    FileDialog file_dialog_;
    StepEditor step_editor_;
    TypedMatrix typed_matrix_;
    std::size_t strip_step_ = 0;  ///< the step that the strip showed last
    EndCard end_card_;
    std::string wanted_exercise_;  ///< the exercise to open once it is generated
    bool wants_replay_ = false;
    PresetPicker preset_picker_;
    SearchBox search_;
    std::optional<std::vector<ExerciseTitle>> exercise_titles_;  ///< read when the search first opens
    int korean_scene_version_ = -1;  ///< version of the scene whose object names were collected
    std::shared_ptr<const Lesson> korean_lesson_;
    Language korean_language_ = Language::en;
    CaptionFold caption_fold_;
    std::optional<double> pending_scale_;
    HelpDialog help_;
    MatrixDialog matrix_dialog_;
    MatrixChoice matrix_choice_;
    SectionLinks section_links_;
    CameraTab camera_tab_;
    void remember_opened(const Session& session);

    std::string opening_;      ///< the file being read
    std::string opened_mesh_;  ///< the scene's file, if the scene is a mesh file
    /// Dear ImGui puts each new window of the fixed layout behind the others. The panel may lie over the views, so its
    /// window is created first.
    bool has_panel_window_ = false;
    bool leads_ = false;  ///< the stage belongs to the lesson
};

}  // namespace viewing
