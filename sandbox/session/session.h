// One open sandbox without its interface: the parameters with their history, the scene that they name, and the camera's
// motion. Panels edit `params` in place; the session detects this. Read ui/window/workbench.h next.
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

/// A file that a state names but that is neither in the state's own folder nor among the assets.
struct OutsideFile {
    std::filesystem::path file;  ///< with links followed
    std::string named_by;        ///< the state's name, or "clipboard"
};

/// A message for the status bar: about a success, or about an error.
struct StatusMessage {
    std::string text;
    bool is_error = false;
    double shown_s = 0.0;   ///< success messages disappear after a while
    bool is_drawn = false;  ///< shown_s increases only once this is true
};

class Session {
public:
    /// Makes a session and loads its scene immediately; the error says why the scene cannot be loaded.
    static Result<Session> make(const LoadedState& state);
    /// Makes a session for a window without waiting long: if loading takes more than `patience_s`, the opening scene is
    /// shown until the scene arrives.
    static Result<Session> begin(const LoadedState& state, double patience_s);
    /// Makes a session with a loaded scene.
    Session(const LoadedState& state, Scene scene);
    Session(Session&&) noexcept;
    Session& operator=(Session&&) noexcept;
    ~Session();

    Params params;
    StatusMessage message;

    /// Shows a failure as the message.
    void report(const Status& status) {
        if (!status) message = {status.error(), true};
    }

    const Scene& scene() const { return scene_; }
    /// Increases whenever the scene changes.
    int scene_version() const { return scene_version_; }

    /// Called once a frame: starts and finishes loading the scene that `params` names, applies opened states, and
    /// reports finished writes. If a read fails, nothing changes, and `message` says why it failed.
    void update_scene();
    /// Waits until all reads and writes are finished and applied; used to draw pictures without a window.
    void finish_loading();
    std::optional<float> loading_fraction() const;
    /// Whether a state or a scene is being read; until it arrives, `params` are unchanged.
    bool is_loading() const { return wanted_.has_value(); }
    std::string loading_name() const;
    void cancel_loading();

    /// Returns the file that needs permission to be read; null if none does.
    const OutsideFile* asks_to_read() const { return question_ ? &*question_ : nullptr; }
    /// Answers whether the file of asks_to_read() may be read. If `may_read` is true, this session may read all files
    /// in that file's folder, regardless of what refers to them.
    void answer(bool may_read);

    /// Moves the camera, which keeps moving until it comes to rest.
    void navigate(const MotionInput& input, double dt_s);
    bool is_moving() const { return !motion_.at_rest(); }
    const MovingFreedoms& moving_freedoms() const { return moving_; }    ///< moving in the last navigate()
    const MovingFreedoms& asked_freedoms() const { return asked_; }      ///< requested by keys in the last navigate()
    static constexpr double least_speed = 0.05, greatest_speed = 200.0;  ///< world units per second
    double speed() const { return tuning_.speed; }
    void set_speed(double speed);

    /// Moves the camera back to its initial pose in this state.
    void go_home();
    /// Fits the whole scene with its patches and the point lights near it into the picture without rotating the camera.
    /// `aspect` is that of the picture.
    void frame_all(double aspect);
    /// Sets the camera's roll to zero.
    void level();
    /// Looks at the target along a world axis (0: x, 1: y, 2: z) from its positive side, at the same distance; from the
    /// other side if the camera already looks that way.
    void look_along(int axis);

    /// Called when nothing is held or moving: makes one undo step if something changed. A change that names another
    /// scene becomes a step when that scene is loaded.
    void rest();
    void undo();
    void redo();
    bool can_undo() const { return history_.can_undo(); }
    bool can_redo() const { return history_.can_redo(); }
    /// Returns the parameters before the latest edit; the window tints whatever has changed since then.
    const Params& before_latest_edit() const { return params == at_rest_ ? before_ : at_rest_; }

    /// Returns the given parameters with the user's own theme, scale and language.
    Params in_own_looks(Params other) const;

    /// Returns the most recently opened preset; null if a file was opened or the clipboard was pasted since. Undo and
    /// redo restore it.
    const OpenPreset* preset() const { return preset_.get(); }
    /// Whether anything but appearance and layout differs from that preset.
    bool departs_from_preset() const;
    /// Restores the preset, except for appearance and layout, as one step; does nothing without a preset.
    void return_to_preset();

    /// Returns the most recently opened flight, but only once, so that the caller can play it; its start is already in
    /// `params`.
    std::shared_ptr<const Flight> take_flight() { return std::exchange(flight_, nullptr); }

    void reset();
    /// Applies a state as one undo step, once its scene is loaded.
    void replace(const LoadedState& state);

    // Files are read and written in the background. The outcome appears in `message`, and once in take_outcome().

    /// Opens a file, a preset given by name, an .obj file, or a dropped file.
    void open(const std::string& argument);
    /// Returns the argument of open() while the file that it names is being read; otherwise "".
    const std::string& opening() const;
    /// Applies a whole state, or the state that a link contains. Text has no folder of its own, so files that it names
    /// outside the assets need permission.
    Status paste(const std::string& text);
    void save(const std::filesystem::path& file);
    /// Runs `work`, which writes a file, in the background; `told` is the message when it is done.
    void write(std::function<Status()> work, std::string told);
    /// Returns the outcome of the latest finished open(), save() or write(); a question about a file also finishes an
    /// open().
    std::optional<Status> take_outcome() { return std::exchange(outcome_, std::nullopt); }

    /// Returns parameters with absolute file names, which are valid from any folder.
    Params portable(Params own) const;
    /// Returns the whole state as text, made portable.
    std::string text() const;
    /// Whether the scene that `params` names is not loaded yet; the previous one is drawn until then.
    bool awaits_scene() const { return params.scene != loaded_source_ || base_ != loaded_base_; }

private:
    /// The content of one step of the history.
    struct Step {
        Params params;
        std::shared_ptr<const OpenPreset> preset;
        std::filesystem::path base;
        bool operator==(const Step& other) const {
            const auto name = [](const Step& step) { return step.preset ? step.preset->name : std::string(); };
            return params == other.params && name(*this) == name(other);
        }
    };

    /// A read in the background: a whole state with its scene, or the scene that `params` names.
    struct Wanted {
        std::string argument = {};             ///< as given to open(); "" if the state is known
        LoadedState state = {};                ///< not used if there is an argument
        bool is_whole = false;                 ///< otherwise, only the scene is read
        bool may_be_silent = false;            ///< default appearance and layout count as not set
        bool is_first = false;                 ///< the session's first state
        std::optional<std::string> told = {};  ///< the message on arrival
    };
    struct Arrived {
        LoadedState state;
        Scene scene;
        std::filesystem::path outside;  ///< not empty: this file needs permission, and there is no scene
    };

    /// Rotates the camera toward the orbit's target if the target is out of view, because it makes no sense to orbit
    /// something invisible.
    void aim_at_target();
    /// Remakes a scene immediately if the parameters of its formula changed: there is no file to wait for.
    void remake_scene();
    void begin_here();  ///< makes the current view the one that go_home() restores
    /// Gives up the awaited scene and restores the state from before it was named.
    void keep_scene();
    void take_over(const Step& step);
    void start_reading(Wanted wanted);
    void end_reading(Result<Arrived> result);
    void take_written();
    /// Returns the current step without the language, which undo does not change.
    Step now() const;
    /// Returns the user's own appearance settings, even while those of an opened state are shown.
    UiParams own_looks() const;
    /// Chooses the appearance and layout of a newly opened state: its own, or the user's if it sets none.
    void take_over_looks(Params& opened, bool may_be_silent);

    std::filesystem::path base_;
    Scene scene_;
    SceneSource loaded_source_;
    std::filesystem::path loaded_base_;
    int scene_version_ = 0;

    std::optional<Wanted> wanted_;  ///< being read, or waiting for the answer to the question
    BackgroundTask<Arrived> reading_;
    bool has_just_begun_ = false;  ///< reading_ began after the last update_scene()
    std::optional<OutsideFile> question_;
    FileReach allowed_{false, {}};  ///< files allowed by permission, or because they were read before
    BackgroundTask<std::monostate> writing_;
    std::string written_;  ///< the message when done
    std::optional<Status> outcome_;
    int steps_back_ = 0;  ///< undo steps minus redo steps since a scene was last loaded

    CameraParams home_;
    ProjectionParams home_projection_;  ///< its height and window belong to home_
    Motion motion_;
    MovingFreedoms moving_, asked_;
    MotionTuning tuning_;
    std::shared_ptr<const OpenPreset> preset_;
    /// The appearance that an opened state sets, and the user's own, which returns with the next state that sets none.
    struct LentLooks {
        UiParams shown, own;
    };
    std::optional<LentLooks> lent_looks_;
    std::shared_ptr<const Flight> flight_;
    History<Step> history_;
    Params at_rest_, before_;
};

}  // namespace viewing
