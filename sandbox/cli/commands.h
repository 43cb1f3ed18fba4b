// The commands of the program, one file each: NAME_command.cpp. Their texts are part of --help.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "cli/exit_status.h"

namespace viewing {

using Arguments = std::vector<std::string>;

struct Command {
    const char* name;
    const char* synopsis;  ///< the arguments after the name: "[STATE] [--set PATH=VALUE]…"
    const char* about;     ///< one line for the list of commands
    const char* details;   ///< a paragraph or two for the command's own --help
    const char* examples;  ///< one per line, without the program's name
    const char* statuses;  ///< the digits of the exit statuses that the command can return
    /// Writes results to stdout; throws Failure.
    ExitStatus (*run)(const Command& self, const Arguments& arguments);
};

extern const Command open_command, snapshot_command, compare_command, matrices_command, inspect_command,
    measure_command, lesson_command, lecture_command, exercises_command, grade_command, suite_command, sweep_command,
    state_command, params_command, presets_command, doctor_command;

/// Returns all commands, in the order of --help.
std::span<const Command* const> commands();

/// Returns the command with this name, or nullptr.
const Command* find_command(const std::string& name);

}  // namespace viewing
