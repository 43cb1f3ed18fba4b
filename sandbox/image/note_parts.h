// Splits a note into parts, which a file stores under separate names, because Pillow refuses a PNG file with a text of
// more than 1 MiB, and libxml2 refuses an SVG document with one of more than 10 million bytes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace viewing {

/// Whether a figure can store the note: one longer than max_document_bytes could not be read back.
bool can_carry(std::string_view note);

/// Splits a UTF-8 note between characters into parts of at most a million bytes. Returns no parts for "" or for a note
/// that no figure can store.
std::vector<std::string_view> note_parts(std::string_view note);

/// Returns the name of a part, counted from 1: "name", "name 2", "name 3" if `between` is a space.
std::string note_part_name(std::string_view name, std::string_view between, int number);

}  // namespace viewing
