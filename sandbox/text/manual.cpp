#include "text/manual.h"

#include <algorithm>
#include <array>
#include <sstream>

#include "embedded/manual.h"
#include "text/words.h"

namespace viewing {
namespace {

constexpr std::array topics{"window",  "lessons", "exercises", "grading",  "commands", "states", "compare",
                            "figures", "suites",  "sweeps",    "notebook", "page",     "slides"};

/// Returns the text without **bold**, *emphasis*, `code` and [links](address). Inside `code`, nothing is markup.
std::string without_markup(std::string_view text) {
    std::string plain;
    bool in_code = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char sign = text[i];
        if (sign == '`') {
            in_code = !in_code;
        } else if (in_code) {
            plain += sign;
        } else if (sign == '\\' && i + 1 < text.size()) {
            plain += text[++i];
        } else if (sign == ']' && text.substr(i).starts_with("](")) {
            i = std::min(text.find(')', i), text.size() - 1);
        } else if (sign != '*' && !(sign == '[' && text.find("](", i) != std::string_view::npos)) {
            plain += sign;
        }
    }
    return plain;
}

std::string_view trimmed(std::string_view text) {
    const auto begin = text.find_first_not_of(' ');
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

std::vector<std::string> cells_of(std::string_view line) {
    std::vector<std::string> cells;
    line.remove_prefix(1);
    while (!line.empty()) {
        const std::size_t end = line.find('|');
        cells.push_back(without_markup(trimmed(line.substr(0, end))));
        line.remove_prefix(end == std::string_view::npos ? line.size() : end + 1);
    }
    return cells;
}

/// Returns the number of bytes in a list item's marker, "- " or "12. "; 0 if there is none.
std::size_t item_mark(std::string_view line) {
    if (line.starts_with("- ")) return 2;
    const std::size_t digits = line.find_first_not_of("0123456789");
    return digits != 0 && digits != std::string_view::npos && line.substr(digits).starts_with(". ") ? digits + 2 : 0;
}

class Reader {
public:
    void read(std::string_view line) {
        const std::string_view text = trimmed(line);
        if (text.starts_with("```")) {
            end_text();
            in_code_ = !in_code_;
        } else if (in_code_) {
            blocks_.push_back({ManualPart::code, {std::string(line)}});
        } else if (text.empty()) {
            end_text();
        } else if (text.starts_with('#')) {
            end_text();
            const std::string_view heading = trimmed(text.substr(std::min(text.find_first_not_of('#'), text.size())));
            blocks_.push_back({ManualPart::heading, {without_markup(heading)}});
        } else if (text.starts_with('|')) {
            end_text();
            if (text.find_first_not_of("|-: ") != std::string_view::npos)
                blocks_.push_back({ManualPart::row, cells_of(text)});
        } else if (const std::size_t mark = item_mark(text); mark > 0) {
            end_text();
            part_ = ManualPart::item;
            text_ = text;
        } else {
            text_ += (text_.empty() ? "" : " ") + std::string(text);
        }
    }
    std::vector<ManualBlock> blocks() {
        end_text();
        return std::move(blocks_);
    }

private:
    void end_text() {
        if (!text_.empty()) blocks_.push_back({part_, {without_markup(text_)}});
        text_.clear();
        part_ = ManualPart::paragraph;
    }

    std::vector<ManualBlock> blocks_;
    std::string text_;
    ManualPart part_ = ManualPart::paragraph;
    bool in_code_ = false;
};

constexpr std::size_t text_width = 100;

/// Formats a table: each column is as wide as its widest cell; the last column wraps.
std::string table_text(std::span<const ManualBlock> rows) {
    std::vector<std::size_t> widths;
    for (const ManualBlock& row : rows)
        for (std::size_t column = 0; column < row.cells.size(); ++column) {
            if (column == widths.size()) widths.push_back(0);
            widths[column] = std::max(widths[column], character_count(row.cells[column]));
        }
    std::string text;
    for (const ManualBlock& row : rows) {
        std::string begin = "  ";
        for (std::size_t column = 0; column + 1 < row.cells.size(); ++column)
            begin += row.cells[column] + std::string(widths[column] + 2 - character_count(row.cells[column]), ' ');
        text += in_lines(row.cells.empty() ? "" : row.cells.back(), text_width, begin, character_count(begin));
    }
    return text;
}

}  // namespace

std::span<const char* const> manual_topics() {
    return topics;
}

std::vector<ManualBlock> manual_blocks(std::string_view markdown) {
    Reader reader;
    std::istringstream lines{std::string(markdown)};
    for (std::string line; std::getline(lines, line);) reader.read(line);
    return reader.blocks();
}

std::vector<ManualBlock> manual_topic(std::string_view name) {
    return manual_blocks(embedded_manual(std::string(name) + ".md"));
}

std::string manual_text(std::span<const ManualBlock> blocks) {
    std::string text;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const ManualBlock& block = blocks[i];
        const bool continues = i > 0 && blocks[i - 1].part == block.part && block.part != ManualPart::paragraph;
        if (i > 0 && !continues) text += "\n";
        if (block.part == ManualPart::row) {
            std::size_t end = i;
            while (end < blocks.size() && blocks[end].part == ManualPart::row) ++end;
            text += table_text(blocks.subspan(i, end - i));
            i = end - 1;
        } else if (block.part == ManualPart::code) {
            text += "    " + block.cells.front() + "\n";
        } else if (block.part == ManualPart::item) {
            text += in_lines(block.cells.front(), text_width, "  ", 2 + item_mark(block.cells.front()));
        } else {
            text += in_lines(block.cells.front(), text_width, "", 0);
        }
    }
    return text;
}

}  // namespace viewing
