// Tunes memory allocation for processes that run for a tenth of a second and touch a hundred megabytes.
#pragma once

#include <chrono>

namespace viewing {

/// Reserves 32 MB for the heap in one step, without touching the memory. Later blocks of up to that size come from this
/// reserve. Call before the first allocation. If it fails, the heap grows in small steps as usual.
void reserve_heap();

/// From now on, gets blocks of 1 MB and more from the system and returns them when they are freed. Meant for a process
/// that draws thousands of pictures: such blocks would otherwise fragment its heap until the next one no longer fits.
void give_large_blocks_back();

/// Turns the untouched part of the reserve into 2 MB pages, one after another, until a page takes longer than `longest`
/// or the system refuses one. Making a picture then takes a tenth less time from start to finish.
/// Processors clear a page in 40 to 300 µs. A virtual machine whose host must first find the memory takes 5 ms, which
/// is more than a page saves, so on such a machine the first page is also the last one. Call before the first driver is
/// loaded; later calls do nothing.
void take_large_pages(std::chrono::microseconds longest = std::chrono::microseconds(700));

}  // namespace viewing
