// The signals that ask a process to end: Ctrl+C, kill, a terminal that is closed, a pipe without a reader, and the
// clock of --timeout. For faults read cli/signals.h.
#pragma once

namespace viewing {

/// For the whole process, once, at its beginning: SIGINT, SIGTERM, SIGHUP and SIGPIPE end it as they would have, but
/// what waits for its name is removed first (remove_unfinished_files). One that is ignored stays so (nohup).
void clean_up_at_ending_signals();

/// As long as one lives, the first SIGINT, SIGTERM, SIGHUP or SIGALRM is only noted, for work that leaves a report of
/// how far it came. A second one ends the process at once. One at a time.
class EndingNote {
public:
    EndingNote();
    ~EndingNote();
    EndingNote(const EndingNote&) = delete;
    EndingNote& operator=(const EndingNote&) = delete;

    /// The signal that was noted; 0: none.
    static int signal();
    /// A file that can be read from then on, for who sleeps in poll().
    static int file();
};

/// "SIGTERM (kill)"; of SIGALRM "--timeout".
const char* name_of_ending_signal(int signal);

/// Whether it is the clock's of --timeout.
bool is_timeout(int signal);

/// Ends the process as this signal does.
[[noreturn]] void end_by_signal(int signal);

/// For a child of a program that answers to Ctrl+C for both: SIGINT and SIGHUP are left to the parent.
void leave_terminal_to_parent();

}  // namespace viewing
