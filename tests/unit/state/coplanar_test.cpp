// Checks the scene `coplanar` against its design values, and checks the effect of its three parameters.
#include "state/mesh/coplanar.h"

#include <gtest/gtest.h>

#include "state/scene.h"

namespace viewing {
namespace {

const glm::dvec3 viewpoint{0.0, 1.5, 4.0};

/// Returns the corners of a quad of side 2 in y = 0, placed by the object's pose.
std::array<glm::dvec3, 4> corners_world(const ObjectDescription& object) {
    const glm::dmat4 world_from_quad = world_from_model(object.position, object.rotation, object.scale);
    std::array<glm::dvec3, 4> corners;
    for (int i = 0; i < 4; ++i)
        corners[static_cast<std::size_t>(i)] =
            glm::dvec3(world_from_quad * glm::dvec4(i % 2 == 0 ? -1.0 : 1.0, 0.0, i < 2 ? -1.0 : 1.0, 1.0));
    return corners;
}

/// Returns the normal of the plane through three corners, toward the viewpoint.
glm::dvec3 normal_world(const ObjectDescription& object) {
    const std::array<glm::dvec3, 4> corners = corners_world(object);
    const glm::dvec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    return glm::dot(normal, viewpoint - corners[0]) > 0.0 ? normal : -normal;
}

TEST(Coplanar, DefaultsMatchTheDesign) {
    const SceneDescription scene = coplanar_scene({});
    ASSERT_EQ(scene.objects.size(), 12U);
    const struct {
        std::size_t index;
        const char* name;
        glm::dvec3 position;
        Angles rotation;
        double scale;
        Color color;
    } designed[] = {
        {0, "back quad at 4", {-1.7809, 0.9378, 0}, {30, 98, 0}, 0.272, {0x5a, 0x9e, 0xf0}},
        {1, "front quad at 4", {-1.6633, 1.0307, -0.0411}, {30, 98, 0}, 0.272, {0xe0, 0x81, 0x2f}},
        {3, "front quad at 8", {-1.902, 1.0576, -4.0537}, {21, 98, 0}, 0.544, {0xe0, 0x81, 0x2f}},
        {4, "back quad at 14", {-1.348, 1.1334, -10}, {11.5, 98, 0}, 0.952, {0x5a, 0x9e, 0xf0}},
        {7, "front quad at 24", {2.6253, 2.4831, -19.9299}, {1.5, 98, 0}, 1.632, {0xe0, 0x81, 0x2f}},
        {8, "back quad at 44", {10.9704, 3.652, -40}, {-8, 98, 0}, 2.992, {0x5a, 0x9e, 0xf0}},
        {10, "back quad at 84", {36.5242, 7.3739, -80}, {-17.5, 98, 0}, 5.712, {0x5a, 0x9e, 0xf0}},
        {11, "front quad at 84", {38.889, 9.3523, -78.9523}, {-17.5, 98, 0}, 5.712, {0xe0, 0x81, 0x2f}},
    };
    for (const auto& expected : designed) {
        SCOPED_TRACE(expected.name);
        const ObjectDescription& object = scene.objects[expected.index];
        EXPECT_EQ(object.name, expected.name);
        EXPECT_EQ(object.shape, ShapeKind::quad);
        EXPECT_EQ(object.color, expected.color);
        EXPECT_EQ(object.rotation, expected.rotation);
        EXPECT_LT(glm::distance(object.position, expected.position), 1e-3);
        EXPECT_NEAR(object.scale.x, expected.scale, 1e-12);
        EXPECT_NEAR(object.scale.z, expected.scale, 1e-12);
        EXPECT_EQ(object.decal, object.name.starts_with("front"));
    }
}

TEST(Coplanar, GapIsMeasuredAlongTheNormalAtAnyDistance) {
    for (const CoplanarParams& params : {CoplanarParams{0.2, 8.0, 4.0}, CoplanarParams{0.2, 60.0, 400.0},
                                         CoplanarParams{10.0, 75.0, 1000.0}, CoplanarParams{0.0, 8.0, 4.0}}) {
        const SceneDescription scene = coplanar_scene(params);
        for (std::size_t pair = 0; pair < 12; pair += 2) {
            SCOPED_TRACE(scene.objects[pair].name);
            const glm::dvec3 normal = normal_world(scene.objects[pair]);
            for (const glm::dvec3& corner : corners_world(scene.objects[pair + 1]))
                EXPECT_NEAR(glm::dot(corner - scene.objects[pair].position, normal), params.gap,
                            1e-12 * (1.0 + params.distance));
        }
    }
}

TEST(Coplanar, PictureIsTheSameAtAnyDistance) {
    const SceneDescription near = coplanar_scene({0.0, 8.0, 4.0});
    for (const double distance : {1.0, 40.0, 1000.0}) {
        const SceneDescription far = coplanar_scene({0.0, 8.0, distance});
        EXPECT_NEAR(viewpoint.z - far.objects[0].position.z, distance, 1e-9);
        for (std::size_t object = 0; object < 12; ++object) {
            SCOPED_TRACE(far.objects[object].name);
            const auto near_corners = corners_world(near.objects[object]);
            const auto far_corners = corners_world(far.objects[object]);
            for (std::size_t i = 0; i < 4; ++i) {
                const glm::dvec3 a = near_corners[i] - viewpoint, b = far_corners[i] - viewpoint;
                EXPECT_NEAR(b.x / b.z, a.x / a.z, 1e-9);
                EXPECT_NEAR(b.y / b.z, a.y / a.z, 1e-9);
            }
        }
    }
    EXPECT_EQ(coplanar_scene({0.01, 8.0, 40.0}).objects[0].name, "back quad at 40");
}

TEST(Coplanar, TiltTurnsAPairFromTheVertical) {
    for (const double tilt : {0.0, 8.0, 75.0}) {
        for (const ObjectDescription& object : coplanar_scene({0.01, tilt, 4.0}).objects) {
            SCOPED_TRACE(object.name);
            const glm::dvec3 normal = normal_world(object);
            EXPECT_NEAR(std::abs(normal.y), std::sin(glm::radians(tilt)), 1e-12);
            EXPECT_GT(normal.z, 0.0) << "faces a viewer who looks along −z";
        }
    }
}

TEST(Coplanar, LoadsWithItsParameters) {
    const CoplanarParams params{0.2, 20.0, 7.0};
    const Result<Scene> scene = load_scene(std::string("coplanar"), "", params);
    ASSERT_TRUE(scene) << scene.error();
    EXPECT_EQ(scene->made_from, params);
    ASSERT_EQ(scene->objects.size(), 12U);
    EXPECT_EQ(scene->objects[3].description, coplanar_scene(params).objects[3]);
    EXPECT_EQ(load_scene(std::string("coplanar"), "")->made_from, CoplanarParams{});
    EXPECT_FALSE(load_scene(std::string("decals"), "", params)->made_from) << "this scene lists its objects";
}

}  // namespace
}  // namespace viewing
