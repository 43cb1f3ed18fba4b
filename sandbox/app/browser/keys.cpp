#include "app/browser/keys.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "ui/parts/imgui_keys.h"

namespace viewing {
namespace {

struct KnownKey {
    std::string_view code;
    KeyKind kind;
    Key key = Key::count;  ///< count: a key that only ImGui uses
    ImGuiKey imgui = ImGuiKey_COUNT;
};

constexpr KnownKey known_keys[] = {
    {"KeyA", KeyKind::prints, Key::a, ImGuiKey_A},
    {"KeyB", KeyKind::prints, Key::b},
    {"KeyC", KeyKind::prints, Key::c, ImGuiKey_C},
    {"KeyD", KeyKind::prints, Key::d},
    {"KeyE", KeyKind::prints, Key::e},
    {"KeyF", KeyKind::prints, Key::f},
    {"KeyG", KeyKind::prints, Key::g},
    {"KeyH", KeyKind::prints, Key::h},
    {"KeyI", KeyKind::prints, Key::i},
    {"KeyL", KeyKind::prints, Key::l},
    {"KeyM", KeyKind::prints, Key::m},
    {"KeyN", KeyKind::prints, Key::n},
    {"KeyO", KeyKind::prints, Key::o},
    {"KeyP", KeyKind::prints, Key::p},
    {"KeyQ", KeyKind::prints, Key::q},
    {"KeyR", KeyKind::prints, Key::r},
    {"KeyS", KeyKind::prints, Key::s},
    {"KeyT", KeyKind::prints, Key::t},
    {"KeyV", KeyKind::prints, Key::v, ImGuiKey_V},
    {"KeyW", KeyKind::prints, Key::w},
    {"KeyX", KeyKind::prints, Key::x, ImGuiKey_X},
    {"KeyY", KeyKind::prints, Key::y, ImGuiKey_Y},
    {"KeyZ", KeyKind::prints, Key::z, ImGuiKey_Z},
    {"Digit0", KeyKind::prints, Key::zero},
    {"Numpad0", KeyKind::prints, Key::zero},
    {"Digit1", KeyKind::prints, Key::one},
    {"Digit2", KeyKind::prints, Key::two},
    {"Digit3", KeyKind::prints, Key::three},
    {"Digit4", KeyKind::prints, Key::four},
    {"Digit5", KeyKind::prints, Key::five},
    {"Digit6", KeyKind::prints, Key::six},
    {"Digit7", KeyKind::prints, Key::seven},
    {"Digit8", KeyKind::prints, Key::eight},
    {"Digit9", KeyKind::prints, Key::nine},
    {"Equal", KeyKind::prints, Key::plus},
    {"NumpadAdd", KeyKind::prints, Key::plus},
    {"Minus", KeyKind::prints, Key::minus},
    {"NumpadSubtract", KeyKind::prints, Key::minus},
    {"Period", KeyKind::prints, Key::period},
    {"Comma", KeyKind::prints, Key::comma},
    {"Space", KeyKind::prints, Key::space, ImGuiKey_Space},
    {"ShiftLeft", KeyKind::modifier, Key::shift},
    {"ShiftRight", KeyKind::modifier, Key::shift},
    {"ControlLeft", KeyKind::modifier, Key::ctrl},
    {"ControlRight", KeyKind::modifier, Key::ctrl},
    {"AltLeft", KeyKind::modifier, Key::alt},
    {"AltRight", KeyKind::modifier, Key::alt},
    {"MetaLeft", KeyKind::modifier, Key::super},
    {"MetaRight", KeyKind::modifier, Key::super},
    {"ArrowLeft", KeyKind::edits, Key::left, ImGuiKey_LeftArrow},
    {"ArrowRight", KeyKind::edits, Key::right, ImGuiKey_RightArrow},
    {"ArrowUp", KeyKind::edits, Key::up, ImGuiKey_UpArrow},
    {"ArrowDown", KeyKind::edits, Key::down, ImGuiKey_DownArrow},
    {"Backspace", KeyKind::edits, Key::backspace, ImGuiKey_Backspace},
    {"Delete", KeyKind::edits, Key::count, ImGuiKey_Delete},
    {"Insert", KeyKind::edits, Key::count, ImGuiKey_Insert},
    {"Home", KeyKind::edits, Key::home, ImGuiKey_Home},
    {"End", KeyKind::edits, Key::count, ImGuiKey_End},
    {"PageUp", KeyKind::edits, Key::page_up, ImGuiKey_PageUp},
    {"PageDown", KeyKind::edits, Key::page_down, ImGuiKey_PageDown},
    {"Enter", KeyKind::leaves, Key::enter, ImGuiKey_Enter},
    {"NumpadEnter", KeyKind::leaves, Key::enter, imgui_keypad_enter},
    {"Tab", KeyKind::leaves, Key::count, ImGuiKey_Tab},
    {"Escape", KeyKind::leaves, Key::escape, ImGuiKey_Escape},
    {"F1", KeyKind::leaves, Key::f1},
    {"F2", KeyKind::leaves, Key::f2},
    {"F3", KeyKind::leaves, Key::f3},
    {"F5", KeyKind::leaves, Key::f5},
    {"F6", KeyKind::leaves, Key::f6},
    {"F9", KeyKind::leaves, Key::f9},
    {"F11", KeyKind::leaves, Key::f11},
    {"F12", KeyKind::leaves, Key::f12},
};

const KnownKey* known(std::string_view code) {
    const auto* const at = std::find_if(std::begin(known_keys), std::end(known_keys),
                                        [code](const KnownKey& key) { return key.code == code; });
    return at != std::end(known_keys) ? at : nullptr;
}

/// Returns the key that produces `text` on a US keyboard; null unless `text` is a letter, plus or minus.
const KnownKey* printing(std::string_view text) {
    if (text == "+") return known("Equal");
    if (text == "-") return known("Minus");
    if (text.size() != 1) return nullptr;
    const char upper = text[0] >= 'a' && text[0] <= 'z' ? static_cast<char>(text[0] - 'a' + 'A') : text[0];
    const std::array code{'K', 'e', 'y', upper};
    return upper >= 'A' && upper <= 'Z' ? known({code.data(), code.size()}) : nullptr;
}

}  // namespace

std::optional<KeyChanged> key_changed(std::string_view code, std::string_view key, bool down, bool ctrl, bool shift) {
    const KnownKey* const place = known(code);
    const KnownKey* const printed = printing(key);
    const KnownKey* const meant = printed ? printed : place;
    if (!meant) return std::nullopt;
    // Track held keys by position, so that a release matches its press even if the layout has changed in between.
    const KnownKey* const held = place ? place : meant;
    const std::optional<Key> ours = meant->key != Key::count ? std::optional(meant->key) : std::nullopt;
    const std::size_t index =
        static_cast<std::size_t>(meant->imgui != ImGuiKey_COUNT ? meant - known_keys : held - known_keys);
    return KeyChanged{index, meant->kind, ours, down, ctrl, shift};
}

void name_imgui_keys() {
    ImGuiIO& io = ImGui::GetIO();
    for (const KnownKey& key : known_keys)
        if (key.imgui != ImGuiKey_COUNT) io.KeyMap[key.imgui] = static_cast<int>(&key - known_keys);
}

}  // namespace viewing
