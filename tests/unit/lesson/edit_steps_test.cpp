// Editing a lesson's file from the window: steps that are typed, moved, duplicated, or removed read back correctly, and
// a bad edit gives one error sentence and leaves the text unchanged.
#include "lesson/edit_steps.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "lesson/append.h"
#include "platform/file.h"
#include "platform/sanitized.h"
#include "state/scene.h"

namespace viewing {
namespace {

using Kind = StepPart::Kind;

LessonSource lesson_file(const std::string& name) {
    return {*read_text_file(assets_directory() / "lessons" / name), name, assets_directory() / "lessons"};
}

/// A file with two steps, each saved from a state.
LessonSource own_file() {
    Params second;
    second.projection.near = 2.0;
    LessonSource source{"", "mine.json", ""};
    source.text = *with_step("", source.name, {}, "");
    source.text = *with_step(source.text, source.name, second, "walk", {"control:projection.near"});
    return source;
}

Lesson read(const LessonSource& source) {
    Result<Lesson> lesson = parse_lesson(source.text, source.name, source.folder);
    EXPECT_TRUE(lesson) << lesson.error();
    return *std::move(lesson);
}

std::vector<std::string> ids(const LessonSource& source) {
    std::vector<std::string> all;
    for (const LessonStep& step : read(source).steps) all.push_back(step.id);
    return all;
}

StepPart part_of(const LessonSource& source, std::size_t step, Kind kind, std::size_t number = 0) {
    for (const StepPart& part : step_parts(source, step, Language::en))
        if (part.kind == kind && part.number == number) return part;
    ADD_FAILURE() << "no such part";
    return {};
}

/// In three of the program's lessons, writing back any part of any step, except the right answer, changes nothing in
/// either language. Under sanitizers, the test writes back only every tenth part.
TEST(EditSteps, WritingBackEveryPartOfTheLessonsChangesNothing) {
    const std::size_t stride = is_sanitized ? 10 : 1;
    std::size_t parts = 0;
    for (const char* name : {"01-view-is-the-inverse.json", "08-two-buffers.json", "13-any-plane-any-light.json"}) {
        const LessonSource source = lesson_file(name);
        const Lesson before = read(source);
        for (std::size_t step = 0; step < before.steps.size(); ++step)
            for (const Language language : {Language::en, Language::ko})
                for (const StepPart& part : step_parts(source, step, language)) {
                    if (part.kind == Kind::right || (++parts % stride != 0)) continue;
                    const Result<std::string> text = with_part(source, step, part, language);
                    ASSERT_TRUE(text) << text.error() << " " << part.place;
                    const Lesson after = read({*text, source.name, source.folder});
                    EXPECT_EQ(after.steps[step].ask.question, before.steps[step].ask.question) << part.place;
                    EXPECT_EQ(after.steps[step].reveal.say, before.steps[step].reveal.say) << part.place;
                    EXPECT_EQ(after.steps[step].note, before.steps[step].note) << part.place;
                }
    }
    EXPECT_GT(parts, 200U);
}

TEST(EditSteps, ATypedSentenceIsReadInItsLanguageAlone) {
    LessonSource source = own_file();
    StepPart question = part_of(source, 0, Kind::question);
    EXPECT_EQ(question.text, template_texts.question);
    question.text = "Where is \"p\"?";
    source.text = *with_part(source, 0, question, Language::en);
    question.text = "p는 어디입니까?";
    source.text = *with_part(source, 0, question, Language::ko);
    const LessonText read_back = read(source).steps[0].ask.question;
    EXPECT_EQ(read_back.in(Language::en), "Where is \"p\"?");
    EXPECT_EQ(read_back.in(Language::ko), "p는 어디입니까?");
    EXPECT_EQ(read(source).steps[1].ask.question.in(Language::en), template_texts.question);
    StepPart note = part_of(source, 1, Kind::note);
    EXPECT_EQ(note.text, "");
    note.text = "Wait for the vote.";
    source.text = *with_part(source, 1, note, Language::en);
    EXPECT_EQ(read(source).steps[1].note.in(Language::en), note.text);
    note.text.clear();
    source.text = *with_part(source, 1, note, Language::en);
    EXPECT_TRUE(read(source).steps[1].note.empty());
}

TEST(EditSteps, ExactlyOneChoiceIsRight) {
    LessonSource source = own_file();
    source.text = *with_choice(source, 0);
    EXPECT_EQ(read(source).steps[0].ask.choices.size(), 3U);
    const Result<std::string> marked =
        with_part(source, 0, {Kind::right, 2, "/ask/choices/2/right", "true"}, Language::en);
    ASSERT_TRUE(marked) << marked.error();
    source.text = *marked;
    const std::vector<LessonChoice> choices = read(source).steps[0].ask.choices;
    EXPECT_FALSE(choices[0].right || choices[1].right);
    EXPECT_TRUE(choices[2].right);
}

TEST(EditSteps, StepsAreMovedDoubledAndRemoved) {
    LessonSource source = own_file();
    EXPECT_EQ(read(source).steps[1].highlight, std::vector<std::string>{"control:projection.near"});
    source.text = *with_doubled_step(source, 0);
    EXPECT_EQ(ids(source), (std::vector<std::string>{"step-1", "step-1-2", "step-2"}));
    source.text = *with_doubled_step(source, 0);
    EXPECT_EQ(ids(source), (std::vector<std::string>{"step-1", "step-1-3", "step-1-2", "step-2"}));
    source.text = *with_moved_step(source, 3, 0);
    EXPECT_EQ(ids(source), (std::vector<std::string>{"step-2", "step-1", "step-1-3", "step-1-2"}));
    source.text = *with_moved_step(source, 0, 99);
    EXPECT_EQ(ids(source).back(), "step-2");
    EXPECT_EQ(read(source).steps.back().start.params.projection.near, 2.0) << "the whole step moves";
    for (int removed = 0; removed < 3; ++removed) source.text = *with_removed_step(source, 0);
    EXPECT_EQ(ids(source), std::vector<std::string>{"step-2"});
    EXPECT_EQ(with_removed_step(source, 0).error(), "mine.json: a lesson needs at least one step");
}

TEST(EditSteps, TakeTheStateOnTheScreen) {
    LessonSource source = own_file();
    Params start, revealed;
    start.camera.yaw = 12.0;
    start.view.lower_left = Topic::pixel;
    start.view.layout.folded = {"panel"};
    start.follow = Follow{"box", 3};
    revealed = start;
    revealed.depth.test = false;
    source.text = *with_start(source, 0, start, "");
    source.text = *with_revealed(source, 0, start, revealed);
    const LessonStep step = read(source).steps[0];
    EXPECT_EQ(step.start.params, start);
    EXPECT_EQ(step.revealed, revealed);
}

TEST(EditSteps, ABadEditIsOneSentence) {
    const LessonSource source = lesson_file("10-depth-is-not-linear.json");
    const std::vector<StepPart> parts = step_parts(source, 1, Language::en);
    const auto answer = std::ranges::find(parts, Kind::answer, &StepPart::kind);
    ASSERT_NE(answer, parts.end());
    StepPart typed = *answer;
    typed.text = "2 +";
    const Result<std::string> text = with_part(source, 1, typed, Language::en);
    ASSERT_FALSE(text);
    EXPECT_TRUE(text.error().starts_with("10-depth-is-not-linear.json: ")) << text.error();
    EXPECT_EQ(text.error().find('\n'), std::string::npos);
    EXPECT_EQ(with_removed_step(source, 99).error(), "10-depth-is-not-linear.json: has no step 100");
    EXPECT_FALSE(with_moved_step({"{", "x.json", ""}, 0, 1));
    EXPECT_FALSE(with_moved_step({R"({"steps":[3]})", "x.json", ""}, 0, 1));
    EXPECT_TRUE(step_parts({"[", "x.json", ""}, 0, Language::en).empty());
}

}  // namespace
}  // namespace viewing
