// Turns fatal signals into one of the program's exit statuses if possible, and leaves no unfinished files.
#pragma once

namespace viewing {

/// The message for a fault.
inline constexpr const char* fault_sentence =
    "internal error: the program or the graphics driver crashed; memory or threads may have run out";

/// Call once at startup. From then on, a write beyond the file size limit fails like one on a full disk instead of
/// ending the process. A fault, or an abort (a driver's reaction to a lack of memory or threads), prints one sentence
/// on stderr and exits with status 9; under a sanitizer, the sanitizer handles faults. A signal that asks the process
/// to end still ends it with that signal (platform/ending_signals.h).
void end_cleanly_by_signals();

}  // namespace viewing
