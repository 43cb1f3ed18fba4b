// Common parts of full-window pages: lessons, steps, exercises.
#pragma once

#include <string>

#include "ui/lesson/cards.h"
#include "ui/lesson/lesson_text.h"
#include "ui/views/views.h"

namespace viewing {

/// A full-window page that is open for the lifetime of this object.
class Page {
public:
    explicit Page(const char* name);
    ~Page();
    Page(const Page&) = delete;
    Page& operator=(const Page&) = delete;
};

/// Draws a page's heading. `room`: the width to keep free at the right end of the line, in design pixels.
void page_heading(const std::string& text, const char* label, float room = 180.0F);

/// Draws a button at the right end of the current line.
bool button_at_right(const char* label);

/// Returns a card's picture, or null if there is none yet.
ImTextureID texture_in(const Pictures& pictures, const std::string& key);

}  // namespace viewing
