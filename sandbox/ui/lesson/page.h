// What pages over the whole window have in common: lessons, steps, exercises.
#pragma once

#include <string>

#include "ui/lesson/cards.h"
#include "ui/lesson/lesson_text.h"
#include "ui/views/views.h"

namespace viewing {

/// A page over the whole window, as long as it lives.
class Page {
public:
    explicit Page(const char* name);
    ~Page();
    Page(const Page&) = delete;
    Page& operator=(const Page&) = delete;
};

/// `room`: what stands at the right end of its line, design pixels.
void page_heading(const std::string& text, const char* label, float room = 180.0F);

/// At the right end of the line that was begun.
bool button_at_right(const char* label);

/// The picture of a card; null while there is none.
ImTextureID texture_in(const Pictures& pictures, const std::string& key);

}  // namespace viewing
