// Checks whether threads can be started at all: without this check, a graphics driver that cannot start its threads may
// wait for them forever.
#pragma once

namespace viewing {

/// Starts `count` threads, lets them all exist at the same time, and ends them. Returns whether that worked.
bool can_start_threads(int count);

/// Returns the number of threads that a graphics driver may start: one for each core (at most 16), and a few more.
int threads_of_a_driver();

}  // namespace viewing
