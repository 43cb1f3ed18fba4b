// How the program's memory is laid out: for processes that live a tenth of a second and touch a hundred megabytes.
#pragma once

namespace viewing {

/// The first 32 MB of the heap are to be pages of 2 MB where the system has them on request, and blocks up to 32 MB
/// come from there: a picture's start to its end takes a tenth less. Costs 4 MB at most. Call before memory is asked
/// for; where it cannot be, nothing changes.
void prefer_large_pages();

}  // namespace viewing
