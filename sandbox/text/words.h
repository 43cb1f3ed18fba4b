// The small pieces that messages are made of, and the characters of UTF-8.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace viewing {

/// Whether a byte belongs to the character that the byte before it belongs to.
constexpr bool continues_character(char byte) {
    return (byte & 0xC0) == 0x80;
}

constexpr bool is_digit(char byte) {
    return byte >= '0' && byte <= '9';
}

/// Characters, not bytes.
std::size_t character_count(std::string_view text);

/// Nothing in an empty text.
void remove_last_character(std::string& text);

/// A text as a terminal and a window may show it: what is no character of UTF-8 as \xff, control characters and those
/// that turn the direction of writing, which make a text look like another, as \u202e.
std::string printable(std::string_view text);

/// A text of the person's own, fit for a message: printable, and cut between two characters beyond 200 bytes.
std::string one_line(std::string_view text);

/// A message with a name of thousands of bytes: beyond `most_bytes` its beginning and its end, where the reason is.
std::string without_middle(std::string_view text, std::size_t most_bytes);

bool is_utf8(std::string_view text);

/// A word of a file, fit for a message: printable, and not more than 20 characters of it.
std::string excerpt(std::string_view text);

/// A text in lines of at most `width` characters where its words let it, each ended: the first begins with `first`, the
/// others with `indent` blanks. Words are separated by single blanks.
std::string in_lines(const std::string& text, std::size_t width, const std::string& first, std::size_t indent);

/// ASCII letters in lower case, all else as it is: for endings of files and for what is searched.
std::string in_lower_case(std::string text);

/// A byte as links and safe file names have it: "%2F".
std::string percent_encoded(char byte);

/// At each `sign` that stands in no brackets and no quotes; one part at least.
std::vector<std::string> split_outside_brackets(std::string_view text, char sign);

/// "1 entry", "1,024 entries"; `many` is left out where it is `one` with an s. For what commands print, in English.
std::string counted(std::int64_t count, const std::string& one, const std::string& many = "");

/// "never, less, equal".
std::string joined(std::span<const char* const> names);
std::string joined(std::span<const std::string> names);
/// "13, 15".
std::string joined(std::span<const int> numbers);

/// How many insertions, deletions, substitutions and swaps of neighbours turn one word into the other
/// (Damerau–Levenshtein, optimal string alignment). Words are cut at 64 characters.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The candidate nearest to a misspelt word, the first on a tie; none when nothing is near enough to be meant.
std::optional<std::string> nearest_name(std::string_view word, std::span<const std::string> candidates);

/// `; did you mean "less"?` for a misspelt word, "" when nothing is near.
std::string suggestion(std::string_view word, std::span<const std::string> candidates);

/// Whether so many edits still look like a slip of the pen in a word of this length: never in a single letter.
bool is_near(std::size_t distance, std::size_t word_length);

}  // namespace viewing
