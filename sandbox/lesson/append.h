// Builds a custom lesson in the window: the current state becomes the last step of a file.
#pragma once

#include <string>
#include <string_view>

#include "state/params.h"
#include "text/result.h"

namespace viewing {

/// The texts of a saved step that its author has to replace: lesson --check refuses them.
struct TemplateTexts {
    const char *say, *question, *right, *wrong, *why, *reveal;
};
inline constexpr TemplateTexts template_texts{"What the picture shows.",
                                              "What will happen?",
                                              "this",
                                              "that",
                                              "Why that is wrong.",
                                              "What the picture shows now, and why."};

/// Returns the file's content with one more step. The step stores how the state differs from the preset, and has a text
/// and a question for the author to fill in. `existing` is the file's current content, "" for a new file. `preset` is
/// the preset that the state is based on, "" for the opening state. The error is one sentence that begins with
/// `source`.
Result<std::string> with_step(std::string_view existing, const std::string& source, const Params& params,
                              const std::string& preset);

}  // namespace viewing
