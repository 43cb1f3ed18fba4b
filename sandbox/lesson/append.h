// Builds a custom lesson in the window: the current state becomes the last step of a file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "state/file/document.h"
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
/// the preset that the state is based on, "" for the opening state; `highlight` lists the parts framed on the
/// screen. The error is one sentence that begins with `source`.
Result<std::string> with_step(std::string_view existing, const std::string& source, const Params& params,
                              const std::string& preset, const std::vector<std::string>& highlight = {});

/// Parses a lesson's file as a document with a list of steps. Throws a Refusal that begins with `source`.
Json lesson_document(std::string_view text, const std::string& source);

/// Returns a step's "state": its preset, and how the state differs from it. Throws a Refusal that begins with `source`.
Json state_of_step(const Params& params, const std::string& preset, const std::string& source);

}  // namespace viewing
