#include "topics/planes/shown/derivation_text.h"

#include <algorithm>
#include <array>
#include <limits>

#include "text/catalogue.h"
#include "text/words.h"
#include "ui/parts/look.h"

namespace viewing {
namespace {

constexpr int decimals = 3;

/// The position and length of a text's first primed symbol. If there is none, the position is the end of the text, and
/// the length is 0.
struct Found {
    std::size_t begin, length;
};
Found primed_symbol(const std::string& text) {
    static constexpr std::array<std::string_view, 4> symbols = {"q′", "x_0′", "y_0′", "z_0′"};
    Found found{text.size(), 0};
    for (const std::string_view symbol : symbols)
        if (const std::size_t at = text.find(symbol); at < found.begin) found = {at, symbol.size()};
    return found;
}

/// Draws a part, or only measures it if `draw` is null. Returns its width.
float formula(ImDrawList* draw, ImVec2 at, std::string part) {
    const float from = at.x;
    while (!part.empty()) {
        const Found found = primed_symbol(part);
        const std::string before = part.substr(0, found.begin), symbol = part.substr(found.begin, found.length);
        at.x += widgets::Formula(draw, at, before.c_str(), derivation_roles(), palette().text).x;
        at.x += widgets::Formula(draw, at, symbol.c_str(), {}, palette().mirror).x;
        part.erase(0, found.begin + found.length);
    }
    return at.x - from;
}

}  // namespace

std::span<const widgets::LetterRole> derivation_roles() {
    using widgets::Role;
    static constexpr widgets::LetterRole roles[] = {
        {'l', Role::light}, {'L', Role::light}, {'s', Role::light}, {'n', Role::plane}, {U'Π', Role::plane},
        {'a', Role::plane}, {'b', Role::plane}, {'c', Role::plane}, {'d', Role::plane}, {'p', Role::point},
        {'q', Role::point}, {'x', Role::point}, {'y', Role::point}, {'z', Role::point}};
    return roles;
}

std::string derivation_number(double value) {
    return number_text(value, decimals);
}

std::string derivation_vector(const glm::dvec3& value) {
    std::string text = "(";
    for (int axis = 0; axis < 3; ++axis) {
        const std::string number = derivation_number(value[axis]);
        text.append(std::size_t{7} - std::min(character_count(number), std::size_t{7}), ' ').append(number);
        text += axis < 2 ? "," : ")";
    }
    return text;
}

namespace {

/// Lays out the parts of an equation, and draws them unless `draw` is null. Returns the size in pixels, without the
/// space below it; a part wider than `room` increases the width.
ImVec2 rows(ImDrawList* draw, const std::vector<std::string>& parts, float room) {
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float below = ImGui::GetStyle().ItemSpacing.y;
    const float line = ImGui::GetTextLineHeight() + below, blank = ImGui::CalcTextSize(" ").x;
    ImVec2 at = from;
    float indent = 0.0F, right = from.x;
    for (const std::string& part : parts) {
        if (part.empty()) continue;
        const std::string shown(tr_part(part));
        const float width = formula(nullptr, at, shown);
        if (indent > 0.0F && at.x > from.x + indent && at.x + width > from.x + room)
            at = {from.x + indent, at.y + line};
        if (draw) formula(draw, at, shown);
        right = std::max(right, at.x + width);
        at.x += width + blank;
        if (indent == 0.0F) indent = at.x - from.x;
    }
    return {right - from.x, at.y + line - from.y - below};
}

ImFont* font_for(float room, bool is_small) {
    const widgets::Fonts& fonts = widgets::CurrentContext().fonts;
    return is_small || room < px(400.0F) ? fonts.small_number : fonts.number;
}

ImFont* heading_font(bool is_small) {
    const widgets::Fonts& fonts = widgets::CurrentContext().fonts;
    return is_small ? fonts.note : fonts.heading;
}

}  // namespace

void equation(const std::vector<std::string>& parts, float width_px, bool is_small) {
    const float room = width_px > 0.0F ? width_px : ImGui::GetContentRegionAvail().x;
    ImGui::PushFont(font_for(room, is_small));
    const float height = rows(ImGui::GetWindowDrawList(), parts, room).y;
    ImGui::PopFont();
    std::string recorded;
    for (const std::string& part : parts)
        if (!part.empty()) recorded += (recorded.empty() ? "" : " ") + part;
    ImGui::Dummy({room, height});
    widgets::Record(recorded.c_str());
}

float equation_height(const std::vector<std::string>& parts, float width_px, bool is_small) {
    ImGui::PushFont(font_for(width_px, is_small));
    const ImVec2 size = rows(nullptr, parts, width_px);
    ImGui::PopFont();
    return size.x <= width_px ? size.y : std::numeric_limits<float>::infinity();
}

void derivation_heading(const char* text, bool is_small) {
    if (!is_small) ImGui::Dummy({0.0F, px(2.0F)});
    ImGui::PushFont(heading_font(is_small));
    ImGui::TextUnformatted(widgets::BrokenAtBlanks(tr(text), ImGui::GetContentRegionAvail().x).c_str());
    ImGui::PopFont();
    widgets::Record(text);
}

float heading_height(const char* text, float width_px, bool is_small) {
    ImGui::PushFont(heading_font(is_small));
    const float lines = ImGui::CalcTextSize(widgets::BrokenAtBlanks(tr(text), width_px).c_str()).y;
    ImGui::PopFont();
    return is_small ? lines : px(2.0F) + ImGui::GetStyle().ItemSpacing.y + lines;
}

}  // namespace viewing
