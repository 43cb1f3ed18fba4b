// The demo's window: every widget once, with the values it edits. Read show_demo.cpp as the library's manual.
#pragma once

#include "widgets/widgets.h"

namespace widgets {

/// Appearance settings that the demo itself can change.
struct DemoLook {
    ThemeKind theme = ThemeKind::dark;
    float scale = 1.0F;
};

/// Fills the display. Call between widgets::NewFrame and ImGui::Render. The caller applies changes to `look`.
void ShowWidgetsDemo(DemoLook& look);
/// Shows the part with the diagrams: a tree, its steps, costs.
void ShowDiagramsDemo();
/// Shows the part about the depth buffer: precision, codes, counts, single pixels, two pictures in one area.
void ShowDepthDemo();

}  // namespace widgets
