// Drives real ImGui input without a window or GL: finds a recorded widget by label, then clicks, drags and types. ImGui
// 1.86 has no input queue, so every press, move and release takes a frame of its own. widget_test.h adds a window
// around single widgets; the UI's tests pass their own drawing function.
#pragma once

#include <imgui.h>

#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "widgets/widgets.h"

namespace widgets::test {

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();

/// Relative luminance as defined by WCAG 2, from 0 to 1.
inline double luminance(ImU32 color) {
    const auto linear = [color](int shift) {
        const double c = ((color >> shift) & 0xFF) / 255.0;
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(IM_COL32_R_SHIFT) + 0.7152 * linear(IM_COL32_G_SHIFT) + 0.0722 * linear(IM_COL32_B_SHIFT);
}

inline double contrast(ImU32 a, ImU32 b) {
    const auto [low, high] = std::minmax({luminance(a), luminance(b)});
    return (high + 0.05) / (low + 0.05);
}

#if IMGUI_VERSION_NUM >= 18700
constexpr int first_key = ImGuiKey_NamedKey_BEGIN;
#else
constexpr int first_key = 0;
#endif

/// Returns a reference to the state of a key, in the harness's own mapping.
inline bool& key_down(ImGuiKey key) {
    ImGuiIO& io = ImGui::GetIO();
    return io.KeysDown[io.KeyMap[key]];
}

class Harness {
public:
    /// `draw` draws one whole frame between ImGui::NewFrame and ImGui::Render and calls widgets::NewFrame(context)
    /// itself. Creates an ImGui context if there is none, and builds the fonts.
    Harness(Context& context, std::function<void()> draw, ImVec2 display_size = ImVec2(1280, 800))
        : context_(context), draw_(std::move(draw)), owns_imgui_(ImGui::GetCurrentContext() == nullptr) {
        if (owns_imgui_) ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = display_size;
        io.MousePos = ImVec2(-1, -1);
        for (int key = first_key; key < ImGuiKey_COUNT; ++key) io.KeyMap[key] = key - first_key;
#if IMGUI_VERSION_NUM >= 18700
        io.BackendUsingLegacyKeyArrays = 1;  // ImGui itself sets this only when the first key is pressed
#endif
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        io.Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
        context_.record = true;
    }
    ~Harness() {
        if (owns_imgui_) ImGui::DestroyContext();
    }
    Harness(const Harness&) = delete;
    Harness& operator=(const Harness&) = delete;

    void frame(float seconds = 1.0F / 60.0F) {
        ImGui::GetIO().DeltaTime = seconds;
        ImGui::NewFrame();
        draw_();
        any_item_active_ = ImGui::IsAnyItemActive();
        ImGui::Render();
    }
    void frames(int count) {
        for (int i = 0; i < count; ++i) frame();
    }

    const RecordedItem* try_find(std::string_view label) const {
        for (const RecordedItem& item : context_.recorded) {
            if (item.label == label) return &item;
        }
        return nullptr;
    }
    /// Throws if no item has this label; the message lists all labels.
    const RecordedItem& find(std::string_view label) const {
        if (const RecordedItem* item = try_find(label)) return *item;
        std::string message = "no widget '" + std::string(label) + "' among:";
        for (const RecordedItem& item : context_.recorded) message += "\n  " + item.label;
        throw std::runtime_error(message);
    }
    bool has(std::string_view label) const {
        return try_find(label) != nullptr;
    }
    std::string text_of(std::string_view label) const {
        return find(label).text;
    }
    /// Returns whether an ImGui item was active at the end of the last frame.
    bool any_item_active() const {
        return any_item_active_;
    }

    void move_to(ImVec2 position) {
        ImGui::GetIO().MousePos = position;
        frame();
    }
    /// Moves to a fraction of the widget's rectangle, by default its center.
    void hover(std::string_view label, float x = 0.5F, float y = 0.5F) {
        const RecordedItem& item = find(label);
        move_to(ImVec2(item.min.x + x * (item.max.x - item.min.x), item.min.y + y * (item.max.y - item.min.y)));
    }
    void press(int button = 0) {
        ImGui::GetIO().MouseDown[button] = true;
        frame();
    }
    void release(int button = 0) {
        ImGui::GetIO().MouseDown[button] = false;
        frame();
    }
    void click(std::string_view label, int button = 0) {
        rest();
        hover(label);
        press(button);
        release(button);
        frame();
    }
    void right_click(std::string_view label) {
        click(label, ImGuiMouseButton_Right);
    }
    void double_click(std::string_view label) {
        rest();
        hover(label);
        for (int i = 0; i < 2; ++i) {
            press();
            release();
        }
        frames(3);
    }
    void ctrl_click(std::string_view label) {
        ImGui::GetIO().KeyCtrl = true;
        click(label);
        ImGui::GetIO().KeyCtrl = false;
        frames(3);
    }
    /// Drags by (dx, dy) pixels in equal steps, from the fraction `from_x` of the widget's width and half its height.
    void drag(std::string_view label, float dx, float dy = 0.0F, int steps = 5, float from_x = 0.5F) {
        rest();
        hover(label, from_x);
        const ImVec2 from = ImGui::GetIO().MousePos;
        press();
        for (int i = 1; i <= steps; ++i) {
            const float share = static_cast<float>(i) / static_cast<float>(steps);
            move_to(ImVec2(from.x + dx * share, from.y + dy * share));
        }
        release();
        frame();
    }
    void type(const char* text) {
        ImGui::GetIO().AddInputCharactersUTF8(text);
        frame();
    }
    void key(ImGuiKey which, bool shift = false) {
        ImGuiIO& io = ImGui::GetIO();
        io.KeyShift = shift;
        key_down(which) = true;
        frame();
        key_down(which) = false;
        frame();
        io.KeyShift = false;
        frames(3);
    }

private:
    /// Waits long enough that the next press is not a double-click.
    void rest() {
        frame(1.0F);
    }

    Context& context_;
    std::function<void()> draw_;
    bool owns_imgui_;
    bool any_item_active_ = false;
};

}  // namespace widgets::test
