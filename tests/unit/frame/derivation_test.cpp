// Checks the derivations against worked examples, against geometry (lengths, ratios, planes) and against each other,
// for any plane, light and point.
#include "topics/planes/numbers/derivation.h"

#include <cmath>

#include "unit/frame/frame_test.h"
#include "unit/geometry/random.h"

namespace viewing {
namespace {

using testing::box_scene;
using testing::params_with;

constexpr glm::dvec4 ground(0.0, 1.0, 0.0, 0.0);

glm::dvec4 slanted_plane() {
    return {glm::dvec3(1.0 / std::sqrt(3.0)), -2.0};
}

void expect_point(const glm::dvec3& found, const glm::dvec3& expected, double tolerance) {
    EXPECT_LE(glm::length(found - expected), tolerance) << found.x << " " << found.y << " " << found.z << " instead of "
                                                        << expected.x << " " << expected.y << " " << expected.z;
}

glm::dvec4 random_plane(Random& random) {
    return {random.direction(), random.number(-3.0, 3.0)};
}

TEST(ShadowDerivation, MatchesWorkedNumbers) {
    const ShadowDerivation point = derive_shadow(ground, {12, 20, 0, 1}, {0, 10, 0});
    ASSERT_TRUE(point.shadow_world);
    expect_point(*point.shadow_world, {-12, 0, 0}, 1e-12);
    EXPECT_DOUBLE_EQ(point.t, 20.0 / (20.0 - 10.0));
    EXPECT_DOUBLE_EQ(point.light_height, 20.0);
    EXPECT_DOUBLE_EQ(point.point_height, 10.0);
    EXPECT_DOUBLE_EQ(point.light_to_point, std::sqrt(144.0 + 100.0));
    EXPECT_DOUBLE_EQ(point.light_to_shadow, 2.0 * point.light_to_point);
    expect_point(point.light_foot_world, {12, 0, 0}, 1e-12);
    expect_point(point.point_foot_world, {0, 0, 0}, 1e-12);

    const ShadowDerivation parallel = derive_shadow(ground, {12, 20, 0, 0}, {0, 10, 0});
    ASSERT_TRUE(parallel.shadow_world && parallel.parallel_light);
    expect_point(*parallel.shadow_world, {-6, 0, 0}, 1e-12);
    EXPECT_DOUBLE_EQ(parallel.t, -0.5);

    const ShadowDerivation tilted = derive_shadow(slanted_plane(), {5, 9, 7, 1}, {1, 2, 3});
    ASSERT_TRUE(tilted.shadow_world);
    expect_point(*tilted.shadow_world, {0.323760, 0.816581, 2.323760}, 1e-6);
}

TEST(ShadowDerivation, IsInThePlaneOnTheRayAndDividesItByT) {
    Random random(seed);
    int regular = 0;
    for (int i = 0; i < 500; ++i) {
        const glm::dvec4 plane = random_plane(random);
        const glm::dvec4 light(random.vec3(8.0), i % 3 == 0 ? 0.0 : random.number(0.05, 1.0));
        const glm::dvec3 p = random.vec3(4.0);
        SCOPED_TRACE(i);
        const ShadowDerivation found = derive_shadow(plane, light, p);
        ASSERT_TRUE(found.shadow_world);
        const glm::dvec3 s = *found.shadow_world;
        const double size = 1.0 + glm::length(s) + glm::length(found.light_world);
        EXPECT_NEAR(glm::dot(glm::dvec3(plane), s) + plane.w, 0.0, 1e-12 * size);
        const glm::dvec3 towards = glm::dvec3(light) - light.w * p;  // from p toward the light, point or parallel
        EXPECT_NEAR(glm::length(glm::cross(s - p, glm::normalize(towards))), 0.0, 1e-11 * size);
        if (!found.parallel_light && found.ray == ShadowRay::regular) {
            EXPECT_NEAR(found.t, found.light_to_shadow / found.light_to_point, 1e-11 * size);
            EXPECT_NEAR(found.light_to_shadow, found.light_to_point + found.point_to_shadow, 1e-11 * size);
            EXPECT_GT(found.t, 1.0);
            ++regular;
        }
        EXPECT_NEAR(std::abs(found.point_height), glm::length(p - found.point_foot_world), 1e-12 * size);
    }
    EXPECT_GT(regular, 50);
}

TEST(ShadowDerivation, ChangesContinuouslyFromPointToParallel) {
    glm::dvec3 before{0.0};
    for (int step = 0; step <= 1000; ++step) {
        const double w = 1.0 - step / 1000.0;
        const ShadowDerivation found = derive_shadow(ground, {2.6, 5.2, 2.2, w}, {1.0, 1.5, -0.5});
        ASSERT_TRUE(found.shadow_world) << w;
        EXPECT_EQ(found.ray, ShadowRay::regular);
        EXPECT_EQ(found.parallel_light, w == 0.0);
        if (step > 0) {
            EXPECT_LT(glm::length(*found.shadow_world - before), 0.01) << w;
        }
        before = *found.shadow_world;
    }
    expect_point(before, {1.0 - 1.5 / 2.0, 0.0, -0.5 - 1.5 * 2.2 / 5.2}, 1e-12);
}

TEST(ShadowDerivation, DefinesAndReportsEverySpecialCase) {
    const struct {
        glm::dvec4 light;
        glm::dvec3 p;
        ShadowRay ray;
        bool has_shadow;
    } cases[] = {{{1, 4, 0, 1}, {0, 1, 0}, ShadowRay::regular, true},
                 {{1, 4, 0, 1}, {0, 0, 2}, ShadowRay::point_in_plane, true},
                 {{1, 4, 0, 1}, {0, -1, 0}, ShadowRay::point_behind, true},
                 {{1, 4, 0, 1}, {0, 6, 0}, ShadowRay::beyond_light, true},
                 {{1, 4, 0, 1}, {0, 4, 0}, ShadowRay::parallel, false},
                 {{1, 0, 0, 1}, {0, 4, 0}, ShadowRay::light_in_plane, false},
                 {{1, 0, 0, 0}, {0, 4, 0}, ShadowRay::light_in_plane, false},
                 {{1, 4, 0, 1}, {1, 4, 0}, ShadowRay::at_light, false},
                 {{1, -4, 0, 1}, {0, -1, 0}, ShadowRay::regular, true},
                 {{1, -4, 0, 0}, {0, 3, 0}, ShadowRay::point_behind, true},
                 {{0, 1, 0, 1e-30}, {0, 3, 0}, ShadowRay::regular, true}};
    for (const auto& one : cases) {
        SCOPED_TRACE(::testing::PrintToString(static_cast<int>(one.ray)));
        const ShadowDerivation found = derive_shadow(ground, one.light, one.p);
        EXPECT_EQ(found.ray, one.ray);
        EXPECT_EQ(found.shadow_world.has_value(), one.has_shadow);
        EXPECT_TRUE(std::isfinite(found.t));
        EXPECT_EQ(*sentence_of(found.ray) == '\0', one.ray == ShadowRay::regular);
    }
}

/// Expects an anti-shadow exactly where a clipper would see one: where the signs of w and Π·L differ.
TEST(ShadowDerivation, AntiShadowIsWhereWChangesSign) {
    Random random(seed + 1);
    for (int i = 0; i < 300; ++i) {
        const glm::dvec4 plane = random_plane(random), light(random.vec3(6.0), 1.0);
        const ShadowDerivation found = derive_shadow(plane, light, random.vec3(6.0));
        const glm::dvec4 sent = shadow_matrix(plane, light) * glm::dvec4(found.point_world, 1.0);
        EXPECT_NEAR(found.w, sent.w, 1e-12);
        EXPECT_EQ(found.ray == ShadowRay::beyond_light, sent.w * glm::dot(plane, light) < 0.0);
    }
}

TEST(ShadowForms, AreOneMatrix) {
    Random random(seed + 2);
    for (int i = 0; i < 200; ++i) {
        const glm::dvec4 plane = i % 2 == 0 ? ground : random_plane(random);
        const glm::dvec4 light(random.vec3(10.0), 1.0);
        const ShadowForms forms = shadow_forms(plane, light);
        ASSERT_TRUE(forms.with_d);
        EXPECT_EQ(forms.blinn.has_value(), i % 2 == 0);
        EXPECT_LE(worst_difference(*forms.with_d, forms.four_vectors), 1e-14);
        if (forms.blinn) {
            EXPECT_LE(worst_difference(*forms.blinn, forms.four_vectors), 1e-14);
        }
        EXPECT_LE(forms.largest_difference, 1e-14);
    }
    const ShadowForms parallel = shadow_forms(ground, {1, 2, 3, 0.5});
    EXPECT_FALSE(parallel.blinn || parallel.with_d);
    EXPECT_EQ(parallel.largest_difference, 0.0);
    EXPECT_FALSE(shadow_forms(-ground, {1, 2, 3, 1}).blinn) << "Blinn's form needs a normal that points up";
}

TEST(MirrorDerivation, MatchesWorkedNumbers) {
    const MirrorDerivation found = derive_mirror(slanted_plane(), {1, 2, 3});
    expect_point(found.mirrored_world, {-0.690599, 0.309401, 1.309401}, 1e-6);
    EXPECT_NEAR(found.k, 6.0 / std::sqrt(3.0) - 2.0, 1e-12);
}

TEST(MirrorDerivation, FootIsHalfwayAndTwiceIsTheIdentity) {
    Random random(seed + 3);
    for (int i = 0; i < 200; ++i) {
        const glm::dvec4 plane = random_plane(random);
        const glm::dvec3 q = random.vec3(5.0);
        const MirrorDerivation there = derive_mirror(plane, q), back = derive_mirror(plane, there.mirrored_world);
        expect_point(back.mirrored_world, q, 1e-12);
        EXPECT_NEAR(back.k, -there.k, 1e-12);
        expect_point(there.foot_world, (q + there.mirrored_world) * 0.5, 1e-12);
        EXPECT_NEAR(glm::dot(glm::dvec3(plane), there.foot_world) + plane.w, 0.0, 1e-12);
        expect_point(glm::dvec3(there.mirrored_world_from_world * glm::dvec4(q, 1.0)), there.mirrored_world, 1e-12);
        for (int row = 0; row < 3; ++row)
            EXPECT_NEAR(there.terms[row][0] + there.terms[row][1] + there.terms[row][2] + there.terms[row][3],
                        there.mirrored_world[row], 1e-12);
        EXPECT_LE(there.expansion_difference, 1e-13);
    }
}

TEST(MirrorDerivation, RecognizesTheCoordinatePlanes) {
    const glm::dvec3 q(1.0, 2.0, 3.0);
    const struct {
        glm::dvec4 plane;
        MirrorPlane name;
        glm::dvec3 mirrored;
    } cases[] = {{{1, 0, 0, 0}, MirrorPlane::yz, {-1, 2, 3}},
                 {{0, 1, 0, 0}, MirrorPlane::xz, {1, -2, 3}},
                 {{0, 0, 1, 0}, MirrorPlane::xy, {1, 2, -3}},
                 {{0, -1, 0, 0}, MirrorPlane::xz, {1, -2, 3}},
                 {{0, 1, 0, 0.5}, MirrorPlane::general, {1, -3, 3}}};
    for (const auto& one : cases) {
        const MirrorDerivation found = derive_mirror(one.plane, q);
        EXPECT_EQ(found.plane, one.name);
        expect_point(found.mirrored_world, one.mirrored, 1e-12);
        expect_point(glm::dvec3(found.mirrored_world_from_world * glm::dvec4(q, 1.0)), one.mirrored, 1e-12);
    }
}

TEST(DerivationPoint, IsTheFollowedVertexOrOneAboveThePatch) {
    const Scene scene = box_scene();
    Params params = params_with({"plane.equation=[0,2,0,3]"});
    expect_point(derivation_point(derive(params, scene, {})), {0.0, -0.5, 0.0}, 1e-12);
    params.lights.front().position = {0.0, -9.0, 0.0, 1.0};
    expect_point(derivation_point(derive(params, scene, {})), {0.0, -2.5, 0.0}, 1e-12);
    params.follow = Follow{"box", 0};
    const Derived derived = derive(params, scene, {});
    ASSERT_TRUE(derived.followed);
    expect_point(derivation_point(derived), derived.followed->point_world, 0.0);
}

}  // namespace
}  // namespace viewing
