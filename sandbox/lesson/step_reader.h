// Internal to lesson/: reads a step of a lesson from its JSON tree. On an error, every function here throws a Refusal
// with the whole message.
#pragma once

#include <filesystem>
#include <map>
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

/// Reads a preset and applies settings to it; if both are missing, returns the opening state. File names in a scene
/// that the settings change are relative to `folder`.
LoadedState state_at(const Json& object, const char* key, const std::filesystem::path& folder, PresetShelf& presets,
                     const Where& where);

/// Reads the state at the beginning of a step, with its layout.
LoadedState read_start(const Json& object, const std::filesystem::path& folder, PresetShelf& presets,
                       const Where& where);

/// Collects mistakes instead of throwing them; the step is then incomplete.
LessonStep read_step(const Json& object, const std::filesystem::path& folder, PresetShelf& presets, const Where& where,
                     Mistakes& mistakes);

/// Read one expression, or a list of them, and check that they use only known names and `constants`.
std::string expression_in(const Json& value, const Where& where, const std::vector<std::string>& constants);
std::vector<std::string> expressions_at(const Json& object, const char* key, const Where& where,
                                        const std::vector<std::string>& constants);

/// Refuses a name that a constant cannot have.
void require_constant_name(const std::string& name, const Where& where);

}  // namespace viewing
