// Editing the user's own lesson in the window: each edit is written to the file at once, the step on the screen
// follows, and a bad edit changes nothing and is reported in one sentence.
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "desk.h"
#include "lesson/append.h"
#include "platform/text_file.h"

namespace viewing::test {
namespace {

namespace fs = std::filesystem;

class StepEditorTest : public UiTest {
protected:
    StepEditorTest() {
        Params second;
        second.projection.near = 2.0;
        std::ofstream(file_) << *with_step(*with_step("", "mine.json", {}, ""), "mine.json", second, "");
        desk.workbench.guide.open(file_.string());
        wait_until([&] { return desk.workbench.guide.is_shown(); });
        desk.click("lesson strip/Edit");
        desk.ui.frames(3);
    }
    ~StepEditorTest() override {
        std::error_code ignored;
        fs::remove(file_, ignored);
    }
    template <typename Is>
    void wait_until(const Is& is) {
        for (int i = 0; i < 500 && !is(); ++i) {
            desk.ui.frame(0.1F);
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        ASSERT_TRUE(is());
        desk.settle();
        desk.ui.frames(3);
    }
    Lesson in_file() const {
        Result<Lesson> lesson = parse_lesson(*read_text_file(file_), "mine.json", "");
        EXPECT_TRUE(lesson) << lesson.error();
        return *std::move(lesson);
    }
    const Lesson& on_screen() { return desk.workbench.guide.run()->lesson(); }
    void edit(const std::string& part, const char* text) {
        desk.click("step editor/" + part);
        ImGui::GetIO().KeyCtrl = true;
        ui.key(ImGuiKey_A);
        ImGui::GetIO().KeyCtrl = false;
        if (*text == '\0')
            ui.key(ImGuiKey_Delete);
        else
            ui.type(text);
        ui.key(ImGuiKey_Enter);
        ui.frames(2);
    }

    const fs::path file_ = fs::temp_directory_path() / ("viewing-mine-" + std::to_string(getpid()) + ".json");
};

TEST_F(StepEditorTest, TypedTextsAreInTheFileAndOnTheScreen) {
    ASSERT_TRUE(ui.has("step editor//ask/question"));
    edit("/ask/question", "Where is p?");
    EXPECT_EQ(in_file().steps[0].ask.question.in_english(), "Where is p?");
    wait_until([&] { return on_screen().steps[0].ask.question.in_english() == "Where is p?"; });
    EXPECT_TRUE(ui.has("step editor//ask/question")) << "the editor stays open";
    desk.click("step editor/Undo the edit");
    EXPECT_EQ(in_file().steps[0].ask.question.in_english(), template_texts.question);
}

/// A paragraph wraps in its field, accepts typing at any position, and has no newlines in the file.
TEST_F(StepEditorTest, ALongTextWrapsAndStaysOneLineInTheFile) {
    std::string text = "Where is p?";
    const auto height = [this] {
        const RecordedItem& field = ui.find("step editor//ask/question");
        return field.max.y - field.min.y;
    };
    const float one_line = height();
    for (int i = 0; i < 12; ++i) text += " The light goes on to the plane, and the plane stays.";
    edit("/ask/question", text.c_str());
    EXPECT_EQ(in_file().steps[0].ask.question.in_english(), text);
    wait_until([&] { return on_screen().steps[0].ask.question.in_english() == text; });
    EXPECT_GT(height(), 3.0F * one_line);
    desk.click("step editor//ask/question");
    ImGui::GetIO().KeyCtrl = true;
    ui.key(ImGuiKey_Home);
    ImGui::GetIO().KeyCtrl = false;
    for (int i = 0; i < 5; ++i) ui.key(ImGuiKey_RightArrow);
    ui.type(" and why, in a few more words than a line has,");
    ui.key(ImGuiKey_Enter);
    ui.frames(2);
    EXPECT_EQ(in_file().steps[0].ask.question.in_english(),
              "Where and why, in a few more words than a line has," + text.substr(5));
    desk.click("step editor/Undo the edit");
    EXPECT_EQ(in_file().steps[0].ask.question.in_english(), text);
}

TEST_F(StepEditorTest, StepsMoveAndTheScreenStaysAtTheStep) {
    desk.click("step editor/Move down");
    EXPECT_EQ(in_file().steps[1].id, "step-1");
    wait_until([&] { return on_screen().steps[1].id == "step-1"; });
    EXPECT_EQ(desk.workbench.guide.run()->index(), 1U);
    desk.click("step editor/Remove");
    EXPECT_EQ(in_file().steps.size(), 1U);
    wait_until([&] { return on_screen().steps.size() == 1; });
    EXPECT_FALSE(ui.find("step editor/Remove").enabled);
    desk.click("step editor/Duplicate");
    EXPECT_EQ(in_file().steps.size(), 2U);
}

TEST_F(StepEditorTest, TheScreenBecomesTheStepsStates) {
    desk.params().camera.yaw = 20.0;
    desk.settle();
    desk.click("step editor/Use screen as question");
    EXPECT_EQ(in_file().steps[0].start.params.camera.yaw, 20.0);
    wait_until([&] { return on_screen().steps[0].start.params.camera.yaw == 20.0; });
    desk.params().depth.test = false;
    desk.settle();
    desk.click("step editor/Use screen as answer");
    EXPECT_FALSE(in_file().steps[0].revealed.depth.test);
    EXPECT_TRUE(in_file().steps[0].start.params.depth.test);
}

TEST_F(StepEditorTest, ABadEditIsASentence) {
    const std::string before = *read_text_file(file_);
    edit("/ask/choices/1/say", "");  // a choice must not be empty
    EXPECT_EQ(*read_text_file(file_), before);
    ASSERT_TRUE(ui.has("step editor/trouble"));
    EXPECT_NE(ui.find("step editor/trouble").text.find("mine"), std::string::npos)
        << ui.find("step editor/trouble").text;
    edit("/ask/choices/1/say", "the other");
    EXPECT_FALSE(ui.has("step editor/trouble"));
}

TEST(StepEditorOfLessons, TheProgramsOwnLessonsHaveNone) {
    Desk desk;
    desk.workbench.guide.open("depth-fighting");
    for (int i = 0; i < 500 && !desk.workbench.guide.is_shown(); ++i) {
        desk.ui.frame(0.1F);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    desk.settle();
    ASSERT_TRUE(desk.workbench.guide.is_shown());
    EXPECT_FALSE(desk.ui.has("lesson strip/Edit"));
}

}  // namespace
}  // namespace viewing::test
