// A field for text. ImGui takes its steps of undo up again when it is the same field that becomes active once more,
// whatever has been written into the text meanwhile, and Ctrl+Z then ends the program (an assertion of 1.86): so a
// field that was left is another one for ImGui when it comes back.
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
        use = {use.times, frame, true};
        AskForRedraw(inner::caret_blink_s);
    }
    ImGui::PopID();
    return is_entered;
}

}  // namespace widgets
