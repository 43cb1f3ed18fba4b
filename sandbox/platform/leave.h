// Ends the program immediately, since the system releases its resources anyway.
#pragma once

#include "platform/sanitized.h"

namespace viewing {

/// Whether leave() ends the process without running destructors.
inline constexpr bool leaves_at_once = !is_sanitized;

/// Ends the process with this status, after flushing its streams. If leaves_at_once, skips static destructors and the
/// exit handlers of libraries: a GL driver takes milliseconds to unload its compiler.
[[noreturn]] void leave(int status);

}  // namespace viewing
