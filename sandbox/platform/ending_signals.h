// Handles the signals that ask a process to end: Ctrl+C, kill, a closed terminal, a pipe without a reader, and the
// timer of --timeout. cli/signals.h handles faults.
#pragma once

namespace viewing {

/// Call once, at the start of the process: SIGINT, SIGTERM, SIGHUP and SIGPIPE still end it, but unfinished files are
/// removed first (remove_unfinished_files). A signal that is already ignored stays ignored (nohup).
void clean_up_at_ending_signals();

/// While an object of this class exists, the first SIGINT, SIGTERM, SIGHUP or SIGALRM is only noted, so that work can
/// stop and report its results so far. A second one ends the process immediately. Only one object may exist at a time.
class EndingNote {
public:
    EndingNote();
    ~EndingNote();
    EndingNote(const EndingNote&) = delete;
    EndingNote& operator=(const EndingNote&) = delete;

    /// Returns the noted signal; 0 if there is none.
    static int signal();
    /// Returns a file descriptor that becomes readable when a signal is noted, for use in poll().
    static int file();
};

/// Returns a name such as "SIGTERM (kill)"; "--timeout" for SIGALRM.
const char* name_of_ending_signal(int signal);

/// Whether the signal is the one that --timeout uses.
bool is_timeout(int signal);

/// Ends the process as if by this signal.
[[noreturn]] void end_by_signal(int signal);

/// Call in a child process whose parent handles Ctrl+C for both: ignores SIGINT and SIGHUP, and leaves them to the
/// parent.
void leave_terminal_to_parent();

}  // namespace viewing
