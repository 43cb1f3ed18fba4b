// Toggles, choices, segments, colors, buttons, sections, splitters and lamps under real input.
#include "widget_test.h"

namespace widgets::test {
namespace {

using ControlsTest = WidgetTest;

constexpr const char* names[] = {"GL_NEVER", "GL_LESS", "GL_EQUAL"};

TEST_F(ControlsTest, Toggle) {
    bool value = false;
    start([&] { return Toggle("Depth test", value, true); });
    ui.frames(10);
    EXPECT_EQ(changes, 0);
    ui.click("Depth test");
    EXPECT_TRUE(value);
    EXPECT_EQ(changes, 1);
    EXPECT_EQ(ui.text_of("Depth test"), "on");
    ui.click("Depth test");
    EXPECT_FALSE(value);
    ui.right_click("Depth test");
    EXPECT_TRUE(value);
    ui.right_click("Depth test");
    EXPECT_EQ(changes, 3);
}

/// If the field kept the undo steps of its old text, ImGui would apply them to the current text and crash the program.
TEST_F(ControlsTest, ATextFieldForgetsItsUndoStepsWhenLeft) {
    std::string text = "a text that is much longer than what comes later";
    start([&] {
        TextField("##text", text);
        Record("text");
        ImGui::Button("elsewhere");
        Record("elsewhere");
        return false;
    });
    for (int i = 0; i < 2; ++i) {
        ui.click("text");
        ui.type("1234567890");
        ui.type("X");
        ui.click("elsewhere");
        text = "b";  // as a dialog does when it opens
        ui.frames(3);
        ui.click("text");
        for (int steps = 0; steps < 3; ++steps) {
            ImGui::GetIO().KeyCtrl = true;
            ui.key(ImGuiKey_Z);
            ImGui::GetIO().KeyCtrl = false;
        }
        EXPECT_EQ(text, "b");
    }
    ui.type("c");
    EXPECT_TRUE(text == "bc" || text == "cb") << text;
}

TEST_F(ControlsTest, ChoiceOpensItsListAndRecordsItsItems) {
    int index = 1;
    start([&] { return Choice("depth func", index, names, 1); });
    EXPECT_FALSE(ui.has("depth func/GL_EQUAL"));
    ui.click("depth func");
    ui.frames(2);
    ui.click("depth func/GL_EQUAL");
    EXPECT_EQ(index, 2);
    EXPECT_EQ(changes, 1);
    EXPECT_EQ(ui.text_of("depth func"), "GL_EQUAL");
    EXPECT_FALSE(ui.has("depth func/GL_EQUAL")) << "the list closes";
    ui.right_click("depth func");
    EXPECT_EQ(index, 1);
}

TEST_F(ControlsTest, ChoiceShowsAnIndexOutsideItsNamesAndKeepsIt) {
    int index = 17;
    start([&] { return Choice("c", index, names, 1); });
    ui.frames(10);
    EXPECT_EQ(index, 17);
    EXPECT_EQ(ui.text_of("c"), "—");
}

TEST_F(ControlsTest, AListOfAnythingLooksLikeAChoice) {
    std::string chosen;
    start([&] {
        if (BeginChoice("##scene", "a scene whose name is far too long for its box", 120.0F)) {
            for (const char* name : {"room", "garden"}) {
                if (ImGui::Selectable(name)) chosen = name;
                Record(name);
            }
            EndChoice();
        }
        return false;
    });
    EXPECT_EQ(ui.find("scene").max.x - ui.find("scene").min.x, 120.0F);
    EXPECT_FALSE(ui.has("garden"));
    ui.click("scene");
    ui.frames(2);
    ui.click("garden");
    EXPECT_EQ(chosen, "garden");
    EXPECT_FALSE(ui.has("garden"));
    ui.click("scene");
    ui.frames(2);
    EXPECT_TRUE(ui.has("garden"));
    ui.key(ImGuiKey_Escape);
    EXPECT_FALSE(ui.has("garden")) << "Escape closes the list";
}

TEST_F(ControlsTest, EscapeClosesTheInnermostPopupBeforeEndingTyping) {
    int index = 0;
    double value = 1.0;
    start([&] {
        if (Button("File")) ImGui::OpenPopup("file");
        bool changed = false;
        if (ImGui::BeginPopup("file")) {
            ClosePopupOnEscape();
            changed |= Choice("c", index, names, 0);
            changed |= Number("x", value, {}, 80.0F);
            ImGui::EndPopup();
        }
        return changed;
    });
    ui.click("File");
    ui.frames(2);
    ui.click("c");
    ui.frames(2);
    EXPECT_TRUE(ui.has("c/GL_EQUAL"));
    ui.key(ImGuiKey_Escape);
    EXPECT_FALSE(ui.has("c/GL_EQUAL"));
    EXPECT_TRUE(ui.has("x")) << "only the list has closed";
    ui.ctrl_click("x");
    ui.type("7");
    ui.key(ImGuiKey_Escape);
    EXPECT_EQ(value, 1.0);
    EXPECT_TRUE(ui.has("x")) << "only the typing has ended";
    ui.key(ImGuiKey_Escape);
    EXPECT_FALSE(ui.has("x"));
    EXPECT_EQ(changes, 0);
}

TEST_F(ControlsTest, SegmentsExplainEachOption) {
    int index = 0;
    start([&] {
        static constexpr const char* tips[] = {"Nothing passes.", "Nearer passes."};
        const bool changed = Segments("##func", index, names, 0, tips);
        Tooltip("depth function", "");
        return changed;
    });
    const auto tip_of = [this](const char* label) {
        ui.hover(label);
        ui.frames(60);
        for (const RecordedItem& item : context.recorded) {
            if (item.label.ends_with("tooltip")) return item.text;
        }
        return std::string();
    };
    EXPECT_EQ(tip_of("func/GL_NEVER"), "GL_NEVER\nNothing passes.");
    EXPECT_EQ(tip_of("func/GL_LESS"), "GL_LESS\nNearer passes.");
    EXPECT_EQ(tip_of("func/GL_EQUAL"), "depth function") << "a segment without a tooltip shows the group's";
}

TEST_F(ControlsTest, Segments) {
    int index = 0;
    start([&] { return Segments("##mode", index, names, 2); });
    ui.click("mode/GL_LESS");
    EXPECT_EQ(index, 1);
    ui.click("mode/GL_LESS");
    EXPECT_EQ(changes, 1);
    ui.right_click("mode/GL_NEVER");
    EXPECT_EQ(index, 2);
}

TEST_F(ControlsTest, SegmentsWrapWhereTheyDoNotFit) {
    int index = 0;
    start([&] {
        ImGui::BeginChild("narrow", ImVec2(170, 200));
        const bool changed = Segments("mode", index, names, 0);
        ImGui::EndChild();
        return changed;
    });
    EXPECT_GT(ui.find("mode/GL_EQUAL").min.y, ui.find("mode/GL_LESS").min.y);
    EXPECT_LE(ui.find("mode/GL_LESS").max.x, 180.0F);
}

TEST_F(ControlsTest, LongTextsGetEnoughRoom) {
    bool value = false;
    double number = 0.5;
    float line = 0.0F, behind = 0.0F, above = 0.0F;
    start([&] {
        ImGui::BeginChild("narrow", ImVec2(220, 400));
        line = ImGui::GetFrameHeight();
        Toggle("a toggle that says in many words what it is for", value, true);
        Button("a button that says in many words what it does");
        Slider("short", number, {.min = 0.0, .max = 1.0}, 120.0F);
        behind = ImGui::GetItemRectSize().y;
        Slider("a label that is too long to stand behind", number, {.min = 0.0, .max = 1.0}, 120.0F);
        above = ImGui::GetItemRectSize().y;
        Slider("##none", number, {.min = 0.0, .max = 1.0}, 240.0F);
        ImGui::EndChild();
        return false;
    });
    for (const char* label :
         {"a toggle that says in many words what it is for", "a button that says in many words what it does"}) {
        const RecordedItem item = ui.find(label);
        EXPECT_LE(item.max.x - item.min.x, 220.0F);
        EXPECT_GT(item.max.y - item.min.y, 1.5F * line);
    }
    EXPECT_FLOAT_EQ(behind, line);
    EXPECT_GT(above, 1.5F * line);
    EXPECT_FLOAT_EQ(ui.find("none").max.y - ui.find("none").min.y, line);
    ui.click("a toggle that says in many words what it is for");
    EXPECT_TRUE(value);
}

TEST_F(ControlsTest, AChoiceReportsTheWidthItNeeds) {
    int index = 0;
    float needed = 0.0F;
    start([&] {
        needed = ChoiceWidth(names);
        return Choice("depth func", index, names, 1);
    });
    const RecordedItem item = ui.find("depth func");
    EXPECT_FLOAT_EQ(item.max.x - item.min.x, needed);
    EXPECT_GT(needed, ImGui::CalcTextSize("GL_NEVER").x);
}

TEST_F(ControlsTest, ColorFieldKeepsItsBytes) {
    glm::u8vec3 rgb{1, 2, 3};
    start([&] { return ColorField("colour", rgb, {0x5A, 0x9E, 0xF0}); });
    EXPECT_EQ(ui.text_of("colour"), "#010203");
    ui.click("colour");
    ui.frames(10);
    EXPECT_EQ(rgb, glm::u8vec3(1, 2, 3)) << "an open picker changes nothing by itself";
    EXPECT_EQ(changes, 0);
    ui.hover("picker", 0.5F, 0.4F);
    ui.press();
    ui.release();
    EXPECT_NE(rgb, glm::u8vec3(1, 2, 3));
    ui.key(ImGuiKey_Escape);
    ui.move_to(ImVec2(590, 770));
    ui.press();
    ui.release();
    ui.right_click("colour");
    EXPECT_EQ(rgb, glm::u8vec3(0x5A, 0x9E, 0xF0));
}

TEST_F(ControlsTest, ButtonsAndTheirReasons) {
    start([&] {
        const bool enabled = Button("Snapshot");
        const bool disabled = SmallButton("Undo", false, "There is nothing to undo");
        return enabled || disabled;
    });
    ui.click("Snapshot");
    EXPECT_EQ(changes, 1);
    EXPECT_TRUE(ui.find("Snapshot").enabled);
    EXPECT_FALSE(ui.find("Undo").enabled);
    ui.click("Undo");
    EXPECT_EQ(changes, 1);
}

TEST_F(ControlsTest, SectionFoldsAndRemembers) {
    bool value = false;
    start([&] { return Section("Light") && Toggle("inside", value, false); });
    EXPECT_TRUE(ui.has("inside"));
    ui.click("Light");
    EXPECT_FALSE(ui.has("inside"));
    ui.frames(5);
    EXPECT_EQ(ui.text_of("Light"), "folded");
    ui.click("Light");
    EXPECT_TRUE(ui.has("inside"));
}

TEST_F(ControlsTest, SplitterFollowsInBothDirectionsAndStops) {
    float left = 100, right = 100;
    start([&] {
        bool changed = Splitter("left", true, left, 50, 200, 300);
        changed |= Splitter("right", true, right, 50, 200, 300, -1.0F);
        return changed;
    });
    ui.drag("left", 30);
    EXPECT_FLOAT_EQ(left, 130);
    ui.drag("right", 30);
    EXPECT_FLOAT_EQ(right, 70);
    ui.drag("left", 1000);
    EXPECT_FLOAT_EQ(left, 200);
}

TEST_F(ControlsTest, LampsExplainTheirState) {
    const Lamp lamps[] = {
        {"yaw", true, true}, {"pitch", true, false}, {"roll", false, false}, {"lift", false, false, "R F", true}};
    start([&] {
        Lamps("freedom", lamps, Role::camera);
        return false;
    });
    EXPECT_EQ(ui.text_of("freedom/yaw"), "active");
    EXPECT_EQ(ui.text_of("freedom/pitch"), "available");
    EXPECT_EQ(ui.text_of("freedom/roll"), "absent");
    EXPECT_EQ(ui.text_of("freedom/lift"), "refused") << "its key has no effect";
}

TEST_F(ControlsTest, LabelsAreRecordedWithTheirPath) {
    double value = 0.0;
    start([&] {
        const Group group("camera");
        return Number("##hidden", value, {}) || Number("Gierwinkel###yaw", value, {});
    });
    EXPECT_TRUE(ui.has("camera/hidden"));
    EXPECT_TRUE(ui.has("camera/yaw"));
    EXPECT_EQ(ui.find("camera/yaw").window, "test");
}

TEST_F(ControlsTest, TooltipWaitsAndRequestsAFrame) {
    double value = 0.0;
    start([&] {
        const bool changed = Number("near", value, {});
        Tooltip("Near plane", "What lies nearer is cut away.", "Δz ≈ z^2", "glm::perspective");
        return changed;
    });
    const auto tooltip_is_open = [] { return ImGui::GetDrawData()->CmdListsCount > 1; };
    ui.hover("near");
    ui.frames(3);
    EXPECT_FALSE(tooltip_is_open());
    EXPECT_GT(RedrawIn(context), 0.0F);
    EXPECT_LE(RedrawIn(context), 0.5F);
    ui.frames(60);
    EXPECT_TRUE(tooltip_is_open());
    ui.move_to(ImVec2(500, 700));
    ui.frames(2);
    EXPECT_FALSE(tooltip_is_open());
    EXPECT_LT(RedrawIn(context), 0.0F);
}

}  // namespace
}  // namespace widgets::test
