// One open sandbox without its looks: the parameters with their history, the scene they name, and the motion
// through it. Panels edit `params` in place; the session notices. Read workbench.h next.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "geometry/navigation.h"
#include "platform/background.h"
#include "session/history.h"
#include "state/presets.h"
#include "state/scene.h"

namespace viewing {

/// A file that a state names and that lies neither in the state's own folder nor among the assets.
struct OutsideFile {
    std::filesystem::path file;  ///< where the links lead
    std::string named_by;        ///< the state: its name, or "clipboard"
};

/// A line for the status bar, good or bad news.
struct Message {
    std::string text;
    bool is_error = false;
    double shown_s = 0.0;   ///< good news goes by itself after a while
    bool is_drawn = false;  ///< since then shown_s counts
};

class Session {
public:
    /// Loads the scene at once; the error says why it cannot be.
    static Result<Session> make(const LoadedState& state);
    /// The same for a window, which does not wait long: a scene that takes more than `patience_s` is awaited, and until
    /// it comes the opening one is there.
    static Result<Session> begin(const LoadedState& state, double patience_s);
    /// With a scene that is already loaded.
    Session(const LoadedState& state, Scene scene);
    Session(Session&&) noexcept;
    Session& operator=(Session&&) noexcept;
    ~Session();

    Params params;
    Message message;

    /// A failure becomes the message.
    void report(const Status& status) {
        if (!status) message = {status.error(), true};
    }

    const Scene& scene() const { return scene_; }
    /// Counts up whenever another scene takes over.
    int scene_version() const { return scene_version_; }

    /// Called once a frame: starts and ends the reading of the scene that `params` names, takes over what was opened,
    /// and tells what was written. Whatever cannot be read leaves everything as it was and says why in `message`.
    void update_scene();
    /// Waits for all of that; for pictures without a window.
    void finish_loading();
    std::optional<float> loading_fraction() const;
    /// Whether a state or a scene is on its way: `params` are still those before it.
    bool is_loading() const { return wanted_.has_value(); }
    std::string loading_name() const;
    void cancel_loading();

    /// What is opened waits for a yes to read this file; null: nothing does.
    const OutsideFile* asks_to_read() const { return question_ ? &*question_ : nullptr; }
    /// Yes: this file's folder may be read from in this session, by whatever names it.
    void answer(bool may_read);

    /// Moves the camera; the motion goes on until it is at rest.
    void navigate(const MotionInput& input, double dt_s);
    bool is_moving() const { return !motion_.at_rest(); }
    const MovingFreedoms& moving_freedoms() const { return moving_; }    ///< in the last step
    static constexpr double least_speed = 0.05, greatest_speed = 200.0;  ///< world units a second
    double speed() const { return tuning_.speed; }
    void set_speed(double speed);

    /// Back to where the camera of this state began.
    void go_home();
    /// The whole scene with its patches in the picture; the camera keeps its directions. `aspect`: of the picture.
    void frame_all(double aspect);
    /// Without roll.
    void level();
    /// From the target's distance towards the target along a world axis (0: x, 1: y, 2: z) from its positive side; from
    /// the other side when that is how the camera looks already.
    void look_along(int axis);

    /// Called when nothing is held or moving: one undo step if something changed. A change that names another scene
    /// becomes a step when that scene is there.
    void rest();
    void undo();
    void redo();
    bool can_undo() const { return history_.can_undo(); }
    bool can_redo() const { return history_.can_redo(); }
    /// The parameters before the latest edit: what is tinted as changed is measured against them.
    const Params& before_latest_edit() const { return params == at_rest_ ? before_ : at_rest_; }

    /// Other parameters in the person's theme, scale and language.
    Params in_own_looks(Params other) const;

    /// The preset that was opened last, none where it was a file or the clipboard; undo and redo bring it along.
    const OpenPreset* preset() const { return preset_.get(); }
    /// Whether anything is no longer as that preset has it; theme and scale are the person's.
    bool departs_from_preset() const;
    /// Everything as the preset has it, as one step; nothing without one.
    void return_to_preset();

    /// What was opened last, once, where it was a flight: its start is there, and it wants to be played.
    std::shared_ptr<const Flight> take_flight() { return std::exchange(flight_, nullptr); }

    void reset();
    /// Takes over a state as one step, when its scene is there.
    void replace(const LoadedState& state);

    // Nothing waits for a file: what came of it is told when it is known, in `message` and once by take_outcome().

    /// A file, a preset's name, an .obj or a dropped file.
    void open(const std::string& argument);
    /// The name that was given to open() while that is read, else "".
    const std::string& opening() const;
    /// A whole state, or a link to one. A text has no folder of its own: files that it names outside the assets are
    /// asked about.
    Status paste(const std::string& text);
    void save(const std::filesystem::path& file);
    /// `work` writes a file, beside this thread; `told` is the message when it is done.
    void write(std::function<Status()> work, std::string told);
    /// Of the latest open(), save() or write() that has ended; a file that is asked about ends an open() too.
    std::optional<Status> take_outcome() { return std::exchange(outcome_, std::nullopt); }

    /// Parameters of this session with the files they name told from the root: they mean the same from anywhere.
    Params portable(Params own) const;
    /// The whole state as text, portable.
    std::string text() const;
    /// Whether the scene that `params` names is not there yet: what is drawn has the one before.
    bool awaits_scene() const { return params.scene != loaded_source_ || base_ != loaded_base_; }

private:
    /// What one step of the history brings back.
    struct Step {
        Params params;
        std::shared_ptr<const OpenPreset> preset;
        std::filesystem::path base;
        bool operator==(const Step& other) const {
            const auto name = [](const Step& step) { return step.preset ? step.preset->name : std::string(); };
            return params == other.params && name(*this) == name(other);
        }
    };

    /// What is read beside this thread: a whole state with its scene, or the scene that `params` names.
    struct Wanted {
        std::string argument = {};             ///< as open() took it; "" where the state is known
        LoadedState state = {};                ///< unless there is an argument
        bool is_whole = false;                 ///< else it is only the scene
        bool may_be_silent = false;            ///< defaults of looks and layout mean that it sets none
        bool is_first = false;                 ///< what the session was begun with
        std::optional<std::string> told = {};  ///< the message when it is there
    };
    struct Arrived {
        LoadedState state;
        Scene scene;
        std::filesystem::path outside;  ///< not empty: this has to be asked about, and there is no scene
    };

    /// Turns the camera to the orbit's target when that is out of view: orbiting something unseen helps nobody.
    void aim_at_target();
    /// Makes the scene anew at once where a formula made it from other parameters: there is nothing to wait for.
    void remake_scene();
    void begin_here();  ///< where the camera is now is its home
    /// The scene that is awaited does not come: back to what was before it was named.
    void keep_scene();
    void take_over(const Step& step);
    void start_reading(Wanted wanted);
    void end_reading(Result<Arrived> result);
    void take_written();
    /// Without the language, which is not undone.
    Step now() const;
    /// The person's looks, also while an opened state shows others.
    UiParams own_looks() const;
    /// What a state shows that has just been opened: its own looks and layout, or the person's where it sets none.
    void take_over_looks(Params& opened, bool may_be_silent);

    std::filesystem::path base_;
    Scene scene_;
    SceneSource loaded_source_;
    std::filesystem::path loaded_base_;
    int scene_version_ = 0;

    std::optional<Wanted> wanted_;  ///< is being read, or waits for the answer to the question
    BackgroundTask<Arrived> reading_;
    bool has_just_begun_ = false;  ///< reading
    std::optional<OutsideFile> question_;
    FileReach allowed_{false, {}};  ///< by a yes, or since it was read before
    BackgroundTask<std::monostate> writing_;
    std::string written_;  ///< the message when it is done
    std::optional<Status> outcome_;
    int steps_back_ = 0;  ///< in the history, to where the awaited scene belongs; negative: forth

    CameraParams home_;
    double home_height_ = 0.0;  ///< of the orthographic view there
    Motion motion_;
    MovingFreedoms moving_;
    MotionTuning tuning_;
    std::shared_ptr<const OpenPreset> preset_;
    /// Looks that an opened state has set, and the person's, which come back with the next state that sets none.
    struct LentLooks {
        UiParams shown, own;
    };
    std::optional<LentLooks> lent_looks_;
    std::shared_ptr<const Flight> flight_;
    History<Step> history_;
    Params at_rest_, before_;
};

}  // namespace viewing
