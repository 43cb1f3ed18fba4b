// The manual: one Markdown file per topic in assets/manual, embedded in the program. `viewing-sandbox help`, the man
// page and the window's help show the same blocks.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace viewing {

/// Returns the names of all topics, such as "lessons", in reading order.
std::span<const char* const> manual_topics();

enum class ManualPart { heading, paragraph, item, code, row };

/// A heading, a paragraph, an item of a list, one line of code, or one row of a table, as plain text without markup.
struct ManualBlock {
    ManualPart part = ManualPart::paragraph;
    std::vector<std::string> cells;  ///< the cells of a row; otherwise a single text
};

/// Splits a Markdown text into blocks: headings (#), paragraphs, lists (- and 1.), fenced code and tables. Removes the
/// markup of emphasis, code spans, links and headings; other markup stays unchanged.
std::vector<ManualBlock> manual_blocks(std::string_view markdown);

/// Returns the blocks of a topic; the first is its title. Empty for an unknown name.
std::vector<ManualBlock> manual_topic(std::string_view name);

/// Returns the blocks for a terminal, in lines of at most 100 characters; code keeps its lines.
std::string manual_text(std::span<const ManualBlock> blocks);

}  // namespace viewing
