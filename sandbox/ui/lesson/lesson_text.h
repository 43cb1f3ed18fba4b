// Texts of lessons, set in lines.
#pragma once

#include <string>

#include "lesson/lesson.h"
#include "widgets/widgets.h"

namespace viewing {

/// A paragraph in a font of its own size.
struct Paragraph {
    std::string lines;  ///< broken at blanks
    ImFont* font = nullptr;
    float height = 0.0F;

    /// Draws it and moves the cursor below; recorded under `label`.
    void draw(const char* label, ImU32 color) const;
};
/// Also outside a frame.
Paragraph paragraph(const std::string& text, ImFont* font, float width);

}  // namespace viewing
