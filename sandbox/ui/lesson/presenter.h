// Presenter mode shows a lesson's step or, without a lesson, the current state to an audience. It handles a clicker's
// keys and a few more, and draws overlays: a blank screen, a pointer, ink, and votes. Everything under the overlays
// stays live. See session/guide.h for the navigation through a lesson.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "session/guide.h"
#include "ui/lesson/vote_panel.h"
#include "ui/parts/input.h"
#include "widgets/widgets.h"

namespace viewing {

class PresenterMode {
public:
    enum class Blank { none, black, white };

    bool is_on() const { return is_on_; }
    void begin();
    void end();
    /// Returns the requested full-screen state, if any, and clears the request.
    std::optional<bool> take_wish_for_full_screen() { return std::exchange(wants_full_screen_, std::nullopt); }

    /// Hands a key to what is over the picture: the overview, a blank screen, votes, ink. Returns true if one of them
    /// used the key; nothing else should then use it.
    bool take(const KeyPress& press, Guide& guide, Session& session);
    /// Call once a frame with the keys and buttons that are held down.
    void update(const FrameInput& input, Guide& guide, Session& session);

    /// Whether the audience's picture is frozen.
    bool is_frozen() const { return is_on_ && is_frozen_; }
    /// Whether the overview is open. It shows the steps as pictures and lets the user jump to one.
    bool shows_overview() const { return shows_overview_; }
    void show_overview(const Guide& guide);
    void close_overview() { shows_overview_ = false; }
    int overview_choice() const { return choice_; }

    /// Returns "3:20" while there is a timer, otherwise "".
    std::string clock() const;
    bool has_running_clock() const { return is_on_ && clock_runs_; }
    /// Whether X is held without a lesson. The session's params are then those from before the latest edit.
    bool holds_before() const { return held_.has_value(); }
    double presented_s() const { return presented_s_; }  ///< seconds since presenting began
    /// Whether the screen is black or white.
    bool is_blank() const { return is_on_ && blank_ != Blank::none; }
    /// Whether ink or a blank screen keeps the mouse from reaching the views.
    bool takes_mouse() const { return is_on_ && (inks_ || blank_ != Blank::none); }

    /// Whether the QR code of the step or state is shown.
    bool shows_code() const { return is_on_ && shows_code_; }
    void show_code() { shows_code_ = true; }
    /// Whether letter keys type vote counts, so that holding them does not move the camera.
    bool takes_letters() const { return is_on_ && votes_.is_typing(); }

    void show_blank(Blank blank) { blank_ = blank; }  ///< until any key is pressed
    void toggle_freeze() { is_frozen_ = !is_frozen_; }
    void next_pointer();  ///< none, a dot, a spotlight
    /// Begins to draw with the mouse, or ends it and erases the page's ink.
    void toggle_ink(const Guide& guide);
    void toggle_code() { shows_code_ = !shows_code_; }
    void toggle_clock() { clock_runs_ = !clock_runs_; }
    void reset_clock() { clock_runs_ = false, clock_s_ = 0.0; }
    /// Hides the QR code or, if it is hidden, ends inking. Ends presenter mode only if there is no code, inking, or
    /// lesson: a stray Escape must not end a lesson.
    void leave_by_escape(const Guide& guide);

    /// Draws on top of everything else. `room`: the part of the window above the lesson's text.
    void draw(const Guide& guide, const Rect& room);

private:
    enum class Pointer { none, spot, spotlight };
    using Stroke = std::vector<ImVec2>;  ///< in fractions of the window

    bool take_in_overview(const KeyPress& press, Guide& guide, Session& session);
    void draw_ink(std::size_t step);
    void draw_pointer(const Rect& room);

    bool is_on_ = false, has_lesson_ = false, is_frozen_ = false, shows_overview_ = false, shows_code_ = false,
         inks_ = false, clock_runs_ = false;
    Blank blank_ = Blank::none;
    Pointer pointer_ = Pointer::none;
    VotePanel votes_;
    /// What the votes and the QR code belong to: the step, and whether its answer is shown.
    std::optional<std::pair<std::size_t, bool>> shown_step_;
    int choice_ = 0;     ///< the step chosen in the overview
    std::string typed_;  ///< the digits of a step number that have been typed so far
    double clock_s_ = 0.0, presented_s_ = 0.0;
    std::map<std::size_t, std::vector<Stroke>> ink_;  ///< by step; strokes without a lesson have the greatest key
    std::optional<Params> held_;                      ///< the parameters that return when X is released
    std::optional<bool> wants_full_screen_;
};

}  // namespace viewing
