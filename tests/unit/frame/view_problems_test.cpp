// A picture without any object explains why and offers a working fix; a picture with objects has no such problem.
#include <algorithm>

#include "frame/problems.h"

#include "state/file/json.h"
#include "text/numbers.h"
#include "unit/frame/frame_test.h"

namespace viewing {
namespace {

std::vector<Problem> problems_with(const std::vector<std::string>& settings) {
    const Scene scene = testing::box_scene();
    const Result<Params> params = apply_settings(Params{}, settings);
    EXPECT_TRUE(params) << params.error();
    std::vector<Problem> problems;
    find_view_problems(problems, *params, derive(*params, scene, {}), scene);
    return problems;
}

TEST(ViewProblems, AreAbsentIfAnObjectIsVisible) {
    EXPECT_TRUE(problems_with({}).empty());
    EXPECT_TRUE(problems_with({"projection.type=orthographic"}).empty());
    EXPECT_TRUE(problems_with({"projection.fovy=2"}).empty()) << "the middle of an object fills the picture";
}

TEST(ViewProblems, ReportWhereTheObjectsAre) {
    const std::pair<const char*, const char*> cases[] = {{"camera.yaw=-149.4", "behind the camera"},
                                                         {"camera.yaw=100", "right edge"},
                                                         {"camera.yaw=-40", "left edge"},
                                                         {"camera.pitch=60", "below"},
                                                         {"camera.pitch=-80", "above"}};
    for (const auto& [setting, expected] : cases) {
        const std::vector<Problem> problems = problems_with({setting});
        ASSERT_EQ(problems.size(), 1U) << setting;
        EXPECT_NE(problems[0].sentence.find(expected), std::string::npos) << setting << ": " << problems[0].sentence;
        EXPECT_EQ(problems[0].kind, ProblemKind::about_window);
    }
}

TEST(ViewProblems, ReportAndFixClippingByNearAndFar) {
    for (const std::string& setting : {std::string("projection.near=30"), std::string("projection.far=2")}) {
        const std::vector<Problem> problems = problems_with({setting});
        ASSERT_EQ(problems.size(), 1U) << setting;
        EXPECT_NE(problems[0].sentence.find(setting.ends_with("30") ? "near = 30" : "far = 2"), std::string::npos)
            << problems[0].sentence;
        ASSERT_FALSE(problems[0].mended_by.empty());
        EXPECT_TRUE(problems_with({setting, problems[0].mended_by}).empty()) << problems[0].mended_by;
    }
}

TEST(ViewProblems, NumbersAreThoseOfTheVertices) {
    const Scene scene = testing::box_scene();
    const Params params;
    const Derived derived = derive(params, scene, {});
    double nearest = 1e300, farthest = 0.0;
    for (const SceneObject& object : scene.objects)
        for (const glm::vec3& vertex : object.mesh->positions) {
            const glm::dvec4 world = object.world_from_model * glm::dvec4(vertex, 1.0);
            nearest = std::min(nearest, -(derived.view_from_world * world).z);
            farthest = std::max(farthest, -(derived.view_from_world * world).z);
        }
    const auto sentence = [](const std::string& setting) { return problems_with({setting}).at(0).sentence; };
    EXPECT_NE(sentence("projection.near=30").find("z = " + figures(farthest, 3)), std::string::npos);
    EXPECT_NE(sentence("projection.far=2").find("z = " + figures(nearest, 3)), std::string::npos);
}

}  // namespace
}  // namespace viewing
