#include "state/obj_lines.h"

#include <algorithm>

#include "text/words.h"

namespace viewing {

namespace {

constexpr std::size_t block_bytes = 256U << 10U;
constexpr std::size_t longest_line = 1U << 20U;
constexpr std::size_t longest_number = 64;

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}
bool is_space(char c) {
    return c == ' ' || c == '\t';
}

/// The next word of a line, which is taken off its front; empty at the end.
std::string_view next_word(std::string_view& line) {
    std::size_t begin = 0;
    while (begin < line.size() && is_space(line[begin])) {
        ++begin;
    }
    std::size_t end = begin;
    while (end < line.size() && !is_space(line[end])) {
        ++end;
    }
    const std::string_view word = line.substr(begin, end - begin);
    line.remove_prefix(end);
    return word;
}

std::size_t skip_digits(std::string_view word, std::size_t at) {
    while (at < word.size() && is_digit(word[at])) {
        ++at;
    }
    return at;
}

std::size_t skip_sign(std::string_view word, std::size_t at) {
    return at < word.size() && (word[at] == '-' || word[at] == '+') ? at + 1 : at;
}

/// A decimal number: sign, digits with a point somewhere, exponent.
bool is_number(std::string_view word) {
    std::size_t at = skip_sign(word, 0);
    const std::size_t whole = at;
    at = skip_digits(word, at);
    std::size_t digits = at - whole;
    if (at < word.size() && word[at] == '.') {
        const std::size_t fraction = at + 1;
        at = skip_digits(word, fraction);
        digits += at - fraction;
    }
    if (digits > 0 && at < word.size() && (word[at] == 'e' || word[at] == 'E')) {
        const std::size_t exponent = skip_sign(word, at + 1);
        at = skip_digits(word, exponent);
        digits = at - exponent;
    }
    return digits > 0 && at == word.size() && word.size() <= longest_number;
}

/// A corner of a face: v, v/vt, v//vn or v/vt/vn, each a whole number of at most nine digits.
bool is_corner(std::string_view word) {
    constexpr std::size_t most_digits = 9;
    for (int part = 0;; ++part) {
        const std::size_t begin = !word.empty() && word.front() == '-' ? 1 : 0;
        const std::size_t end = skip_digits(word, begin);
        const bool left_out = part == 1 && end == 0;
        if ((end == begin && !left_out) || end - begin > most_digits) {
            return false;
        }
        word.remove_prefix(end);
        if (word.empty()) {
            return !left_out;
        }
        if (word.front() != '/' || part == 2) {
            return false;
        }
        word.remove_prefix(1);
    }
}

}  // namespace

ObjLines::int_type ObjLines::underflow() {
    passed_on_.clear();
    while (passed_on_.empty() && !stopped_) {
        take_block();
    }
    if (stopped_ && !trouble_.empty()) {
        passed_on_.clear();
    }
    setg(passed_on_.data(), passed_on_.data(), passed_on_.data() + passed_on_.size());
    return passed_on_.empty() ? traits_type::eof() : traits_type::to_int_type(passed_on_.front());
}

void ObjLines::take_block() {
    std::string block = std::move(unfinished_);
    unfinished_.clear();
    const std::size_t kept = block.size();
    block.resize(kept + block_bytes);
    source_.read(block.data() + kept, block_bytes);
    const auto count = static_cast<std::size_t>(source_.gcount());
    block.resize(kept + count);
    bytes_read_ += count;
    progress_.show(size_bytes_ == 0 ? 1.0 : static_cast<double>(bytes_read_) / static_cast<double>(size_bytes_));
    if (progress_.cancelled()) {
        stopped_ = true;
        return;
    }

    std::string_view rest = block;
    for (std::size_t end = rest.find('\n'); end != std::string_view::npos && !stopped_; end = rest.find('\n')) {
        take_line(rest.substr(0, end));
        rest.remove_prefix(end + 1);
    }
    if (stopped_) {
        return;
    }
    if (count == 0) {
        take_line(rest);
        stopped_ = true;
    } else if (rest.size() > longest_line) {
        ++line_number_;
        refuse(rest, "a line longer than 1 MiB");
    } else {
        unfinished_ = rest;
    }
}

void ObjLines::take_line(std::string_view line) {
    ++line_number_;
    while (!line.empty() && (line.back() == '\r' || is_space(line.back()))) {
        line.remove_suffix(1);
    }
    if (std::find(line.begin(), line.end(), '\0') != line.end()) {
        refuse(line, "binary data");
        return;
    }
    std::string_view rest = line;
    const std::string_view keyword = next_word(rest);
    const bool is_face = keyword == "f";
    if (!is_face && keyword != "v" && keyword != "vn") {
        return;
    }
    std::size_t words = 0;
    for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest)) {
        if (word.front() == '#') {
            line = line.substr(0, static_cast<std::size_t>(word.data() - line.data()));
            break;
        }
        if (!(is_face ? is_corner(word) : is_number(word))) {
            refuse(line, is_face ? "not a face" : "not three numbers");
            return;
        }
        ++words;
    }
    if (words < 3) {
        refuse(line, is_face ? "a face with fewer than three corners" : "not three numbers");
        return;
    }
    passed_on_.append(line).append("\n");
}

void ObjLines::refuse(std::string_view line, const std::string& what) {
    constexpr std::size_t longest_shown = 60;
    std::string shown(line.substr(0, longest_shown));
    std::replace_if(
        shown.begin(), shown.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    trouble_ = "line " + std::to_string(line_number_) + ": " + what + ": " + shown;
    stopped_ = true;
}

}  // namespace viewing
