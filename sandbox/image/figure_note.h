// The note that a figure carries: the state that it shows, as JSON. In a PNG file it is a text chunk, in SVG metadata,
// in PDF a keyword; where it is long, several chunks or elements (note_parts.h).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "text/result.h"

namespace viewing {

/// Elements of an SVG document; "" for no note, or one that no figure can carry.
std::string note_as_svg(std::string_view note);
/// A keyword of a PDF document, letters and digits alone behind its name; "" as above.
std::string note_as_keyword(std::string_view note);

/// Whether a file's name ends as a figure's does: .png, .svg, .pdf.
bool is_figure_name(const std::filesystem::path& path);

/// The note of a figure; empty where it has none. An error is one sentence that begins with the path: a file that
/// cannot be read, or a PNG that is broken.
Result<std::string> read_figure_note(const std::filesystem::path& path);

}  // namespace viewing
