// What the panel's sections share.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>

#include "frame/problems.h"
#include "ui/parts/look.h"

namespace viewing {

/// What is wrong in some groups of fields, a line each, for the sign on their section.
inline std::string troubles(const std::vector<Problem>& problems, std::initializer_list<std::string_view> groups) {
    std::string sentences;
    for (const Problem& problem : problems)
        if (std::find(groups.begin(), groups.end(), problem.group) != groups.end())
            sentences += (sentences.empty() ? "" : "\n") + problem.sentence;
    return sentences;
}

/// Places the cursor for a second control `width` pixels wide: in the same row, at a fixed column; below where the
/// first one reaches into that column or the second has no room there.
inline void beside(float design_x, float width) {
    const float left = ImGui::GetWindowPos().x + px(design_x);
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    if (ImGui::GetItemRectMax().x < left && left + width <= right) ImGui::SameLine(px(design_x));
}

/// Places the cursor for an item `width` pixels wide: behind the last one where there is room, else below it.
inline void behind(float width) {
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    if (ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x + width <= right) ImGui::SameLine();
}

/// What is wanted less often stays folded. Returns whether it is open.
inline bool details(const char* label) {
    const bool open = ImGui::TreeNodeEx(widgets::BrokenLabelText(label, ImGui::GetTreeNodeToLabelSpacing()).c_str(),
                                        ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_NoTreePushOnOpen);
    widgets::Record(label);
    return open;
}

}  // namespace viewing
