// What a page's one thread costs where the browser cannot suspend WebAssembly: work is done in one go.
#pragma once

namespace viewing {

/// How many milliseconds the longest work that has ended since this was asked last held the page; 0 where works stand
/// still for the page's turns, and where none has ended.
double take_standstill_ms();

}  // namespace viewing
