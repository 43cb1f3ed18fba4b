#include "state/mesh/obj_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/normals.h"
#include "state/mesh/obj.h"
#include "state/mesh/obj_words.h"
#include "text/words.h"

namespace viewing {

namespace {

constexpr std::size_t block_bytes = 256U << 10U;
constexpr std::size_t longest_line = 1U << 20U;
constexpr double largest_coordinate = 1e12;
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// Converts an index in the file to one that counts from 0; −1 if it points before the first element. A positive index
/// may name an element later in the file.
int from_zero(int index, std::size_t count) {
    const auto size = static_cast<int>(count);
    return index > 0 ? index - 1 : index < 0 && -index <= size ? size + index : -1;
}

class ObjLines {
public:
    ObjLines(std::istream& source, std::uint64_t size_bytes, WorkProgress* progress)
        : source_(source), size_bytes_(size_bytes), progress_(progress) {}

    Result<ObjContent> read() {
        // Reserve about as much memory as the lines need: memory that is reserved but untouched costs nothing, whereas
        // growing repeatedly is expensive. Reserve no more than a file of 128 MiB would fill, since a larger file may
        // turn out to contain something else.
        const auto likely_bytes = static_cast<std::size_t>(std::min<std::uint64_t>(size_bytes_, 128U << 20U));
        content_.corners.reserve(likely_bytes / 16);
        content_.positions.reserve(likely_bytes / 128);
        content_.normals.reserve(likely_bytes / 128);
        while (!is_at_end_ && trouble_.empty()) take_block();
        if (trouble_.empty() && content_.faces.empty()) trouble_ = without_faces();
        if (trouble_.empty()) check_corners();
        if (!trouble_.empty()) return Error{trouble_};
        note_what_is_left_out();
        return std::move(content_);
    }

private:
    void take_block();
    void take_lines(std::string_view block, bool is_last);
    void take_line(std::string_view line);
    void take_statement(std::string_view line);
    void take_position(std::string_view rest);
    void take_normal(std::string_view rest);
    void take_face(std::string_view rest);
    void take_smoothing(std::string_view rest, std::string_view line);
    void add_corner(const NamedCorner& named);
    void check_corners();
    bool is_usable(int position, std::uint64_t face);
    std::string without_faces() const;
    void note_what_is_left_out();
    /// `token` is the invalid part of the line; empty if there is none to point at.
    void refuse(const std::string& what, std::string_view token = {});

    /// A recurring finding: its count, and the sentence for its first occurrence.
    struct Met {
        std::uint64_t count = 0;
        std::string first;
    };
    void meet(Met& met, std::uint64_t line, const std::string& what) {
        if (met.count++ == 0) met.first = at_line(line) + what;
    }
    void meet_strange(std::string_view line) {
        const bool hides = line.find("\xc2\xa0") != std::string_view::npos;
        meet(strange_, statement_line_, "not understood: " + excerpt(line) + (hides ? " (with a no-break space)" : ""));
    }
    static std::string at_line(std::uint64_t line) { return "line " + std::to_string(line) + ": "; }

    std::istream& source_;
    const std::uint64_t size_bytes_;
    WorkProgress* const progress_;
    std::uint64_t bytes_read_ = 0;
    std::uint64_t line_number_ = 0;
    std::uint64_t statement_line_ = 0;  ///< where the current statement begins
    std::string unfinished_;            ///< the beginning of a line that ends in the next block
    std::string statement_;             ///< the beginning of a statement that continues on the next line
    bool is_plain_ = false;             ///< the current block has neither a comment nor a zero byte
    bool ends_with_cr_ = false;         ///< the last block ended with CR; an LF that begins the next one belongs to it
    int smoothing_ = ObjFaces::no_statement;
    ObjContent content_;
    Met strange_, replaced_;  ///< lines not understood, and corners with an unusable normal
    std::string trouble_;     ///< the first error
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
    const char* const encoding = bytes_read_ == 0 ? foreign_encoding(block) : nullptr;
    bytes_read_ += count;
    const double done = size_bytes_ == 0 ? 1.0 : static_cast<double>(bytes_read_) / static_cast<double>(size_bytes_);
    report(progress_, std::min(done, 1.0));
    if (is_canceled(progress_)) {
        trouble_ = "loading was canceled";
    } else if (encoding != nullptr) {
        trouble_ = at_line(1) + encoding + " text: save it as UTF-8";
    } else {
        take_lines(block, count == 0);
    }
}

void ObjLines::take_lines(std::string_view block, bool is_last) {
    // Most blocks have no CR, comment or zero byte, so one search of the whole block is faster than one per line.
    const bool has_cr = block.find('\r') != std::string_view::npos;
    is_plain_ = block.find('#') == std::string_view::npos && block.find('\0') == std::string_view::npos;
    const auto end_of_line = [has_cr](std::string_view text) {
        const std::size_t end = has_cr ? text.find_first_of("\r\n") : text.find('\n');
        return std::min(end, text.size());
    };
    if (std::exchange(ends_with_cr_, false) && block.starts_with('\n')) block.remove_prefix(1);
    for (std::size_t end = end_of_line(block); end < block.size(); end = end_of_line(block)) {
        take_line(block.substr(0, end));
        if (!trouble_.empty()) return;
        const bool is_cr = block[end] == '\r';
        block.remove_prefix(end + 1);
        if (!is_cr) continue;
        ends_with_cr_ = block.empty();
        if (block.starts_with('\n')) block.remove_prefix(1);
    }
    if (is_last) {
        take_line(block);
        if (trouble_.empty()) take_statement(statement_);
        is_at_end_ = true;
    } else if (block.size() > longest_line) {
        statement_line_ = line_number_ + 1;
        refuse("a line longer than 1 MiB");
    } else {
        unfinished_ = block;
    }
}

/// Removes the comment and joins continued lines.
void ObjLines::take_line(std::string_view line) {
    ++line_number_;
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    if (line_number_ == 1 && line.starts_with(byte_order_mark)) line.remove_prefix(byte_order_mark.size());
    if (statement_.empty()) statement_line_ = line_number_;
    if (!is_plain_) {
        if (line.find('\0') != std::string_view::npos) return refuse("binary data");
        line = without_comment(line);
    }
    while (!line.empty() && is_space(line.back())) line.remove_suffix(1);
    std::string_view rest = statement_.empty() ? line : statement_;
    if (line.ends_with('\\')) {
        // A line of names may end with the \ of a \# whose # was removed as a comment; such a line does not continue.
        if (statement_of(next_word(rest)) != Statement::names) {
            statement_.append(line.substr(0, line.size() - 1)).push_back(' ');
            if (statement_.size() > longest_line) refuse("a line longer than 1 MiB");
            return;
        }
    }
    if (statement_.empty()) return take_statement(line);
    statement_ += line;
    take_statement(std::exchange(statement_, {}));
}

void ObjLines::take_statement(std::string_view line) {
    std::string_view rest = line;
    const std::string_view word = next_word(rest);
    if (word.empty()) return;
    const std::optional<Statement> statement = statement_of(word);
    if (!statement) return meet_strange(line);
    switch (*statement) {
        case Statement::position:
            return take_position(rest);
        case Statement::face:
            return take_face(rest);
        case Statement::normal:
            return take_normal(rest);
        case Statement::smoothing:
            return take_smoothing(rest, line);
        case Statement::line:
            ++content_.line_count;
            return;
        case Statement::point:
            ++content_.point_count;
            return;
        case Statement::surface:
            ++content_.surface_count;
            return;
        case Statement::numbers:
        case Statement::names:
            return;
    }
}

/// Reads three numbers and ignores the rest (a weight, a color).
void ObjLines::take_position(std::string_view rest) {
    glm::dvec3 position(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        const std::string_view word = next_word(rest);
        if (word.empty()) return refuse("not three numbers");
        const std::optional<double> number = number_of(word);
        if (!number && !is_no_finite_number(word)) return refuse("not a number", word);
        position[axis] = number.value_or(no_number);
    }
    content_.positions.push_back(position);
    content_.position_lines.add(statement_line_);
}

/// Reads a normal; one that cannot be read becomes 0, which has no direction.
void ObjLines::take_normal(std::string_view rest) {
    glm::dvec3 normal(0.0);
    for (int axis = 0; axis < 3; ++axis) normal[axis] = number_of(next_word(rest)).value_or(no_number);
    content_.normals.emplace_back(direction_of(normal));
    content_.normal_lines.add(statement_line_);
}

void ObjLines::take_face(std::string_view rest) {
    const std::size_t begin = content_.corners.size();
    content_.face_lines.add(statement_line_);
    for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest)) {
        const std::optional<NamedCorner> corner = corner_of(word);
        if (!corner) return refuse("not a corner of a face", word);
        add_corner(*corner);
    }
    const std::size_t count = content_.corners.size() - begin;
    if (count < 3) return refuse("a face with fewer than three corners");
    if (content_.faces.empty() || content_.faces.back().corners_each != count ||
        content_.faces.back().smoothing != smoothing_)
        content_.faces.push_back({static_cast<std::uint32_t>(count), 0, smoothing_});
    ++content_.faces.back().count;
    content_.triangle_count += count - 2;
    if (content_.triangle_count > max_obj_triangles) refuse("more than 50 million triangles");
}

/// Reads "s 3", "s off" and "s 0"; "s on" counts as "s 1".
void ObjLines::take_smoothing(std::string_view rest, std::string_view line) {
    std::string_view word = next_word(rest);
    if (word == "off" || word == "on") {
        smoothing_ = word == "on" ? 1 : ObjFaces::smoothing_off;
        return;
    }
    constexpr std::size_t most_digits = 9;
    const std::string_view digits = take_digits(word);
    if (digits.empty() || digits.size() > most_digits || !word.empty()) return meet_strange(line);
    smoothing_ = 0;
    for (const char digit : digits) smoothing_ = 10 * smoothing_ + (digit - '0');
}

std::string face_names(std::uint64_t face, const char* what, int index) {
    return "face " + std::to_string(face + 1) + " refers to " + what + ' ' + std::to_string(index);
}

/// Adds a corner. Refuses a position index that points before the first position, and drops a normal index that points
/// before the first normal. check_corners() tests all other indices, whose targets may be on later lines.
void ObjLines::add_corner(const NamedCorner& named) {
    const std::uint64_t face = content_.face_lines.count() - 1;
    const int position = from_zero(named.position, content_.positions.size());
    const bool has_normal = named.normal != 0;
    const int normal = has_normal ? from_zero(named.normal, content_.normals.size()) : ObjCorner::no_normal;
    content_.corners.push_back({position, normal});
    if (has_normal && normal < 0)
        meet(replaced_, statement_line_, face_names(face, "normal", named.normal) + ", which does not exist");
    if (trouble_.empty() && position < 0) refuse(face_names(face, "vertex", named.position) + ", which does not exist");
}

/// Refuses a corner whose position does not exist or is not usable; drops a normal that cannot be used.
void ObjLines::check_corners() {
    std::size_t corner = 0;
    std::uint64_t face = 0;
    for (const auto& [corners_each, count, smoothing] : content_.faces) {
        for (std::uint64_t i = 0, left = corners_each; i < std::uint64_t{corners_each} * count; ++i, ++corner) {
            const std::uint64_t of_face = face;
            if (--left == 0) {
                left = corners_each;
                ++face;
            }
            ObjCorner& checked = content_.corners[corner];
            if (!is_usable(checked.position, of_face)) return;
            if (checked.normal == ObjCorner::no_normal) continue;
            const auto normal = static_cast<std::size_t>(checked.normal);
            if (normal >= content_.normals.size())
                meet(replaced_, content_.face_lines.line_of(of_face),
                     face_names(of_face, "normal", checked.normal + 1) + ", but the file has " +
                         std::to_string(content_.normals.size()));
            else if (content_.normals[normal] == glm::vec3(0.0F))
                meet(replaced_, content_.normal_lines.line_of(normal),
                     "normal " + std::to_string(normal + 1) + " has no direction");
            else
                continue;
            checked.normal = ObjCorner::no_normal;
        }
    }
}

/// Returns whether a face may use this position; if not, stores the reason in trouble_.
bool ObjLines::is_usable(int position, std::uint64_t face) {
    const auto index = static_cast<std::size_t>(position);
    if (index >= content_.positions.size()) {
        trouble_ = at_line(content_.face_lines.line_of(face)) + face_names(face, "vertex", position + 1) +
                   ", but the file has " + std::to_string(content_.positions.size());
        return false;
    }
    const glm::dvec3 size = glm::abs(content_.positions[index]);
    if (size.x <= largest_coordinate && size.y <= largest_coordinate && size.z <= largest_coordinate) return true;
    const bool is_number = !std::isnan(size.x) && !std::isnan(size.y) && !std::isnan(size.z);
    trouble_ = at_line(content_.position_lines.line_of(index)) + "vertex " + std::to_string(position + 1) +
               (is_number ? " has a coordinate beyond 1e12" : " has a coordinate that is not a finite number");
    return false;
}

std::string ObjLines::without_faces() const {
    std::string has;
    const auto add = [&has](const char* what, std::uint64_t count) {
        if (count > 0) has += (has.empty() ? "" : ", ") + std::string(what) + " (" + std::to_string(count) + ")";
    };
    add("lines", content_.line_count);
    add("points", content_.point_count);
    add("curves and surfaces", content_.surface_count);
    if (has.empty()) add("vertices", content_.positions.size());
    if (has.empty()) return "not an OBJ file, or an empty one: it has no vertices and no faces";
    const std::string also = strange_.count > 0 ? "; " + strange_.first : "";
    return "has only " + has + " and no faces: nothing to shade" + also;
}

void ObjLines::note_what_is_left_out() {
    const auto note = [this](const Met& met, const std::string& rest) {
        if (met.count > 0) content_.notes.push_back(met.first + rest);
    };
    note(strange_, strange_.count > 1 ? ", and " + std::to_string(strange_.count - 1) + " more" : "");
    note(replaced_, "; corners whose normal comes from the faces instead: " + std::to_string(replaced_.count));
    std::string left_out;
    const auto add = [&left_out](const char* what, std::uint64_t count) {
        if (count > 0) left_out += (left_out.empty() ? "" : ", ") + std::string(what) + ": " + std::to_string(count);
    };
    add("lines", content_.line_count);
    add("points", content_.point_count);
    add("curves and surfaces", content_.surface_count);
    if (!left_out.empty()) content_.notes.push_back("only faces are drawn; left out: " + left_out);
}

/// Sets the error, replacing any earlier one: a malformed line is reported rather than an error in its indices.
void ObjLines::refuse(const std::string& what, std::string_view token) {
    trouble_ = at_line(statement_line_) + what + (token.empty() ? "" : ": " + excerpt(token));
}

}  // namespace

Result<ObjContent> read_obj_lines(std::istream& stream, std::uint64_t size_bytes, WorkProgress* progress) {
    return ObjLines(stream, size_bytes, progress).read();
}

}  // namespace viewing
