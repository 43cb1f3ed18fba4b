// An area of a window that is drawn freely, inside the library. Read tree_diagram.cpp for its use.
#pragma once

#include "widgets/inner.h"

namespace widgets::inner {

/// A child window without look that keeps the wheel from scrolling what is around it; its upper left corner is
/// ImGui::GetWindowPos().
struct WheelArea {
    WheelArea(const char* id, ImVec2 size);
    ~WheelArea();
    WheelArea(const WheelArea&) = delete;
    WheelArea& operator=(const WheelArea&) = delete;
    ImVec2 min, max;
};

/// A quiet sentence in the middle of an area with nothing in it.
void DrawHint(ImDrawList* draw, ImVec2 min, ImVec2 max, std::string_view sentence);

}  // namespace widgets::inner
