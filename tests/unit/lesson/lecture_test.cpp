// The shipped lessons follow the plan of the lecture: seventeen lessons in its order, with 116 steps. Each step asks a
// question before it reveals the answer, responds to common mistakes, and changes something when it reveals the answer.
// Checking the steps' claims and answers needs the renderer: `viewing-sandbox lesson --check` does that.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>

#include "lesson/lesson.h"
#include "text/words.h"

namespace viewing {
namespace {

/// Returns all lessons. Reports a failure for each lesson that cannot be read, and leaves it out.
const std::vector<Lesson>& lecture() {
    static const std::vector<Lesson> read = [] {
        std::vector<Lesson> result;
        for (const LessonFile& file : lessons()) {
            Result<Lesson> lesson = load_lesson(file.path.string());
            if (lesson) {
                result.push_back(*std::move(lesson));
            } else {
                ADD_FAILURE() << lesson.error();
            }
        }
        return result;
    }();
    return read;
}

/// Calls `look` with every step and its name for messages.
template <typename Look>
void for_each_step(const Look& look) {
    for (const Lesson& lesson : lecture())
        for (const LessonStep& step : lesson.steps) look(step, lesson.id + ", step " + step.id);
}

std::vector<std::string> texts_of(const LessonStep& step) {
    // A value that is filled in has up to five characters.
    const std::string told = std::regex_replace(step.reveal.say.in_english(), std::regex("\\{[^}]*\\}"), "0.000");
    std::vector<std::string> texts{step.say.in_english(), step.ask.question.in_english(), told};
    for (const LessonChoice& choice : step.ask.choices) texts.push_back(choice.why.in_english());
    for (const WrongAnswer& wrong : step.ask.wrong) texts.push_back(wrong.say.in_english());
    return texts;
}

/// Counts the ends of sentences: a period, question mark or exclamation point before a space or at the end of the text.
int sentence_count(const std::string& text) {
    int count = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool is_stop = text[i] == '.' || text[i] == '?' || text[i] == '!';
        count += is_stop && (i + 1 == text.size() || text[i + 1] == ' ');
    }
    return count;
}

TEST(LectureLessons, FollowTheOrderOfTheSlides) {
    const std::pair<const char*, std::size_t> plan[] = {{"view-is-the-inverse", 8},
                                                        {"fly-and-walk", 6},
                                                        {"lens", 7},
                                                        {"who-hides-whom", 6},
                                                        {"orders", 7},
                                                        {"rays", 4},
                                                        {"two-sides", 6},
                                                        {"two-buffers", 6},
                                                        {"gl-depth", 6},
                                                        {"depth-is-not-linear", 6},
                                                        {"depth-fighting", 8},
                                                        {"similar-triangles", 6},
                                                        {"any-plane-any-light", 10},
                                                        {"drawing-the-shadow", 7},
                                                        {"mirror-matrix", 10},
                                                        {"drawing-the-mirror", 7},
                                                        {"why-this-pixel", 6}};
    ASSERT_EQ(lecture().size(), std::size(plan));
    std::size_t steps = 0;
    for (std::size_t i = 0; i < std::size(plan); ++i) {
        EXPECT_EQ(lecture()[i].id, plan[i].first);
        EXPECT_EQ(lecture()[i].steps.size(), plan[i].second) << plan[i].first;
        EXPECT_FALSE(lecture()[i].slides.empty()) << plan[i].first;
        EXPECT_GE(lecture()[i].minutes, 10) << plan[i].first;
        steps += lecture()[i].steps.size();
    }
    EXPECT_EQ(steps, 116U);
}

TEST(LectureLessons, PrerequisitesComeFirst) {
    std::set<std::string> before;
    for (const Lesson& lesson : lecture()) {
        for (const std::string& needed : lesson.needs) EXPECT_TRUE(before.contains(needed)) << lesson.id << needed;
        before.insert(lesson.id);
    }
}

TEST(LectureLessons, EveryStepRespondsToMistakes) {
    for_each_step([](const LessonStep& step, const std::string& name) {
        if (step.ask.kind == AskKind::choice) {
            EXPECT_GE(step.ask.choices.size(), 3U) << name;
            EXPECT_LE(step.ask.choices.size(), 4U) << name;
            EXPECT_TRUE(std::any_of(step.ask.choices.begin(), step.ask.choices.end(), [](const LessonChoice& choice) {
                return !choice.tag.empty();
            })) << name;
        } else {
            EXPECT_FALSE(step.ask.wrong.empty()) << name;
            EXPECT_FALSE(step.ask.hints.empty()) << name;
            EXPECT_LE(step.ask.hints.size(), 2U) << name;
        }
    });
}

TEST(LectureLessons, EveryRevealShowsSomethingAndHasClaimsAndANote) {
    for_each_step([](const LessonStep& step, const std::string& name) {
        EXPECT_TRUE(!step.reveal.settings.empty() || !step.reveal.highlight.empty()) << name;
        EXPECT_FALSE(step.claims.empty()) << name;
        EXPECT_FALSE(step.note.empty()) << name;
    });
}

TEST(LectureLessons, NoStepShowsOneViewTwice) {
    for_each_step([](const LessonStep& step, const std::string& name) {
        for (const Params* const params : {&step.start.params, &step.revealed}) {
            const ViewParams& view = params->view;
            EXPECT_TRUE(view.lower_left == Topic::automatic || view.lower_left != view.lower_right) << name;
        }
    });
}

TEST(LectureLessons, TextsAreShortEnoughForTheLastRow) {
    for_each_step([](const LessonStep& step, const std::string& name) {
        for (const std::string& text : texts_of(step)) {
            EXPECT_LE(sentence_count(text), 2) << name << ": " << text;
            EXPECT_LE(character_count(text), 140U) << name << ": " << text;
        }
        EXPECT_LE(sentence_count(step.note.in_english()), 3) << name << ": " << step.note.in_english();
    });
}

TEST(LectureLessons, RightAnswerIsSpreadOverTheFirstThreePlaces) {
    std::map<std::ptrdiff_t, int> places;
    int choices = 0;
    for_each_step([&](const LessonStep& step, const std::string&) {
        if (step.ask.kind != AskKind::choice) return;
        const auto right = std::find_if(step.ask.choices.begin(), step.ask.choices.end(),
                                        [](const LessonChoice& choice) { return choice.right; });
        ++places[right - step.ask.choices.begin()];
        ++choices;
    });
    for (const std::ptrdiff_t place : {0, 1, 2}) EXPECT_GE(5 * places[place], choices) << "place " << place;
}

}  // namespace
}  // namespace viewing
