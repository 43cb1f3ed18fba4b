#include "ui/planes/derivation_text.h"

#include <algorithm>
#include <array>

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

void equation(const std::vector<std::string>& parts, float width_px) {
    const widgets::Context& context = widgets::CurrentContext();
    const float room = width_px > 0.0F ? width_px : ImGui::GetContentRegionAvail().x;
    ImGui::PushFont(room < px(400.0F) ? context.fonts.small_number : context.fonts.number);
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float line = ImGui::GetTextLineHeight() + px(3.0F), blank = ImGui::CalcTextSize(" ").x;
    ImVec2 at = from;
    float indent = 0.0F;
    std::string recorded;
    for (const std::string& part : parts) {
        if (part.empty()) continue;
        const std::string shown(tr_part(part));
        const float width = formula(nullptr, at, shown);
        if (indent > 0.0F && at.x > from.x + indent && at.x + width > from.x + room)
            at = {from.x + indent, at.y + line};
        formula(ImGui::GetWindowDrawList(), at, shown);
        at.x += width + blank;
        if (indent == 0.0F) indent = at.x - from.x;
        recorded += (recorded.empty() ? "" : " ") + part;
    }
    ImGui::PopFont();
    ImGui::Dummy({room, at.y + line - from.y - ImGui::GetStyle().ItemSpacing.y});
    widgets::Record(recorded.c_str());
}

void derivation_heading(const char* text) {
    ImGui::Dummy({0.0F, px(2.0F)});
    ImGui::PushFont(widgets::CurrentContext().fonts.heading);
    ImGui::TextUnformatted(tr(text));
    ImGui::PopFont();
    widgets::Record(text);
}

}  // namespace viewing
