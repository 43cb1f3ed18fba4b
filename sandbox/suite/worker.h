// The process that draws a suite's entries: it reads requests line by line and answers with results line by line. A
// crash ends only this process. See suite_run.h for the process that sends the requests.
#pragma once

#include <cstdio>
#include <istream>

#include "suite/entry_check.h"

namespace viewing {

/// Writes {"renderer": …}, then answers each request {"entry": 12, "key": "…"} with the entry's result, until the input
/// ends. The key in a request replaces the known key in `wish`.
void serve_entries(const Suite& suite, CheckWish wish, Renderer& renderer, gl::DebugLog& log, std::istream& input,
                   std::FILE* output);

}  // namespace viewing
