// A text field. When a field becomes active again, ImGui still has its old undo history. If other code has changed the
// text meanwhile, Ctrl+Z fails an assertion (ImGui 1.86). Therefore, a field that was left gets a new ImGui id when it
// is used again. Typed text is stored immediately, so nothing is lost when the field is left. EntryField is for text
// that counts only when complete.
#include <imgui.h>
#include <imgui_stdlib.h>

#include "widgets/inner.h"

namespace widgets {

bool TextField(const char* label, std::string& text, const char* hint, ImGuiInputTextFlags flags) {
    TextFieldUse& use = CurrentContext().text_fields[ImGui::GetID(label)];
    const int frame = ImGui::GetFrameCount();
    if (use.is_used && use.active_frame < frame - 1) {
        use.is_used = false;
        ++use.times;
    }
    ImGui::PushID(use.times);
    const bool is_entered = ImGui::InputTextWithHint(label, hint, &text, flags);
    if (ImGui::IsItemActive()) {
        use.active_frame = frame;
        use.is_used = true;
        AskForRedraw(inner::caret_blink_s);
    }
    ImGui::PopID();
    return is_entered;
}

bool EntryField(const char* label, std::string& value) {
    Context& context = CurrentContext();
    std::optional<std::string>& entry = context.text_fields[ImGui::GetID(label)].entry;
    std::string text = entry.value_or(value);
    TextField(label, text);
    const bool is_being_typed = ImGui::IsItemActive() && !context.editing.ends;
    if (is_being_typed) {
        if (text != value || entry) entry = std::move(text);
        return false;
    }
    entry.reset();
    if (text == value) return false;
    value = std::move(text);
    return true;
}

}  // namespace widgets
