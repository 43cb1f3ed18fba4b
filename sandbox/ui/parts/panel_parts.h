// What the panel's sections share.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

#include "frame/problems.h"
#include "ui/parts/look.h"

namespace viewing {

/// What is wrong in some groups of fields, a line each, for the sign on their section.
inline std::string troubles(const std::vector<Problem>& problems, std::initializer_list<std::string_view> groups) {
    std::string sentences;
    if (widgets::IsCovered("sentences")) return sentences;
    for (const Problem& problem : problems)
        if (std::find(groups.begin(), groups.end(), problem.group) != groups.end())
            sentences += (sentences.empty() ? "" : "\n") + problem.sentence;
    return sentences;
}

constexpr float second_column = 142.0F;  ///< design pixels

/// Places the cursor for a second control `width` pixels wide: in the same row, at a fixed column; below where the
/// first one reaches into that column or the second has no room there.
inline void beside(float design_x, float width) {
    if (widgets::IsListing()) return;  // each has a row of its own
    const float left = ImGui::GetWindowPos().x + px(design_x);
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    if (ImGui::GetItemRectMax().x < left && left + width <= right) ImGui::SameLine(px(design_x));
}

/// Places the cursor for an item `width` pixels wide: behind the last one where there is room, else below it.
inline void behind(float width) {
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    if (ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x + width <= right) ImGui::SameLine();
}

/// What is wanted less often stays folded, unless one of these names is sought in it. Returns whether it is open.
inline bool details(const char* label, std::span<const char* const> targets = {}) {
    if (widgets::IsListing()) return true;
    if (widgets::IsSought(targets)) ImGui::SetNextItemOpen(true);
    const bool open = ImGui::TreeNodeEx(widgets::BrokenLabelText(label, ImGui::GetTreeNodeToLabelSpacing()).c_str(),
                                        ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_NoTreePushOnOpen);
    widgets::Record(label);
    return open;
}

/// A quiet line under its name for a lesson, which may be covered. Says whether it is there to be explained.
inline bool named_note(const char* target, const std::string& text) {
    const bool is_covered = widgets::IsCovered(target);
    if (is_covered)
        widgets::Plate("note", {ImGui::GetContentRegionAvail().x, widgets::CurrentContext().fonts.note->FontSize});
    else
        widgets::Note(text.c_str());
    widgets::MarkTarget(target);
    return !is_covered;
}

/// A section of the panel under its name for a lesson: folded out where one of `targets` is sought in it, a plate where
/// it is covered. `draw` draws it, headline and all.
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
