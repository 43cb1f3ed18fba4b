// The browser's names of keys (KeyboardEvent.code and .key, W3C UI Events) as the sandbox and Dear ImGui know them.
#pragma once

#include <string_view>

#include "ui/parts/input_queue.h"

namespace viewing {

/// `code`: the key's place on a US keyboard ("KeyW"), `key`: what the layout prints ("w"). A letter is taken by what is
/// printed, or by its place where the layout prints no Latin letter. None for keys that nothing here knows.
std::optional<KeyChanged> key_changed(std::string_view code, std::string_view key, bool down, bool ctrl, bool shift);

/// Tells ImGui which of io.KeysDown its own keys are.
void name_imgui_keys();

}  // namespace viewing
