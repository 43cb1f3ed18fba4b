// Internal to lesson/: the form of a step, the forms of its parts, and the data that they share while a file is read.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "lesson/tree.h"

namespace viewing {

/// Presets by name, each read once.
class PresetShelf {
public:
    const LoadedState& get(const std::string& name, const Where& where);

private:
    std::map<std::string, LoadedState> states_;
};

/// What is known while a lesson is read.
struct LessonReading {
    std::filesystem::path folder;  ///< file names in scenes are relative to it
    PresetShelf presets = {};
    /// The names that a step defines for its expressions; none if they cannot be read; then no expression is checked.
    std::optional<std::vector<std::string>> constants = std::vector<std::string>();
};

/// {"preset", "set"}: a preset with changes, by default the opening state.
form::Form<LoadedState> state_form(LessonReading& reading);

/// Reads the state at the beginning of a step; it is the opening state if there is none.
LoadedState read_start(const Json* state, LessonReading& reading, const Where& where);

form::Form<LessonStep> step_form(LessonReading& reading);

/// An expression, a number or a list of numbers, or a list of these. An expression uses only known names and constants.
form::Form<std::string> expression_form(const LessonReading& reading);
form::Form<std::vector<std::string>> expressions_form(const LessonReading& reading);

/// Returns the parameters with these settings; refuses settings that cannot be applied.
Params changed(const Params& params, const std::vector<std::string>& settings, const Where& where);

/// Refuses a name that a constant cannot have.
void require_constant_name(const std::string& name, const Where& where);

}  // namespace viewing
