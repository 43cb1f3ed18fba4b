// Builds parts of messages, and handles the characters of UTF-8.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace viewing {

/// Whether a byte belongs to the same character as the byte before it.
constexpr bool continues_character(char byte) {
    return (byte & 0xC0) == 0x80;
}

constexpr bool is_digit(char byte) {
    return byte >= '0' && byte <= '9';
}

/// Counts characters, not bytes.
std::size_t character_count(std::string_view text);

/// Does nothing to an empty text.
void remove_last_character(std::string& text);

/// Returns a text that is safe to show in a terminal and a window: invalid bytes become escapes such as \xff. Control
/// characters, and characters that disguise a text by changing its writing direction, become escapes such as \u202e.
std::string printable(std::string_view text);

/// Prepares user input for a message: makes it printable, and cuts it between two characters after at most 200 bytes.
std::string one_line(std::string_view text);

/// Shortens a message of more than `most_bytes`, such as one with a very long name, but keeps its beginning and its
/// end, which gives the reason.
std::string without_middle(std::string_view text, std::size_t most_bytes);

bool is_utf8(std::string_view text);

/// Prepares a word from a file for a message: makes it printable, and cuts it after at most 20 characters.
std::string excerpt(std::string_view text);

/// Breaks a text between words into lines of at most `width` characters where possible, each ending with a newline. The
/// first line begins with `first`, the others with `indent` spaces. Words are separated by single spaces.
std::string in_lines(const std::string& text, std::size_t width, const std::string& first, std::size_t indent);

/// Returns the start of a text that should stay on one line: a word, or a formula with spaces around its operators.
std::string_view unbroken_start(std::string_view text);

/// Converts ASCII letters to lower case and keeps everything else. Used for file extensions and searches.
std::string in_lower_case(std::string text);

/// Returns a byte as links and safe file names write it: "%2F".
std::string percent_encoded(char byte);

/// Splits at each `sign` outside brackets and quotes; returns at least one part.
std::vector<std::string> split_outside_brackets(std::string_view text, char sign);

/// Returns, for example, "1 entry" or "1,024 entries"; omit `many` if it is `one` with an s. Used for the English
/// output of commands.
std::string counted(std::int64_t count, const std::string& one, const std::string& many = "");

/// Returns a list such as "never, less, equal".
std::string joined(std::span<const char* const> names);
std::string joined(std::span<const std::string> names);
/// Returns a list such as "13, 15".
std::string joined(std::span<const int> numbers);

/// Returns the smallest number of insertions, deletions, substitutions and swaps of neighbors that turns one word into
/// the other (Damerau–Levenshtein, optimal string alignment). Words are cut at 64 bytes.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// Returns the candidate nearest to a misspelled word, the first on a tie; none if no candidate is near enough.
std::optional<std::string> nearest_name(std::string_view word, std::span<const std::string> candidates);

/// Returns "; did you mean less?" for a misspelled word, "" if nothing is near.
std::string suggestion(std::string_view word, std::span<const std::string> candidates);

/// Whether `distance` edits still look like a typo in a word of this length; never for a single letter.
bool is_near(std::size_t distance, std::size_t word_length);

}  // namespace viewing
