// A view that is drawn by the user interface alone: its window, and what it says where it has nothing to show.
#pragma once

#include <string>

#include "ui/parts/layout.h"

namespace viewing {

/// A view's child window over its rectangle, on the views' ground; ends with its scope.
struct ViewWindow {
    ViewWindow(const char* name, const Rect& rect, ImGuiWindowFlags flags = 0);
    ~ViewWindow();
    ViewWindow(const ViewWindow&) = delete;
    ViewWindow& operator=(const ViewWindow&) = delete;

private:
    bool never_scrolls_;
    int counted_before_;  ///< windows that scroll
};

/// How high a widgets::Note is in the room that there is, pixels.
float note_height(const char* text);

/// A quiet sentence that tests find by its words; nothing where it is empty.
void recorded_note(const std::string& sentence);

/// A sentence in the middle of the view and, unless null, a button below it, both looked up here. True when it was
/// clicked.
bool offer(const char* english, const char* button = nullptr);

}  // namespace viewing
