// A freely drawn area of a window, internal to the library. See tree_diagram.cpp for an example.
#pragma once

#include "widgets/inner.h"

namespace widgets::inner {

/// An invisible child window that keeps the wheel from scrolling its parent. Its upper left corner is
/// ImGui::GetWindowPos().
struct WheelArea {
    WheelArea(const char* id, ImVec2 size);
    ~WheelArea();
    WheelArea(const WheelArea&) = delete;
    WheelArea& operator=(const WheelArea&) = delete;
    ImVec2 min, max;
};

/// Draws a sentence in muted text in the middle of an empty area.
void DrawHint(ImDrawList* draw, ImVec2 min, ImVec2 max, std::string_view sentence);

}  // namespace widgets::inner
