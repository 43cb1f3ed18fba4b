// What would end the process by a signal ends it with a status of the table, where that is possible, and leaves nothing
// unfinished.
#pragma once

namespace viewing {

/// What is said of a fault.
inline constexpr const char* fault_sentence =
    "internal error: the program or the graphics driver has failed; memory or threads may have run out";

/// For the whole process, once, at its beginning. A write beyond the file size limit fails like one on a full disk
/// instead of ending the process. A fault or an abort, which is what a driver makes of a lack of memory or threads, is
/// one sentence on stderr and exit status 9. Without effect on faults where a sanitizer reports them. What asks the
/// process to end does so by its signal (platform/ending_signals.h).
void end_cleanly_by_signals();

}  // namespace viewing
