// How the program's memory is laid out: for processes that live a tenth of a second and touch a hundred megabytes.
#pragma once

#include <chrono>

namespace viewing {

/// The heap gets 32 MB at once, of which none is touched yet, and blocks up to that size come from there. Call before
/// memory is asked for; where it cannot be, nothing changes.
void reserve_heap();

/// From now on blocks of 1 MB and more are the system's and go back to it when they are freed. For a process that makes
/// pictures by the thousand, whose heap they would leave in pieces too small for the next one.
void give_large_blocks_back();

/// What is still untouched of the reserve becomes pages of 2 MB where the system has them on request, one after the
/// other as long as none takes longer than `longest`: then a picture's start to its end takes a tenth less. Processors
/// clear one in 40 to 300 µs; a virtual machine whose host must find the memory first takes 5 ms for each, more than it
/// saves, so there the first one is the last. Before the first driver is loaded; later calls do nothing.
void take_large_pages(std::chrono::microseconds longest = std::chrono::microseconds(700));

}  // namespace viewing
