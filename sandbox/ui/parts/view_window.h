// The window of a view that shows no rendered picture, and the message that a view draws if it has nothing to show.
#pragma once

#include <string>

#include "ui/parts/layout.h"

namespace viewing {

/// A view's child window over its rectangle, with the views' background. Closes at the end of its scope.
struct ViewWindow {
    ViewWindow(const char* name, const Rect& rect, ImGuiWindowFlags flags = 0);
    ~ViewWindow();
    ViewWindow(const ViewWindow&) = delete;
    ViewWindow& operator=(const ViewWindow&) = delete;

private:
    bool never_scrolls_;
    int counted_before_;  ///< number of scrolling windows before this one
};

/// Returns the height in pixels of a widgets::Note with this text, wrapped to a width in pixels; 0 means the available
/// width.
float note_height(const char* text, float width_px = 0.0F);

/// Draws a sentence in muted text and records it for tests; does nothing if it is empty.
void recorded_note(const std::string& sentence);

/// Draws a sentence in the middle of the view and, unless `button` is null, a button below it; translates both. Returns
/// whether the button was clicked.
bool offer(const char* english, const char* button = nullptr);

}  // namespace viewing
