// Exercises in the window: every question is readable, fields and the clipboard take input, and only a right answer
// uncovers hidden parts.
#include <gtest/gtest.h>

#include <chrono>
#include <map>
#include <set>

#include "exercise_desk.h"
#include "readable.h"
#include "unit/state/scratch_folder.h"

namespace viewing::test {
namespace {

struct Screen {
    ImVec2 size;
    Theme theme = Theme::dark;
    Language language = Language::en;
};
std::ostream& operator<<(std::ostream& out, const Screen& screen) {
    return out << screen.size.x << "x" << screen.size.y << " " << name_of(screen.theme) << " "
               << name_of(screen.language);
}
const Screen screens[] = {{{1600, 900}},
                          {{1280, 720}, Theme::projector},
                          {{1024, 768}},
                          {{1280, 720}, Theme::dark, Language::ko},
                          {{1024, 768}, Theme::projector, Language::ko}};

class ExerciseScreensSlowTest : public ::testing::TestWithParam<Screen> {
protected:
    void SetUp() override {
        desk.params().ui.theme = GetParam().theme;
        desk.params().ui.language = GetParam().language;
        desk.apply_looks();
    }
    ExerciseSheetDesk desk{GetParam().size};
};

/// Checks each question before an answer and after each known wrong answer. At each screen size, only every other
/// exercise is checked.
TEST_P(ExerciseScreensSlowTest, EveryQuestionIsReadable) {
    std::map<std::string, std::string> wrong;
    std::size_t count = GetParam().size.x > 1100.0F ? 0 : 1;
    for (const ExerciseDesk::Entry& entry : desk.workbench.exercises.desk.entries()) {
        if (!*entry.step || count++ % 2 != 0) continue;
        desk.begin(entry.exercise.id);
        for (const std::string& text : unreadable(desk)) wrong.emplace(text, entry.exercise.id);
        for (const WrongAnswer& known : desk.run().step().ask.wrong) {
            Verdict verdict;
            verdict.say = known.say;
            desk.run().take(verdict);
            desk.ui.frames(2);
            for (const std::string& text : unreadable(desk)) wrong.emplace(text, entry.exercise.id + ", with feedback");
        }
    }
    for (const auto& [text, where] : wrong) ADD_FAILURE() << where << ", " << text;
}

TEST_P(ExerciseScreensSlowTest, ThePageIsReadable) {
    desk.workbench.exercises.open_page();
    desk.ui.frames(4);
    for (const std::string& text : unreadable(desk)) ADD_FAILURE() << text;
}

INSTANTIATE_TEST_SUITE_P(Screens, ExerciseScreensSlowTest, ::testing::ValuesIn(screens));

class ExercisesInTheWindow : public ::testing::Test {
protected:
    ExerciseSheetDesk desk{{1600, 900}};
    widgets::test::Harness& ui = desk.ui;
};

TEST_F(ExercisesInTheWindow, TheButtonOpensThePageAndACardOpensItsExercise) {
    desk.click("top/Exercises");
    ui.frames(3);
    ASSERT_TRUE(ui.has("exercises/card 1"));
    desk.click("exercises/card 16");
    ui.frames(3);
    desk.settle();
    EXPECT_FALSE(desk.workbench.exercises.page.is_open());
    ASSERT_TRUE(desk.workbench.guide.is_sheet());
    EXPECT_EQ(desk.run().step().id, "E16-shadow-matrix");
}

TEST_F(ExercisesInTheWindow, ACardClickedTooEarlyOpensWhenTheSheetIsReady) {
    desk.click("top/Exercises");
    ui.frames(3);
    desk.workbench.exercises.desk.sit_down({"viewing-2026", "32209999", "Lee"});
    ui.frames(1);
    ASSERT_FALSE(desk.workbench.exercises.desk.is_ready());
    desk.click("exercises/card 16");
    ui.frames(3);
    EXPECT_TRUE(desk.workbench.exercises.page.is_open());
    desk.make();
    ui.frames(3);
    desk.settle();
    EXPECT_FALSE(desk.workbench.exercises.page.is_open());
    ASSERT_TRUE(desk.workbench.guide.is_sheet());
    EXPECT_EQ(desk.run().step().id, "E16-shadow-matrix");
    EXPECT_EQ(desk.run().lesson().sheet->student, "32209999");
}

TEST_F(ExercisesInTheWindow, PageDownAdvancesWithoutShowingAnswers) {
    desk.begin("E16-shadow-matrix");
    desk.press(Key::page_down);
    desk.settle();
    EXPECT_EQ(desk.run().step().id, "E17-shadow-point");
    for (int i = 0; i < 30; ++i) desk.press(Key::page_down);
    EXPECT_TRUE(desk.run().is_last());
    for (int i = 0; i < 40; ++i) {
        EXPECT_FALSE(desk.run().is_revealed()) << desk.run().step().id;
        desk.press(Key::page_up);
    }
    EXPECT_TRUE(desk.run().is_first());
}

TEST_F(ExercisesInTheWindow, PastedNumbersBecomeTheAnswer) {
    desk.begin("E16-shadow-matrix");
    desk.clipboard = "array([[1., 2, 3, 4],\n [5, 6, 7, 8], [9, 10, 11, −12], [1/4, 0, 0, 1e-3]], dtype=float64)";
    desk.press_with(Key::ctrl, Key::v);
    const std::vector<double> wanted{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, -12, 0.25, 0, 0, 0.001};
    EXPECT_EQ(desk.run().answer().numbers, wanted);
    desk.clipboard = "1 2 3";
    desk.click("lesson strip/Paste");
    EXPECT_EQ(desk.run().answer().numbers, wanted) << "three numbers are not a matrix";
    EXPECT_NE(desk.run().trouble().find("3 numbers"), std::string::npos) << desk.run().trouble();
}

TEST_F(ExercisesInTheWindow, AMisconceptionIsExplainedAndARightAnswerUncovers) {
    desk.begin("E16-shadow-matrix");
    const Result<Surroundings> numbers = numbers_of(desk.run().step().start, desk.run().step().start.params, nullptr);
    ASSERT_TRUE(numbers);
    const Answer right = *model_answer(desk.run().step().ask, *numbers);
    Answer transposed = right;
    for (std::size_t i = 0; i < 16; ++i) transposed.numbers[i] = right.numbers[i % 4 * 4 + i / 4];
    desk.run().answer() = transposed;
    desk.check();
    EXPECT_EQ(desk.run().verdict()->tag, "M33");
    EXPECT_EQ(ui.text_of("matrices/S"), "?");
    EXPECT_FALSE(desk.workbench.exercises.desk.is_right("E16-shadow-matrix"));
    desk.run().answer() = right;
    desk.run().answer().numbers[5] += 1.0;
    desk.check();
    EXPECT_EQ(desk.run().verdict()->places, (std::vector<int>{1, 3, 4})) << "the rows that are right";
    desk.run().answer() = right;
    for (double& number : desk.run().answer().numbers) number *= -2.5;  // any multiple of the matrix is the same map
    desk.check();
    EXPECT_TRUE(desk.run().is_revealed());
    desk.settle();
    EXPECT_TRUE(ui.has("matrices/S/r0c0")) << "the covered part is shown";
    EXPECT_EQ(desk.workbench.exercises.desk.points(), 3);
    EXPECT_EQ(desk.workbench.exercises.desk.hand_in().find("E16-shadow-matrix")->attempts.size(), 3U);
}

TEST_F(ExercisesInTheWindow, ShowsTheEffectOfAMatrixAndEscapeLeaves) {
    desk.begin("E16-shadow-matrix");
    desk.run().answer().numbers.assign(16, 1.0);
    desk.check();
    desk.click("lesson strip/What my matrix does");
    ui.frames(3);
    ASSERT_TRUE(ui.has("typed matrix/your matrix"));
    const std::vector<CardPicture> wanted = desk.workbench.wanted_cards();
    ASSERT_EQ(wanted.size(), 2U);
    const Result<LoadedState> typed = wanted[0].load(), right = wanted[1].load();
    ASSERT_TRUE(typed && right);
    EXPECT_TRUE(typed->params.overrides != right->params.overrides);
    EXPECT_TRUE(right->params.overrides == Params{}.overrides);
    for (const std::string& text : unreadable(desk)) ADD_FAILURE() << text;
    desk.press(Key::escape);
    EXPECT_FALSE(ui.has("typed matrix/your matrix"));
}

TEST_F(ExercisesInTheWindow, ProgressTowardAGoalIsKeptAcrossExercises) {
    desk.begin("E18-place-the-light");
    desk.session.params.lights.front().position = {1.0, 9.0, 2.0, 1.0};
    desk.ui.frames(3);
    desk.press(Key::page_down);
    desk.settle();
    EXPECT_NE(desk.run().step().id, "E18-place-the-light");
    desk.press(Key::page_up);
    desk.settle();
    EXPECT_EQ(desk.session.params.lights.front().position, glm::dvec4(1.0, 9.0, 2.0, 1.0));
    const HandInItem* const item = desk.workbench.exercises.desk.hand_in().find("E18-place-the-light");
    ASSERT_TRUE(item);
    EXPECT_EQ(item->draft_settings, std::vector<std::string>{"light.position=[1.0,9.0,2.0,1.0]"});
    EXPECT_EQ(item->replay.size(), 1U);
}

TEST_F(ExercisesInTheWindow, AnotherStudentNumberHasItsOwnSheet) {
    desk.begin("E16-shadow-matrix");
    const std::size_t variant = desk.run().lesson().sheet->items[desk.run().index()].variant;
    desk.click("lesson strip/All exercises");
    ui.frames(3);
    std::set<std::size_t> variants;
    for (const char* number : {"1", "2", "3", "4", "5", "6"}) {
        desk.workbench.exercises.desk.sit_down({"viewing-2026", number, ""});
        variants.insert(desk.workbench.exercises.desk.entries()[15].variant);
    }
    EXPECT_GT(variants.size(), 2U);
    desk.workbench.exercises.desk.sit_down({"viewing-2026", "32201234", "Kim"});
    EXPECT_EQ(desk.workbench.exercises.desk.entries()[15].variant, variant);
}

/// Returns all text on the screen, lines joined by spaces.
std::string drawn(const Desk& desk) {
    const widgets::Fonts& fonts = desk.workbench.widgets.fonts;
    const Page page{fonts.text, fonts.heading, fonts.note, fonts.number, fonts.small_number, fonts.caption};
    std::string text;
    const ImDrawData& data = *ImGui::GetDrawData();
    for (int i = 0; i < data.CmdListsCount; ++i)
        for (const Line& line : lines_of(page.letters(*data.CmdLists[i]))) text += line.text + ' ';
    return text;
}

class Practice : public testing::ScratchFolder {};

/// The student answers without a student number, then enters one. The page mentions the practice run, imports its
/// answers, and leads to it and back.
TEST_F(Practice, IsMentionedAndAdoptedOnThePage) {
    ExerciseSheetDesk desk({1600, 900}, Student{});
    widgets::test::Harness& ui = desk.ui;
    desk.workbench.exercises.desk.keep_in(folder_, "test");
    desk.workbench.exercises.desk.sit_down(Student{});
    const auto settle = [&] {
        EXPECT_TRUE(desk.workbench.exercises.desk.finish());
        const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(60);
        do {  // the sheet is read on another thread
            ui.frame();
            desk.make();
        } while (!desk.workbench.exercises.desk.is_ready() && std::chrono::steady_clock::now() < patience);
        ui.frames(4);
    };
    const auto says = [&](const std::string& sentence) {
        EXPECT_NE(drawn(desk).find(sentence), std::string::npos) << sentence << "\n" << drawn(desk);
    };
    const auto variant = [&] { return desk.workbench.exercises.desk.entries()[15].variant; };
    settle();
    desk.click("top/Exercises");
    settle();
    says("Practice: student number and course are missing. Answers are kept on this computer and are not handed in.");
    EXPECT_FALSE(ui.has("exercises/Import"));
    EXPECT_FALSE(ui.has("exercises/Practice")) << "this is a practice run";
    const std::size_t practiced = variant();
    desk.click("exercises/card 16");
    ui.frames(3);
    desk.settle();
    desk.run().answer() = *model_answer(desk.run().step().ask,
                                        *numbers_of(desk.run().step().start, desk.run().step().start.params, nullptr));
    desk.check();
    settle();

    desk.click("lesson strip/All exercises");
    ui.frames(3);
    Student student{"viewing-2026", "", ""};
    for (int number = 1; number < 1000; ++number) {  // find a student whose variant has the practiced values
        student.number = std::to_string(number);
        desk.workbench.exercises.desk.sit_down(student);
        if (variant() == practiced) break;
    }
    desk.workbench.exercises.desk.sit_down(Student{});
    settle();
    for (const auto& [field, text] :
         {std::pair("exercises/Student number", student.number), std::pair("exercises/Course", student.course)}) {
        ui.click(field);
        ui.type(text.c_str());
        ui.key(ImGuiKey_Tab);
        settle();
    }
    says("You practiced one exercise. One of them has your numbers: you can import its answers.");
    EXPECT_EQ(desk.workbench.exercises.desk.points(), 0);
    desk.click("exercises/Import");
    settle();
    EXPECT_EQ(desk.workbench.exercises.desk.points(), 3);
    EXPECT_FALSE(ui.has("exercises/Import"));
    says("You practiced one exercise. The answers are kept under Practice.");

    desk.click("exercises/Practice");
    settle();
    EXPECT_TRUE(desk.workbench.exercises.desk.is_practice());
    says("Practice: these are not your numbers.");
    desk.click("exercises/My sheet");
    settle();
    EXPECT_FALSE(desk.workbench.exercises.desk.is_practice());
    says("You practiced one exercise.");
}

}  // namespace
}  // namespace viewing::test
