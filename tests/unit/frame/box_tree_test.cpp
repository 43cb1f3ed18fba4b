// Boxes around a mesh's vertices and triangles must give the same results as testing each vertex and triangle, on
// random meshes, planes, lights and views, and exactly at the limits.
#include "frame/box_tree.h"

#include <limits>

#include "frame/box_form.h"
#include "frame/object_reach.h"
#include "geometry/projection.h"
#include "topics/depth/numbers/near_advice.h"
#include "unit/frame/frame_test.h"
#include "unit/geometry/random.h"

namespace viewing {
namespace {

using testing::scene_of;

/// Makes triangles at random positions or near a ball, with coordinates that are often equal. Some vertices are unused.
Mesh random_mesh(Random& random, int triangles) {
    Mesh mesh;
    const bool is_ball = random.number(0, 1) < 0.5, is_coarse = random.number(0, 1) < 0.3;
    const auto place = [&] {
        const glm::dvec3 at = is_ball ? random.direction() : random.vec3(1.0);
        return glm::vec3(is_coarse ? glm::round(4.0 * at) / 4.0 : at);
    };
    for (int i = 0; i < triangles; ++i) {
        const glm::vec3 corner = place();
        for (const glm::vec3& offset : {glm::vec3(0), glm::vec3(random.vec3(0.2)), glm::vec3(random.vec3(0.2))}) {
            mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
            mesh.positions.push_back(corner + offset);
        }
    }
    for (int i = 0; i < 5; ++i) mesh.positions.push_back(place());
    mesh.normals.resize(mesh.positions.size(), {0, 1, 0});
    return mesh;
}

SceneObject placed(const std::string& name, Mesh mesh, Random& random) {
    SceneObject object = testing::object(name, std::move(mesh), random.vec3(3.0));
    object.world_from_model =
        world_from_model(object.description.position, random.angles(), glm::dvec3(0.2) + glm::abs(random.vec3(2.0)));
    return object;
}

Scene random_boxes(Random& random) {
    std::vector<SceneObject> objects;
    for (const int triangles : {1, 40, 700})
        objects.push_back(placed("mesh of " + std::to_string(triangles), random_mesh(random, triangles), random));
    return scene_of(std::move(objects));
}

glm::dvec4 cutting_plane(Random& random) {
    return {random.direction(), random.number(-4.0, 4.0)};
}

template <typename IsSo>
bool any_linear(const SceneObject& object, IsSo is_so) {
    for (const glm::vec3& vertex : object.mesh->positions)
        if (is_so(object.world_from_model * glm::dvec4(vertex, 1.0))) return true;
    return false;
}

template <typename IsSo>
std::string names_linear(const Scene& scene, IsSo is_so) {
    std::vector<std::string> names;
    for (const SceneObject& object : scene.objects)
        if (is_so(object)) names.push_back(object.description.name);
    std::string said;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const bool is_last = i > 0 && i + 1 == names.size();
        said += (is_last && i == 1 ? " and " : is_last ? ", and " : i > 0 ? ", " : "") + names[i];
    }
    return said;
}

TEST(BoxTree, HoldsEveryItemOnceInAnEnclosingBox) {
    Random random(seed);
    for (const int triangles : {0, 1, 15, 16, 17, 5000}) {
        const Mesh mesh = random_mesh(random, triangles);
        std::vector<int> met(mesh.triangle_count(), 0);
        Bounds box;
        BoxTree::of_triangles(mesh).each(
            [&](const Bounds& next) {
                box = next;
                return true;
            },
            [&](std::uint32_t triangle) {
                ++met[triangle];
                for (std::size_t corner = 0; corner < 3; ++corner) {
                    const glm::dvec3 at(mesh.positions[mesh.indices[3 * std::size_t{triangle} + corner]]);
                    EXPECT_EQ(glm::clamp(at, box.min, box.max), at);
                }
            });
        EXPECT_EQ(std::count(met.begin(), met.end(), 1), triangles);
    }
}

TEST(BoxTree, VisitsFewBoxesOfALargeMesh) {
    const Mesh ball = sphere_mesh(300, 150);
    const BoxTree tree = BoxTree::of_vertices(ball);
    int asked = 0;
    const auto is_high = [&](std::uint32_t vertex) {
        ++asked;
        return ball.positions[vertex].y > 1.001F;
    };
    EXPECT_FALSE(tree.any([](const Bounds& box) { return box.max.y > 0.9999; }, is_high));
    EXPECT_GT(asked, 0);
    EXPECT_LT(asked, static_cast<int>(ball.positions.size() / 20));
}

TEST(BoxTree, LivesAsLongAsItsMesh) {
    auto mesh = std::make_shared<const Mesh>(box_mesh());
    const std::weak_ptr<const BoxTree> tree = vertex_tree(mesh);
    EXPECT_EQ(tree.lock(), vertex_tree(mesh));
    EXPECT_NE(vertex_tree(std::make_shared<const Mesh>(box_mesh())), tree.lock());
    mesh.reset();
    vertex_tree(std::make_shared<const Mesh>(box_mesh()));
    EXPECT_TRUE(tree.expired());
}

TEST(BoxForm, BoundsTheValuesAtVertices) {
    Random random(seed + 1);
    for (int i = 0; i < 200; ++i) {
        const SceneObject object = placed("mesh", random_mesh(random, 20), random);
        const glm::dvec4 form = cutting_plane(random) * std::pow(10.0, random.number(-6.0, 6.0));
        const BoxForm in_box(form, object.world_from_model);
        const Bounds box = bounds_of(*object.mesh);
        const double width = in_box.greatest(box) - in_box.least(box);
        for (const glm::vec3& vertex : object.mesh->positions) {
            const double value = glm::dot(form, object.world_from_model * glm::dvec4(vertex, 1.0));
            ASSERT_LE(in_box.least(box), value);
            ASSERT_GE(in_box.greatest(box), value);
        }
        for (const glm::vec3& vertex : object.mesh->positions) {  // for a single point, the bound is the value itself
            const Bounds point{vertex, vertex};
            ASSERT_NEAR(in_box.least(point), in_box.greatest(point), 1e-9 * width);
        }
    }
}

TEST(ObjectReach, MatchesATestOfEveryVertex) {
    Random random(seed + 2);
    int some = 0, across = 0;
    for (int i = 0; i < 300; ++i) {
        const Scene scene = random_boxes(random);
        glm::dvec4 plane = cutting_plane(random);
        double limit = random.number(0, 1) < 0.5 ? 0.0 : -standing;
        if (i % 3 == 0) {  // exactly through a vertex
            const SceneObject& object = scene.objects[static_cast<std::size_t>(i) % scene.objects.size()];
            const std::vector<glm::vec3>& positions = object.mesh->positions;
            const auto vertex =
                static_cast<std::size_t>(random.number(0, static_cast<double>(positions.size()) - 0.01));
            limit = glm::dot(plane, object.world_from_model * glm::dvec4(positions[vertex], 1.0));
        }
        const auto is_below = [&](const glm::dvec4& point) { return glm::dot(plane, point) <= limit; };
        const auto is_above = [&](const glm::dvec4& point) { return glm::dot(plane, point) > limit; };
        const std::string below =
            names_linear(scene, [&](const SceneObject& object) { return any_linear(object, is_below); });
        const std::string both = names_linear(scene, [&](const SceneObject& object) {
            return any_linear(object, is_below) && any_linear(object, is_above);
        });
        ASSERT_EQ(say(objects_at_most(scene, plane, limit)), below) << i;
        ASSERT_EQ(say(objects_across(scene, plane, limit)), both) << i;
        some += below.empty() ? 0 : 1;
        across += both.empty() ? 0 : 1;
    }
    EXPECT_GT(some, 100);
    EXPECT_LT(some, 300);
    EXPECT_GT(across, 50);
}

/// A row of triangles, and a square inside only one of them, away from its corners.
TEST(ObjectReach, TriesEveryTriangle) {
    for (std::uint32_t count = 1; count <= 40; ++count) {
        Mesh mesh;
        for (std::uint32_t i = 0; i < count; ++i) {
            const float left = 3.0F * static_cast<float>(i);
            mesh.positions.insert(mesh.positions.end(), {{left, 0, 0}, {left + 2, 0, 0}, {left, 2, 0}});
            mesh.indices.insert(mesh.indices.end(), {3 * i, 3 * i + 1, 3 * i + 2});
        }
        const SceneObject row{.description = {}, .mesh = std::make_shared<const Mesh>(mesh)};
        for (std::uint32_t i = 0; i < count; ++i) {
            const auto reaches = [&](double x) {  // the square's middle is at (x, 0.5)
                const glm::dvec4 forms[] = {{1, 0, 0, 0.1 - x}, {-1, 0, 0, x + 0.1}, {0, 1, 0, -0.4}, {0, -1, 0, 0.6}};
                return may_reach(row, forms);
            };
            EXPECT_TRUE(reaches(3.0 * i + 0.5)) << i << " of " << count;
            EXPECT_FALSE(reaches(3.0 * i + 2.5)) << i << " of " << count;
        }
    }
}

TEST(ObjectReach, EnclosesTheImageOfEveryVertex) {
    Random random(seed + 3);
    int beyond = 0, inside = 0;
    for (int i = 0; i < 400; ++i) {
        const Scene scene = random_boxes(random);
        const glm::dvec4 plane = cutting_plane(random);
        const PlanePatch patch = plane_patch(plane, random.number(0.5, 30.0));
        const glm::dvec4 light(6.0 * random.direction(), i % 4 == 0 ? 0.0 : 1.0);
        const double side = glm::dot(plane, light) < 0.0 ? -1.0 : 1.0;
        const glm::dmat4 sends = shadow_sign(plane, light) * shadow_matrix(plane, light);
        const auto lands = [&](const SceneObject& object, bool is_inside) {
            const double reach = patch.extent * (1.0 + 1e-9);
            return any_linear(object, [&](const glm::dvec4& point) {
                const glm::dvec4 sent = sends * point;
                if (!(sent.w > 0.0) || side * glm::dot(plane, point) < -standing) return false;
                const glm::dvec3 offset = glm::dvec3(sent) / sent.w - patch.center;
                const bool hits =
                    std::abs(glm::dot(offset, patch.u)) <= reach && std::abs(glm::dot(offset, patch.v)) <= reach;
                return hits == is_inside;
            });
        };
        const auto is_stretched = [&](const SceneObject& object) {  // the shadow reaches from the patch to infinity
            return lands(object, true) && any_linear(object, [&](const glm::dvec4& point) {
                       return (sends * point).w <= 0.0 && side * glm::dot(plane, point) >= -standing;
                   });
        };
        const bool is_beyond =
            std::ranges::any_of(scene.objects, [&](const SceneObject& object) { return lands(object, false); });
        const bool is_inside =
            std::ranges::any_of(scene.objects, [&](const SceneObject& object) { return lands(object, true); });
        glm::dmat4 sees_everything(1.0);
        sees_everything[3][3] = 1e12;
        const Landing landing{sends, sees_everything, side * plane, patch};
        if (is_beyond || std::ranges::none_of(scene.objects, is_stretched)) {
            ASSERT_EQ(lands_beyond(scene, landing), is_beyond) << i;
        }
        ASSERT_EQ(lands_inside(scene, landing), is_inside) << i;
        beyond += is_beyond ? 1 : 0;
        inside += is_inside ? 1 : 0;
    }
    for (const int count : {beyond, inside}) {
        EXPECT_GT(count, 40);
        EXPECT_LT(count, 390);
    }
}

/// Clips a polygon to the positive side of a plane in view space. Source: Sutherland and Hodgman 1974.
std::vector<glm::dvec3> cut(const std::vector<glm::dvec3>& polygon, const glm::dvec4& side) {
    std::vector<glm::dvec3> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3 &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
        const double a = glm::dot(side, glm::dvec4(from, 1.0)), b = glm::dot(side, glm::dvec4(to, 1.0));
        if (a >= 0.0) kept.push_back(from);
        if ((a < 0.0) != (b < 0.0)) kept.push_back(from + (to - from) * (a / (a - b)));
    }
    return kept;
}

TEST(SeenThings, MatchAClipOfEveryTriangle) {
    Random random(seed + 4);
    int seen_at_all = 0;
    for (int i = 0; i < 200; ++i) {
        const Scene scene = random_boxes(random);
        Params params;
        params.camera.position = random.vec3(4.0);
        params.camera.yaw = random.number(-180, 180);
        params.camera.pitch = random.number(-80, 80);
        params.projection.fovy = random.number(5, 100);
        params.projection.far = random.number(3, 20);
        const Derived derived = derive(params, scene, {});
        const double y = std::tan(glm::radians(0.5 * params.projection.fovy)), x = y * derived.aspect;
        const glm::dvec4 sides[] = {{1, 0, -x, 0},  {-1, 0, -x, 0}, {0, 1, -y, 0},
                                    {0, -1, -y, 0}, {0, 0, -1, 0},  {0, 0, 1, params.projection.far}};
        const std::vector<SeenThing> seen = seen_things(params, derived, scene);
        for (const SceneObject& object : scene.objects) {
            const Mesh& mesh = *object.mesh;
            double nearest = std::numeric_limits<double>::infinity(), farthest = -nearest;
            for (std::size_t at = 0; at < mesh.indices.size(); at += 3) {
                std::vector<glm::dvec3> polygon;
                for (std::size_t k = 0; k < 3; ++k)
                    polygon.emplace_back(derived.view_from_world * object.world_from_model *
                                         glm::dvec4(mesh.positions[mesh.indices[at + k]], 1.0));
                for (const glm::dvec4& side : sides) polygon = cut(polygon, side);
                for (const glm::dvec3& corner : polygon) {
                    nearest = std::min(nearest, -corner.z);
                    farthest = std::max(farthest, -corner.z);
                }
            }
            const auto thing = std::find_if(seen.begin(), seen.end(),
                                            [&](const SeenThing& one) { return one.name == object.description.name; });
            ASSERT_EQ(thing != seen.end(), nearest <= farthest) << i << " " << object.description.name;
            if (thing == seen.end()) continue;
            ++seen_at_all;
            EXPECT_NEAR(thing->nearest, std::max(nearest, 0.0), 1e-9);
            EXPECT_NEAR(thing->farthest, farthest, 1e-9);
        }
    }
    EXPECT_GT(seen_at_all, 100);
}

}  // namespace
}  // namespace viewing
