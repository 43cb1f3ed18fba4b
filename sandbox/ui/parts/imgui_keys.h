// The one key of Dear ImGui that has two names: KeyPadEnter until 1.86, KeypadEnter since.
#pragma once

#include <imgui.h>

#if IMGUI_VERSION_NUM < 18700
inline constexpr ImGuiKey imgui_keypad_enter = ImGuiKey_KeyPadEnter;
#else
inline constexpr ImGuiKey imgui_keypad_enter = ImGuiKey_KeypadEnter;
#endif
