// Starts a program, measures its wall time, the CPU time of all its threads and its peak memory, and keeps its output.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace viewing::bench {

using Command = std::vector<std::string>;

/// A running program and the file descriptor of its standard output.
struct Started {
    pid_t process = 0;
    int output = -1;
};

/// Starts the command; if that fails, this program ends with a message. Both programs share standard error.
Started start(const Command& command);

struct Measured {
    double wall_ms = 0.0;
    double cpu_ms = 0.0;  ///< user and system
    double peak_mb = 0.0;
    std::string output;
};

/// Runs the command to completion. If it does not exit with 0, this program ends with a message.
Measured run(const Command& command);

}  // namespace viewing::bench
