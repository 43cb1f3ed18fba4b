// Shared parts of the panel's sections.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

#include "frame/problems.h"
#include "ui/parts/look.h"

namespace viewing {

/// The tone of a problem's sentence.
inline widgets::Tone tone_of(ProblemKind kind) {
    return static_cast<widgets::Tone>(kind);
}

/// Draws a section's header with the icon of the worst problem in the given groups of fields. `more` describes one more
/// problem, which counts as an error. Returns whether the section is open.
inline bool section(const char* label, const std::vector<Problem>& problems,
                    std::initializer_list<std::string_view> groups, const std::string& more = "") {
    std::string sentences;
    ProblemKind worst = more.empty() ? ProblemKind::about_window : ProblemKind::wrong;
    for (const Problem& problem : problems) {
        const bool is_told = std::find(groups.begin(), groups.end(), problem.group) != groups.end();
        if (!is_told || widgets::IsCovered("sentences")) continue;
        sentences += (sentences.empty() ? "" : "\n") + say(problem.sentence);
        worst = std::min(worst, problem.kind);
    }
    if (!more.empty()) sentences += (sentences.empty() ? "" : "\n") + more;
    return widgets::Section(label, true, "", sentences.c_str(), tone_of(worst));
}

constexpr float second_column = 142.0F;  ///< design pixels

/// Places the cursor for a second control `width` pixels wide: at `design_x` in the same row, or in the next row if the
/// first control reaches into that column or the second one does not fit.
inline void beside(float design_x, float width) {
    if (widgets::IsListing()) return;  // each control has its own row
    const float left = ImGui::GetWindowPos().x + px(design_x);
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    if (ImGui::GetItemRectMax().x < left && left + width <= right) ImGui::SameLine(px(design_x));
}

/// Places the cursor for an item `width` pixels wide: after the last item if it fits there, otherwise below it.
inline void behind(float width) {
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    if (ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x + width <= right) ImGui::SameLine();
}

/// Draws a foldable header for rarely used controls; opens it if one of `targets` is sought (widgets::IsSought).
/// Returns whether it is open.
inline bool details(const char* label, std::span<const char* const> targets = {}) {
    if (widgets::IsListing()) return true;
    if (widgets::IsSought(targets)) ImGui::SetNextItemOpen(true);
    const bool open = ImGui::TreeNodeEx(widgets::BrokenLabelText(label, ImGui::GetTreeNodeToLabelSpacing()).c_str(),
                                        ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_NoTreePushOnOpen);
    widgets::Record(label);
    return open;
}

/// Draws a line of muted text that lessons refer to as `target`, or a plate if that target is covered. Returns whether
/// the line is visible.
inline bool named_note(const char* target, const std::string& text) {
    const bool is_covered = widgets::IsCovered(target);
    if (is_covered)
        widgets::Plate("note", {ImGui::GetContentRegionAvail().x, widgets::CurrentContext().fonts.note->FontSize});
    else
        widgets::Note(text.c_str());
    widgets::MarkTarget(target);
    return !is_covered;
}

/// Calls `draw`, which draws a section of the panel with its header. Lessons refer to the section by `name`. Opens the
/// section if it or one of `targets` is sought; if it is covered, draws a plate instead.
template <typename Draw>
void named_section(const char* name, std::initializer_list<const char*> targets, const Draw& draw) {
    if (widgets::IsListing()) return draw();
    const std::string target = std::string("section:") + name;
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    if (widgets::IsCovered(target)) {
        widgets::Plate(name, {width, ImGui::GetFrameHeight()});
    } else {
        const char* const self[] = {target.c_str()};
        if (widgets::IsSought(self) || widgets::IsSought({targets.begin(), targets.size()})) widgets::OpenNextSection();
        draw();
    }
    widgets::MarkTarget(target, from, {from.x + width, ImGui::GetCursorScreenPos().y});
}

}  // namespace viewing
