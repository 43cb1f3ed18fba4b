// The lecture's matrices: rows as on the slides, aligned columns, the symbolic entry under each number. This file first
// computes the measures (Measures), then draws one cell (DrawNumber, DrawSymbol), then the whole matrix (ShowMatrix).
#include <algorithm>
#include <cmath>

#include "widgets/inner.h"

namespace widgets {

namespace {

using inner::Px;

constexpr const char* cell_names[16] = {"r0c0", "r0c1", "r0c2", "r0c3", "r1c0", "r1c1", "r1c2", "r1c3",
                                        "r2c0", "r2c1", "r2c2", "r2c3", "r3c0", "r3c1", "r3c2", "r3c3"};

/// Returns entry `cell` = 4 · row + column of a GLM matrix.
double& Entry(glm::dmat4& m, int cell) {
    return m[cell % 4][cell / 4];
}
double Entry(const glm::dmat4& m, int cell) {
    return m[cell % 4][cell / 4];
}

/// Returns the matrix without rounding residues: an entry below 1e-14 of the largest one is the residue of a zero, such
/// as V[0][3] = 2e-16 for a camera that looks at the origin. Every other entry is shown.
glm::dmat4 WithoutResidues(glm::dmat4 value) {
    constexpr double residue_share = 1e-14;
    double largest = 0.0;
    for (int cell = 0; cell < 16; ++cell) {
        const double size = std::abs(Entry(value, cell));
        if (std::isfinite(size)) largest = std::max(largest, size);
    }
    for (int cell = 0; cell < 16; ++cell) {
        if (std::abs(Entry(value, cell)) < residue_share * largest) Entry(value, cell) = 0.0;
    }
    return value;
}

/// The layout for a given width: the cells' positions, the number of decimals, and whether symbols fit.
struct Measures {
    inner::Face number, symbol;
    float bracket, inset;  ///< from the edge to the bracket's line; from a cell's edge to its text
    float cell_width, cell_height, number_height;
    float spread = 0.0F;  ///< extra space above and below the text of a cell
    int columns;          ///< characters that fit
    int decimals;         ///< of every number that fits
    bool symbols = false;

    Measures(const glm::dmat4& value, const MatrixStyle& style, float width);

    ImVec2 CellMin(ImVec2 corner, int cell) const {
        const auto row = static_cast<float>(cell / 4), column = static_cast<float>(cell % 4);
        return ImVec2(corner.x + 2.0F * bracket + column * cell_width, corner.y + Px(3) + row * cell_height);
    }
    float Height() const { return HeightOf(cell_height); }
    static float HeightOf(float cell_height) { return 4.0F * cell_height + 2.0F * Px(3); }
    /// The height of a cell without a number box. `symbol_size` 0: without symbols.
    static float ShownHeight(float number_size, bool hides_symbols, float symbol_size) {
        return number_size + (hides_symbols ? Px(5) : Px(9)) + symbol_size * 1.1F;
    }
};

/// Shrinks the symbols until the widest one fits, but to no less than 0.7 of their size. Returns false if it still does
/// not fit.
bool FitSymbols(const MatrixStyle& style, float room, inner::Face& symbol) {
    float widest = 0.0F;
    for (const MatrixCell& cell : style.cells) {
        widest = std::max(widest, inner::FormulaLayout(cell.symbol, {}, 0, symbol).size.x);
    }
    constexpr float smallest = 0.7F;
    const float shrink = widest > room ? room / widest : 1.0F;
    if (widest == 0.0F || shrink < smallest) return false;
    symbol.size *= shrink;
    return true;
}

/// Returns the number of characters of the longest entry.
int ColumnsOf(const glm::dmat4& value, int decimals) {
    int columns = 1;
    for (int cell = 0; cell < 16; ++cell)
        columns = std::max(columns, viewing::number_chars(Entry(value, cell), decimals, inner::Tiny::zero).columns);
    return columns;
}

/// Returns the size of a face enlarged by at most `growth`, so that `columns` characters still fit into `room`.
float GrownSize(const inner::Face& face, float growth, float room, int columns) {
    const float advance = face.font->GetCharAdvance('0') / face.font->FontSize;
    return std::clamp(room / (static_cast<float>(columns) * advance), face.size, growth * face.size);
}

/// Returns the largest number of decimals with which all entries fit, ignoring entries that never fit.
int FitDecimals(const glm::dmat4& value, int decimals, int columns) {
    const int fewest = std::min(decimals, 1);
    int best = decimals;
    for (int cell = 0; cell < 16; ++cell) {
        int digits = best;
        while (digits > fewest &&
               viewing::number_chars(Entry(value, cell), digits, inner::Tiny::zero).columns > columns) {
            --digits;
        }
        const bool fits = viewing::number_chars(Entry(value, cell), digits, inner::Tiny::zero).columns <= columns;
        if (fits) best = digits;
    }
    return best;
}

Measures::Measures(const glm::dmat4& value, const MatrixStyle& style, float width)
    : number(inner::FaceOf(CurrentContext().fonts.matrix)), symbol(inner::FaceOf(CurrentContext().fonts.note)) {
    bracket = Px(7);
    cell_width = std::floor((width - 4.0F * bracket) / 4.0F);
    inset = std::min(Px(6), cell_width * 0.07F);
    // The type grows less than the rows: larger digits would dwarf the text beside them.
    constexpr float most_growth = 1.4F;
    const float room = cell_width - 2.0F * inset, growth = std::min(CurrentContext().matrix_growth, most_growth);
    number.size = GrownSize(number, growth, room, ColumnsOf(value, style.decimals));
    symbol.size *= growth;
    symbols = FitSymbols(style, room, symbol);

    const float digit = number.font->GetCharAdvance('0') * number.size / number.font->FontSize;
    columns = std::max(1, static_cast<int>(room / digit + 0.01F));
    decimals = FitDecimals(value, style.decimals, columns);

    number_height = style.editable ? ImGui::GetFrameHeight() : number.size + Px(1);
    // The height stays the same when editing starts. If all its symbols are hidden, a matrix also gives up the space
    // around its numbers.
    const bool hides_symbols =
        !style.cells.empty() && std::all_of(style.cells.begin(), style.cells.end(),
                                            [](const MatrixCell& cell) { return *cell.symbol == '\0'; });
    const float usual = inner::FaceOf(CurrentContext().fonts.matrix).size, small = symbol.size / growth;
    const float shown_height = growth * ShownHeight(usual, hides_symbols, symbols ? small : 0.0F);
    if (const float rows = CurrentContext().matrix_growth; rows > 1.0F) {  // symbols that shrank leave space, too
        const float full_symbol = symbols ? inner::FaceOf(CurrentContext().fonts.note).size : 0.0F;
        const float full_height = rows * ShownHeight(usual, hides_symbols, full_symbol);
        spread = std::floor(0.5F * std::max(full_height - shown_height, 0.0F));
    }
    const float text_height = style.editable ? std::max(number_height + Px(4), shown_height) : shown_height;
    cell_height = std::ceil(text_height) + 2.0F * spread;
}

void DrawBrackets(ImDrawList* draw, ImVec2 min, ImVec2 max, float at, bool overridden) {
    const Palette& palette = CurrentContext().palette;
    const float serif = Px(5), inset = Px(4), thickness = Px(1.5F) * palette.stroke;
    const ImU32 color = inner::Shown(overridden ? palette.trouble : inner::Mix(palette.quiet, palette.text, 0.4F));
    for (const float side : {1.0F, -1.0F}) {
        const float x = side > 0.0F ? min.x + at : max.x - at;
        const ImVec2 line[] = {ImVec2(x + side * serif, min.y + inset), ImVec2(x, min.y + inset),
                               ImVec2(x, max.y - inset), ImVec2(x + side * serif, max.y - inset)};
        draw->AddPolyline(line, 4, color, 0, thickness);
    }
}

struct CellState {
    bool changed, lit, zero;
};

void DrawTint(ImDrawList* draw, ImVec2 min, ImVec2 max, const CellState& state) {
    if (!state.changed && !state.lit) return;
    const Palette& palette = CurrentContext().palette;
    const ImVec2 from(min.x + Px(1), min.y + Px(1)), to(max.x - Px(1), max.y - Px(1));
    const float rounding = ImGui::GetStyle().FrameRounding;
    draw->AddRectFilled(from, to, inner::Shown(inner::WithAlpha(palette.accent, state.lit ? 0.11F : 0.09F)), rounding);
    const ImU32 outline = inner::Shown(inner::WithAlpha(palette.accent, 0.7F));
    if (state.lit) draw->AddRect(from, to, outline, rounding, 0, Px(1) * palette.stroke);
}

/// Draws the symbol. It is fainter if its entry is currently zero, except on a projector, where it would be invisible.
void DrawSymbol(ImDrawList* draw, ImVec2 min, const Measures& measures, const MatrixStyle& style,
                const CellState& state, int cell) {
    if (!measures.symbols) return;
    const char* formula = style.cells[cell].symbol;
    if (*formula == '\0') return;
    const inner::FormulaLayout layout(formula, style.roles, CurrentContext().palette.quiet, measures.symbol);
    const float x = min.x + measures.cell_width - measures.inset - layout.size.x;
    const Context& context = CurrentContext();
    const bool is_for_audience = context.is_on_stage || context.palette.stroke > 1.0F;
    const bool stands_back = state.zero && !state.lit && !state.changed && !is_for_audience;
    layout.Draw(draw, ImVec2(std::floor(x), std::floor(min.y + measures.spread + Px(3) + measures.number_height)),
                stands_back ? 0.65F : 1.0F);
}

/// Draws the number, right-aligned so that the decimal points align.
void DrawNumber(ImDrawList* draw, ImVec2 min, const Measures& measures, double value, const CellState& state, int cell,
                ImVec2 max) {
    const inner::NumberChars text =
        viewing::fitted_number(value, measures.decimals, inner::Tiny::exact, {}, measures.columns);
    const Palette& palette = CurrentContext().palette;
    const ImU32 color = state.zero && !state.changed && !state.lit ? palette.quiet : palette.text;
    const float width = measures.number.Measure(text.view()).x;
    const float top = min.y + measures.spread + Px(3);
    measures.number.Draw(draw, ImVec2(std::floor(max.x - measures.inset - width), std::floor(top)), inner::Shown(color),
                         text.view());
    inner::RecordRect(cell_names[cell], min, max, text.view());
}

bool EditNumber(ImVec2 min, const Measures& measures, glm::dmat4& value, const MatrixStyle& style, int cell) {
    static const glm::dmat4 identity(1.0);
    const MatrixCell* info = style.cells.empty() ? nullptr : &style.cells[cell];
    const NumberStyle number{.step = 0.01,
                             .decimals = measures.decimals,
                             .shows_tiny = true,
                             .default_value = Entry(style.defaults ? *style.defaults : identity, cell),
                             .links = info ? info->links : 0,
                             .read = style.read,
                             .unread = style.unread ? style.unread + cell : nullptr};
    ImGui::SetCursorScreenPos(ImVec2(min.x + Px(1), min.y + measures.spread + Px(2)));
    return inner::NumberBox(cell_names[cell], Entry(value, cell), number, measures.cell_width - Px(2));
}

/// Returns the entry under the pointer while the last item, the whole matrix, is hovered; otherwise −1.
int CellUnderPointer(ImVec2 corner, const Measures& measures) {
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return -1;
    const ImVec2 first = measures.CellMin(corner, 0), pointer = ImGui::GetMousePos();
    const float column = std::floor((pointer.x - first.x) / measures.cell_width);
    const float row = std::floor((pointer.y - first.y) / measures.cell_height);
    if (column < 0.0F || column > 3.0F || row < 0.0F || row > 3.0F) return -1;
    return 4 * static_cast<int>(row) + static_cast<int>(column);
}

/// Describes the entry: its position, its symbol, its value with more decimals, and its GLM name.
void CellTooltip(const glm::dmat4& value, const MatrixStyle& style, int cell) {
    const Context& context = CurrentContext();
    inner::BeginTooltipWindow();
    {
        const inner::FontScope font(context.fonts.heading);
        const std::string title = say("row {row}, column {column}", "row"_a = cell / 4 + 1, "column"_a = cell % 4 + 1);
        ImGui::TextUnformatted(title.c_str());
    }
    if (!style.cells.empty() && *style.cells[cell].symbol) {
        const inner::FormulaLayout layout(style.cells[cell].symbol, style.roles, context.palette.text,
                                          inner::FaceOf(nullptr));
        layout.Draw(ImGui::GetWindowDrawList(), ImGui::GetCursorScreenPos());
        ImGui::Dummy(layout.size);
    }
    {
        const inner::FontScope font(context.fonts.number);
        const inner::NumberChars digits = viewing::number_chars(Entry(value, cell), 9, inner::Tiny::exact);
        ImGui::TextUnformatted(digits.data, digits.data + digits.bytes);
        ImGui::PushStyleColor(ImGuiCol_Text, context.palette.accent);
        // GLM indexes columns first.
        const std::string glm = say("GLM: m[{column}][{row}] (column, row)", "column"_a = cell % 4, "row"_a = cell / 4);
        ImGui::TextUnformatted(glm.c_str());
        ImGui::PopStyleColor();
    }
    inner::EndTooltipWindow();
}

/// Returns the name of a cell as a target: "matrix:V[2][3]".
std::string TargetOfCell(const MatrixStyle& style, int cell) {
    return std::string(style.target) + "[" + std::to_string(cell / 4) + "][" + std::to_string(cell % 4) + "]";
}

bool IsCellCovered(const MatrixStyle& style, int cell) {
    return style.target && !CurrentContext().targets.covered.empty() && IsCovered(TargetOfCell(style, cell));
}

CellState StateOf(double value, const MatrixStyle& style, int cell, int hovered_cell) {
    CellState state{false, cell == hovered_cell, value == 0.0};
    if (style.cells.empty()) return state;
    const MatrixCell& info = style.cells[cell];
    state.changed = info.changed;
    state.lit |= inner::IsEntryLit(info.own, info.links);
    return state;
}

/// Shows `value`. Also edits it if `style.editable`; the caller must then own the value.
bool ShowMatrix(const char* label, glm::dmat4& value, const MatrixStyle& style, float width) {
    IM_ASSERT(style.cells.empty() || style.cells.size() == 16);
    Context& context = CurrentContext();
    if (width <= 0.0F) width = std::max(ImGui::GetContentRegionAvail().x, Px(120));
    const glm::dmat4 exact = WithoutResidues(value);
    const Measures measures(value, style, width);
    const ImVec2 min = ImGui::GetCursorScreenPos();
    const ImVec2 max(min.x + width, min.y + measures.Height());
    if (style.target && IsCovered(style.target)) {
        if (style.hovered_cell) *style.hovered_cell = -1;
        Plate(label, {width, measures.Height()});
        MarkTarget(style.target);
        return false;
    }

    ImGui::BeginGroup();
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->AddRectFilled(min, max, inner::Shown(inner::Mix(context.palette.ground, context.palette.raised, 0.55F)),
                        ImGui::GetStyle().FrameRounding);
    DrawBrackets(draw, min, max, measures.bracket, style.overridden);
    if (!style.editable) ImGui::Dummy(ImVec2(width, measures.Height()));
    int hovered_cell = style.editable ? -1 : CellUnderPointer(min, measures);
    if (hovered_cell >= 0 && IsCellCovered(style, hovered_cell)) hovered_cell = -1;

    const Group group(label);
    bool changed = false;
    int edited_cell = -1;
    for (int cell = 0; cell < 16; ++cell) {
        const ImVec2 cell_min = measures.CellMin(min, cell);
        const ImVec2 cell_max(cell_min.x + measures.cell_width, cell_min.y + measures.cell_height);
        if (IsCellCovered(style, cell)) {
            const ImVec2 from(cell_min.x + Px(2), cell_min.y + Px(2)), to(cell_max.x - Px(2), cell_max.y - Px(2));
            DrawPlate(draw, from, to);
            inner::RecordRect(cell_names[cell], cell_min, cell_max, "?");
            continue;
        }
        const CellState state = StateOf(Entry(exact, cell), style, cell, hovered_cell);
        if (style.editable) {
            changed |= EditNumber(cell_min, measures, value, style, cell);
            if (ImGui::IsItemHovered()) edited_cell = cell;
        } else {
            DrawTint(draw, cell_min, cell_max, state);
            DrawNumber(draw, cell_min, measures, Entry(exact, cell), state, cell, cell_max);
        }
        DrawSymbol(draw, cell_min, measures, style, state, cell);
    }
    if (style.editable) {
        ImGui::SetCursorScreenPos(min);
        ImGui::Dummy(ImVec2(width, measures.Height()));
    }
    ImGui::EndGroup();

    if (style.target && !context.targets.highlighted.empty()) {
        MarkTarget(style.target, min, max);
        for (int cell = 0; cell < 16; ++cell) {
            const ImVec2 from = measures.CellMin(min, cell);
            MarkTarget(TargetOfCell(style, cell), from, {from.x + measures.cell_width, from.y + measures.cell_height});
        }
    }

    if (hovered_cell >= 0 && !style.cells.empty()) {
        const MatrixCell& info = style.cells[hovered_cell];
        inner::PointAtEntry(info.own, info.links);
    }
    if (hovered_cell >= 0) {
        const ImVec2 cell_min = measures.CellMin(min, hovered_cell);
        const ImVec2 cell_max(cell_min.x + measures.cell_width, cell_min.y + measures.cell_height);
        if (inner::TooltipDue(true, cell_min, cell_max)) CellTooltip(exact, style, hovered_cell);
    }
    if (style.hovered_cell) *style.hovered_cell = style.editable ? edited_cell : hovered_cell;
    return changed;
}

}  // namespace

bool Matrix(const char* label, glm::dmat4& value, const MatrixStyle& style, float width) {
    return ShowMatrix(label, value, style, width);
}

void Matrix(const char* label, const glm::dmat4& value, const MatrixStyle& style, float width) {
    glm::dmat4 shown = value;
    MatrixStyle fixed = style;
    fixed.editable = false;
    ShowMatrix(label, shown, fixed, width);
}

float MatrixHeight(bool has_symbols) {
    const Fonts& fonts = CurrentContext().fonts;
    const float symbol_size = has_symbols ? inner::FaceOf(fonts.note).size : 0.0F;
    return Measures::HeightOf(
        std::ceil(CurrentContext().matrix_growth *
                  Measures::ShownHeight(inner::FaceOf(fonts.matrix).size, !has_symbols, symbol_size)));
}

}  // namespace widgets
