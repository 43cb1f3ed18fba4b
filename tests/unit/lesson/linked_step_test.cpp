// Links to a step of a lesson: each step of each lesson round-trips through its own link, and nothing else opens.
#include <gtest/gtest.h>

#include "lesson/linked_step.h"
#include "platform/file.h"
#include "trials.h"

namespace viewing {
namespace {

std::string link_trouble(const std::string& text) {
    const std::optional<Link> link = lesson_link(text);
    if (!link) return "none";
    const Result<LinkedStep> step = load_linked_step(*link);
    return step ? "nothing" : step.error();
}

TEST(LinkedStep, EveryStepRoundTripsThroughItsLink) {
    ASSERT_GT(lessons().size(), 5U);
    std::size_t index = 0;
    for (const LessonFile& file : lessons()) {
        if (!testing::takes(index++)) continue;
        const Lesson lesson = *load_lesson(file.id);
        for (std::size_t step = 0; step < lesson.steps.size(); ++step) {
            SCOPED_TRACE(lesson.id + " " + std::to_string(step));
            const std::optional<std::string> text = link_to(lesson, step);
            ASSERT_TRUE(text);
            EXPECT_EQ(*text, "#lesson=" + file.id + "&step=" + std::to_string(step + 1));
            const std::optional<Link> link = lesson_link("https://example.org/v.html" + *text + "\n");
            ASSERT_TRUE(link);
            if (step > 0 && step + 1 < lesson.steps.size()) continue;
            const Result<LinkedStep> back = load_linked_step(*link);
            ASSERT_TRUE(back) << back.error();
            EXPECT_EQ(back->lesson.file, lesson.file);
            EXPECT_EQ(back->step, step);
        }
    }
}

TEST(LinkedStep, DefaultsToTheFirstStep) {
    EXPECT_EQ(load_linked_step(*lesson_link("#lesson=depth-fighting"))->step, 0U);
}

TEST(LinkedStep, ReportsAMissingStep) {
    const std::size_t count = load_lesson("depth-fighting")->steps.size();
    EXPECT_EQ(link_trouble("#lesson=depth-fighting&step=" + std::to_string(count)), "nothing");
    EXPECT_EQ(link_trouble("#lesson=depth-fighting&step=" + std::to_string(count + 1)),
              "link: step " + std::to_string(count + 1) + ": depth-fighting has steps 1 to " + std::to_string(count));
    EXPECT_EQ(link_trouble("#lesson=depth-fihting"),
              "link: depth-fihting: neither a file nor a lesson or lecture (viewing-sandbox lesson --list and lecture "
              "--list list them); did you "
              "mean depth-fighting?");
    for (const char* other : {"depth-fighting", "#preset=room", "#lesson=../a", "#lesson=a.json", "#1abc", ""})
        EXPECT_EQ(link_trouble(other), "none") << other;
}

/// A link cannot open the user's own file, so a custom lesson has no link, regardless of its id.
TEST(LinkedStep, CustomLessonHasNoLink) {
    Lesson lesson = *load_lesson("depth-fighting");
    lesson.file = "/tmp/depth-fighting.json";
    EXPECT_FALSE(link_to(lesson, 0));
}

}  // namespace
}  // namespace viewing
