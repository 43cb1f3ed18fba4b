#include "state/mesh/obj_lines.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "state/mesh/obj.h"
#include "text/words.h"

namespace viewing {

namespace {

constexpr std::size_t block_bytes = 256U << 10U;
constexpr std::size_t longest_line = 1U << 20U;
constexpr std::size_t longest_number = 64;
constexpr double largest_coordinate = 1e12;

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

/// The digits from the front of a word, which are taken off it.
std::string_view take_digits(std::string_view& word) {
    std::size_t end = 0;
    while (end < word.size() && is_digit(word[end])) ++end;
    const std::string_view digits = word.substr(0, end);
    word.remove_prefix(end);
    return digits;
}

bool take(char c, std::string_view& word) {
    if (word.empty() || word.front() != c) return false;
    word.remove_prefix(1);
    return true;
}

/// Whether a sign, taken off the front of a word, is a minus.
bool take_sign(std::string_view& word) {
    const bool is_negative = take('-', word);
    if (!is_negative) take('+', word);
    return is_negative;
}

/// A decimal number: sign, digits with a point somewhere, exponent. One beyond what a double holds is infinite.
std::optional<double> number_of(std::string_view word) {
    if (word.size() > longest_number) return std::nullopt;
    const bool is_negative = take_sign(word);
    double digits_value = 0.0;
    int power_of_ten = 0;
    const auto add = [&](std::string_view digits) {
        for (const char digit : digits) digits_value = 10.0 * digits_value + (digit - '0');
        return digits.size();
    };
    std::size_t count = add(take_digits(word));
    if (take('.', word)) {
        const std::size_t decimals = add(take_digits(word));
        count += decimals;
        power_of_ten = -static_cast<int>(decimals);
    }
    if (count == 0) return std::nullopt;
    if (take('e', word) || take('E', word)) {
        const bool divides = take_sign(word);
        const std::string_view digits = take_digits(word);
        if (digits.empty()) return std::nullopt;
        constexpr int beyond_all = 9999;
        int exponent = 0;
        for (const char digit : digits) exponent = std::min(10 * exponent + (digit - '0'), beyond_all);
        power_of_ten += divides ? -exponent : exponent;
    }
    if (!word.empty()) return std::nullopt;
    if (is_negative) digits_value = -digits_value;
    if (digits_value == 0.0) return digits_value;
    return power_of_ten < 0 ? digits_value / std::pow(10.0, -power_of_ten)
                            : digits_value * std::pow(10.0, power_of_ten);
}

/// The indices of a corner as the file has them, from 1 or from the end if negative; 0 for what is not told.
struct NamedCorner {
    int position = 0, normal = 0;
};

/// A corner of a face: v, v/vt, v//vn or v/vt/vn, each a whole number of at most nine digits.
std::optional<NamedCorner> corner_of(std::string_view word) {
    constexpr std::size_t most_digits = 9;
    NamedCorner corner;
    for (int part = 0;; ++part) {
        const bool is_negative = take('-', word);
        const std::string_view digits = take_digits(word);
        const bool left_out = part == 1 && digits.empty() && !is_negative;
        if ((digits.empty() && !left_out) || digits.size() > most_digits) return std::nullopt;
        int index = 0;
        for (const char digit : digits) index = 10 * index + (digit - '0');
        if (is_negative) index = -index;
        if (part == 0) corner.position = index;
        if (part == 2) corner.normal = index;
        if (word.empty()) return left_out ? std::nullopt : std::optional(corner);
        if (part == 2 || !take('/', word)) return std::nullopt;
    }
}

/// An index as the file has it, made to count from 0; −1 for one before the first. One that is positive may name what
/// comes later in the file.
int from_zero(int index, std::size_t count) {
    const auto size = static_cast<int>(count);
    return index > 0 ? index - 1 : index < 0 && -index <= size ? size + index : -1;
}

bool is_usable(const glm::vec3& v) {
    const auto fits = [](float x) { return std::abs(static_cast<double>(x)) <= largest_coordinate; };
    return fits(v.x) && fits(v.y) && fits(v.z);
}

class ObjLines {
public:
    ObjLines(std::istream& source, std::uint64_t size_bytes, WorkProgress* progress)
        : source_(source), size_bytes_(size_bytes), progress_(progress) {}

    Result<ObjContent> read() {
        // About what lines take: what is set aside and not written to costs nothing, growing step by step does.
        // Not for more than a file of 128 MiB would fill: what is in a larger one is not known yet.
        const auto likely_bytes = static_cast<std::size_t>(std::min<std::uint64_t>(size_bytes_, 128U << 20U));
        content_.corners.reserve(likely_bytes / 16);
        content_.positions.reserve(likely_bytes / 128);
        content_.normals.reserve(likely_bytes / 128);
        while (!is_at_end_ && trouble_.empty()) take_block();
        if (trouble_.empty()) check_indices();
        if (!trouble_.empty()) return Error{trouble_};
        return std::move(content_);
    }

private:
    void take_block();
    void take_line(std::string_view line);
    void take_numbers(std::string_view rest, std::vector<glm::vec3>& triples);
    void take_face(std::string_view rest);
    void add_corner(const NamedCorner& named);
    void check_indices();
    /// `token`: what of the line is wrong; empty where nothing can be pointed at.
    void refuse(const std::string& what, std::string_view token = {});

    std::istream& source_;
    const std::uint64_t size_bytes_;
    WorkProgress* const progress_;
    std::uint64_t bytes_read_ = 0;
    std::size_t line_number_ = 0;
    std::string unfinished_;  ///< the beginning of a line whose end is in the next block
    ObjContent content_;
    std::string trouble_;  ///< the first that was met
    bool is_at_end_ = false;
};

void ObjLines::take_block() {
    std::string block = std::move(unfinished_);
    unfinished_.clear();
    const std::size_t kept = block.size();
    block.resize(kept + block_bytes);
    source_.read(block.data() + kept, block_bytes);
    const auto count = static_cast<std::size_t>(source_.gcount());
    block.resize(kept + count);
    bytes_read_ += count;
    const double done = size_bytes_ == 0 ? 1.0 : static_cast<double>(bytes_read_) / static_cast<double>(size_bytes_);
    report(progress_, std::min(done, 1.0));
    if (is_cancelled(progress_)) {
        trouble_ = "loading was cancelled";
        return;
    }

    std::string_view rest = block;
    for (std::size_t end = rest.find('\n'); end != std::string_view::npos; end = rest.find('\n')) {
        take_line(rest.substr(0, end));
        if (!trouble_.empty()) return;
        rest.remove_prefix(end + 1);
    }
    if (count == 0) {
        take_line(rest);
        is_at_end_ = true;
    } else if (rest.size() > longest_line) {
        ++line_number_;
        refuse("a line longer than 1 MiB");
    } else {
        unfinished_ = rest;
    }
}

void ObjLines::take_line(std::string_view line) {
    ++line_number_;
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    if (line_number_ == 1 && line.starts_with(byte_order_mark)) line.remove_prefix(byte_order_mark.size());
    while (!line.empty() && (line.back() == '\r' || is_space(line.back()))) line.remove_suffix(1);
    if (std::find(line.begin(), line.end(), '\0') != line.end()) return refuse("binary data");
    std::string_view rest = line;
    const std::string_view keyword = next_word(rest);
    if (keyword == "v") {
        take_numbers(rest, content_.positions);
        if (trouble_.empty() && !is_usable(content_.positions.back()))
            trouble_ = "vertex " + std::to_string(content_.positions.size()) + " has a coordinate beyond 1e12";
    } else if (keyword == "vn") {
        take_numbers(rest, content_.normals);
    } else if (keyword == "f") {
        take_face(rest);
    }
}

/// Three numbers; further ones (a weight, a colour) have to be numbers too.
void ObjLines::take_numbers(std::string_view rest, std::vector<glm::vec3>& triples) {
    glm::vec3 triple(0.0F);
    int count = 0;
    for (std::string_view word = next_word(rest); !word.empty() && word.front() != '#'; word = next_word(rest)) {
        const std::optional<double> number = number_of(word);
        if (!number) return refuse("not a number", word);
        if (count < 3) triple[count] = static_cast<float>(*number);
        ++count;
    }
    if (count < 3) return refuse("not three numbers");
    triples.push_back(triple);
}

void ObjLines::take_face(std::string_view rest) {
    const std::size_t begin = content_.corners.size();
    ++content_.face_count;
    for (std::string_view word = next_word(rest); !word.empty() && word.front() != '#'; word = next_word(rest)) {
        const std::optional<NamedCorner> corner = corner_of(word);
        if (!corner) return refuse("not a corner of a face", word);
        add_corner(*corner);
    }
    const std::size_t count = content_.corners.size() - begin;
    if (count < 3) return refuse("a face with fewer than three corners");
    if (content_.faces.empty() || content_.faces.back().corners_each != count)
        content_.faces.push_back({static_cast<std::uint32_t>(count), 0});
    ++content_.faces.back().count;
    content_.triangle_count += count - 2;
    if (content_.triangle_count > max_obj_triangles) trouble_ = "more than 50 million triangles";
}

void ObjLines::add_corner(const NamedCorner& named) {
    const int position = from_zero(named.position, content_.positions.size());
    const bool has_normal = named.normal != 0;
    const int normal = has_normal ? from_zero(named.normal, content_.normals.size()) : ObjCorner::no_normal;
    content_.corners.push_back({position, normal});
    if (!trouble_.empty() || (position >= 0 && (!has_normal || normal >= 0))) return;
    trouble_ = "face " + std::to_string(content_.face_count) + " names " +
               (position < 0 ? "vertex " + std::to_string(named.position) : "normal " + std::to_string(named.normal)) +
               ", which there is not";
}

/// Positive indices may name what comes later in the file, so they are checked at the end.
void ObjLines::check_indices() {
    const auto refuse_corner = [this](std::size_t face, const char* what, int index, std::size_t count) {
        trouble_ = "face " + std::to_string(face) + " names " + what + " " + std::to_string(index + 1) +
                   ", but there are " + std::to_string(count);
    };
    std::size_t corner = 0, face = 0;
    for (const auto& [corners_each, count] : content_.faces) {
        for (std::uint64_t i = 0; i < std::uint64_t{corners_each} * count; ++i, ++corner) {
            if (i % corners_each == 0) ++face;
            const auto [position, normal] = content_.corners[corner];
            if (position >= static_cast<int>(content_.positions.size()))
                return refuse_corner(face, "vertex", position, content_.positions.size());
            if (normal >= static_cast<int>(content_.normals.size()))
                return refuse_corner(face, "normal", normal, content_.normals.size());
        }
    }
}

/// What is wrong with a line as such comes before what it names.
void ObjLines::refuse(const std::string& what, std::string_view token) {
    trouble_ = "line " + std::to_string(line_number_) + ": " + what + (token.empty() ? "" : ": " + excerpt(token));
}

}  // namespace

Result<ObjContent> read_obj_lines(std::istream& stream, std::uint64_t size_bytes, WorkProgress* progress) {
    return ObjLines(stream, size_bytes, progress).read();
}

}  // namespace viewing
