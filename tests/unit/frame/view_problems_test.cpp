// If a picture shows no object, a problem says why and offers a working fix; a picture with objects has no such
// problem.
#include <algorithm>
#include <cmath>

#include "frame/problems.h"

#include "state/file/state_json.h"
#include "text/numbers.h"
#include "unit/frame/frame_test.h"

namespace viewing {
namespace {

std::vector<Problem> view_problems(const std::vector<std::string>& settings,
                                   const Scene& scene = testing::box_scene()) {
    const Result<Params> params = apply_settings(Params{}, settings);
    EXPECT_TRUE(params) << params.error();
    std::vector<Problem> problems;
    const Derived derived = derive(*params, scene, {});
    find_view_problems(problems, *params, derived, scene, seen_images(*params, derived, scene, plan(*params, derived)));
    return problems;
}

TEST(ViewProblems, AreAbsentIfAnObjectIsVisible) {
    EXPECT_TRUE(view_problems({}).empty());
    EXPECT_TRUE(view_problems({"projection.type=orthographic"}).empty());
    EXPECT_TRUE(view_problems({"projection.fovy=2"}).empty()) << "the middle of an object fills the picture";
}

TEST(ViewProblems, ReportWhereTheObjectsAre) {
    const std::pair<const char*, const char*> cases[] = {{"camera.yaw=-149.4", "behind the camera"},
                                                         {"camera.yaw=100", "right edge"},
                                                         {"camera.yaw=-40", "left edge"},
                                                         {"camera.pitch=60", "below"},
                                                         {"camera.pitch=-80", "above"}};
    for (const auto& [setting, expected] : cases) {
        const std::vector<Problem> problems = view_problems({setting});
        ASSERT_EQ(problems.size(), 1U) << setting;
        EXPECT_NE(say(problems[0].sentence).find(expected), std::string::npos)
            << setting << ": " << say(problems[0].sentence);
        EXPECT_EQ(problems[0].kind, ProblemKind::about_window);
    }
}

TEST(ViewProblems, ReportAndFixClippingByNearAndFar) {
    for (const std::string& setting : {std::string("projection.near=30"), std::string("projection.far=2")}) {
        const std::vector<Problem> problems = view_problems({setting});
        ASSERT_EQ(problems.size(), 1U) << setting;
        EXPECT_NE(say(problems[0].sentence).find(setting.ends_with("30") ? "near = 30" : "far = 2"), std::string::npos)
            << say(problems[0].sentence);
        ASSERT_FALSE(problems[0].fixed_by.empty());
        EXPECT_TRUE(view_problems({setting, problems[0].fixed_by}).empty()) << problems[0].fixed_by;
    }
}

/// The edges of a frustum are measured at near: without them, a nearer near plane would widen the view.
TEST(ViewProblems, FixANearPlaneWithoutChangingTheFrustum) {
    const std::vector<std::string> settings = {
        R"(projection={"type": "frustum", "near": 7, "far": 40, "left": -4, "right": 4.2, "bottom": -2, "top": 2.5})"};
    const std::vector<Problem> problems = view_problems(settings);
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_EQ(problems[0].id, "view.near_cuts");
    EXPECT_TRUE(view_problems({settings[0], problems[0].fixed_by}).empty()) << problems[0].fixed_by;
    const ProjectionParams before = testing::params_with(settings).projection,
                           after = testing::params_with({settings[0], problems[0].fixed_by}).projection;
    EXPECT_LT(after.near, 6.0);
    EXPECT_NEAR(after.left / after.near, before.left / before.near, 1e-5);
    EXPECT_NEAR(after.right / after.near, before.right / before.near, 1e-5);
    EXPECT_NEAR(after.bottom / after.near, before.bottom / before.near, 1e-5);
    EXPECT_NEAR(after.top / after.near, before.top / before.near, 1e-5);
}

/// The eye is between the box and the mirror, and looks at the mirror.
TEST(ViewProblems, AMirrorShowsWhatIsBehindTheCamera) {
    std::vector<std::string> settings = {"plane.equation=[0,0,1,3]", "camera.position=[0,1,-1.5]", "camera.yaw=0",
                                         "camera.pitch=0"};
    EXPECT_TRUE(view_problems(settings).empty());
    settings.emplace_back("projection.far=3");  // the mirror image reaches from 3.5 to 5.5 in front of the eye
    std::vector<Problem> problems = view_problems(settings);
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_NE(say(problems[0].sentence).find("reaches to eye distance 5.5"), std::string::npos)
        << say(problems[0].sentence);
    EXPECT_EQ(problems[0].fixed_by, "projection.far=11");
    settings.back() = "reflection.enabled=false";
    problems = view_problems(settings);
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_NE(say(problems[0].sentence).find("behind the camera"), std::string::npos) << say(problems[0].sentence);
}

/// Returns a scene with one mesh: triangles whose corners are scattered in a cube of side 1, except one corner at
/// x = `stray`.
Scene mesh_scene(float stray, const glm::dvec3& scale) {
    Mesh mesh;
    for (int i = 0; i < 300; ++i) {
        const auto n = static_cast<float>(i);
        mesh.positions.push_back({std::fmod(0.37F * n, 1.0F), std::fmod(0.61F * n, 1.0F), std::fmod(0.83F * n, 1.0F)});
        mesh.normals.push_back({0.0F, 1.0F, 0.0F});
        mesh.indices.push_back(static_cast<std::uint32_t>(i));
    }
    mesh.positions[17].x = stray;
    SceneObject object = testing::object("scan", std::move(mesh), {0.0, 0.5, 0.0}, scale);
    object.description.shape = ShapeKind::mesh;
    return testing::scene_of({object});
}

TEST(ViewProblems, AMeshOfWhichNothingIsSeenIsNamed) {
    const auto says = [](const Scene& scene, const std::string& words, const std::vector<std::string>& settings = {}) {
        const std::vector<Problem> problems = view_problems(settings, scene);
        return std::any_of(problems.begin(), problems.end(), [&](const Problem& problem) {
            return say(problem.sentence).find(words) != std::string::npos;
        });
    };
    EXPECT_FALSE(says(mesh_scene(0.5F, glm::dvec3(1.0)), "scan"));
    EXPECT_TRUE(says(mesh_scene(0.5F, {2.0, 1e-5, 1e-5}), "thinner than a pixel"));
    EXPECT_FALSE(says(mesh_scene(0.5F, {2.0, 0.1, 0.1}), "thinner than a pixel"));
    EXPECT_TRUE(says(mesh_scene(500.0F, glm::dvec3(0.004)), "a few stray vertices shrink the rest to a dot"));
    EXPECT_FALSE(says(mesh_scene(20.0F, glm::dvec3(0.1)), "stray"));
    EXPECT_FALSE(says(mesh_scene(500.0F, glm::dvec3(1.0)), "stray")) << "the rest is large enough to see";
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
    const auto sentence = [](const std::string& setting) { return say(view_problems({setting}).at(0).sentence); };
    EXPECT_NE(sentence("projection.near=30").find("eye distance " + figures(farthest, 3)), std::string::npos);
    EXPECT_NE(sentence("projection.far=2").find("eye distance " + figures(nearest, 3)), std::string::npos);
}

}  // namespace
}  // namespace viewing
