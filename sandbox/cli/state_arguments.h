// STATE, --at, --mesh and --set: the arguments shared by all commands that read a state.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/options.h"
#include "cli/output.h"
#include "lesson/linked_step.h"
#include "state/presets.h"
#include "state/scene.h"

namespace viewing {

class StateArguments {
public:
    /// Declares these arguments under the title "State".
    explicit StateArguments(Options& options);
    StateArguments(const StateArguments&) = delete;
    StateArguments& operator=(const StateArguments&) = delete;

    /// Loads STATE (for a link to a lesson, the state of the linked step; for a flight, the picture at the time that
    /// --at gives), replaces its scene with the mesh, and applies the settings in order. File names in STATE are
    /// relative to its folder, those in settings to the working directory. The returned state keeps file names as
    /// given, unless settings change an inline scene, in which case all its file names become relative to the working
    /// directory. Files in STATE's folder and those named on the command line may be read; with --allow-outside, all
    /// files may be read. For a flight without --at, mesh and settings apply to its start. Throws Failure.
    LoadedState load() const;
    /// Returns the step that STATE links to; nothing if STATE is not such a link. Throws Failure.
    std::optional<LinkedStep> linked_step() const;
    /// Returns the files named on the command line: STATE, unless it is a preset, and --mesh.
    std::vector<FileArgument> files() const;
    /// Returns STATE as typed; "" if it was left out.
    const std::string& as_typed() const { return state_; }
    /// Returns theme, scale and language from --set. Throws Failure if --set changes anything else or --mesh was given.
    UiParams looks() const;
    /// Whether any of these arguments was given.
    bool are_given() const { return !state_.empty() || !settings_.empty() || mesh_ || at_; }
    /// Whether the arguments, apart from a lesson's link, only set how the window looks: theme, scale, language.
    bool say_only_looks() const;

private:
    bool set_only_looks() const;
    void take_picture_at(LoadedState& loaded) const;
    /// Returns STATE, or the text of standard input if STATE is "-".
    const std::string& text() const;
    LoadedState loaded() const;

    const Options& options_;
    std::string state_;
    std::vector<std::string> settings_;
    std::optional<std::string> at_, mesh_;
    mutable std::optional<std::string> piped_;  ///< the text of standard input, which can be read only once
    bool allows_outside_ = false;
};

/// Returns the step that --lesson and --step name; without --step, the first one. Throws Failure.
LinkedStep lesson_step(const Options& options, const std::string& lesson, const std::optional<std::string>& number);

/// Loads the scene of a state with its meshes. If parts were skipped, calls note() (output.h). Throws Failure.
Scene scene_of(const LoadedState& state);

/// Return the files that a state's scene names, and the files that were read for a scene.
std::vector<FileArgument> files_of(const LoadedState& state);
std::vector<FileArgument> files_of(const Scene& scene);

}  // namespace viewing
