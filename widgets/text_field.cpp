// A text field. When a field becomes active again, ImGui still has its old undo history. If other code has changed the
// text meanwhile, Ctrl+Z triggers a failed assertion (ImGui 1.86). Therefore, a field that was left gets a new ImGui id
// when it is used again. Typed text is stored immediately, so nothing is lost when the field is left. EntryField is for
// text that counts only when complete.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <utility>

#include "widgets/inner.h"

namespace widgets {

using inner::Px;

namespace {

/// Draws a field that gets a new id whenever it is used again. Returns what `draw` returns.
template <typename Draw>
bool KeptField(const char* label, const Draw& draw) {
    TextFieldUse& use = CurrentContext().text_fields[ImGui::GetID(label)];
    const int frame = ImGui::GetFrameCount();
    if (use.is_used && use.active_frame < frame - 1) {
        use.is_used = false;
        ++use.times;
    }
    ImGui::PushID(use.times);
    const bool result = draw();
    if (ImGui::IsItemActive()) {
        use.active_frame = frame;
        use.is_used = true;
        AskForRedraw(inner::caret_blink_s);
    }
    ImGui::PopID();
    return result;
}

/// Keeps typed text until the user leaves the field. `draw` draws the field with a text, which it may change. Returns
/// whether `value` has changed.
template <typename Draw>
bool Entry(const char* label, std::string& value, const Draw& draw) {
    Context& context = CurrentContext();
    std::optional<std::string>& entry = context.text_fields[ImGui::GetID(label)].entry;
    std::string text = entry.value_or(value);
    draw(text);
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

/// Replaces spaces with newlines and vice versa, so that no line is wider than `width` if possible. No byte moves, so a
/// caret stays where it is.
void Wrap(char* begin, char* end, float width) {
    std::replace(begin, end, '\n', ' ');
    char *line = begin, *last_blank = nullptr;
    for (char* at = begin; at <= end; ++at) {
        if (at < end && *at != ' ') continue;
        if (last_blank && ImGui::CalcTextSize(line, at).x > width) {
            *last_blank = '\n';
            line = last_blank + 1;
        }
        last_blank = at;
    }
}

int WrapWhatIsTyped(ImGuiInputTextCallbackData* data) {
    Wrap(data->Buf, data->Buf + data->BufTextLen, *static_cast<const float*>(data->UserData));
    data->BufDirty = true;
    return 0;
}

/// A field that gets the focus selects its text, which the next letter would replace.
int CaretToEnd(ImGuiInputTextCallbackData* data) {
    if (!std::exchange(*static_cast<bool*>(data->UserData), false)) return 0;
    data->ClearSelection();
    data->CursorPos = data->BufTextLen;
    return 0;
}

}  // namespace

bool TextField(const char* label, std::string& text, const char* hint, ImGuiInputTextFlags flags, bool* to_end) {
    if (to_end != nullptr) flags |= ImGuiInputTextFlags_CallbackAlways;
    return KeptField(label, [&] { return ImGui::InputTextWithHint(label, hint, &text, flags, CaretToEnd, to_end); });
}

bool EntryField(const char* label, std::string& value) {
    return Entry(label, value, [&](std::string& text) { TextField(label, text); });
}

bool ParagraphField(const char* label, std::string& value) {
    if (value.find('\n') != std::string::npos) return EntryField(label, value);
    const ImVec2 padding = ImGui::GetStyle().FramePadding;
    const float width = ImGui::GetContentRegionAvail().x;
    float room = std::max(width - 2.0F * padding.x - Px(2), 1.0F);
    return Entry(label, value, [&](std::string& text) {
        Wrap(text.data(), text.data() + text.size(), room);
        const auto lines = static_cast<float>(1 + std::count(text.begin(), text.end(), '\n'));
        const ImVec2 size(width, lines * ImGui::GetTextLineHeight() + 2.0F * padding.y);
        constexpr ImGuiInputTextFlags flags = ImGuiInputTextFlags_CtrlEnterForNewLine |
                                              ImGuiInputTextFlags_CallbackEdit | ImGuiInputTextFlags_NoHorizontalScroll;
        KeptField(label, [&] { return ImGui::InputTextMultiline(label, &text, size, flags, WrapWhatIsTyped, &room); });
        std::replace(text.begin(), text.end(), '\n', ' ');
    });
}

}  // namespace widgets
