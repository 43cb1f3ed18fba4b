// Maps the browser's key names (KeyboardEvent.code and .key, W3C UI Events) to the keys of the sandbox and Dear ImGui.
#pragma once

#include <string_view>

#include "ui/parts/input_queue.h"

namespace viewing {

/// Translates a key event. `code` is the key's position on a US keyboard ("KeyW"), `key` the character that the
/// keyboard layout produces ("w"). Letters are matched by `key`, or by `code` if the layout produces no Latin letter.
/// Returns nothing for unknown keys.
std::optional<KeyChanged> key_changed(std::string_view code, std::string_view key, bool down, bool ctrl, bool shift);

/// Fills io.KeyMap, which maps ImGui's own keys to entries of io.KeysDown.
void name_imgui_keys();

}  // namespace viewing
