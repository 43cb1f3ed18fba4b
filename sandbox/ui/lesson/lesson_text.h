// Lesson texts, broken into lines.
#pragma once

#include <string>

#include "lesson/lesson.h"
#include "widgets/widgets.h"

namespace viewing {

/// A paragraph in a font at the font's own size.
struct Paragraph {
    std::string lines;  ///< broken at spaces
    ImFont* font = nullptr;
    float height = 0.0F;

    /// Draws the text, moves the cursor below it, and records it under `label`.
    void draw(const char* label, ImU32 color) const;
};
/// Breaks a text into lines; also works outside a frame.
Paragraph paragraph(const std::string& text, ImFont* font, float width);

}  // namespace viewing
