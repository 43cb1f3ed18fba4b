// Exercises: how a pattern becomes a step with a student's own numbers, and the errors of a broken file. Also checks
// that the shipped exercises are complete in both languages.
#include "lesson/exercise.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <iterator>
#include <set>

#include "lesson/questions/judge.h"
#include "lesson/variants.h"
#include "state/scene.h"
#include "unit/lesson/has.h"

namespace viewing {
namespace {

using testing::has;

namespace fs = std::filesystem;

// ---- an exercise made by hand ---------------------------------------------------------------------------------------

const char* const number_exercise = R"({
  "exercise": 1, "id": "T01-yaw", "title": {"en": "Yaw", "ko": "요"}, "sets": ["camera"], "slides": [3], "points": 2,
  "tags": {"M02": {"en": "sign", "ko": "부호"}},
  "pick": {"P": [[0, 1, 0, 2.5]], "k": [30, 40], "n": [3]},
  "require": ["k > 10"],
  "step": {
    "state": {"set": {"camera.yaw": "=k", "camera.position": "={n, 1.5, P[3]}"}},
    "layout": {"target": {"point": "={n, 0, -n}", "label": {"en": "p{n}", "ko": "점{n}"}}},
    "ask": {
      "kind": "number", "question": {"en": "From {k} to P = {P}: {camera.yaw / 7}, {-n}.", "ko": "{k}도"},
      "expect": "=2 * camera.yaw", "tol": 0.5, "hints": ["Twice {k}."],
      "wrong": [
        {"value": "=-2 * k", "tag": "M02", "say": "Not −{2 * k}."},
        {"value": "=2 * k", "unless": "camera.yaw == k", "say": "dropped"},
        {"value": 1, "unless": "k == 41", "say": "kept"}
      ]
    },
    "reveal": {"set": {"camera.pitch": "=-n"}, "say": "It was {k}."}
  }
})";

const char* const goal_exercise = R"({
  "exercise": 1, "id": "T02-turn", "title": "Turn", "pick": {"k": [90]},
  "step": {"ask": {"kind": "goal", "question": "Turn to {k}.", "until": "camera.yaw > k", "allow": ["camera.yaw"],
                   "model": {"camera.yaw": "=k + start.camera.yaw"},
                   "wrong": [{"when": "camera.yaw < 0", "try": {"camera.yaw": "=-k"}, "say": "The other way."}]}}
})";

/// Returns surroundings that know only the start state's camera and a P, which the exercise's constant P must hide.
Result<Surroundings> camera_alone(const LoadedState& start) {
    const CameraParams camera = start.params.camera;
    Surroundings surroundings;
    surroundings.look_up = [camera](const std::string& name, std::span<const double>) -> Result<Json> {
        const Json fields = {{"yaw", camera.yaw}, {"pitch", camera.pitch}};
        if (name == "camera") return fields;
        if (name == "start") return Json{{"camera", fields}};
        if (name == "P") return Json(-777.0);
        return Error{name + " is not made here"};
    };
    return surroundings;
}

std::string with(std::string text, const std::string& part, const std::string& other) {
    const std::size_t at = text.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    return at == std::string::npos ? text : text.replace(at, part.size(), other);
}

/// Returns the step of the first variant that contains this text. The text is needed because variants are shuffled.
Result<LessonStep> step_of(const std::string& json, const std::string& variant = "\"k\":") {
    const Result<Exercise> exercise = parse_exercise(json, "mine.json", "");
    if (!exercise) return Error{exercise.error()};
    for (std::size_t i = 0; i < exercise->variants.size(); ++i)
        if (exercise->variants[i].find(variant) != std::string::npos) return variant_step(*exercise, i, camera_alone);
    return Error{"no variant has " + variant};
}

/// Returns the error: one sentence that begins with the file name and is safe to print in a terminal; "" if there is
/// none.
std::string trouble_with(const std::string& json) {
    const Result<LessonStep> step = step_of(json);
    EXPECT_FALSE(step) << "the file is accepted";
    if (step) return "";
    const std::string& told = step.error();
    EXPECT_EQ(told.find("mine.json: "), 0U) << told;
    EXPECT_LT(told.size(), 600U) << told.substr(0, 600);
    for (const char c : told) EXPECT_TRUE(static_cast<unsigned char>(c) >= 0x20 && c != 0x7f) << told;
    return told;
}

std::string trouble_with(const std::string& part, const std::string& other) {
    return trouble_with(with(number_exercise, part, other));
}

TEST(Exercise, ReadsAWholeFile) {
    const Result<Exercise> exercise = parse_exercise(number_exercise, "mine.json", "/somewhere");
    ASSERT_TRUE(exercise) << exercise.error();
    EXPECT_EQ(exercise->id, "T01-yaw");
    EXPECT_EQ(exercise->short_id(), "T01");
    EXPECT_EQ(exercise->title.in(Language::ko), "요");
    EXPECT_TRUE(exercise->is_in("camera"));
    EXPECT_FALSE(exercise->is_in("cam"));
    EXPECT_EQ(exercise->slides, std::vector{3});
    EXPECT_EQ(exercise->points, 2);
    EXPECT_EQ(exercise->visible_px, 0);
    ASSERT_EQ(exercise->tags.size(), 1U);
    EXPECT_EQ(exercise->tags[0].second.in(Language::ko), "부호");
    EXPECT_EQ(exercise->variants.size(), 2U);
    EXPECT_EQ(exercise->file, fs::path("/somewhere/mine.json"));
}

TEST(Exercise, VariantHasItsNumbersEverywhere) {
    const Result<LessonStep> step = step_of(number_exercise, "\"k\":40");
    ASSERT_TRUE(step) << step.error();
    EXPECT_EQ(step->id, "T01-yaw");
    EXPECT_EQ(step->start.params.camera.yaw, 40.0);
    EXPECT_EQ(step->start.params.camera.position, glm::dvec3(3, 1.5, 2.5));
    EXPECT_EQ(step->say.in(Language::ko), "요") << "the title replaces a missing text";
    EXPECT_EQ(step->ask.question.in_english(), "From 40 to P = (0, 1, 0, 2.5): 5.71429, −3.");
    EXPECT_EQ(step->ask.question.in(Language::ko), "40도");
    EXPECT_EQ(step->ask.expect, "80") << "a whole number stays whole";
    EXPECT_EQ(step->ask.hints[0].in_english(), "Twice 40.");
    EXPECT_EQ(step->target->point_world, glm::dvec3(3, 0, -3));
    EXPECT_EQ(step->target->label.in(Language::ko), "점3");
    EXPECT_EQ(step->revealed.camera.pitch, -3.0);
    EXPECT_EQ(step->reveal.say.in_english(), "It was 40.");
    EXPECT_EQ(step->reveal.settings, std::vector<std::string>{"camera.pitch=-3"});
    EXPECT_EQ(Json::parse(step->ask.constants), Json::parse(R"({"P": [0, 1, 0, 2.5], "k": 40, "n": 3})"));
}

TEST(Exercise, DropsWrongAnswersThatWouldBeRight) {
    const Result<LessonStep> step = step_of(number_exercise, "\"k\":30");
    ASSERT_TRUE(step) << step.error();
    ASSERT_EQ(step->ask.wrong.size(), 2U);
    EXPECT_EQ(step->ask.wrong[0].sample.numbers, std::vector{-60.0});
    EXPECT_EQ(step->ask.wrong[0].say.in_english(), "Not −60.");
    EXPECT_EQ(step->ask.wrong[1].say.in_english(), "kept");
    EXPECT_TRUE(has(trouble_with("camera.yaw == k", "camera.yaw"), "wrong[1].unless: must be true or false"));
    EXPECT_TRUE(has(trouble_with("camera.yaw == k", "camera.yaw =="), "wrong[1].unless: "));
    EXPECT_TRUE(has(trouble_with("\"unless\": \"camera.yaw == k\"", "\"unless\": 1"), "wrong[1].unless: must be"));
}

TEST(Exercise, EachVariantIsJudgedByItsOwnNumbers) {
    for (const double k : {30.0, 40.0}) {
        const Result<LessonStep> step = step_of(number_exercise, "\"k\":" + std::to_string(static_cast<int>(k)));
        ASSERT_TRUE(step) << step.error();
        const Surroundings surroundings = *camera_alone(step->start);
        EXPECT_TRUE(judge(step->ask, {{2 * k}, {}}, surroundings)->right);
        EXPECT_EQ(judge(step->ask, {{-2 * k}, {}}, surroundings)->tag, "M02");
        EXPECT_FALSE(judge(step->ask, {{2 * (70 - k)}, {}}, surroundings)->right) << "the other student's answer";
    }
}

TEST(Exercise, FillsPlaceholdersInKeysToo) {
    const std::string json = with(number_exercise, R"("camera.yaw": "=k")", R"("{path}": "=k")");
    const Result<LessonStep> step = step_of(with(json, R"("n": [3])", R"("n": [3], "path": ["camera.roll"])"));
    ASSERT_TRUE(step) << step.error();
    EXPECT_NE(step->start.params.camera.roll, 0.0);
}

TEST(Exercise, ComputesTheModelOfAGoal) {
    const Result<LessonStep> step = step_of(goal_exercise);
    ASSERT_TRUE(step) << step.error();
    const double yaw = step->start.params.camera.yaw;
    EXPECT_EQ(step->revealed.camera.yaw, 90.0 + yaw);
    EXPECT_EQ(step->ask.wrong[0].settings, std::vector<std::string>{"camera.yaw=-90"});
    EXPECT_EQ(step->reveal.say.in_english(), "That is right.");
    EXPECT_EQ(step->reveal.say.in(Language::ko), "맞습니다.");
    LoadedState turned = step->start;
    turned.params.camera.yaw = 91.0;
    EXPECT_TRUE(judge(step->ask, {}, *camera_alone(turned))->right);
    turned.params.camera.yaw = 90.0;
    EXPECT_FALSE(judge(step->ask, {}, *camera_alone(turned))->right);
}

TEST(Exercise, GoalListsAllowedFields) {
    const std::string none = with(goal_exercise, R"("allow": ["camera.yaw"],)", "");
    EXPECT_TRUE(has(trouble_with(none), "ask.allow: is missing")) << trouble_with(none);
    const std::string empty = with(goal_exercise, R"("allow": ["camera.yaw"])", R"("allow": [])");
    EXPECT_TRUE(has(trouble_with(empty), "ask.allow: is missing")) << trouble_with(empty);
    EXPECT_TRUE(has(trouble_with(with(goal_exercise, R"(["camera.yaw"])", R"(["camera.yow"])")), "camera.yaw"));
}

TEST(Exercise, StateDependsOnThePicksAlone) {
    const std::string told = trouble_with(R"("camera.yaw": "=k")", R"("camera.yaw": "=camera.pitch")");
    EXPECT_TRUE(has(told, "state.set.camera.yaw: ")) << told;
    EXPECT_TRUE(has(told, "camera is not known here: it depends on the state")) << told;
    EXPECT_TRUE(has(trouble_with(R"("camera.yaw": "=k")", R"("camera.yaw": "=V[0][0]")"), "state.set.camera.yaw: V "));
}

TEST(Exercise, RequireSeesThePicksAlone) {
    const std::string told = trouble_with("\"k > 10\"", "\"camera.yaw > 10\"");
    EXPECT_TRUE(has(told, "require[0]: ")) << told;
    EXPECT_TRUE(has(trouble_with("\"k > 10\"", "\"kk > 10\""), "require[0]: unknown name kk"));
    EXPECT_TRUE(has(trouble_with("\"k > 10\"", "\"k + 10\""), "require[0]: must be true or false"));
    EXPECT_TRUE(has(trouble_with("\"k > 10\"", "\"k > 100\""), "require: rejects every combination"));
}

TEST(Exercise, RequireKeepsPassingCombinations) {
    const std::string json = R"({"id": "x", "pick": {"a": [1, 2, 3, 4, 5], "b": [1, 2, 3, 4, 5]},
                                 "require": ["a < b", "a + b ~= 5"]})";
    const Result<std::vector<std::string>> all = combinations(json, "mine.json");
    ASSERT_TRUE(all) << all.error();
    std::set<std::pair<int, int>> expected, found;
    for (int a = 1; a <= 5; ++a)
        for (int b = a + 1; b <= 5; ++b)
            if (a + b != 5) expected.insert({a, b});
    for (const std::string& text : *all) {
        const Json one = Json::parse(text);
        found.emplace(one["a"].get<int>(), one["b"].get<int>());
    }
    EXPECT_EQ(all->size(), expected.size()) << "no duplicates";
    EXPECT_EQ(found, expected);
}

TEST(Exercise, IdSeedsTheShuffleOfCombinations) {
    const std::string json = R"({"id": "E16-shadow-matrix", "pick": {"a": [0, 1], "b": [0, 1, 2, 3]}})";
    const Result<std::vector<std::string>> all = combinations(json, "mine.json");
    ASSERT_TRUE(all) << all.error();
    std::vector<int> order;
    for (const std::string& text : *all) {
        const Json one = Json::parse(text);
        order.push_back(4 * one["a"].get<int>() + one["b"].get<int>());
    }
    EXPECT_EQ(order, (std::vector{5, 7, 0, 4, 3, 2, 6, 1})) << "as in another implementation";
    const Result<std::vector<std::string>> other = combinations(with(json, "E16-shadow-matrix", "E16-x"), "mine.json");
    ASSERT_TRUE(other);
    EXPECT_NE(*all, *other);
}

TEST(Exercise, DeploysSixteenVariants) {
    const Result<Exercise> exercise =
        parse_exercise(with(number_exercise, "[30, 40]",
                            "[11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, "
                            "26, 27, 28, 29, 30]"),
                       "mine.json", "");
    ASSERT_TRUE(exercise) << exercise.error();
    EXPECT_EQ(exercise->variants.size(), 16U);
    EXPECT_EQ(std::set(exercise->variants.begin(), exercise->variants.end()).size(), 16U);
}

TEST(Exercise, KeepsDeployedVariants) {
    const std::string deployed = R"("deployed": [{"P": [1, 0, 0, 9], "k": 12, "n": 5}, {"P": [0, 0, 1, 0], "k": 77,
        "n": 6}], "require")";
    const Result<Exercise> exercise = parse_exercise(with(number_exercise, "\"require\"", deployed), "mine.json", "");
    ASSERT_TRUE(exercise) << exercise.error();
    ASSERT_EQ(exercise->variants.size(), 2U);
    EXPECT_EQ(Json::parse(exercise->variants[0])["k"], 12);
    EXPECT_EQ(Json::parse(exercise->variants[1])["k"], 77);
    const Result<LessonStep> step = variant_step(*exercise, 1, camera_alone);
    ASSERT_TRUE(step) << step.error();
    EXPECT_EQ(step->start.params.camera.yaw, 77.0);
}

TEST(Exercise, DeployedVariantHasExactlyTheConstants) {
    const auto told = [](const std::string& constants) {
        return trouble_with("\"require\"", "\"deployed\": " + constants + ", \"require\"");
    };
    EXPECT_TRUE(has(told(R"([{"P": [1, 0, 0, 9], "k": 12, "n": 1}, {"P": 0, "k": 12}])"), "deployed[1].n: is missing"));
    EXPECT_TRUE(has(told(R"([{"P": 1, "k": 12, "n": 1, "q": 2}])"), "deployed[0].q: no such field"));
    EXPECT_TRUE(has(told("[]"), "deployed: must have at least one variant"));
    EXPECT_TRUE(has(told("[3]"), "deployed[0]: "));
    EXPECT_TRUE(has(told("{}"), "deployed: "));
}

TEST(Exercise, PicksAreAnObjectOfNamesAndLists) {
    EXPECT_TRUE(has(trouble_with("\"pick\"", "\"tags_\""), "tags_: no such field"));
    const std::string pick = R"({"P": [[0, 1, 0, 2.5]], "k": [30, 40], "n": [3]})";
    EXPECT_TRUE(has(trouble_with("\"pick\": " + pick + ",", ""), "pick: is missing"));
    EXPECT_TRUE(has(trouble_with(pick, "{}"), "pick: must have at least one name"));
    EXPECT_TRUE(has(trouble_with(pick, "[1]"), "pick: "));
    EXPECT_TRUE(has(trouble_with(pick, R"({"k": []})"), "pick.k: must have at least one value"));
    EXPECT_TRUE(has(trouble_with(pick, R"({"k": 3})"), "pick.k: "));
    EXPECT_TRUE(has(trouble_with(pick, R"({"2k": [3]})"), "pick: \"2k\" is not a valid name"));
    EXPECT_TRUE(has(trouble_with(pick, R"({"and": [3]})"), "pick: \"and\" is not a valid name"));
    EXPECT_TRUE(has(trouble_with(pick, R"({"k k": [3]})"), "pick: \"k k\" is not a valid name"));
}

TEST(Exercise, ConstantIsNotALuaKeyword) {
    for (const std::string word : {"end", "function", "if", "local", "while", "in"}) {
        const std::string told = trouble_with("\"n\": [3]", "\"n\": [3], \"" + word + "\": [3]");
        EXPECT_TRUE(has(told, "pick: \"" + word + "\" is not a valid name")) << told;
    }
}

TEST(Exercise, ConstantHidesAnyOtherNameOrIsRefused) {
    for (const std::string name : {"V", "camera", "answer", "pi", "identity", "dot"}) {
        const std::string picked = with(number_exercise, "\"n\": [3]", "\"n\": [3], \"" + name + "\": [12345]");
        const std::string asked = with(with(picked, "Twice {k}.", "Twice {" + name + "}."), "{camera.yaw / 7}, ",
                                       "");  // `camera.yaw` would fail if the constant hides `camera`
        const Result<LessonStep> step =
            step_of(with(with(asked, "=2 * camera.yaw", "=2 * k"), "camera.yaw == k", "true"));
        if (step)
            EXPECT_EQ(step->ask.hints[0].in_english(), "Twice 12345.") << name;
        else
            EXPECT_TRUE(has(step.error(), "pick")) << step.error();
    }
}

TEST(Exercise, RefusesTooManyCombinationsEarly) {
    std::string values = "[0";
    for (int i = 1; i < 60; ++i) values += ", " + std::to_string(i);
    values += "]";
    std::string picks = "{\"k\": " + values;
    for (int i = 0; i < 60; ++i) picks += ", \"c" + std::to_string(i) + "\": " + values;
    const auto begun = std::chrono::steady_clock::now();
    const std::string told = trouble_with(R"({"P": [[0, 1, 0, 2.5]], "k": [30, 40], "n": [3]})", picks + "}");
    EXPECT_TRUE(has(told, "pick: has more than 20000 combinations")) << told;
    EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(2));
    const std::string most =
        R"({"id": "x", "pick": {"a": )" + values + R"(, "b": )" + values + R"(, "c": [1, 2, 3, 4, 5]}})";
    const Result<std::vector<std::string>> all = combinations(most, "mine.json");
    ASSERT_TRUE(all) << all.error();
    EXPECT_EQ(all->size(), 18'000U);
}

TEST(Exercise, LimitsComputedValues) {
    const auto told = [](const std::string& hints) { return trouble_with("\"Twice {k}.\"", hints); };
    std::string places;
    for (int i = 0; i < 100; ++i) places += "{k}";
    std::string hints = "\"" + places + "\"";
    for (int i = 1; i < 64; ++i) hints += ", \"" + places + "\"";
    EXPECT_TRUE(has(told(hints), ": exceeds the limit of 4096 expressions")) << told(hints);
    const std::string text = "\"='" + std::string(4000, 'x') + "'\"";
    std::string texts = text;
    for (int i = 1; i < 1050; ++i) texts += ", " + text;
    EXPECT_TRUE(has(told(texts), ": exceeds the limit of 4 MiB")) << told(texts);
}

TEST(Exercise, LimitsNumberAndLengthOfCombinations) {
    std::string values = "[0";
    for (int i = 1; i < 50; ++i) values += ", " + std::to_string(i);
    const std::string pick = R"({"id": "x", "pick": {"a": )" + values + R"(], "b": )" + values + R"(]}, "require": [)";
    const auto told = [](const std::string& json) {
        const Result<std::vector<std::string>> all = combinations(json, "mine.json");
        return all ? "" : all.error();
    };
    std::string require = R"("a >= 0")";
    for (int i = 1; i < 17; ++i) require += R"(, "a >= 0")";
    EXPECT_EQ(told(pick + require + "]}"),
              "mine.json: require: has 17 expressions for 2500 combinations: at most 40000 values are computed");
    EXPECT_EQ(told(pick + R"("abs(a - dot({a, b, 1}, {b, a, 1})) >= 0"]})"), "");
    std::string costly = "0";
    for (int i = 0; i < 2000; ++i) costly += "+a";
    EXPECT_EQ(told(pick + "\"" + costly + R"( >= 0", "a >= 0", "a >= 0"]})"), "mine.json: require[0]: takes too long");
    EXPECT_EQ(told(R"({"id": "x", "pick": {"a": [")" + std::string(9000, 'x') + R"("]}})"),
              "mine.json: pick: has a combination longer than 8192 bytes");
}

TEST(Exercise, FollowsTheRulesOfExpressions) {
    EXPECT_TRUE(has(trouble_with("\"=k\"", "\"=(function() return 1 end)()\""), "camera.yaw: function is not allowed"));
    EXPECT_TRUE(has(trouble_with("\"=k\"", "\"=\\\"\\\\xff\\\"\""), "camera.yaw: its value \\xff is not valid UTF-8"));
    EXPECT_TRUE(has(trouble_with("\"=k\"", "\"=0/0\""), "camera.yaw"));
    EXPECT_TRUE(has(trouble_with("Twice {k}.", "Twice {0/0}."), "ask.hints[0]: {0/0} has no value"));
    EXPECT_TRUE(has(trouble_with("Twice {k}.", "Twice {{1, 0/0}[2]}."), "ask.hints[0]: "));
}

TEST(Exercise, RefusesUnknownFields) {
    EXPECT_TRUE(has(trouble_with("\"points\"", "\"point\""), "point: no such field; did you mean points?"));
    EXPECT_TRUE(has(trouble_with("\"hints\"", "\"hint\""), "ask.hint: no such field"));
    EXPECT_TRUE(has(trouble_with("\"reveal\"", "\"revael\""), "revael: no such field"));
    EXPECT_TRUE(has(trouble_with("\"camera.yaw\"", "\"camera.yow\""), "camera.yow"));
    EXPECT_TRUE(has(trouble_with("\"exercise\": 1", "\"exercise\": 2"), "exercise: must be 1"));
    EXPECT_TRUE(has(trouble_with("\"points\": 2", "\"points\": 0"), "points: must be"));
    EXPECT_TRUE(has(trouble_with("\"id\": \"T01-yaw\",", ""), "id: is missing"));
    EXPECT_TRUE(has(trouble_with("[3]", "[3.5]"), "slides[0]: must be"));
    EXPECT_TRUE(has(trouble_with("{\"en\": \"Yaw\", \"ko\": \"요\"}", "{\"ko\": \"요\"}"), "title.en: is missing"));
}

TEST(Exercise, PlaceholderIsClosedAndNamesAValue) {
    EXPECT_TRUE(has(trouble_with("Twice {k}.", "Twice {k."), "ask.hints[0]: has a { without a }"));
    EXPECT_TRUE(has(trouble_with("Twice {k}.", "Twice {kk}."), "ask.hints[0]: unknown name kk"));
    EXPECT_TRUE(has(trouble_with("Twice {k}.", "Twice {}."), "ask.hints[0]: is empty"));
    EXPECT_TRUE(has(trouble_with("\"=2 * camera.yaw\"", "\"=\""), "ask.expect: is empty"));
    EXPECT_TRUE(has(trouble_with("\"=2 * camera.yaw\"", "\"=camera.yow\""), "ask.expect: "));
    EXPECT_TRUE(has(trouble_with("It was {k}.", "It was {V}."), "reveal.say: V is not made here"));
}

TEST(Exercise, RefusesAPlaceholderWithoutValue) {
    EXPECT_TRUE(has(trouble_with("Twice {k}.", "Twice {P[4]}."), "ask.hints[0]: ")) << "P has four numbers";
    EXPECT_TRUE(has(trouble_with("\"=2 * camera.yaw\"", "\"=P[4]\""), "ask.expect: "));
    EXPECT_TRUE(has(trouble_with("\"=k\"", "\"=P[4]\""), "camera.yaw"));
}

TEST(Exercise, HostileExpressionsEndWithASentence) {
    const std::string loop = "(function() while true do end end)()";
    EXPECT_TRUE(has(trouble_with("Twice {k}.", "Twice {" + loop + "}."), "ask.hints[0]: function is not allowed"));
    EXPECT_TRUE(has(trouble_with("\"=k\"", "\"=" + loop + "\""), "state.set.camera.yaw: function is not allowed"));
    EXPECT_TRUE(has(trouble_with("\"=k\"", "\"=" + std::string(3000, '(') + "1" + "\""), "state.set.camera.yaw: "));
    EXPECT_TRUE(has(trouble_with("\"=k\"", "\"=" + std::string(100'000, '1') + "\""), "longer than 4096 bytes"));
    for (const char* const not_finite : {"=0/0", "=1/0", "=-1/0"})
        EXPECT_TRUE(has(trouble_with("\"=k\"", "\"" + std::string(not_finite) + "\""), "camera.yaw")) << not_finite;
    EXPECT_TRUE(has(trouble_with("\"=k\"", "\"=camera\""), "state.set.camera.yaw: "));
    EXPECT_TRUE(has(trouble_with("\"=2 * camera.yaw\"", "\"=camera\""), "ask.expect: "));
}

TEST(Exercise, HugeStringsAndDeepNestingEndWithASentence) {
    EXPECT_TRUE(has(trouble_with("Twice", std::string(1'000'000, 'x')), "longer than 4000 bytes"));
    // This text becomes long only when a variant fills in the constant.
    const std::string filled =
        with(number_exercise, "\"n\": [3]", "\"n\": [3], \"s\": [\"" + std::string(5000, 'y') + "\"]");
    EXPECT_TRUE(has(trouble_with(with(filled, "Twice {k}.", "{s}")), "longer than 4000 bytes"));
    const std::string deep = std::string(100'000, '[') + std::string(100'000, ']');
    EXPECT_FALSE(trouble_with("\"=k\"", deep).empty());
    EXPECT_FALSE(trouble_with("[30, 40]", "[" + std::string(50, '[') + "1" + std::string(50, ']') + "]").empty());
    const std::string control = with(number_exercise, "\"n\": [3]", R"("n": [3], "s": ["a\nb\u0007"])");
    EXPECT_TRUE(has(trouble_with(with(control, "Twice {k}.", "{s}")), "control character"));
    EXPECT_TRUE(has(trouble_with(with(control, "\"=k\"", "\"=s\"")), "camera.yaw"));
}

TEST(Exercise, TruncatedFileNeverCrashes) {
    const std::string whole = number_exercise;
    for (std::size_t length = 0; length + 1 < whole.size(); length += 7) {
        const Result<Exercise> cut = parse_exercise(std::string_view(whole).substr(0, length), "cut.json", "");
        ASSERT_FALSE(cut) << length;
        EXPECT_EQ(cut.error().find("cut.json: "), 0U) << cut.error();
    }
}

// ---- many exercises -------------------------------------------------------------------------------------------------

std::vector<Exercise> three() {
    std::vector<Exercise> all;
    for (const auto& [id, sets] : std::vector<std::pair<std::string, std::vector<std::string>>>{
             {"E01-view-matrix", {"camera"}}, {"E02-eye", {"camera", "shadow"}}, {"E16-shadow-matrix", {"shadow"}}}) {
        Exercise& exercise = all.emplace_back();
        exercise.id = id;
        exercise.sets = sets;
    }
    return all;
}

std::string ids(const Result<std::vector<Exercise>>& exercises) {
    if (!exercises) return exercises.error();
    std::string all;
    for (const Exercise& exercise : *exercises) all += exercise.short_id() + " ";
    return all;
}

TEST(Exercises, AreFoundByIdOrSuggestTheNearest) {
    EXPECT_EQ(*find_exercise(three(), "E16"), 2U);
    EXPECT_EQ(*find_exercise(three(), "E02-eye"), 1U);
    EXPECT_FALSE(find_exercise(three(), ""));
    EXPECT_FALSE(find_exercise(three(), "E1"));
    EXPECT_FALSE(find_exercise(three(), "shadow-matrix"));
    EXPECT_FALSE(find_exercise({}, "E01"));
    EXPECT_EQ(find_exercise(three(), "E16-shadow-matrx").error(),
              "no exercise is called \"E16-shadow-matrx\"; did you mean E16-shadow-matrix?");
    EXPECT_FALSE(has(find_exercise(three(), "E\n\x1b[31m").error(), "\x1b"));
}

TEST(Exercises, AreChosenBySetOrById) {
    EXPECT_EQ(ids(of_set(three(), "")), "E01 E02 E16 ");
    EXPECT_EQ(ids(of_set(three(), "camera")), "E01 E02 ");
    EXPECT_EQ(ids(of_set(three(), "shadow")), "E02 E16 ");
    EXPECT_EQ(ids(of_set(three(), "E16,E01-view-matrix")), "E16 E01 ");
    EXPECT_EQ(ids(of_set(three(), "E02,E02")), "E02 ");
    EXPECT_EQ(ids(of_set(three(), "shadow,camera")), "E02 E16 E01 ");
    EXPECT_EQ(ids(of_set(three(), "E01,shadow")), "E01 E02 E16 ");
    EXPECT_TRUE(has(ids(of_set(three(), "camera,shadw")), "\"shadw\" is neither"));
    const std::string told = ids(of_set(three(), "shadw"));
    EXPECT_TRUE(has(told, "\"shadw\" is neither a set (camera, shadow) nor an exercise; did you mean shadow?")) << told;
    EXPECT_TRUE(has(ids(of_set(three(), "E01,E99")), "\"E99\" is neither")) << ids(of_set(three(), "E01,E99"));
    EXPECT_TRUE(has(ids(of_set(three(), "E01,")), "is neither"));
    EXPECT_TRUE(has(ids(of_set(three(), ",")), "is neither"));
}

TEST(Exercises, SheetHasTheStudentsVariants) {
    std::vector<Exercise> all;
    for (const char* const json : {number_exercise, goal_exercise})
        all.push_back(*parse_exercise(json, "mine.json", ""));
    const Result<Lesson> made = sheet(all, "cg", "32201234", camera_alone);
    ASSERT_TRUE(made) << made.error();
    ASSERT_EQ(made->steps.size(), 2U);
    EXPECT_EQ(made->sheet->student, "32201234");
    EXPECT_EQ(made->sheet->items[0].variant, variant_of("cg", "32201234", "T01-yaw", 2));
    EXPECT_EQ(made->sheet->items[0].points, 2);
    EXPECT_EQ(made->steps[0].start.params.camera.yaw,
              Json::parse(all[0].variants[made->sheet->items[0].variant])["k"].get<double>());
    EXPECT_FALSE(sheet({}, "cg", "1", camera_alone));
}

// ---- shipped exercises ----------------------------------------------------------------------------------------------

std::string contents(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::vector<fs::path> shipped() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(assets_directory() / "exercises")) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

TEST(ShippedExercises, AreTwentyFourAndReadable) {
    const std::vector<fs::path> files = shipped();
    const std::vector<Result<Exercise>> all = exercises();
    ASSERT_EQ(files.size(), 26U);
    ASSERT_EQ(all.size(), 26U);
    int points = 0;
    std::set<std::string> sets;
    for (std::size_t i = 0; i < all.size(); ++i) {
        ASSERT_TRUE(all[i]) << all[i].error();
        EXPECT_EQ(all[i]->id, files[i].stem().string());
        EXPECT_EQ(all[i]->file, files[i]);
        EXPECT_FALSE(all[i]->sets.empty());
        EXPECT_FALSE(all[i]->variants.empty());
        EXPECT_LE(all[i]->variants.size(), 16U);
        sets.insert(all[i]->sets.begin(), all[i]->sets.end());
        points += all[i]->points;
    }
    EXPECT_EQ(points, 53);
    EXPECT_EQ(sets, (std::set<std::string>{"camera", "depth", "hidden", "mirror", "shadow"}));
}

TEST(ShippedExercises, KeepTheVariantsOfTheirShuffle) {
    int stored = 0;
    for (const fs::path& file : shipped()) {
        const std::string text = contents(file);
        const nlohmann::json document = nlohmann::json::parse(text);
        if (!document.contains("deployed")) continue;
        ++stored;
        const Result<std::vector<std::string>> all = combinations(text, file.filename().string());
        ASSERT_TRUE(all) << all.error();
        ASSERT_EQ(document["deployed"].size(), std::min<std::size_t>(all->size(), 16)) << file;
        for (std::size_t i = 0; i < document["deployed"].size(); ++i)
            EXPECT_EQ(document["deployed"][i], nlohmann::json::parse((*all)[i])) << file << " " << i;
        const std::set<nlohmann::json> apart(document["deployed"].begin(), document["deployed"].end());
        EXPECT_EQ(apart.size(), document["deployed"].size()) << file << ": a duplicate";
    }
    EXPECT_GT(stored, 0);
}

/// Returns the word at this place if it is only a particle; 라 in 라디안 is not one.
std::string particle_at(const std::string& text, std::size_t at) {
    const auto is_hangul = [&](std::size_t place) {
        const auto byte = static_cast<unsigned char>(place < text.size() ? text[place] : ' ');
        return byte >= 0xea && byte <= 0xed;
    };
    std::size_t end = at;
    while (is_hangul(end)) end += 3;
    const std::string word = text.substr(at, end - at);
    for (const char* const particle :
         {"은",   "는",     "이",   "가", "을",   "를", "과",   "와",   "로",     "으로",   "라",
          "이라", "이라고", "라고", "나", "이나", "란", "이란", "로는", "으로는", "로부터", "으로부터"})
        if (word == particle) return word;
    return "";
}

void collect_texts(const nlohmann::json& value, const std::string& path, std::vector<std::string>& faults, int& texts) {
    if (value.is_object() && value.contains("en")) {
        ++texts;
        const std::string korean = value.contains("ko") ? value["ko"].get<std::string>() : "";
        if (korean.empty()) faults.push_back(path + " has no Korean");
        // A particle's form depends on the sound of the number before it, which varies.
        for (std::size_t at = korean.find('}'); at != std::string::npos; at = korean.find('}', at + 1))
            if (const std::string particle = particle_at(korean, at + 1); !particle.empty())
                faults.push_back(path + " has " + particle + " directly behind a place: " + korean);
    }
    if (!value.is_structured()) return;
    for (const auto& [key, member] : value.items()) collect_texts(member, path + "." + key, faults, texts);
}

TEST(ShippedExercises, CoverBothLanguages) {
    int texts = 0;
    for (const fs::path& file : shipped()) {
        std::vector<std::string> faults;
        const nlohmann::json document = nlohmann::json::parse(contents(file));
        EXPECT_TRUE(document["title"].contains("ko")) << file;
        const nlohmann::json tags = document.value("tags", nlohmann::json::object());
        for (const auto& [tag, text] : tags.items())
            EXPECT_TRUE(text.is_object() && text.contains("ko")) << file << " " << tag;
        collect_texts(document, file.stem().string(), faults, texts);
        for (const std::string& fault : faults) ADD_FAILURE() << fault;
    }
    EXPECT_GT(texts, 24 * 4);
}

/// Covers every text that a student reads. A text without Korean appears in English, so it must be a formula.
TEST(ShippedExercises, AskInBothLanguages) {
    for (const fs::path& file : shipped()) {
        const nlohmann::json document = nlohmann::json::parse(contents(file));
        const nlohmann::json& ask = document["step"]["ask"];
        EXPECT_TRUE(ask["question"].is_object()) << file;
        for (const nlohmann::json& wrong : ask.value("wrong", nlohmann::json::array()))
            EXPECT_TRUE(wrong["say"].is_object()) << file << " " << wrong["say"];
        for (const nlohmann::json& choice : ask.value("choices", nlohmann::json::array())) {
            const bool is_right = choice.contains("right") && choice["right"] == true;
            EXPECT_TRUE(is_right || choice["why"].is_object()) << file << " " << choice;
        }
    }
}

TEST(ShippedExercises, UseOnlyTagsThatTheyExplain) {
    for (const Result<Exercise>& exercise : exercises()) {
        ASSERT_TRUE(exercise);
        std::set<std::string> known, used;
        for (const auto& [tag, text] : exercise->tags) known.insert(tag);
        const nlohmann::json ask = nlohmann::json::parse(exercise->pattern)["ask"];
        for (const char* const list : {"wrong", "choices"})
            for (const nlohmann::json& one : ask.value(list, nlohmann::json::array()))
                if (one.contains("tag") && one["tag"].get<std::string>().front() != '=') used.insert(one["tag"]);
        for (const std::string& tag : used) EXPECT_TRUE(known.contains(tag)) << exercise->id << ": " << tag;
    }
}

}  // namespace
}  // namespace viewing
