// Internal to state/: the words of an OBJ file's lines, each read by itself. Read obj_lines.h for the lines.
#pragma once

#include <optional>
#include <string_view>

namespace viewing {

inline bool is_space(char c) {
    return c == ' ' || c == '\t';
}

/// A line up to its comment; the # of a number that is none (1.#QNAN) begins no comment.
std::string_view without_comment(std::string_view line);

/// The next word of a line, which is taken off its front; empty at the end.
std::string_view next_word(std::string_view& line);

/// The digits from the front of a word, which are taken off it.
std::string_view take_digits(std::string_view& word);

/// A decimal number: sign, digits with a point somewhere, exponent. One beyond what a double holds is infinite.
std::optional<double> number_of(std::string_view word);

/// Whether a word is what programs write for a number that is none: nan, -nan(ind), inf, 1.#QNAN.
bool is_no_finite_number(std::string_view word);

/// The indices of a corner as the file has them, from 1 or from the end if negative; 0 for what is not said.
struct NamedCorner {
    int position = 0, normal = 0;
};

/// A corner of a face: v, v/vt, v//vn or v/vt/vn, each a whole number; what stands behind a / may be left out. v and vn
/// have at most nine digits; vt is not used.
std::optional<NamedCorner> corner_of(std::string_view word);

/// What a line is about. names: a text follows, numbers: numbers follow; both are left out without a word.
enum class Statement { position, face, normal, smoothing, line, point, surface, numbers, names };

/// By the first word of a line; none for one that Wavefront's format has not.
std::optional<Statement> statement_of(std::string_view keyword);

/// The encoding of a text that is not UTF-8, by its byte order mark or by the zero bytes of its first letters; null for
/// any other text.
const char* foreign_encoding(std::string_view beginning);

}  // namespace viewing
