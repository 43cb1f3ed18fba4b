// Tests how much it may cost to grade one hand-in, and what happens when time runs out halfway. The tests count judged
// answers and measure no time. They need no reference pictures.
#include "grading/grading.h"

#include <set>

#include "gl/gl_test.h"
#include "grading/state_numbers.h"

namespace viewing {
namespace {

constexpr const char* number_exercise = R"({"exercise": 1, "id": "N1", "title": "t", "sets": ["mine"], "points": 2,
    "pick": {"k": [40]}, "step": {"ask": {"kind": "number", "question": "?", "expect": "=k", "tol": 0.1,
    "wrong": [{"value": 10, "tag": "T10", "say": "That is ten."}]}}, "tags": {"T10": "ten"}})";
constexpr const char* measured_exercise = R"({"exercise": 1, "id": "G1", "title": "t", "sets": ["mine"], "points": 3,
    "pick": {"k": [1]}, "step": {"ask": {"kind": "goal", "question": "?", "allow": ["projection.near"],
    "until": "depth_step(10) > 0 and projection.near < 0.2", "model": {"projection.near": 0.1}}}})";

Attempt number(double value, const std::string& told = "") {
    Attempt attempt;
    attempt.answer = {value};
    attempt.told = told;
    return attempt;
}

Attempt near_plane(double near, const std::string& told = "") {
    Attempt attempt;
    attempt.is_goal = true;
    attempt.settings = {"projection.near=" + std::to_string(near)};
    attempt.told = told;
    return attempt;
}

class GradingTest : public testing::GlTest {
protected:
    Grader grader(const std::vector<const char*>& files) {
        std::vector<Exercise> exercises;
        for (const char* const file : files) {
            const Result<Exercise> exercise = parse_exercise(file, "mine.json", "");
            EXPECT_TRUE(exercise) << exercise.error();
            exercises.push_back(*exercise);
        }
        return {std::move(exercises), &renderer()};
    }

    static HandIn hand_in(std::vector<std::pair<std::string, std::vector<Attempt>>> items) {
        HandIn made;
        made.student = "1";
        for (auto& [exercise, attempts] : items) made.items.push_back({exercise, 0, std::move(attempts), {}, {}, {}});
        return made;
    }
};

TEST_F(GradingTest, JudgesTheLastTheFirstTheClaimedRightThenTheLatest) {
    const Attempt plain = number(1), called = number(2, "right");
    const auto order = [](const std::vector<const Attempt*>& answers) { return order_of_judging(answers); };
    using Places = std::vector<std::size_t>;
    EXPECT_EQ(order({}), Places{});
    EXPECT_EQ(order({&plain}), Places{0});
    EXPECT_EQ(order({&plain, &plain}), (Places{1, 0}));
    EXPECT_EQ(order({&plain, &called, &plain, &called, &plain, &called}), (Places{5, 0, 3, 1, 4, 2}));
}

TEST_F(GradingTest, AFileStaysWithinItsBudgetAndKeepsItsPoints) {
    std::vector<Attempt> numbers, goals;
    for (int i = 0; i < 1000; ++i) numbers.push_back(number(1000.0 + i, "right"));
    for (int i = 0; i < 1000; ++i) goals.push_back(near_plane(0.5 + 0.001 * i));
    numbers.front() = number(10);           // wrong, and a known mistake
    numbers.back() = number(40);            // right in the end
    goals[7] = near_plane(0.125, "right");  // right already, and marked as right in the file
    Grader of_both = grader({number_exercise, measured_exercise});
    const StudentGrade grade = of_both.grade({hand_in({{"N1", numbers}, {"G1", goals}}), {}}, "f.json", {});
    ASSERT_EQ(grade.items.size(), 2U);
    EXPECT_EQ(grade.items[0].standing, Standing::right);
    EXPECT_EQ(grade.items[1].standing, Standing::right);
    EXPECT_EQ(grade.points(), 5);
    EXPECT_EQ(grade.items[0].tries, 1000);
    const std::size_t measured = grade.items[1].judged(), others = grade.items[0].judged();
    EXPECT_LE(static_cast<int>(others) + static_cast<int>(measured) * cost_of_measured, budget_of_file);
    EXPECT_GT(static_cast<int>(others) + static_cast<int>(measured + 1) * cost_of_measured, budget_of_file - 1);
    EXPECT_GE(measured, 16U);
    ASSERT_TRUE(grade.items[0].verdicts.front());
    EXPECT_EQ(grade.items[0].verdicts.front()->tag, "T10");
    ASSERT_TRUE(grade.items[0].verdicts.back());
    EXPECT_TRUE(grade.items[0].verdicts.back()->right);
    EXPECT_FALSE(grade.is_cut);
    ASSERT_EQ(grade.notes.size(), 1U);
    EXPECT_EQ(grade.notes[0].find("N1: " + std::to_string(others) + " of 1000, G1: " + std::to_string(measured) +
                                  " of 1000 answers judged (the last"),
              0U)
        << grade.notes[0];
}

TEST_F(GradingTest, RepeatingAnAnswerCostsNothing) {
    const std::vector<Attempt> again(1000, near_plane(0.3));
    const StudentGrade grade = grader({measured_exercise}).grade({hand_in({{"G1", again}}), {}}, "f.json", {});
    EXPECT_EQ(grade.items[0].judged(), 1000U);
    EXPECT_EQ(grade.items[0].standing, Standing::wrong);
    EXPECT_TRUE(grade.notes.empty());
}

TEST_F(GradingTest, AfterTheTimeLimitTheRestIsUnjudgedAndRightAnswersStay) {
    const HandIn both =
        hand_in({{"N1", {number(1), number(2), number(40)}}, {"G1", {near_plane(0.5), near_plane(0.6)}}});
    for (int judged = 0; judged <= 5; ++judged) {
        Grader of_both = grader({number_exercise, measured_exercise});
        int asked = -static_cast<int>(both.items.size());  // one more call per item, before its step is made
        of_both.stop_when([&] { return asked++ >= judged; }, "no time");
        const StudentGrade grade = of_both.grade({both, {}}, "f.json", {});
        const ItemGrade &typed = grade.items[0], &goal = grade.items[1];
        EXPECT_EQ(static_cast<int>(typed.judged() + goal.judged()), judged);
        EXPECT_EQ(grade.is_cut, judged < 5) << judged;
        EXPECT_EQ(typed.standing, judged == 0 ? Standing::not_judged : Standing::right)
            << "its last answer is judged first";
        EXPECT_EQ(typed.points, judged == 0 ? 0 : 2);
        EXPECT_EQ(goal.standing, judged < 4 ? Standing::not_judged : Standing::wrong) << judged;
        EXPECT_EQ(goal.trouble, judged < 4 ? "no time" : "") << judged;
    }
    Grader late = grader({number_exercise});
    late.stop_when([] { return true; }, "no time");
    const StudentGrade none = late.grade({hand_in({{"N1", {number(40)}}}), {}}, "f.json", {});
    EXPECT_EQ(none.items[0].standing, Standing::not_judged);
    EXPECT_TRUE(none.is_cut);
    EXPECT_FALSE(late.grade({hand_in({}), {}}, "f.json", {}).is_cut) << "nothing was to be judged";
}

TEST_F(GradingTest, AStateIsMeasuredOnce) {
    const Measurer measurer(&renderer());
    const LoadedState state = *load_state("depth-fighting");
    const auto fighting_in = [&](const LoadedState& now) {
        return *numbers_of(now, state.params, measurer)->look_up("fighting", {});
    };
    const auto known_of = [&](const LoadedState& now) {
        return measurer.known(now.params, *load_scene(now.params.scene, now.base, now.params.coplanar));
    };
    const Json measured = fighting_in(state);
    EXPECT_EQ(known_of(state)->at("fighting"), measured);
    EXPECT_EQ(fighting_in(state), *numbers_of(state, state.params, &renderer())->look_up("fighting", {}));
    (*known_of(state))["fighting"] = 42;
    EXPECT_EQ(fighting_in(state), 42) << "not measured again";

    LoadedState other = state;
    other.params.projection.near *= 2.0;
    EXPECT_NE(fighting_in(other), 42);
    EXPECT_EQ(fighting_in(state), 42);
    other = state;
    other.params.scene = "cyclic-overlap";
    EXPECT_NE(fighting_in(other), 42) << "another scene";
}

TEST_F(GradingTest, AChangedMeshIsAnotherState) {
    const Measurer measurer(&renderer());
    const Params params = load_state("")->params;
    Scene scene = testing::scene_named("torus-and-boxes");
    const auto known = measurer.known(params, scene);
    EXPECT_EQ(measurer.known(params, testing::scene_named("torus-and-boxes")), known) << "loaded again";
    scene.objects[0].mesh = std::make_shared<const Mesh>(*scene.objects[0].mesh);
    EXPECT_NE(measurer.known(params, scene), known);
    scene = testing::scene_named("torus-and-boxes");
    scene.objects.pop_back();
    EXPECT_NE(measurer.known(params, scene), known);
}

TEST_F(GradingTest, ManyStatesAreNotAllKept) {
    const Measurer measurer(&renderer());
    const Scene scene = testing::scene_named("torus-and-boxes");
    Params params = load_state("")->params;
    std::vector<std::weak_ptr<Measurer::Values>> known;
    for (int i = 0; i < 1000; ++i) {
        params.projection.near = 0.001 * (i + 1);
        known.push_back(measurer.known(params, scene));
    }
    const auto alive = [](const auto& values) { return !values.expired(); };
    EXPECT_LE(std::count_if(known.begin(), known.end(), alive), 100);
    EXPECT_TRUE(alive(known.back()));
}

}  // namespace
}  // namespace viewing
