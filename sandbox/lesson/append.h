// Builds a custom lesson in the window: the current state becomes the last step of a file.
#pragma once

#include <string>
#include <string_view>

#include "state/params.h"
#include "text/result.h"

namespace viewing {

/// Returns the file with one more step, which has the state as differences from the preset, and a text and a question
/// for the author to fill in. `existing` is the content of the current file, "" for a new one. `preset` is the preset
/// that the state is based on, "" for the opening state. The error is one sentence that begins with `source`.
Result<std::string> with_step(std::string_view existing, const std::string& source, const Params& params,
                              const std::string& preset);

}  // namespace viewing
