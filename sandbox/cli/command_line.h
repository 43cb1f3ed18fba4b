// The entry point of the command line: runs a command and returns its exit status.
#pragma once

#include <string>
#include <vector>

namespace viewing {

/// Runs the program with the arguments after its name and returns the exit status (exit_status.h). Never throws; one
/// sentence on stderr reports an error.
int run_command_line(const std::vector<std::string>& arguments);

}  // namespace viewing
