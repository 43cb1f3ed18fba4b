// The note in a figure: the state shown, as JSON. PNG stores it in a text chunk, SVG as metadata, and PDF as a keyword;
// a long note uses several chunks or elements (note_parts.h).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "text/result.h"

namespace viewing {

/// Returns the note as elements of an SVG document; "" if the note is empty or no figure can store it.
std::string note_as_svg(std::string_view note);
/// Returns the note as a keyword of a PDF document: a fixed name, followed only by letters and digits; "" in the same
/// cases as note_as_svg().
std::string note_as_keyword(std::string_view note);

/// Whether a file name has the extension of a figure: .png, .svg or .pdf.
bool is_figure_name(const std::filesystem::path& path);

/// Returns the note in a figure; empty if it has none. The error for an unreadable file or a damaged PNG is one
/// sentence that begins with the path.
Result<std::string> read_figure_note(const std::filesystem::path& path);

}  // namespace viewing
