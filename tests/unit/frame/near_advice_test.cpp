// Checks the distances in view against random points on the triangles. Also checks the advice to change near.
#include "topics/depth/numbers/near_advice.h"

#include <algorithm>

#include "state/person/language.h"
#include "unit/frame/frame_test.h"
#include "unit/geometry/random.h"

namespace viewing {
namespace {

using testing::object;
using testing::scene_of;

/// Returns a state whose camera looks from the origin along −z, with the plane out of view.
Params looking_from(double near, double far = 100.0) {
    Params params;
    params.camera.position = {0.0, 0.0, 0.0};
    params.camera.yaw = params.camera.pitch = 0.0;
    params.projection.near = near;
    params.projection.far = far;
    params.planes.front().equation = {0.0, 0.0, 1.0, -50.0};  // behind the eye
    return params;
}

/// Makes a box of side 2 whose front face is `z` in front of the eye.
SceneObject box_at(double z, double x = 0.0, const std::string& name = "box") {
    return object(name, box_mesh(), {x, 0.0, -z - 1.0});
}

std::optional<NearAdvice> advice(const Params& params, const Scene& scene) {
    return near_advice(params, derive(params, scene, {}), scene);
}

TEST(SeenThings, ReachOnlyAsFarAsTheView) {
    const Params params = looking_from(0.1);
    const Scene scene = scene_of({box_at(4.0), box_at(-9.0, 0.0, "behind"), box_at(4.0, 30.0, "beside"),
                                  box_at(120.0, 0.0, "beyond far"), box_at(99.0, 0.0, "across far")});
    const std::vector<SeenThing> seen = seen_things(params, derive(params, scene, {}), scene);
    ASSERT_EQ(seen.size(), 2U);
    EXPECT_EQ(seen[0].name, "box");
    EXPECT_NEAR(seen[0].nearest, 4.0, 1e-9);
    EXPECT_NEAR(seen[0].farthest, 6.0, 1e-9);
    EXPECT_EQ(seen[1].name, "across far");
    EXPECT_NEAR(seen[1].nearest, 99.0, 1e-9);
    EXPECT_NEAR(seen[1].farthest, 100.0, 1e-9);
}

TEST(SeenThings, OfThePlaneAreThoseOfItsPatch) {
    Params params = looking_from(0.1);
    params.projection.fovy = 90.0;
    params.planes.front() = {{0.0, 1.0, 0.0, 2.0}, 10.0};  // 2 below the eye, from 10 behind it to 10 in front
    const Scene scene;
    const std::vector<SeenThing> seen = seen_things(params, derive(params, scene, {}), scene);
    ASSERT_EQ(seen.size(), 1U);
    EXPECT_TRUE(seen[0].is_plane);
    EXPECT_NEAR(seen[0].nearest, 2.0, 1e-9) << "at the lower edge of a 90° view";
    EXPECT_NEAR(seen[0].farthest, 10.0, 1e-9);
}

/// Samples points of the triangles in the picture and finds the nearest and the farthest.
TEST(SeenThings, EncloseEveryVisiblePointOfTheirTriangles) {
    Random random(seed);
    for (int trial = 0; trial < 60; ++trial) {
        SCOPED_TRACE("seed " + std::to_string(seed) + " trial " + std::to_string(trial));
        const auto corner = [&] {
            return glm::dvec3{random.number(-8, 8), random.number(-8, 8), random.number(-20, 6)};
        };
        const std::array<glm::dvec3, 3> corners{corner(), corner(), corner()};
        Params params = looking_from(0.1, 15.0);
        params.projection.type = static_cast<ProjectionType>(trial % 4);
        const bool is_frustum = params.projection.type == ProjectionType::frustum;
        params.projection.set_window(is_frustum ? Edges{-0.02, 0.07, -0.05, 0.01} : Edges{-1.0, 4.0, -3.0, 0.5});
        const Scene scene = scene_of({object("triangle", triangle_mesh(corners), glm::dvec3(0.0))});
        const Derived derived = derive(params, scene, {});
        double nearest = 1e300, farthest = -1e300;
        for (int i = 0; i < 20'000; ++i) {
            double u = random.number(0, 1), v = random.number(0, 1);
            if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
            const glm::dvec3 point = corners[0] + u * (corners[1] - corners[0]) + v * (corners[2] - corners[0]);
            const glm::dvec4 clip = derived.clip_from_world * glm::dvec4(point, 1.0);
            const bool in_sides = std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w;
            if (!in_sides || point.z > 0.0 || point.z < -15.0) continue;
            nearest = std::min(nearest, -point.z);
            farthest = std::max(farthest, -point.z);
        }
        const std::vector<SeenThing> seen = seen_things(params, derived, scene);
        if (nearest > farthest) continue;  // the view contains too little of the triangle for the random points to hit
        ASSERT_EQ(seen.size(), 1U);
        EXPECT_LE(seen[0].nearest, nearest + 1e-6);
        EXPECT_GE(seen[0].farthest, farthest - 1e-6);
        EXPECT_NEAR(seen[0].nearest, nearest, 0.6) << "not much farther than the sampled points";
        EXPECT_NEAR(seen[0].farthest, farthest, 0.6);
    }
}

TEST(DistanceMarks, AreGroupedWhereTheyAreClosest) {
    const std::vector<SeenThing> seen = {
        {"d", 40.0, 41.0}, {"a", 1.0, 2.0}, {"b", 1.01, 2.0}, {"c", 10.0, 11.0}, {"e", 50.0, 60.0, true}};
    const std::vector<DistanceMark> four = distance_marks(seen, 8);
    ASSERT_EQ(four.size(), 4U);
    EXPECT_EQ(say(four[0].label), "a +1") << "too close to distinguish";
    EXPECT_EQ(four[0].z, 1.0);
    EXPECT_EQ(say(four[3].label), "the plane");
    EXPECT_TRUE(four[3].is_plane);
    const std::vector<DistanceMark> three = distance_marks(seen, 3);
    ASSERT_EQ(three.size(), 3U);
    EXPECT_EQ(say(three[2].label), "d +1");
    ASSERT_EQ(distance_marks(seen, 1).size(), 1U);
    EXPECT_EQ(say(distance_marks(seen, 0).at(0).label), "a +4");
    EXPECT_TRUE(distance_marks({}, 8).empty());
}

TEST(DistanceMarks, NameObjectsInTheChosenLanguage) {
    const std::vector<SeenThing> seen = {{"torus", 1.0, 2.0}, {"b", 1.01, 2.0}};
    const Message label = distance_marks(seen, 8).at(0).label;
    EXPECT_EQ(say(label), "torus +1");
    ASSERT_TRUE(speak(Language::ko));
    EXPECT_EQ(say(label), "토러스 +1");
    ASSERT_TRUE(speak(Language::en));
}

TEST(NearAdvice, QuantifiesTheGain) {
    const std::optional<NearAdvice> found = advice(looking_from(0.01), scene_of({box_at(4.0), box_at(78.0)}));
    ASSERT_TRUE(found);
    EXPECT_FALSE(found->cuts);
    EXPECT_EQ(found->near, 3.6);
    const std::string sentence = say(found->sentence);
    EXPECT_TRUE(sentence.starts_with("Nothing is nearer than 4: with near = 3.6, the safe gap at z = 80 would be "));
    // The step is proportional to 1/n − 1/f, which changes from 99.99 to 0.2678.
    const std::size_t end = sentence.find(" times smaller.");
    ASSERT_NE(end, std::string::npos) << sentence;
    EXPECT_NEAR(std::stod(sentence.substr(sentence.rfind(' ', end - 1))), 373.4, 0.05 * 373.4);
}

TEST(NearAdvice, IsAbsentIfNearIsFine) {
    const Scene scene = scene_of({box_at(4.0)});
    EXPECT_FALSE(advice(looking_from(3.0), scene));
    EXPECT_FALSE(advice(looking_from(2.0), scene)) << "a factor of 2";
    EXPECT_TRUE(advice(looking_from(0.7), scene)) << "a factor of 5.3";
    EXPECT_FALSE(advice(looking_from(0.001), Scene{})) << "nothing in view";
    EXPECT_FALSE(advice(looking_from(0.001), scene_of({box_at(-9.0)}))) << "behind the eye";

    Params params = looking_from(0.001);
    params.projection.type = ProjectionType::orthographic;
    EXPECT_FALSE(advice(params, scene));
    params = looking_from(0.001);
    params.depth.mapping = DepthMapping::logarithmic;
    EXPECT_FALSE(advice(params, scene)) << "a small near costs little";
    params.projection.near = 5.0;
    EXPECT_TRUE(advice(params, scene)) << "near can still be too large";
    params.projection.near = 0.001;
    params.depth.mapping = DepthMapping::reversed;
    params.depth.format = DepthFormat::d32f;
    EXPECT_FALSE(advice(params, scene)) << "a small near costs nothing";
    params.depth.reversed_zero_to_one = false;
    EXPECT_TRUE(advice(params, scene)) << "a small near is costly with a clip range of −1 to 1";
}

TEST(NearAdvice, ReportsCutObjects) {
    const std::optional<NearAdvice> found = advice(looking_from(5.0), scene_of({box_at(4.0)}));
    ASSERT_TRUE(found);
    EXPECT_TRUE(found->cuts);
    EXPECT_EQ(found->near, 3.6);
    EXPECT_EQ(say(found->sentence).substr(0, 52), "near = 5 cuts into box, whose nearest point is at 4:");
    EXPECT_NE(say(found->sentence).find("1.4 times larger."), std::string::npos) << say(found->sentence);

    const std::optional<NearAdvice> inside = advice(looking_from(0.5), scene_of({box_at(-1.0)}));
    EXPECT_FALSE(inside) << "inside a box all faces are one unit away";
    const std::optional<NearAdvice> through =
        advice(looking_from(0.5), scene_of({object("wall", box_mesh(), {1, 0, 0})}));
    ASSERT_TRUE(through);
    EXPECT_FALSE(through->near);
    EXPECT_EQ(say(through->sentence),
              "near = 0.5 cuts into wall, which reaches the eye or goes past it: no near plane would keep it whole.");
}

TEST(NearAdvice, NeverCutsVisibleObjects) {
    Random random(seed);
    int given = 0;
    for (int trial = 0; trial < 300; ++trial) {
        SCOPED_TRACE("seed " + std::to_string(seed) + " trial " + std::to_string(trial));
        Params params = looking_from(std::exp(random.number(std::log(1e-5), std::log(20.0))), 60.0);
        params.camera.yaw = random.number(-180, 180);
        params.camera.pitch = random.number(-80, 80);
        params.planes.front() = {{0.0, 1.0, 0.0, 1.5}, 6.0};
        std::vector<SceneObject> objects;
        for (int i = 0; i < 6; ++i)
            objects.push_back(box_at(random.number(-20, 20), random.number(-20, 20), "box " + std::to_string(i)));
        const Scene scene = scene_of(std::move(objects));
        const Derived derived = derive(params, scene, {});
        const std::optional<NearAdvice> found = near_advice(params, derived, scene);
        if (!found || !found->near) continue;
        ++given;
        EXPECT_GT(*found->near, 0.0);
        EXPECT_LT(*found->near, params.projection.far);
        EXPECT_EQ(found->cuts, *found->near < params.projection.near);
        for (const SeenThing& thing : seen_things(params, derived, scene)) EXPECT_LT(*found->near, thing.nearest);
        // A state that follows the advice gets no more advice.
        params.projection.near = *found->near;
        EXPECT_FALSE(near_advice(params, derive(params, scene, {}), scene));
    }
    EXPECT_GT(given, 100);
}

}  // namespace
}  // namespace viewing
