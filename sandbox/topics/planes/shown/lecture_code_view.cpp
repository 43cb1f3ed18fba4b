// The functions in this file build on one another: they draw words of code in color, break code into rows, draw a line
// with its number, and draw a whole function.
#include "topics/planes/shown/lecture_code_view.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string_view>

#include "text/catalogue.h"
#include "text/words.h"
#include "topics/planes/numbers/lecture_code.h"
#include "ui/parts/field_controls.h"
#include "ui/parts/links.h"
#include "ui/parts/look.h"

namespace viewing {
namespace {

using widgets::Links;
using widgets::Role;

/// How the code is written so that it fits a given width.
struct Writing {
    ImFont* font;
    int columns;         ///< characters per row
    bool names_array;    ///< true: "shadowMat[4] = …"; false: "[4] = …"
    const char* before;  ///< text before the number
};

/// One function, ready to show.
struct Function {
    const char *title, *signature, *array;
    char letter;  ///< names the matrix
    CodeLines lines;
    MatrixCells cells;
    std::span<const widgets::LetterRole> roles;
};

Role role_of(std::string_view word) {
    if (word.starts_with("lightpos[")) return Role::light;
    if (word.starts_with("plane[")) return Role::plane;
    return Role::none;
}

void draw_code(ImDrawList* draw, ImVec2 at, std::string_view code) {
    while (!code.empty()) {
        const std::size_t blank = code.find(' ');
        std::string_view word = code.substr(0, blank);
        code.remove_prefix(std::min(code.size(), word.size() + 1));
        const char* end = word.data() + word.size();
        draw->AddText(at, palette().of(role_of(word)), word.data(), end);
        at.x += ImGui::CalcTextSize(word.data(), end).x + ImGui::CalcTextSize(" ").x;
    }
}

/// Breaks code at spaces; continuation rows are indented.
std::vector<std::string> rows_of(std::string_view code, std::size_t columns) {
    std::vector<std::string> rows;
    std::string row;
    while (!code.empty()) {
        const std::string_view word = code.substr(0, code.find(' '));
        code.remove_prefix(std::min(code.size(), word.size() + 1));
        if (!row.empty() && row.size() + 1 + word.size() > columns) {
            rows.push_back(row);
            row = "   ";
        }
        row += (row.empty() ? "" : " ") + std::string(word);
    }
    rows.push_back(row);
    return rows;
}

/// Draws a line of code, with its number at the right end, as one item.
void code_item(const Writing& writing, const std::string& code, const std::string& number) {
    std::vector<std::string> rows = rows_of(code, static_cast<std::size_t>(writing.columns));
    const std::string note = number.empty() ? "" : writing.before + number;
    const std::size_t room = static_cast<std::size_t>(writing.columns);
    if (!note.empty() && rows.back().size() + 1 + character_count(note) > room) rows.emplace_back();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, row_height = ImGui::GetTextLineHeight() + px(1.0F);
    ImGui::Dummy({width, row_height * static_cast<float>(rows.size())});
    ImDrawList* draw = ImGui::GetWindowDrawList();
    for (std::size_t row = 0; row < rows.size(); ++row)
        draw_code(draw, {at.x, at.y + row_height * static_cast<float>(row)}, rows[row]);
    if (note.empty()) return;
    const float digit = ImGui::CalcTextSize("0").x, number_width = digit * static_cast<float>(character_count(number));
    const float y = at.y + row_height * static_cast<float>(rows.size() - 1), x = at.x + width - number_width;
    draw->AddText({x - digit * static_cast<float>(std::strlen(writing.before)), y}, palette().quiet, writing.before);
    draw->AddText({x, y}, palette().text, number.c_str());
}

/// Highlights the item and its matrix entry when either is hovered.
void follow_entry(Links own, Links links) {
    const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
    if (widgets::FollowEntry(own, links))
        ImGui::GetWindowDrawList()->AddRectFilled({min.x - px(3.0F), min.y}, {max.x + px(3.0F), max.y},
                                                  with_alpha(palette().accent, 61), px(3.0F));
}

std::string code_of(const Function& function, const CodeLine& line, bool names_array) {
    return std::string(names_array ? function.array : "") + "[" + std::to_string(line.index) +
           "] = " + line.expression + ";";
}

std::string place_of(const Function& function, const CodeLine& line) {
    return say("Row {row}, column {column} of {matrix}: OpenGL reads the array column by column.",
               "row"_a = line.row + 1, "column"_a = line.column + 1, "matrix"_a = function.letter);
}

void draw_line(const Function& function, const CodeLine& line, const Writing& writing) {
    const widgets::MatrixCell& cell = function.cells[4 * line.row + line.column];
    const std::string target = std::string("matrix:") + function.letter + "[" + std::to_string(line.row) + "][" +
                               std::to_string(line.column) + "]";
    const bool is_covered = widgets::IsCovered(target);
    code_item(writing, code_of(function, line, writing.names_array), is_covered ? "?" : number_text(line.value, 3));
    widgets::MarkLine(target);
    if (is_covered) return;
    follow_entry(cell.own, cell.links);
    const std::string name = std::string(function.array) + "[" + std::to_string(line.index) + "]";
    widgets::Record(name.c_str());
    widgets::Tooltip(name.c_str(), place_of(function, line).c_str(), cell.symbol, "", function.roles);
}

/// Returns the largest style in which no line wraps, or the smallest style if lines wrap in all of them.
Writing writing_for(const Function& function, float width) {
    const widgets::Fonts& fonts = widgets::CurrentContext().fonts;
    Writing writings[] = {{fonts.number, 0, true, "// = "},
                          {fonts.small_number, 0, true, "// = "},
                          {fonts.small_number, 0, true, ""},
                          {fonts.small_number, 0, false, ""}};
    for (Writing& writing : writings) {
        ImGui::PushFont(writing.font);
        writing.columns = std::max(1, static_cast<int>(width / ImGui::CalcTextSize("0").x));
        ImGui::PopFont();
        std::size_t longest = 0;
        for (const CodeLine& line : function.lines)
            longest = std::max(longest, code_of(function, line, writing.names_array).size() + 1 +
                                            character_count(writing.before + number_text(line.value, 3)));
        if (longest <= static_cast<std::size_t>(writing.columns)) return writing;
    }
    return writings[std::size(writings) - 1];
}

void title(const Function& function) {
    ImGui::AlignTextToFramePadding();
    ImGui::PushFont(widgets::CurrentContext().fonts.heading);
    ImGui::TextUnformatted(function.title);
    ImGui::PopFont();
}

/// Draws the lines of code. `dot`: the dot product of plane and light, which only S's code computes; nullopt for R.
void draw_lines(const Function& function, std::optional<double> dot) {
    const Writing writing = writing_for(function, ImGui::GetContentRegionAvail().x);
    ImGui::PushFont(writing.font);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0F, 0.0F});
    code_item(writing, function.signature, "");
    if (dot) {
        code_item(
            writing,
            "dot = plane[0] * lightpos[0] + plane[1] * lightpos[1] + plane[2] * lightpos[2] + plane[3] * lightpos[3];",
            widgets::IsCovered("fact:plane_dot_light") ? "?" : number_text(*dot, 3));
        follow_entry(0, link::all_light | link::all_plane);
        widgets::Record("dot");
        widgets::MarkTarget("fact:plane_dot_light");
    }
    for (const CodeLine& line : function.lines) draw_line(function, line, writing);
    ImGui::PopStyleVar();
    ImGui::PopFont();
    ImGui::Dummy({0.0F, px(4.0F)});
}

void shadow_function(const Derived& derived) {
    const CastShadow& cast = derived.chosen_shadow();
    const Function function{"ShadowMatrix",
                            "void ShadowMatrix(GLfloat shadowMat[16], GLfloat plane[4], GLfloat lightpos[4])",
                            "shadowMat",
                            'S',
                            shadow_code(derived.chosen_plane().unit_plane, cast.light_world),
                            shadow_cells(),
                            shadow_roles()};
    title(function);
    widgets::Note("The code fills the array column by column. The plane has a unit normal.");
    if (cast.has_slip) widgets::Trouble("Mistake: S is filled by rows, not by this code.");
    if (cast.by_hand) widgets::Trouble("S was entered by hand; it does not come from this code.");
    draw_lines(function, cast.plane_dot_light);
}

/// Draws the switch that fills R row by row, as the slide does, and a sentence that says how GL reads the array.
void order_switch(Params& params, double d) {
    if (widgets::Offers("control:reflection.printed_by_rows"))
        control(params, "reflection.printed_by_rows", {.label = marked("R as printed on the slide")});
    if (!params.reflection.printed_by_rows)
        widgets::Note(
            "OpenGL reads an array column by column. ReflectionMatrix on the slide fills it row by row; the code here "
            "is corrected.");
    else if (d == 0.0 && !widgets::IsCovered("sentences"))
        widgets::Note(
            "The slide fills the array row by row, but OpenGL reads it column by column and gets Rᵀ. That is correct "
            "only because d = 0 here: the rest of R is symmetric.");
    else if (!widgets::IsCovered("sentences"))
        widgets::Trouble(
            "The slide fills the array row by row, but OpenGL reads it column by column and gets Rᵀ. With d ≠ 0, the "
            "translation (−2ad, −2bd, −2cd) lands in the bottom row, and w is no longer 1.");
}

void mirror_function(const Params& params, const Derived& derived) {
    const bool printed = params.reflection.printed_by_rows;
    const SlipParams& slips = params.slips;
    const glm::dvec4& plane =
        slips.normal_not_unit ? params.planes[derived.chosen.plane].equation : derived.chosen_plane().unit_plane;
    const Function function{"ReflectionMatrix",
                            "void ReflectionMatrix(GLfloat reflectionMat[16], GLfloat plane[4])",
                            "reflectionMat",
                            'R',
                            mirror_code(plane, printed, slips.plus_2ab),
                            mirror_cells(printed, slips.plus_2ab),
                            mirror_roles()};
    title(function);
    widgets::Note(printed ? marked("Filled by rows.") : marked("Filled by columns."));
    if (slips.normal_not_unit) widgets::Trouble("Mistake: plane[] is used as typed, not divided by |n|.");
    if (slips.plus_2ab) widgets::Trouble("Mistake: row 2, column 1 has lost its minus sign.");
    if (derived.chosen_plane().mirror_by_hand)
        widgets::Trouble("R was entered by hand; it does not come from this code.");
    draw_lines(function, std::nullopt);
}

}  // namespace

void draw_lecture_code(Session& session, const Derived& derived, const Rect& rect) {
    const widgets::Group group("code");
    ImGui::SetCursorScreenPos(rect.min);
    ImGui::PushStyleColor(ImGuiCol_ChildBg, palette().raised);
    ImGui::BeginChild("lecture code", {rect.width(), rect.height()}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
    order_switch(session.params, derived.chosen_plane().unit_plane.w);
    const bool side_by_side = rect.width() >= px(840.0F);
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {px(10.0F), 0.0F});
    const auto function = [&rect](const char* target, const auto& draw) {
        ImGui::TableNextColumn();
        const ImVec2 from = ImGui::GetCursorScreenPos();
        const float width = ImGui::GetContentRegionAvail().x;
        if (widgets::IsCovered(target))
            widgets::Plate(target, {width, 0.45F * rect.height()});
        else
            draw();
        widgets::MarkTarget(target, from, {from.x + width, ImGui::GetCursorScreenPos().y});
    };
    if (ImGui::BeginTable("functions", side_by_side ? 2 : 1, ImGuiTableFlags_SizingStretchSame)) {
        function("code:lecture.shadow", [&] { shadow_function(derived); });
        function("code:lecture.mirror", [&] { mirror_function(session.params, derived); });
        ImGui::EndTable();
    }
    ImGui::PopStyleVar();
    widgets::CountScrolled();
    ImGui::EndChild();
    ImGui::PopStyleColor();
}

}  // namespace viewing
