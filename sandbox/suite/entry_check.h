// Draws and measures one entry of a suite and compares it with its reference. Writes the files for the report into the
// report's folder; writes a reference only if there was none.
#pragma once

#include <string>

#include "gl/debug.h"
#include "render/renderer.h"
#include "suite/results.h"

namespace viewing {

struct CheckWish {
    bool allows_outside = false;  ///< states may use scene files in any folder
    bool makes_keys = false;
    std::string known_key;  ///< the key of the last run that passed; if the new key is equal, drawing is skipped
    std::string program;    ///< identifies the program and the driver, for the key
};

/// Checks an entry, and reports failures in the result. The context to which `renderer` and `log` belong must be
/// current.
EntryResult check_entry(const Suite& suite, const SuiteEntry& entry, const CheckWish& wish, Renderer& renderer,
                        gl::DebugLog& log);

}  // namespace viewing
