// Internal to lesson/: a step of a lesson from its JSON tree. Everything here throws Refusal with the whole message.
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

/// A preset with settings on top; without either, the opening. Files that its scene names are relative to `folder`.
LoadedState state_at(const Json& object, const char* key, const std::filesystem::path& folder, PresetShelf& presets,
                     const Where& where);

/// The state in which a step begins, with its layout.
LoadedState read_start(const Json& object, const std::filesystem::path& folder, PresetShelf& presets,
                       const Where& where);

LessonStep read_step(const Json& object, const std::filesystem::path& folder, PresetShelf& presets, const Where& where);

/// An expression of a file, checked: it names only what there is, and `constants`.
std::string expression_in(const Json& value, const Where& where, const std::vector<std::string>& constants);
std::vector<std::string> expressions_at(const Json& object, const char* key, const Where& where,
                                        const std::vector<std::string>& constants);

/// Refuses what cannot stand for a constant.
void require_constant_name(const std::string& name, const Where& where);

}  // namespace viewing
