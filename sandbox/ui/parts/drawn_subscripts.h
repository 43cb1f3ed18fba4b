// Sentences with real subscripts (text/subscripts.h), drawn by Dear ImGui.
#pragma once

#include <imgui.h>

#include <string>

namespace viewing {

/// Draws lines of text; "\n" ends a line. Returns their size.
ImVec2 draw_with_subscripts(ImDrawList* draw, ImFont* font, ImVec2 corner, ImU32 color, const std::string& lines);

/// Draws such lines as an ImGui item, in the current font and color. `base`: how far below the cursor the text begins
/// if ImGui has aligned the line with framed text.
void text_with_subscripts(const std::string& lines, float base = 0.0F);

}  // namespace viewing
