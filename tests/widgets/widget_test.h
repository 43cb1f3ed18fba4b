// A window around one test's widgets; it counts how often they report a change.
#pragma once

#include <gtest/gtest.h>

#include <functional>

#include "harness.h"

namespace widgets::test {

class WidgetTest : public ::testing::Test {
protected:
    /// Draws the content of the window; returns whether a widget reported a change.
    std::function<bool()> show = [] { return false; };
    int changes = 0;
    Context context;
    Harness ui{context, [this] { draw(); }};

    void start(std::function<bool()> body) {
        show = std::move(body);
        ApplyStyle(context);
        ui.frames(3);
        changes = 0;
    }

private:
    void draw() {
        NewFrame(context);
        ImGui::SetNextWindowPos(ImVec2(0, 0));
        ImGui::SetNextWindowSize(ImVec2(600, 780));
        ImGui::Begin("test", nullptr, ImGuiWindowFlags_NoDecoration);
        changes += show() ? 1 : 0;
        ImGui::End();
    }
};

}  // namespace widgets::test
