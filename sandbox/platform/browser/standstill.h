// Reports freezes of a page's only thread: if the browser cannot suspend WebAssembly, work runs without a pause.
#pragma once

namespace viewing {

/// Returns how many milliseconds the longest work that ended since the last call blocked the page; 0 if none ended, or
/// if work can be suspended.
double take_standstill_ms();

}  // namespace viewing
