// Internal to state/: parses single words of an OBJ file's lines. Read obj_lines.h for the lines.
#pragma once

#include <optional>
#include <string_view>

namespace viewing {

inline bool is_space(char c) {
    return c == ' ' || c == '\t';
}

/// Returns a line up to its comment. The # of a special number (1.#QNAN) does not start a comment.
std::string_view without_comment(std::string_view line);

/// Removes and returns the next word of a line; empty at the end.
std::string_view next_word(std::string_view& line);

/// Removes and returns the digits at the front of a word.
std::string_view take_digits(std::string_view& word);

/// Parses a decimal number: an optional sign, digits with an optional point anywhere, and an optional exponent. A
/// number beyond a double's range becomes infinite.
std::optional<double> number_of(std::string_view word);

/// Returns whether a word is a known spelling of a number that is not finite: nan, -nan(ind), inf, 1.#QNAN.
bool is_no_finite_number(std::string_view word);

/// The indices of a corner as in the file: counted from 1, or negative if counted from the end; 0 if omitted.
struct NamedCorner {
    int position = 0, normal = 0;
};

/// Parses a corner of a face: v, v/vt, v//vn or v/vt/vn, each a whole number; the part after a / may be missing. v and
/// vn have at most nine digits; vt is ignored.
std::optional<NamedCorner> corner_of(std::string_view word);

/// The kind of a line. The lines of two kinds are skipped without a note: `names`, where text follows the keyword, and
/// `numbers`, where numbers follow it.
enum class Statement { position, face, normal, smoothing, line, point, surface, numbers, names };

/// Classifies a line by its first word; none if the word is not a keyword of Wavefront's format.
std::optional<Statement> statement_of(std::string_view keyword);

/// Returns the encoding of a text that is not UTF-8, recognized by its byte order mark or by zero bytes among its first
/// bytes; null for any other text.
const char* foreign_encoding(std::string_view beginning);

}  // namespace viewing
