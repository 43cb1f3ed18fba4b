#include "image/figure_note.h"

#include <array>
#include <cstdint>
#include <system_error>
#include <utility>

#include "image/note_parts.h"
#include "image/png.h"
#include "platform/file.h"
#include "text/html.h"
#include "text/words.h"

namespace viewing {
namespace {

constexpr std::string_view svg_id = "viewing-sandbox-state", svg_end = "</metadata>";
constexpr std::string_view keyword_begin = "viewing-sandbox-state-";
constexpr std::string_view hex = "0123456789abcdef";

/// The inverse of escaped().
std::string unescaped(std::string_view text) {
    static constexpr std::array<std::pair<std::string_view, char>, 4> entities = {
        {{"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}}};
    std::string plain;
    while (!text.empty()) {
        bool is_entity = false;
        for (const auto& [entity, character] : entities)
            if (text.starts_with(entity)) {
                plain += character;
                text.remove_prefix(entity.size());
                is_entity = true;
                break;
            }
        if (is_entity) continue;
        plain += text.front();
        text.remove_prefix(1);
    }
    return plain;
}

/// Returns the tag that precedes a part of the note; parts are counted from 1.
std::string svg_begin(int number) {
    return "<metadata id=\"" + note_part_name(svg_id, "-", number) + "\">";
}

std::string note_in_svg(std::string_view document) {
    std::string note;
    for (int number = 1;; ++number) {
        const std::string tag = svg_begin(number);
        const std::size_t begin = document.find(tag);
        if (begin == std::string_view::npos) return note;
        document.remove_prefix(begin + tag.size());
        const std::size_t end = document.find(svg_end);
        if (end == std::string_view::npos) return "";
        note += unescaped(document.substr(0, end));
    }
}

std::string note_in_pdf(std::string_view document) {
    const std::size_t begin = document.find(keyword_begin);
    if (begin == std::string_view::npos) return "";
    std::string note;
    for (std::size_t at = begin + keyword_begin.size(); at + 1 < document.size(); at += 2) {
        const std::size_t high = hex.find(document[at]), low = hex.find(document[at + 1]);
        if (high == std::string_view::npos || low == std::string_view::npos) break;
        note += static_cast<char>(high * 16 + low);
    }
    return note;
}

}  // namespace

std::string note_as_svg(std::string_view note) {
    std::string elements;
    int number = 0;
    for (const std::string_view part : note_parts(note))
        elements += svg_begin(++number) + escaped(part) + std::string(svg_end) + "\n";
    return elements;
}

std::string note_as_keyword(std::string_view note) {
    if (note.empty() || !can_carry(note)) return "";
    std::string keyword(keyword_begin);
    bool is_indented = false;
    for (const char c : note) {
        // Drop line breaks and the indentation after them, which JSON has only between its tokens.
        is_indented = c == '\n' || (is_indented && c == ' ');
        if (is_indented) continue;
        const auto byte = static_cast<unsigned char>(c);
        keyword += hex[byte / 16];
        keyword += hex[byte % 16];
    }
    return keyword;
}

bool is_figure_name(const std::filesystem::path& path) {
    const std::string ending = path.extension().string();
    return ending == ".png" || ending == ".svg" || ending == ".pdf";
}

Result<std::string> read_figure_note(const std::filesystem::path& path) {
    const std::string ending = path.extension().string();
    if (ending == ".png") return read_png_note(path);
    if (Status readable = check_readable(path); !readable) return Error{readable.error()};
    constexpr std::uintmax_t most_bytes = 256U << 20U;
    if (std::error_code error; std::filesystem::file_size(path, error) > most_bytes)
        return Error{one_line(path.string()) + ": is larger than 256 MiB, unlike any figure of this program"};
    const std::string document = all_bytes(path);
    return ending == ".svg" ? note_in_svg(document) : note_in_pdf(document);
}

}  // namespace viewing
