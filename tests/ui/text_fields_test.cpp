// Leaves every text field of the window in every possible way: the typed text becomes the field's value, and only
// Escape discards it. The fields of dialogs come last.
#include <gtest/gtest.h>

#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "exercise_desk.h"
#include "platform/file.h"
#include "text/numbers.h"
#include "unit/state/scratch_folder.h"

namespace viewing::test {
namespace {

/// A desk on which every field can be edited.
using FieldDesk = ExerciseSheetDesk;

struct FieldOfText {
    const char* name;
    std::function<void(FieldDesk&)> begin;  ///< gives it the keyboard focus and selects its text
    const char* typed;
    std::function<std::string(const FieldDesk&)> value;
    bool is_on_page = false;  ///< the page covers the window, so keys cannot change anything else
};

void open_page(FieldDesk& desk) {
    desk.click("top/Exercises");
    desk.ui.frames(3);
}

void select_all(FieldDesk& desk) {
    ImGui::GetIO().KeyCtrl = true;
    desk.ui.key(ImGuiKey_A);
    ImGui::GetIO().KeyCtrl = false;
}

FieldOfText student_field(const char* label, std::string Student::*text) {
    return {label,
            [label](FieldDesk& desk) {
                open_page(desk);
                desk.ui.click("exercises/" + std::string(label));
                select_all(desk);
            },
            "a12", [text](const FieldDesk& desk) { return desk.workbench.exercises.desk.student().*text; }, true};
}

FieldOfText number_field(const char* name, const char* exercise, const char* label,
                         std::function<double(const FieldDesk&)> value) {
    return {name,
            [=](FieldDesk& desk) {
                if (*exercise != '\0') desk.begin(exercise);
                desk.reveal(label);
                desk.ui.double_click(label);
            },
            "2.5", [value = std::move(value)](const FieldDesk& desk) { return plain_number(value(desk)); }};
}

std::vector<FieldOfText> all_fields() {
    const auto answer = [](std::size_t place) {
        return [place](const FieldDesk& desk) {
            // The answer belongs to the step in which it was typed, whichever step is current.
            const LessonRun& run = *desk.workbench.guide.run();
            const ExerciseDesk& exercises = desk.workbench.exercises.desk;
            for (const char* id : {"E16-shadow-matrix", "E06-radians"})
                if (const HandInItem* item = exercises.hand_in().find(id); item && item->draft)
                    return item->draft->at(place);
            return run.answer().numbers.at(place);
        };
    };
    return {student_field("Student number", &Student::number),
            student_field("Course", &Student::course),
            student_field("Name", &Student::name),
            number_field("a number of the panel", "", "projection/z-near",
                         [](const FieldDesk& desk) { return desk.session.params.projection.near; }),
            number_field("an entry of an answer matrix", "E16-shadow-matrix", "lesson strip/answers/answer/r1c2",
                         answer(6)),
            number_field("a number of an answer", "E06-radians", "lesson strip/answers/answer/x", answer(0))};
}

struct WayOut {
    const char* name;
    std::function<void(FieldDesk&)> leave;
    bool goes_on = false;     ///< editing goes on in the next number
    bool turns_page = false;  ///< turns the page of an exercise; elsewhere, the key does not leave the field
};

std::vector<WayOut> all_ways_out() {
    const auto key = [](ImGuiKey which, bool shift = false) {
        return [which, shift](FieldDesk& desk) { desk.ui.key(which, shift); };
    };
    const auto press = [](Key which) { return [which](FieldDesk& desk) { desk.press(which); }; };
    return {{"Enter", key(ImGuiKey_Enter)},
            {"Tab", key(ImGuiKey_Tab), true},
            {"Shift+Tab", key(ImGuiKey_Tab, true), true},
            {"a click elsewhere",
             [](FieldDesk& desk) {
                 desk.click_at({800.0F, 3.0F});
             }},
            {"Tab twice",
             [](FieldDesk& desk) {
                 desk.ui.key(ImGuiKey_Tab);
                 desk.ui.key(ImGuiKey_Tab);
             },
             true},
            {"Page down", press(Key::page_down), false, true},
            {"Page up", press(Key::page_up), false, true},
            {"F1", press(Key::f1)},
            {"F2", press(Key::f2)},
            {"F11", press(Key::f11)},
            {"a file that is dropped",
             [](FieldDesk& desk) {
                 desk.input.dropped_files = {"/nowhere/dropped.json"};
                 desk.ui.frames(5);
             }},
            {"the window loses the focus",
             [](FieldDesk& desk) {
                 desk.input.loses_focus = true;
                 desk.ui.frame();
                 desk.input.loses_focus = false;
                 desk.ui.frame();
             }},
            {"the window is closed", [](FieldDesk& desk) {
                 widgets::EndTyping(desk.workbench.widgets);
                 desk.ui.frames(2);
             }}};
}

TEST(TextFields, KeepTypedTextHoweverTheyAreLeft) {
    for (const FieldOfText& field : all_fields())
        for (const WayOut& way : all_ways_out()) {
            SCOPED_TRACE(std::string(field.name) + ", left by " + way.name);
            FieldDesk desk({1600, 1100});
            field.begin(desk);
            ASSERT_TRUE(ImGui::GetIO().WantTextInput) << "the field has no keyboard focus";
            ASSERT_NE(field.value(desk), field.typed);
            desk.ui.type(field.typed);
            ASSERT_TRUE(widgets::IsTyping(desk.workbench.widgets));
            if (way.turns_page && !desk.workbench.guide.is_shown()) continue;
            way.leave(desk);
            desk.ui.frames(3);
            EXPECT_EQ(field.value(desk), field.typed);
            EXPECT_TRUE(way.goes_on || !widgets::IsTyping(desk.workbench.widgets)) << "the field is still being edited";
        }
}

TEST(TextFields, EscapeDiscardsTheTypedTextAndNothingElse) {
    for (const FieldOfText& field : all_fields()) {
        SCOPED_TRACE(field.name);
        FieldDesk desk({1600, 1100});
        field.begin(desk);
        const std::string before = field.value(desk);
        desk.ui.type(field.typed);
        desk.press(Key::escape);
        desk.ui.frames(3);
        EXPECT_EQ(field.value(desk), before);
        EXPECT_FALSE(widgets::IsTyping(desk.workbench.widgets));
        EXPECT_EQ(desk.workbench.exercises.page.is_open(), field.is_on_page) << "Escape also closed the page";
    }
}

/// The user types three texts in a row with Tab between them, then goes back with Shift+Tab.
TEST(TextFields, TabFillsThreeFieldsInARow) {
    FieldDesk desk({1600, 900}, Student{});
    open_page(desk);
    desk.ui.click("exercises/Student number");
    for (const char* text : {"32201234", "viewing-2026", "Kim"}) {
        desk.ui.type(text);
        desk.ui.key(ImGuiKey_Tab);
    }
    EXPECT_EQ(desk.workbench.exercises.desk.student(), (Student{"viewing-2026", "32201234", "Kim"}));
    desk.ui.click("exercises/Name");
    select_all(desk);
    desk.ui.type("Lee");
    desk.ui.key(ImGuiKey_Tab, true);
    select_all(desk);
    desk.ui.type("v2");
    desk.ui.key(ImGuiKey_Tab, true);
    EXPECT_EQ(desk.workbench.exercises.desk.student(), (Student{"v2", "32201234", "Lee"}));
}

TEST(TextFields, LeavingAPageByAClickKeepsTheTypedText) {
    for (const char* const button : {"exercises/Close", "exercises/Open answers…", "exercises/card 2"}) {
        SCOPED_TRACE(button);
        FieldDesk desk({1600, 900}, Student{});
        open_page(desk);
        desk.ui.click("exercises/Student number");
        desk.ui.type("32201234");
        desk.ui.click(button);
        desk.make();
        desk.ui.frames(4);
        EXPECT_FALSE(desk.workbench.exercises.page.is_open());
        EXPECT_EQ(desk.workbench.exercises.desk.student().number, "32201234");
    }
}

/// The fields of dialogs: however the user leaves one, the dialog can use its text at once.
class ActingFields : public testing::ScratchFolder {};

TEST_F(ActingFields, AFileNameIsTheTextOfItsField) {
    for (const auto& [name, leave] : {std::pair<const char*, std::function<void(FieldDesk&)>>{
                                          "Enter", [](FieldDesk& desk) { desk.ui.key(ImGuiKey_Enter); }},
                                      {"a click on Save", [](FieldDesk& desk) { desk.ui.click("file/Save"); }},
                                      {"Tab, then Save",
                                       [](FieldDesk& desk) {
                                           desk.ui.key(ImGuiKey_Tab);
                                           desk.ui.click("file/Save");
                                       }},
                                      {"the focus lost, then Save", [](FieldDesk& desk) {
                                           widgets::EndTyping(desk.workbench.widgets);
                                           desk.ui.frames(2);
                                           desk.ui.click("file/Save");
                                       }}}) {
        SCOPED_TRACE(name);
        FieldDesk desk({1600, 900});
        desk.press_with(Key::ctrl, Key::s);
        ASSERT_TRUE(desk.ui.has("file/name"));
        select_all(desk);
        const std::filesystem::path file = folder_ / "typed.json";
        desk.ui.type(file.c_str());
        leave(desk);
        desk.settle();
        EXPECT_TRUE(is_there(file));
        std::filesystem::remove(file);
    }
}

}  // namespace
}  // namespace viewing::test
