// How the program ends: at once, as what it holds is taken back by the system anyway.
#pragma once

namespace viewing {

/// Whether leave() ends the process as it stands: what is held then need not be taken down before. Not where a
/// sanitizer looks at a program's end for what it has left.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool leaves_at_once = false;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
inline constexpr bool leaves_at_once = false;
#else
inline constexpr bool leaves_at_once = true;
#endif
#else
inline constexpr bool leaves_at_once = true;
#endif

/// Ends the process with this status, its streams written out. Where leaves_at_once neither static objects nor what
/// libraries do at a program's end keep it: a GL driver takes milliseconds to unload its compiler.
[[noreturn]] void leave(int status);

}  // namespace viewing
