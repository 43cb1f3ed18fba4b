// The process that draws a suite's entries: told which, line by line, it answers with results, line by line. A crash
// takes down nothing but itself. Read run.h for who tells it.
#pragma once

#include <cstdio>
#include <istream>

#include "suite/entry_check.h"

namespace viewing {

/// First {"renderer": …}; then to each {"entry": 12, "key": "…"} the entry's result, until the input ends. Of `wish`
/// the known key is that of the line.
void serve_entries(const Suite& suite, CheckWish wish, Renderer& renderer, gl::DebugLog& log, std::istream& input,
                   std::FILE* output);

}  // namespace viewing
