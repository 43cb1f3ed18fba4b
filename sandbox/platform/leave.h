// How the program ends: at once, as what it holds is taken back by the system anyway.
#pragma once

#include "platform/sanitized.h"

namespace viewing {

/// Whether leave() ends the process as it stands: what is held then need not be taken down before.
inline constexpr bool leaves_at_once = !is_sanitized;

/// Ends the process with this status, its streams written out. Where leaves_at_once neither static objects nor what
/// libraries do at a program's end keep it: a GL driver takes milliseconds to unload its compiler.
[[noreturn]] void leave(int status);

}  // namespace viewing
