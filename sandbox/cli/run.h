// The command line's entry: which command is meant, and what its end means for the caller.
#pragma once

#include <string>
#include <vector>

namespace viewing {

/// Runs the program with the arguments behind its name; the result is the exit status (exit_status.h). Nothing is
/// thrown: one sentence on stderr says what went wrong.
int run_command_line(const std::vector<std::string>& arguments);

}  // namespace viewing
