// Internal to lesson/: reads a lecture (a list of lessons, single steps and presets, with their minutes) as one lesson
// whose steps are those of all its parts.
#pragma once

#include <filesystem>

#include "lesson/tree.h"

namespace viewing {

/// Whether the document is a lecture; otherwise it must be a lesson.
bool is_lecture(const Json& document);

/// Reads as much of a lecture as can be read. The lecture is complete if `where` has collected no mistakes.
Lesson read_lecture(const Json& document, const std::filesystem::path& folder, const Where& where);

}  // namespace viewing
