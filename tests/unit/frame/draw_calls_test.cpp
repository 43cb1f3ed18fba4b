// The draw calls of a frame in GL's order, and stepping back through them one triangle at a time.
#include "frame/plan/draw_calls.h"

#include <algorithm>

#include "frame_test.h"

namespace viewing {
namespace {

using testing::object;
using testing::params_with;
using testing::scene_of;

Scene two_boxes_and_a_decal() {
    SceneObject decal = object("poster", quad_mesh(), {0, 1, 1});
    decal.description.decal = true;
    return scene_of({object("left", box_mesh(), {-2, 1, 0}), decal, object("right", box_mesh(), {2, 1, 0})});
}

FramePlan planned(const std::vector<std::string>& settings, const Scene& scene) {
    const Params params = params_with(settings);
    return plan(params, derive(params, scene, {{160, 90}, true}));
}

std::vector<std::string> names(const FramePlan& frame, const Scene& scene) {
    std::vector<std::string> all;
    for (const DrawCall& call : draw_calls(frame, scene)) all.push_back(say(name_of(call, frame, scene)));
    return all;
}

TEST(DrawCalls, HaveOneForEachObjectOfEachPass) {
    const Scene scene = two_boxes_and_a_decal();
    const FramePlan frame = planned({"reflection.enabled=false"}, scene);
    EXPECT_EQ(names(frame, scene),
              (std::vector<std::string>{"plane, pass 1: Patch", "left, pass 2: Shadow", "poster, pass 2: Shadow",
                                        "right, pass 2: Shadow", "left, pass 3: Objects", "poster, pass 3: Objects",
                                        "right, pass 3: Objects"}));
    const std::vector<DrawCall> calls = draw_calls(frame, scene);
    EXPECT_EQ(calls[0], (DrawCall{0, -1, 2}));
    EXPECT_EQ(calls[1], (DrawCall{1, 0, 12}));
    EXPECT_EQ(calls[5], (DrawCall{2, 1, 2}));
}

TEST(DrawCalls, OfAPassAreItsChosenObjects) {
    const Scene scene = two_boxes_and_a_decal();
    FramePlan frame;
    frame.passes.resize(3);
    frame.passes[0].name = "Bases";
    frame.passes[0].chosen = Chosen::bases;
    frame.passes[1].name = "Decals";
    frame.passes[1].chosen = Chosen::decals;
    frame.passes[2].name = "Difference";
    frame.passes[2].subject = Subject::difference;
    EXPECT_EQ(names(frame, scene),
              (std::vector<std::string>{"left, pass 1: Bases", "right, pass 1: Bases", "poster, pass 2: Decals"}));
    int counted = 0;
    for (const Pass& pass : frame.passes) counted += call_count(pass, scene);
    EXPECT_EQ(counted, 3);
}

TEST(DrawCalls, AreEmptyIfAMethodFindsTheSurfaces) {
    const Scene scene = two_boxes_and_a_decal();
    FramePlan frame = planned({}, scene);
    for (const Subject subject : {Subject::ordered, Subject::pixels}) {
        frame.passes.back().subject = subject;
        EXPECT_TRUE(draw_calls(frame, scene).empty());
    }
}

TEST(DrawLimits, StopWithinTheirCall) {
    EXPECT_EQ(triangles_drawn({}, 7, 12), 12);
    EXPECT_EQ(triangles_drawn({3, 5}, 2, 12), 12);
    EXPECT_EQ(triangles_drawn({3, 5}, 3, 12), 5);
    EXPECT_EQ(triangles_drawn({3, 50}, 3, 12), 12);
    EXPECT_EQ(triangles_drawn({3, -1}, 3, 12), 12);
    EXPECT_EQ(triangles_drawn({3, 0}, 3, 12), 0);
    EXPECT_EQ(triangles_drawn({3, 5}, 4, 12), 0);
    EXPECT_EQ(triangles_drawn({-1, 5}, 4, 12), 12);
}

/// Counts the triangles that a limit admits in all calls.
int drawn(const DrawLimit& limit, const std::vector<DrawCall>& calls) {
    int sum = 0;
    for (std::size_t i = 0; i < calls.size(); ++i)
        sum += triangles_drawn(limit, static_cast<int>(i), calls[i].triangles);
    return sum;
}

TEST(DrawLimits, StepBackOneTriangleAtATime) {
    const std::vector<DrawCall> calls = {{0, -1, 2}, {1, 0, 0}, {1, 1, 3}, {1, 2, 0}, {1, 3, 0}, {2, 0, 1}, {2, 1, 0}};
    for (const DrawLimit last : {DrawLimit{}, DrawLimit{6, -1}, DrawLimit{99, 4}, DrawLimit{5, 1}, DrawLimit{5, 80}}) {
        DrawLimit limit = last;
        for (int left = 6; left > 0; --left) {
            EXPECT_EQ(drawn(limit, calls), left);
            limit = step_before(limit, calls);
        }
        EXPECT_EQ(limit, (DrawLimit{0, 0}));
        EXPECT_EQ(step_before(limit, calls), (DrawLimit{0, 0}));
    }
    EXPECT_EQ(step_before({2, 1}, calls), (DrawLimit{0, 2})) << "the last triangle of the previous call that has any";
    EXPECT_EQ(step_before({2, 0}, calls), (DrawLimit{0, 1}));
    EXPECT_EQ(step_before({3, -1}, calls), (DrawLimit{2, 2}));
    EXPECT_EQ(step_before({}, {}), (DrawLimit{0, 0}));
    EXPECT_EQ(step_before({4, 4}, {{0, 0, 0}, {0, 1, 0}}), (DrawLimit{0, 0}));
}

}  // namespace
}  // namespace viewing
