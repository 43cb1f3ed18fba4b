// The demo's window: every widget once, with what it edits. Read show_demo.cpp as the library's manual.
#pragma once

#include "widgets/widgets.h"

namespace widgets {

/// What the demo itself can change about how everything looks.
struct DemoLook {
    ThemeKind theme = ThemeKind::dark;
    float scale = 1.0F;
};

/// Fills the display. Call between widgets::NewFrame and ImGui::Render; a change of `look` is for the caller to apply.
void ShowWidgetsDemo(DemoLook& look);
/// The part of it with the diagrams: a tree, its steps, costs.
void ShowDiagramsDemo();
/// The part of it about the depth buffer: precision, codes, counts, pixels one by one, two pictures in one area.
void ShowDepthDemo();

}  // namespace widgets
