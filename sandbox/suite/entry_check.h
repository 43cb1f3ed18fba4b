// One entry of a suite drawn, computed and held against what was accepted. What a person may want to look at is left in
// the report's folder; a reference is written only where there was none.
#pragma once

#include <string>

#include "gl/debug.h"
#include "render/renderer.h"
#include "suite/results.h"

namespace viewing {

struct CheckWish {
    bool allows_outside = false;  ///< states may name scenes anywhere
    bool makes_keys = false;
    std::string known_key;  ///< of the last run that passed: with the same one nothing is drawn again
    std::string program;    ///< what draws: the program and the driver, for the key
};

/// Needs the current context that `renderer` and `log` belong to. What fails is in the result.
EntryResult check_entry(const Suite& suite, const SuiteEntry& entry, const CheckWish& wish, Renderer& renderer,
                        gl::DebugLog& log);

}  // namespace viewing
