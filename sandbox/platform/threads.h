// Whether there can be threads at all: a graphics driver that gets none may wait for them for ever.
#pragma once

namespace viewing {

/// Tries it: so many at once, all gone again afterwards.
bool can_start_threads(int count);

/// As many as a graphics driver may start: one for each core and some beside.
int threads_of_a_driver();

}  // namespace viewing
