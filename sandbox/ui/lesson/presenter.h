// The lesson in front of a room: what a clicker and a few keys do, and what is drawn over everything: a black screen,
// the pointer, ink. Everything below stays live. Read session/guide.h for the way through the lesson.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "session/guide.h"
#include "ui/parts/input.h"
#include "widgets/widgets.h"

namespace viewing {

class PresenterMode {
public:
    bool is_on() const { return is_on_; }
    void begin();
    void end();
    /// What has become of the screen since the last call: full or not.
    std::optional<bool> take_wish_for_full_screen() { return std::exchange(wants_full_screen_, std::nullopt); }

    /// True where the key was for the lesson in front of a room and for nothing else.
    bool take(const KeyPress& press, Guide& guide, Session& session);
    /// Called once a frame with what is held.
    void update(const FrameInput& input, Guide& guide, Session& session);

    /// The picture stays as it is for the room.
    bool is_frozen() const { return is_on_ && is_frozen_; }
    /// The steps as pictures, to jump to one.
    bool shows_overview() const { return shows_overview_; }
    void show_overview(const Guide& guide);
    void close_overview() { shows_overview_ = false; }
    int overview_choice() const { return choice_; }

    /// "3:20" while there is a timer, else empty.
    std::string clock() const;
    bool has_running_clock() const { return is_on_ && clock_runs_; }
    double presented_s() const { return presented_s_; }  ///< since it began
    /// Ink takes the mouse from what is below.
    bool takes_mouse() const { return is_on_ && (inks_ || blank_ != Blank::none); }

    /// Over everything else.
    void draw(std::size_t step);

private:
    enum class Blank { none, black, white };
    enum class Pointer { none, spot, spotlight };
    using Stroke = std::vector<ImVec2>;  ///< in shares of the window

    bool take_in_overview(const KeyPress& press, Guide& guide, Session& session);
    void vote(int choice, int change, Guide& guide);
    void draw_ink(std::size_t step);
    void draw_pointer();

    bool is_on_ = false, is_frozen_ = false, shows_overview_ = false, inks_ = false, clock_runs_ = false;
    Blank blank_ = Blank::none;
    Pointer pointer_ = Pointer::none;
    int choice_ = 0;     ///< in the overview
    std::string typed_;  ///< its digits
    double clock_s_ = 0.0, presented_s_ = 0.0;
    std::map<std::size_t, std::vector<Stroke>> ink_;  ///< by step
    std::optional<bool> wants_full_screen_;
};

}  // namespace viewing
