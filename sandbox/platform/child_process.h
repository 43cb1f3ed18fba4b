// A program beside this one, spoken to in lines: what it says on standard output comes back line by line, what it
// complains of on standard error as a text. For work that may crash without taking this process along.
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
    /// `arguments`: the program's path, then what it is given. The error is the system's reason.
    static Result<ChildProcess> start(const std::vector<std::string>& arguments);
    ChildProcess(ChildProcess&&) noexcept;
    ChildProcess& operator=(ChildProcess&&) noexcept;
    /// One that still runs is ended (end()).
    ~ChildProcess();

    /// Into its standard input, with an end of line or as it is. False: it does not listen any more.
    bool tell(const std::string& line) { return give(line + "\n"); }
    bool give(std::string_view bytes);
    /// It is told nothing any more, and ends by itself.
    void finish_telling();

    /// The lines that have come since the last call, without their ends; what is not ended yet waits.
    std::vector<std::string> take_lines();
    /// What it complained of since the last call; the last 64 KiB of it.
    std::string take_complaints();

    /// Whether it may still say something; reads what is there.
    bool is_running() const;
    /// SIGTERM, so that it can remove what it has not finished; SIGKILL where it has not ended two seconds later. Then
    /// wait().
    std::string end();
    /// Waits for its end. How it ended, in words: "exit status 9", "signal 11 (Segmentation fault)".
    std::string wait();
    /// Of one that was waited for: its exit status, −1 where a signal ended it.
    int exit_status() const;

    /// Sleeps until one of them has said something or has ended, or the file can be read, at most so long. Reads what
    /// was said.
    static void listen(std::span<ChildProcess* const> children, double seconds, int wake_file = -1);

private:
    struct State;
    explicit ChildProcess(std::unique_ptr<State> state);
    void send(int signal);
    std::unique_ptr<State> state_;
};

/// The file of the program that runs.
std::string own_program();

/// For a child: from now on it ends with the thread that started it, however that ended, as by SIGTERM. Ctrl+C and the
/// end of the terminal are the parent's to answer.
void end_with_parent();

}  // namespace viewing
