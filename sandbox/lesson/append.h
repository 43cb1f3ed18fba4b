// A lesson of one's own, made in the window: the present state becomes the last step of a file.
#pragma once

#include <string>
#include <string_view>

#include "state/params.h"
#include "text/result.h"

namespace viewing {

/// The file with one more step: the state told by what differs from the preset, texts and question to be filled in.
/// `existing`: the file as it is, "" for a new one. `preset`: by which the state is told, "" for the opening one. The
/// error is one sentence that begins with `source`.
Result<std::string> with_step(std::string_view existing, const std::string& source, const Params& params,
                              const std::string& preset);

}  // namespace viewing
