// Reports freezes of a page's only thread: if the browser cannot suspend WebAssembly, work runs without a pause.
#pragma once

namespace viewing {

/// Returns the time, in milliseconds, for which the page was blocked by the longest work that has ended since the last
/// call; 0 if none has ended, or if work can be suspended.
double take_standstill_ms();

}  // namespace viewing
