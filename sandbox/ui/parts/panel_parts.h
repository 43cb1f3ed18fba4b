// What the panel's sections share.
#pragma once

#include <string_view>

#include "frame/problems.h"
#include "ui/parts/look.h"

namespace viewing {

inline void tell_problems(const std::vector<Problem>& problems, std::string_view group) {
    for (const Problem& problem : problems)
        if (problem.group == group) widgets::Trouble(problem.sentence.c_str());
}

/// A second control in the same row, at a fixed column.
inline void beside(float design_x) {
    ImGui::SameLine(px(design_x));
}

/// What is wanted less often stays folded. Returns whether it is open.
inline bool details(const char* label) {
    const bool open = ImGui::TreeNodeEx(widgets::LabelText(label).c_str(),
                                        ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_NoTreePushOnOpen);
    widgets::Record(label);
    return open;
}

}  // namespace viewing
