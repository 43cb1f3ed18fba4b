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
    const char* synopsis;  ///< what follows the name: "[STATE] [--set PATH=VALUE]…"
    const char* about;     ///< one line for the list of commands
    const char* details;   ///< a paragraph or two for the command's own --help
    const char* examples;  ///< a line each, without the program's name
    const char* statuses;  ///< the digits of the exit statuses that the command has
    /// Results go to stdout. What goes wrong is thrown as Failure.
    ExitStatus (*run)(const Command& self, const Arguments& arguments);
};

extern const Command open_command, snapshot_command, compare_command, matrices_command, inspect_command,
    measure_command, lesson_command, exercises_command, grade_command, suite_command, sweep_command, state_command,
    params_command, presets_command, doctor_command;

/// All of them in the order of --help.
std::span<const Command* const> commands();

/// The command of a name; nullptr when there is none.
const Command* find_command(const std::string& name);

}  // namespace viewing
