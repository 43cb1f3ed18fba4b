#include "topics/matrices/shown/shown_matrix.h"

#include <algorithm>
#include <cmath>

#include "frame/matrix_facts.h"
#include "text/catalogue.h"
#include "text/numbers.h"
#include "text/words.h"
#include "topics/matrices/numbers/matrix_text.h"
#include "ui/parts/drawn_subscripts.h"
#include "ui/parts/look.h"
#include "ui/parts/table_parts.h"

namespace viewing {

using widgets::Role;

std::string identity_text(const char* identity, double residual) {
    if (residual == 0.0) return std::string(identity) + " ± 0";
    if (residual > 1e-3) {
        std::string broken = identity;
        return broken.replace(broken.find(" = "), 3, " ≠ ");
    }
    const int exponent = static_cast<int>(std::ceil(-std::log10(residual)));
    return std::string(identity) + " ± 10⁻" + raised_text(exponent);
}

float place_at_right(const char* button) {
    if (!widgets::OffersButton(button)) return ImGui::GetContentRegionMax().x;
    return ImGui::GetContentRegionMax().x - std::max(px(52.0F), widgets::SmallButtonWidth(button));
}

bool matrix_heading(const char* title, const char* letter, const std::string& note, Role role, float right) {
    const widgets::Context& context = widgets::CurrentContext();
    ImGui::AlignTextToFramePadding();
    ImGui::PushFont(context.fonts.heading);
    ImGui::TextUnformatted(tr(title));
    ImGui::SameLine(0.0F, px(6.0F));
    ImGui::PushStyleColor(ImGuiCol_Text, context.palette.of(role));
    ImGui::TextUnformatted(letter);
    ImGui::PopStyleColor();
    ImGui::PopFont();
    const float left = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x + px(10.0F);
    if (left + width_of(note, context.fonts.note) > right) return false;
    ImGui::SameLine(left);
    ImGui::AlignTextToFramePadding();
    ImGui::PushFont(context.fonts.note);
    ImGui::PushStyleColor(ImGuiCol_Text, context.palette.quiet);
    text_with_subscripts(note, ImGui::GetStyle().FramePadding.y);
    ImGui::PopStyleColor();
    ImGui::PopFont();
    return true;
}

namespace {

constexpr const char* paste_label = marked("Paste from the clipboard");
/// The reason why a covered matrix cannot be copied.
constexpr const char* covered_text = marked("Hidden until answered.");

void copy_menu(const ShownMatrix& shown, bool is_covered, char& pastes) {
    struct Entry {
        const char* label;
        MatrixFormat format;
    };
    static constexpr Entry entries[] = {{marked("GLM (column-major)"), MatrixFormat::glm},
                                        {marked("GLSL (column-major)"), MatrixFormat::glsl},
                                        {"NumPy", MatrixFormat::numpy},
                                        {"MATLAB", MatrixFormat::matlab},
                                        {"LaTeX", MatrixFormat::latex},
                                        {marked("plain text"), MatrixFormat::text}};
    if (!widgets::OffersButton("Copy")) return;
    ImGui::PushID(shown.name);
    ImGui::SameLine(place_at_right("Copy"));
    if (widgets::SmallButton("Copy", !is_covered, covered_text)) ImGui::OpenPopup("copy");
    if (!is_covered)
        widgets::Tooltip(
            "Copy", "Copies this matrix to the clipboard with all its digits, or pastes another one in its place.");
    if (ImGui::BeginPopup("copy")) {
        widgets::ClosePopupOnEscape();
        for (const Entry& entry : entries) {
            if (ImGui::MenuItem(widgets::LabelText(entry.label).c_str()))
                ImGui::SetClipboardText(matrix_text(shown.name, shown.now, entry.format).c_str());
            widgets::Record(entry.label);
        }
        ImGui::Separator();
        if (ImGui::MenuItem(widgets::LabelText(paste_label).c_str())) pastes = *shown.letter;
        widgets::Record(paste_label);
        widgets::Tooltip("Paste from the clipboard",
                         "Reads GLM, NumPy, MATLAB, C, JSON, LaTeX or plain text. A correct matrix is used; for any "
                         "other, a dialog says what it is. Ctrl+V does the same.");
        ImGui::EndPopup();
    }
    ImGui::PopID();
}

/// Hides the whole note if any of its facts is covered.
std::string told_fact(const std::string& note, std::span<const char* const> facts) {
    return std::any_of(facts.begin(), facts.end(), widgets::IsCovered) ? "?" : note;
}

void mark_facts(std::span<const char* const> facts) {
    for (const char* fact : facts) widgets::MarkTarget(fact);
}

}  // namespace

const char* show_matrix(ShownMatrix shown, const std::string& fact, std::span<const char* const> buttons, char& pastes,
                        std::optional<glm::dmat4>* by_hand) {
    const char* pressed = nullptr;
    const std::string target = "matrix:" + std::string(shown.letter);
    const bool is_covered = widgets::IsCovered(target), is_part_covered = widgets::IsPartCovered(target);
    const bool tells_difference = !is_part_covered && !widgets::IsCovered("sentences");
    std::string note = is_covered ? "" : told_fact(fact, shown.facts), explains = tr(shown.explains);
    if (by_hand && is_part_covered) buttons = buttons.first(buttons.size() - 1);  // omit Edit or Release
    if (by_hand && *by_hand && !tells_difference) note = tr("by hand");
    if (by_hand && *by_hand && tells_difference) {
        const double difference = largest_difference_up_to_scale(**by_hand, shown.derived);
        note = say("off by {difference}", "difference"_a = figures(difference, 3));
        explains =
            shown.property.empty()
                ? say("Entered by hand: the camera and its projection have no effect here. Apart from scale, the "
                      "largest difference from the correct {matrix} is {difference}.",
                      "matrix"_a = shown.letter, "difference"_a = number_text(difference, 3))
                : say("Entered by hand: light and plane have no effect here. Apart from scale, the largest difference "
                      "from the correct {matrix} is {difference}; {property}.",
                      "matrix"_a = shown.letter, "difference"_a = number_text(difference, 3),
                      "property"_a = shown.property);
    }
    ImGui::PushID(shown.name);
    mark_changed(shown.cells, shown.now, shown.before);
    const auto room_of = [](const char* button) {
        return widgets::OffersButton(button) ? widgets::SmallButtonWidth(button) + px(4.0F) : 0.0F;
    };
    float end = place_at_right("Copy") - px(6.0F);
    for (const char* button : buttons) end -= room_of(button);
    const bool has_note = matrix_heading(shown.title, shown.heading.empty() ? shown.letter : shown.heading.c_str(),
                                         note, shown.role, end);
    if (has_note) mark_facts(shown.facts);
    if (tells_difference) widgets::Tooltip(shown.name, explains.c_str());
    float right = place_at_right("Copy") - px(4.0F);
    for (const char* button : buttons) {
        if (!widgets::OffersButton(button)) continue;
        right -= room_of(button);
        ImGui::SameLine(right);
        if (widgets::SmallButton(button)) pressed = button;
    }
    copy_menu(shown, is_part_covered, pastes);
    if (!has_note) {
        widgets::Note(note.c_str());
        mark_facts(shown.facts);
        if (tells_difference) widgets::Tooltip(shown.name, explains.c_str());
    }
    if (by_hand && *by_hand) {
        for (widgets::MatrixCell& cell : shown.cells) cell.links = cell.own = 0;
        const widgets::MatrixStyle style{.cells = shown.cells,
                                         .roles = shown.roles,
                                         .editable = true,
                                         .overridden = true,
                                         .defaults = &shown.derived,
                                         .target = target.c_str()};
        widgets::Matrix(shown.letter, **by_hand, style);
    } else {
        const widgets::MatrixStyle style{.cells = shown.cells, .roles = shown.roles, .target = target.c_str()};
        const glm::dmat4& value = shown.now;
        widgets::Matrix(shown.letter, value, style);
    }
    ImGui::Dummy({0.0F, px(1.0F)});
    ImGui::PopID();
    return pressed;
}

bool show_overridable(const ShownMatrix& shown, const std::string& note, std::optional<glm::dmat4>& by_hand,
                      char& pastes, const char* other_button) {
    const char* const buttons[] = {other_button, by_hand ? marked("Release") : marked("Edit")};
    const char* const pressed =
        show_matrix(shown, note, std::span(buttons).subspan(other_button ? 0 : 1), pastes, &by_hand);
    if (!pressed || pressed == other_button) return pressed != nullptr;
    if (by_hand)
        by_hand.reset();
    else
        by_hand = shown.now;
    return false;
}

}  // namespace viewing
