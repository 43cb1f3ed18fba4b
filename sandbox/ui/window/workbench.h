// The whole window: bars, columns and views in their places, keys, and what is asked of the program around it.
// The same code runs on screen and in a headless snapshot.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "frame/problems.h"
#include "session/flight_recorder.h"
#include "session/replay.h"
#include "state/presets.h"
#include "ui/lesson/exercise_page.h"
#include "ui/lesson/presenter.h"
#include "ui/lesson/start_page.h"
#include "ui/matrices/matrices.h"
#include "ui/parts/stage.h"
#include "ui/views/views.h"
#include "ui/window/caption.h"
#include "ui/window/dialogs.h"
#include "ui/window/preset_picker.h"
#include "ui/window/syllables.h"

namespace viewing {

/// What the status bar says beside what the sandbox itself knows.
struct StatusLine {
    std::string renderer;           ///< "OpenGL 3.3 · llvmpipe"
    std::string frame_time;         ///< "–" in a picture that has to repeat
    std::vector<std::string> told;  ///< what is under the pointer or drawn coarsely, the most wanted first
};

/// What only the program around can do.
struct Requests {
    bool snapshot = false;
    bool toggle_full_screen = false;
    std::optional<bool> full_screen;  ///< what is wanted, whatever it is now
    bool check_answer = false;        ///< of the lesson's question: to be judged
    bool restart_hidden = false;      ///< their work on the current question, which was cancelled
    bool cancel_hidden = false;       ///< what the hidden-surface methods are working on
    std::optional<ViewPicture> view_picture;
    std::optional<Theme> chosen_theme;        ///< by hand: what is remembered for the next time
    std::optional<double> chosen_scale;       ///< the same
    std::optional<Language> chosen_language;  ///< the same
};

class Workbench {
public:
    /// Reads the lists of presets and scenes once.
    Workbench();

    Arrangement arrangement;
    ViewState views;
    Stage stage;  ///< what a lesson covers, points out and marks
    Guide guide;  ///< the lesson that leads, if there is one
    PresenterMode presenter;
    StartPage start_page;
    ExerciseDesk exercises;  ///< of the student who sits here
    ExercisePage exercise_page;
    FlightRecorder recorder;          ///< of what is drawn: whoever draws notes each frame
    Replay replay;                    ///< of a flight or a hand-in, while it plays
    bool is_checking = false;         ///< an answer is being judged beside the window
    LessonsProgress progress;         ///< of this person, in every lesson
    std::vector<std::string> recent;  ///< files that were opened, the latest first
    std::string lesson_trouble;       ///< why an answer could not be judged; "" when it could
    Syllables korean;                 ///< that were shown, for the fonts of the next frame
    widgets::Context widgets;

    /// Where everything is for this session, in the fonts that the widgets have now.
    Layout layout(ImVec2 window_px, const Session& session) const;
    /// What the person has arranged together with what the state says of it (view.layout).
    Arrangement arranged(const Session& session) const;

    /// Goes to an exercise of the student's sheet as soon as that is made; `replays`: and plays how it was done.
    void go_to_exercise(const std::string& id, bool replays);

    /// Pictures of lessons and steps that are wanted in Pictures.
    std::vector<CardPicture> wanted_cards();
    /// The preset whose small picture is wanted in Pictures; "" for none.
    const std::string& wanted_preset_picture() const { return preset_picker_.wanted_picture(); }
    /// In how many seconds the good news in the status bar go; negative: there are none.
    static double message_ends_in_s(const Message& message);

    /// Draws one ImGui frame's windows (between NewFrame and Render), edits the session and moves its camera.
    /// `problems` are those of the plan.
    Requests draw(Session& session, const Derived& derived, const Derived& before, const FramePlan& plan,
                  const std::vector<Problem>& problems, const Pictures& pictures, const StatusLine& status,
                  const FrameInput& input);

private:
    void set_stage();
    /// What is typed counts before a key or a file leads away from it: these wait for a frame then. It counts too when
    /// the window loses the focus.
    FrameInput after_typing(const FrameInput& input);
    /// What a room sees has the switches alone that the step names, and `kinds` beside them.
    std::optional<std::vector<std::string>> offered(const Params& params, std::vector<std::string> kinds) const;
    void follow_lesson(Session& session, const FrameInput& input);
    bool take_lesson_key(const KeyPress& press, Session& session);
    void draw_lesson(Session& session, const Layout& layout, const Pictures& pictures, Requests& requests);
    void draw_lesson_button(Session& session);
    void follow_exercises(Session& session);
    void draw_exercises(Session& session, const Pictures& pictures);
    void choose_answers(FileDialog::Purpose purpose, Session& session);
    /// Numbers in the clipboard as the answer to the question; false where they are not as many as it asks for.
    bool paste_answer(Session& session);
    void handle_keys(Session& session, const FrameInput& input, double aspect, Requests& requests);
    void handle_shortcut(const KeyPress& press, Session& session, Requests& requests);
    void draw_top_bar(Session& session, const Layout& layout, const PresetPicture& picture, Requests& requests);
    void draw_presets(Session& session, float width, bool has_steps, const PresetPicture& picture);
    const NamedFile* open_preset(const Session& session) const;
    /// The preset so many places after the open one in the order of the lecture; none beyond its ends.
    const NamedFile* preset_at(const Session& session, int places) const;
    void choose_scale(Session& session, double scale, Requests& requests);
    void draw_file_menu(Session& session, Requests& requests);
    void draw_look_menu(Session& session, Requests& requests);
    /// Begins a recording, or ends it and writes its file beside the window.
    void toggle_recording(Session& session);
    void end_recording(Session& session);
    /// Ends a recording that is full, plays what was opened.
    void follow_flights(Session& session, double dt_s);
    std::string recording_sign() const;
    void draw_recording_sign(const Layout& layout) const;
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
    /// Texts of others, which are Korean in any language: names of files and objects, lessons, what is typed.
    void want_korean(const Session& session);

    FrameInput waiting_;  ///< keys and files, until what is typed counts
    FileDialog file_dialog_;
    TypedMatrix typed_matrix_;
    std::string wanted_exercise_;  ///< to be gone to when it is made
    bool wants_replay_ = false;
    PresetPicker preset_picker_;
    int korean_scene_version_ = -1;  ///< whose objects' names were looked through
    std::shared_ptr<const Lesson> korean_lesson_;
    Language korean_language_ = Language::en;
    CaptionFold caption_fold_;
    std::optional<double> pending_scale_;
    bool help_open_ = false;
    MatrixChoice matrix_choice_;
    void remember_opened(const Session& session);

    std::string opening_;      ///< a file that is being read
    std::string opened_mesh_;  ///< the scene, where it is a file of its own
    bool leads_ = false;       ///< what is on the stage is the lesson's
};

}  // namespace viewing
