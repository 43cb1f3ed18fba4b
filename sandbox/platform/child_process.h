// Runs another program that communicates in lines: returns its standard output line by line, and its standard error as
// a single string. Meant for work that may crash and must not take this process down with it.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "text/result.h"

namespace viewing {

class ChildProcess {
public:
    /// Starts the program. `arguments` contains its path, followed by its arguments. The error is the system's reason.
    static Result<ChildProcess> start(const std::vector<std::string>& arguments);
    ChildProcess(ChildProcess&&) noexcept;
    ChildProcess& operator=(ChildProcess&&) noexcept;
    /// Ends a child that is still running (end()).
    ~ChildProcess();

    /// Write to the program's standard input: tell() appends a newline, give() does not. Return false if the program no
    /// longer reads its input.
    bool tell(const std::string& line) { return give(line + "\n"); }
    bool give(std::string_view bytes);
    /// Closes the program's standard input, so that the program ends by itself.
    void finish_telling();

    /// Returns the complete lines written since the last call, without newlines; keeps an incomplete line for later.
    std::vector<std::string> take_lines();
    /// Returns what the program has written to standard error since the last call, but only the last 64 KiB of it.
    std::string take_complaints();

    /// Whether the program may still write something: its output had not ended when it was last read.
    bool is_running() const;
    /// Sends SIGTERM, so that the program can remove its unfinished files. Sends SIGKILL when its output ends, or after
    /// two seconds at the latest. Then calls wait().
    std::string end();
    /// Waits until the program ends. Returns how it ended: "exit status 9", "signal 11 (Segmentation fault)".
    std::string wait();
    /// Returns the exit status after wait(); −1 if a signal ended it.
    int exit_status() const;

    /// Sleeps until one of the children writes output or ends, or `wake_file` becomes readable, for at most `seconds`.
    /// Reads the available output.
    static void listen(std::span<ChildProcess* const> children, double seconds, int wake_file = -1);

private:
    struct State;
    explicit ChildProcess(std::unique_ptr<State> state);
    void send(int signal);
    std::unique_ptr<State> state_;
};

/// Returns the path of the running program.
std::string own_program();

/// Call in a child process: sends it SIGTERM when the thread that started it ends, for whatever reason. If the parent
/// has already ended, exits immediately. Leaves Ctrl+C and a closed terminal to the parent.
void end_with_parent();

}  // namespace viewing
