// A note in parts, of which each file keeps every one under a name of its own: Pillow refuses a PNG file with a text of
// more than 1 MiB, and libxml2 an SVG document with one of more than 10 million bytes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace viewing {

/// Whether a figure can carry the note: one that is longer than max_document_bytes could not be read again.
bool can_carry(std::string_view note);

/// UTF-8 cut between characters into parts of at most a million bytes, which joined are the note; none for "" and for
/// what no figure can carry.
std::vector<std::string_view> note_parts(std::string_view note);

/// The name of a part, counted from 1: "name", "name 2", "name 3" with a blank between.
std::string note_part_name(std::string_view name, std::string_view between, int number);

}  // namespace viewing
