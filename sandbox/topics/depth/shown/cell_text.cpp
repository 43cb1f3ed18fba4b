#include "topics/depth/shown/cell_text.h"

#include <algorithm>
#include <map>

#include "text/catalogue.h"
#include "topics/depth/numbers/fragment_text.h"

namespace viewing {
namespace {

constexpr int least_code_decimals = 2, widest_code_bits = 16;
constexpr const char* cleared_text = marked("clear");

bool is_cleared(const BufferCell& cell, double cleared) {
    return cell.window_depth == cleared;
}

std::vector<std::string> window_depths(const CellBlock& block, int decimals) {
    std::vector<std::string> texts;
    for (const BufferCell& cell : block.cells) texts.push_back(plain_decimals(cell.window_depth, decimals));
    return texts;
}

/// Whether cells with equal texts always have equal codes.
bool tells_apart(const CellBlock& block, const std::vector<std::string>& texts) {
    std::map<std::string, std::uint32_t> code_of;
    for (std::size_t i = 0; i < texts.size(); ++i)
        if (code_of.try_emplace(texts[i], block.cells[i].stored).first->second != block.cells[i].stored) return false;
    return true;
}

struct CodeRange {
    std::uint32_t least = ~0U, greatest = 0;
};

CodeRange written_codes(const CellBlock& block, double cleared) {
    CodeRange range;
    for (const BufferCell& cell : block.cells) {
        if (is_cleared(cell, cleared)) continue;
        range.least = std::min(range.least, cell.stored);
        range.greatest = std::max(range.greatest, cell.stored);
    }
    return range;
}

}  // namespace

CellTexts cell_texts(const CellBlock& block, const DepthPrecision& precision, double cleared, int room) {
    const int most_decimals = std::max(room - 2, least_code_decimals);
    if (!precision.is_float && precision.bits <= widest_code_bits) {
        const auto greatest = static_cast<std::int64_t>(precision.greatest_code());
        CellTexts codes;
        for (const BufferCell& cell : block.cells) codes.texts.push_back(std::to_string(cell.stored));
        codes.note = say("stored code, 0 … {greatest}", "greatest"_a = grouped_number(greatest));
        if (static_cast<int>(std::to_string(greatest).size()) <= room) return codes;
    }
    for (int decimals = least_code_decimals; decimals <= most_decimals; ++decimals)
        if (std::vector<std::string> texts = window_depths(block, decimals); tells_apart(block, texts))
            return {std::move(texts), tr("window depth")};

    const CodeRange range = written_codes(block, cleared);
    CellTexts above;
    for (const BufferCell& cell : block.cells)
        above.texts.push_back(is_cleared(cell, cleared) ? tr(cleared_text) : std::to_string(cell.stored - range.least));
    if (range.least <= range.greatest &&
        std::to_string(range.greatest - range.least).size() <= static_cast<std::size_t>(std::max(room, 1))) {
        above.note = precision.is_float ? say("floats above {least}", "least"_a = code_text(range.least, precision))
                                        : say("code − {least}", "least"_a = grouped_number(range.least));
        return above;
    }
    return {window_depths(block, most_decimals), tr("window depth, rounded")};
}

}  // namespace viewing
