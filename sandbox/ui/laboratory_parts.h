// What the laboratory's views in the lower right have in common.
#pragma once

#include "ui/laboratory.h"

namespace viewing {

/// The camera's result, null while there is none.
const std::shared_ptr<const HiddenResult>& shown_result(const HiddenStatus& hidden);

/// A view's child window over its rectangle, on the views' ground; ends with its scope.
struct LaboratoryView {
    LaboratoryView(const char* name, const Rect& rect, ImGuiWindowFlags flags = 0);
    ~LaboratoryView();
    LaboratoryView(const LaboratoryView&) = delete;
    LaboratoryView& operator=(const LaboratoryView&) = delete;
};

/// How high a widgets::Note is in the room that there is, pixels.
float note_height(const char* text);

/// A sentence in the middle of the view and, unless null, a button below it. True when it was clicked.
bool offer(const char* sentence, const char* button = nullptr);

/// "The method is at work: 40 %": instead of a view whose method has not finished.
void tell_waiting(const HiddenStatus& hidden);

}  // namespace viewing
