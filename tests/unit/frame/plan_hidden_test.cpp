// Hidden-surface methods as passes: the subjects drawn, their order relative to the patch, and the overdraw and
// difference views. See tests/gl/hidden_test.cpp for the pictures.
#include <algorithm>

#include "topics/hidden/numbers/hidden_views.h"
#include "unit/frame/hidden_scenes.h"

namespace viewing {
namespace {

using testing::Names;
using testing::names_of_passes;
using testing::object;
using testing::params_with;
using testing::scene_of;

constexpr glm::ivec2 size_px(32, 24);
constexpr std::array methods_by_hand{"painter", "newell", "bsp", "software_depth_buffer", "ray_cast"};

/// Two scenes: a box on the ground, and a box that crosses the ground.
Scene scene_above() {
    return scene_of({object("box", box_mesh(), {0, 1, 0})});
}
Scene scene_through() {
    return scene_of({object("box", box_mesh(), {0, 0.2, 0})});
}

FramePlan plan_by(std::vector<std::string> settings, const Scene& scene, const std::string& method = "painter") {
    settings.insert(settings.begin(), "visibility.method=" + method);
    const Params params = params_with(settings);
    const Derived derived = derive(params, scene, Viewport{size_px});
    const auto question = hidden_question(params, derived, size_px);
    if (!question) return plan(params, derived);
    HiddenSurfaceSolver solver(scene);
    return plan(params, derived, answer_hidden_question(solver, *question).pictures);
}

/// Fragments that are drawn in order take no depth test; pixels that a method found always pass and write their depth.
TEST(PlanHidden, SoftwareMethodsDrawWithoutTheDepthTest) {
    for (const Scene& scene : {scene_above(), scene_through()})
        for (const char* method : methods_by_hand)
            for (const char* shows : {"color", "facing", "overdraw", "difference"}) {
                SCOPED_TRACE(std::string(method) + " " + shows);
                const FramePlan frame = plan_by({std::string("view.shows=") + shows}, scene, method);
                for (const Pass& pass : frame.passes) {
                    EXPECT_EQ(pass.depth.test, pass.subject == Subject::pixels) << say(pass.name);
                    if (!pass.depth.test) continue;
                    EXPECT_EQ(pass.depth.func, CompareFunc::always) << say(pass.name);
                    EXPECT_TRUE(pass.depth.write) << say(pass.name);
                }
            }
    for (const Pass& pass : plan_by({}, scene_above(), "depth_buffer").passes) EXPECT_TRUE(pass.depth.test);
}

TEST(PlanHidden, PatchSplitsTheSceneOnlyIfObjectsCrossIt) {
    const Names plain{"Mirror mask", "Mirror image", "Patch", "Shadow", "Objects"};
    const Names divided{"Mirror mask", "Objects beyond the plane",     "Mirror image", "Patch",
                        "Shadow",      "Objects in front of the plane"};
    for (const char* method : methods_by_hand) {
        SCOPED_TRACE(method);
        EXPECT_EQ(names_of_passes(plan_by({}, scene_above(), method)), plain);
        EXPECT_EQ(names_of_passes(plan_by({}, scene_through(), method)), divided);
    }
    for (const char* method : {"depth_buffer", "none"})
        EXPECT_EQ(names_of_passes(plan_by({}, scene_through(), method)), plain) << method;
    const FramePlan mirrors = plan_by({}, scene_through());
    EXPECT_EQ(mirrors.passes.at(1).stencil, (StencilState{true, CompareFunc::notequal, 1, StencilOp::keep}))
        << "the mirror shows its image, not objects behind it";
    EXPECT_EQ(names_of_passes(plan_by({"reflection.enabled=false"}, scene_through())).front(),
              "Objects beyond the plane");
}

TEST(PlanHidden, ObjectsBeyondAreBehindThePlaneForTheEye) {
    for (const double height : {4.0, -4.0}) {
        for (const double sign : {1.0, -2.0}) {
            const FramePlan frame = plan_by({"camera.position=[0," + std::to_string(height) + ",7]",
                                             "plane.equation=[0," + std::to_string(sign) + ",0,0]"},
                                            scene_through());
            const auto beyond = std::ranges::find(frame.passes, "Objects beyond the plane", &Pass::name);
            ASSERT_NE(beyond, frame.passes.end());
            ASSERT_EQ(frame.passes.back().name, "Objects in front of the plane");
            const glm::dvec4 eye(0, height, 7, 1);
            EXPECT_LT(glm::dot(beyond->clip_planes.at(0), eye), 0.0);
            EXPECT_GT(glm::dot(frame.passes.back().clip_planes.at(0), eye), 0.0);
            EXPECT_EQ(beyond->clip_planes.at(0), -frame.passes.back().clip_planes.at(0));
        }
    }
    const Names passes = names_of_passes(plan_by({"camera.position=[0,0,7]", "camera.pitch=0"}, scene_through()));
    EXPECT_TRUE(std::ranges::none_of(passes, [](const auto& name) { return name.starts_with("Objects b"); }))
        << "the patch is edge-on";
}

TEST(PlanHidden, OrdersAndPixelsReplaceTheObjects) {
    for (const char* method : methods_by_hand) {
        SCOPED_TRACE(method);
        const bool finds_pixels = method == std::string("software_depth_buffer") || method == std::string("ray_cast");
        const FramePlan frame = plan_by({}, scene_through(), method);
        ASSERT_TRUE(frame.hidden.camera);
        ASSERT_TRUE(frame.hidden.mirrored);
        EXPECT_NE(frame.hidden.camera, frame.hidden.mirrored);
        EXPECT_EQ(frame.hidden.camera->pixels.size(), finds_pixels ? 32U * 24U : 0U);
        for (const Pass& pass : frame.passes) {
            const bool shows_scene = pass.name == "Mirror image" || say(pass.name).starts_with("Objects");
            const Subject expected = finds_pixels ? Subject::pixels : Subject::ordered;
            EXPECT_EQ(pass.subject == expected, shows_scene) << say(pass.name);
            EXPECT_EQ(pass.is_mirror_image, pass.name == "Mirror image");
            if (pass.name == "Shadow") {
                EXPECT_EQ(pass.subject, Subject::objects) << "shadows never depend on the method";
            }
            EXPECT_FALSE(pass.reason.empty());
        }
    }
    const FramePlan masked = plan_by({"visibility.walk=front_to_back"}, scene_above(), "bsp");
    EXPECT_EQ(masked.passes.back().subject, Subject::pixels);
}

TEST(PlanHidden, GlDrawsTheObjectsUntilThereIsAnAnswer) {
    const Params params = params_with({"visibility.method=bsp"});
    const FramePlan frame = plan(params, derive(params, scene_above(), Viewport{size_px}));
    EXPECT_EQ(frame.passes.back().subject, Subject::objects);
    EXPECT_FALSE(frame.passes.back().depth.test);
}

TEST(PlanHidden, StepOfTheDepthBufferDrawsInSceneOrder) {
    const FramePlan frame = plan_by({"visibility.step=3"}, scene_above(), "depth_buffer");
    EXPECT_EQ(frame.passes.back().subject, Subject::ordered);
    EXPECT_TRUE(frame.passes.back().depth.test);
    EXPECT_EQ(frame.hidden.camera->triangles.size(), 9U);
    EXPECT_FALSE(hidden_question(params_with({}), derive(Params{}, scene_above(), Viewport{size_px}), size_px))
        << "GL alone draws the opening state";
}

TEST(PlanHidden, OverdrawCountsOnlyTheScene) {
    for (const char* method : {"depth_buffer", "none", "painter", "bsp", "ray_cast"})
        for (const Scene& scene : {scene_above(), scene_through()}) {
            SCOPED_TRACE(method);
            const FramePlan frame = plan_by({"view.shows=overdraw"}, scene, method);
            EXPECT_EQ(frame.samples, 0);
            int counting = 0;
            for (const Pass& pass : frame.passes) {
                EXPECT_EQ(pass.color_write, say(pass.name).starts_with("Objects")) << say(pass.name);
                if (!pass.color_write) continue;
                ++counting;
                EXPECT_EQ(pass.blend, Blend::add);
                EXPECT_EQ(pass.shading, Shading::flat);
                EXPECT_EQ(pass.color.r * 255.0, 1.0);
            }
            EXPECT_GE(counting, 1);
        }
}

TEST(PlanHidden, DifferenceIsDrawnLast) {
    for (const char* method : {"software_depth_buffer", "ray_cast"}) {
        const FramePlan frame = plan_by({"view.shows=difference", "visibility.compare_with=software_depth_buffer"},
                                        scene_through(), method);
        EXPECT_EQ(frame.passes.back().subject, Subject::difference);
        EXPECT_EQ(frame.passes.back().blend, Blend::alpha);
        EXPECT_EQ(std::ranges::count(frame.passes, Subject::difference, &Pass::subject), 1);
        ASSERT_TRUE(frame.hidden.difference);
        EXPECT_EQ(frame.hidden.difference->pixels.size(), 32U * 24U);
    }
    for (const char* method : {"depth_buffer", "painter", "newell", "bsp"}) {
        const FramePlan by_gl =
            plan_by({"view.shows=difference", "visibility.compare_with=ray_cast"}, scene_above(), method);
        EXPECT_NE(by_gl.passes.back().subject, Subject::difference) << "GL's picture is not available yet: " << method;
    }
}

TEST(PlanHidden, ObserverSeesThePlainScene) {
    const Params params = params_with({"visibility.method=bsp", "view.shows=overdraw"});
    const FramePlan frame = plan_observer(params, derive(params, scene_through(), Viewport{size_px}),
                                          derive_observer(params.observer, Viewport{size_px}));
    EXPECT_EQ(frame.passes.back().subject, Subject::objects);
    EXPECT_TRUE(frame.passes.back().depth.test);
    EXPECT_TRUE(frame.passes.back().color_write);
}

}  // namespace
}  // namespace viewing
