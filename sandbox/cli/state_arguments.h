// STATE, --at, --mesh and --set: what every command takes that looks at a state.
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
    /// Declares them under the title "State".
    explicit StateArguments(Options& options);
    StateArguments(const StateArguments&) = delete;
    StateArguments& operator=(const StateArguments&) = delete;

    /// STATE, of a lesson's link the state of its step, of a flight the picture that --at says, then the mesh in place
    /// of its scene, then the settings in order. Relative files in STATE are relative to its folder, those in settings
    /// to the working directory; they are written back as given, except that an inline scene which settings change has
    /// all its files relative to the working directory. Within reach are STATE's folder and what was typed here;
    /// everything with --allow-outside. Of a flight without
    /// --at mesh and settings are those of its start. Throws Failure.
    LoadedState load() const;
    /// The step that STATE links to; none where it is anything else. Throws Failure.
    std::optional<LinkedStep> linked_step() const;
    /// The files that were typed: STATE, unless it is a preset, and --mesh.
    std::vector<FileArgument> files() const;
    /// STATE by itself, "" where it was left out.
    const std::string& as_typed() const { return state_; }
    /// What --set says of theme, scale and language. Throws Failure: it says more, or --mesh was typed.
    UiParams looks() const;
    /// Whether any of them was typed.
    bool are_given() const { return !state_.empty() || !settings_.empty() || mesh_ || at_; }
    /// Whether what was typed says no more than how the window looks: theme, scale, language; a lesson's link aside.
    bool say_only_looks() const;

private:
    bool set_only_looks() const;
    void take_picture_at(LoadedState& loaded) const;
    /// STATE, or what standard input holds where it is "-".
    const std::string& text() const;
    LoadedState loaded() const;

    const Options& options_;
    std::string state_;
    std::vector<std::string> settings_;
    std::optional<std::string> at_, mesh_;
    mutable std::optional<std::string> piped_;  ///< what standard input held: it can be read once
    bool allows_outside_ = false;
};

/// The step that --lesson and --step say, the first where it is left out. Throws Failure.
LinkedStep lesson_step(const Options& options, const std::string& lesson, const std::optional<std::string>& number);

/// The scene of a state with its meshes; what was left out of them goes to stderr. Throws Failure.
Scene scene_of(const LoadedState& state);

/// The files that a state's scene names, and all that were read for it.
std::vector<FileArgument> files_of(const LoadedState& state);
std::vector<FileArgument> files_of(const Scene& scene);

}  // namespace viewing
