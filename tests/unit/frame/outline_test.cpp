// The outline that a light sees: worked examples with boxes, then a brute-force check that it contains every vertex's
// shadow.
#include "topics/planes/numbers/outline.h"

#include "unit/frame/frame_test.h"
#include "unit/geometry/random.h"

namespace viewing {
namespace {

using testing::object;

const glm::dvec4 level(0, 1, 0, 0);

/// Intersects the line from the light through a point with the plane by solving n·(l + t (p − l)) + d = 0; empty if the
/// point is not between the light and the plane.
std::optional<glm::dvec3> shadow_of(const glm::dvec3& point, const glm::dvec4& plane, const glm::dvec4& light) {
    const glm::dvec3 n(plane), way = light.w == 0.0 ? -glm::dvec3(light) : point - glm::dvec3(light) / light.w;
    const double side = glm::dot(plane, light) > 0.0 ? 1.0 : -1.0;
    const double height = side * (glm::dot(n, point) + plane.w), falls = -side * glm::dot(n, way);
    if (height < 0.0 || falls <= 0.0) return std::nullopt;
    return point + way * (height / falls);
}

glm::dvec3 world_vertex(const SceneObject& placed, std::size_t vertex) {
    return glm::dvec3(placed.world_from_model * glm::dvec4(placed.mesh->positions[vertex], 1.0));
}

/// Returns how far a point of the plane lies outside a convex outline, measured by the signed distance to each edge, or
/// 0 if the point is inside.
double outside(const std::vector<OutlineVertex>& outline, const glm::dvec3& point, const glm::dvec3& normal) {
    glm::dvec3 middle(0.0);
    for (const OutlineVertex& corner : outline) middle += corner.shadow_world / static_cast<double>(outline.size());
    double worst = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::dvec3& from = outline[i].shadow_world;
        const glm::dvec3 edge = outline[(i + 1) % outline.size()].shadow_world - from;
        if (glm::length(edge) < 1e-9) continue;
        glm::dvec3 outwards = glm::normalize(glm::cross(edge, normal));
        if (glm::dot(outwards, middle - from) > 0.0) outwards = -outwards;
        worst = std::max(worst, glm::dot(outwards, point - from));
    }
    return worst;
}

TEST(Outline, OfABoxUnderALightStraightAboveIsItsTop) {
    const SceneObject box = object("box", box_mesh(), {0, 1, 0});
    const std::vector<OutlineVertex> outline = shadow_outline(box, level, {0, 6, 0, 1});
    ASSERT_EQ(outline.size(), 4U);
    for (const OutlineVertex& corner : outline) {
        EXPECT_NEAR(corner.vertex_world.y, 2.0, 1e-12);
        EXPECT_NEAR(std::abs(corner.shadow_world.x), 1.5, 1e-12);  // 6 / (6 − 2) times half the width
        EXPECT_NEAR(std::abs(corner.shadow_world.z), 1.5, 1e-12);
    }
    EXPECT_EQ(shadow_outline(box, level, {0, 1, 0, 0}).size(), 4U);
}

TEST(Outline, OfABoxInSlantedLightHasSixCorners) {
    const SceneObject box = object("box", box_mesh(), {0, 1, 0});
    EXPECT_EQ(shadow_outline(box, level, {1, 2, 1.3, 0}).size(), 6U);
    EXPECT_EQ(shadow_outline(box, -level, {1, 2, 1.3, 0}).size(), 6U) << "opposite sign of the plane";
    EXPECT_EQ(shadow_outline(box, level, {1, 0, 1.3, 0}).size(), 0U) << "the light is in the plane";
}

TEST(Outline, IgnoresPartsNotBetweenLightAndPlane) {
    const SceneObject high = object("high", box_mesh(), {0, 9, 0}), low = object("low", box_mesh(), {0, -3, 0});
    EXPECT_TRUE(shadow_outline(high, level, {0, 5, 0, 1}).empty());
    EXPECT_TRUE(shadow_outline(low, level, {0, 5, 0, 1}).empty());
    EXPECT_EQ(shadow_outline(low, level, {0.4, -7, 0.3, 1}).size(), 4U) << "a light below acts on its own side";
    // The box crosses the horizontal plane through the light. The part above that plane casts no shadow.
    for (const OutlineVertex& corner : shadow_outline(object("tall", box_mesh(), {3, 2, 0}), level, {0, 2.5, 0, 1}))
        EXPECT_LT(corner.vertex_world.y, 2.5);
    SceneObject nothing = high;
    nothing.mesh = nullptr;
    EXPECT_TRUE(shadow_outline(nothing, level, {0, 12, 0, 1}).empty());
    nothing.mesh = std::make_shared<const Mesh>();
    EXPECT_TRUE(shadow_outline(nothing, level, {0, 12, 0, 1}).empty());
}

TEST(Outline, ContainsTheShadowOfEveryVertex) {
    Random random(seed);
    const Mesh meshes[] = {box_mesh(), sphere_mesh(), torus_mesh()};
    std::size_t outlines = 0, shadows = 0;
    for (int i = 0; i < 240; ++i) {
        const SceneObject placed =
            object("it", meshes[i % 3], random.vec3(3.0), glm::abs(random.vec3(1.0)) + glm::dvec3(0.2));
        const glm::dvec4 plane(random.direction(), random.number(-3, 3));
        const glm::dvec4 light(random.vec3(9.0), i % 2);
        const std::vector<OutlineVertex> outline = shadow_outline(placed, plane, light);
        outlines += outline.empty() ? 0 : 1;
        for (const OutlineVertex& corner : outline) {
            const std::optional<glm::dvec3> expected = shadow_of(corner.vertex_world, plane, light);
            ASSERT_TRUE(expected);
            EXPECT_LT(glm::length(corner.shadow_world - *expected), 1e-6 * (1.0 + glm::length(*expected)));
        }
        for (std::size_t vertex = 0; vertex < placed.mesh->positions.size(); ++vertex) {
            const std::optional<glm::dvec3> shadow = shadow_of(world_vertex(placed, vertex), plane, light);
            const double reach = shadow ? glm::length(*shadow - world_vertex(placed, vertex)) : 0.0;
            if (!shadow ||
                (light.w == 1.0 && reach > 900.0 * glm::length(world_vertex(placed, vertex) - glm::dvec3(light))))
                continue;
            ++shadows;
            ASSERT_FALSE(outline.empty());
            EXPECT_LT(outside(outline, *shadow, glm::dvec3(plane)), 1e-5 * (1.0 + reach)) << "case " << i;
        }
    }
    EXPECT_GT(outlines, 100U);
    EXPECT_GT(shadows, 10'000U);
}

TEST(Outline, IsThinnedEvenly) {
    const SceneObject ball = object("ball", sphere_mesh(), {0, 2, 0});
    const std::vector<OutlineVertex> outline = shadow_outline(ball, level, {1, 6, 2, 1});
    ASSERT_GT(outline.size(), 24U);
    const std::vector<OutlineVertex> few = thinned(outline, 12);
    ASSERT_EQ(few.size(), 12U);
    for (std::size_t i = 0; i < few.size(); ++i) {
        const auto at = std::find_if(outline.begin(), outline.end(), [&](const OutlineVertex& corner) {
            return corner.shadow_world == few[i].shadow_world;
        });
        const double share = static_cast<double>(at - outline.begin()) / static_cast<double>(outline.size());
        EXPECT_NEAR(share, static_cast<double>(i) / 12.0, 1.0 / static_cast<double>(outline.size()));
    }
    EXPECT_EQ(thinned(few, 12).size(), 12U);
    EXPECT_TRUE(thinned(outline, 0).empty());
}

}  // namespace
}  // namespace viewing
