// Checks the fragments that are found for a pixel without GL: their depths against values computed by hand, the depth
// test against a distance-based simulation, and the triangles against those that a ray hits in world space. Also tests
// culling, ties, and edges shared by two triangles.
#include "topics/depth/numbers/fragments.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <numeric>

#include "frame_test.h"
#include "geometry/ray.h"
#include "unit/geometry/random.h"

namespace viewing {
namespace {

using testing::object;
using testing::params_with;
using testing::scene_of;

constexpr glm::ivec2 fragment_px(64, 48), center_px(32, 24);

/// Returns settings with which the camera looks along −z from the origin and sees no patch, shadow or mirror image.
std::vector<std::string> at_origin(std::vector<std::string> more = {}) {
    std::vector<std::string> settings{"camera.position=[0,0,0]",       "camera.yaw=0",       "camera.pitch=0",
                                      "shadow.enabled=false",          "plane.extent=0.001", "reflection.enabled=false",
                                      "plane.equation=[0,1,0,1000000]"};
    settings.insert(settings.end(), more.begin(), more.end());
    return settings;
}

/// Makes a front-facing or back-facing square at the given distance.
SceneObject facing_quad(const std::string& name, double distance, bool back = false) {
    SceneObject quad = object(name, quad_mesh(), {0, 0, 0});
    quad.world_from_model = world_from_model({0, 0, -distance}, {0, back ? -90.0 : 90.0, 0}, glm::dvec3(30.0));
    return quad;
}

std::vector<Fragment> fragments_of(const Params& params, const Scene& scene, glm::ivec2 pixel = center_px,
                                   glm::ivec2 size = fragment_px) {
    return FragmentFinder(scene).at(plan(params, derive(params, scene, {size, true})), pixel, size);
}

std::vector<Fragment> fragments_of(const std::vector<std::string>& settings, const Scene& scene) {
    return fragments_of(params_with(at_origin(settings)), scene);
}

TEST(Fragments, HaveTheDepthsOfTheFormulas) {
    // near 1, far 100, z = 10 is a row of the table in unit/geometry/projection_test.cpp.
    const Scene scene = scene_of({facing_quad("far", 60), facing_quad("near", 10)});
    const auto code = [&](const char* format, const char* mapping) {
        const std::vector<Fragment> found =
            fragments_of({"projection.near=1", "projection.far=100", std::string("depth.format=") + format,
                          std::string("depth.mapping=") + mapping},
                         scene);
        EXPECT_EQ(found.size(), 2U);
        EXPECT_EQ(found[0].object, "far");
        EXPECT_NEAR(found[1].eye_z, -10.0, 1e-12);
        return found[1].stored;
    };
    const double standard = 100.0 / 99.0 - 100.0 / 990.0, reversed = 90.0 / 990.0, logarithmic = 0.5;
    EXPECT_EQ(code("d4", "standard"), std::lround(standard * 15));
    EXPECT_EQ(code("d16", "standard"), std::lround(standard * 65535));
    EXPECT_EQ(code("d24", "standard"), std::lround(standard * 16777215));
    EXPECT_EQ(code("d32f", "standard"), std::bit_cast<std::uint32_t>(static_cast<float>(standard)));
    EXPECT_EQ(code("d24", "reversed"), std::lround(reversed * 16777215));
    EXPECT_EQ(code("d32f", "reversed"), std::bit_cast<std::uint32_t>(static_cast<float>(reversed)));
    EXPECT_EQ(code("d16", "logarithmic"), std::lround(logarithmic * 65535));
    const std::vector<Fragment> found =
        fragments_of({"projection.near=1", "projection.far=100", "depth.format=d16"}, scene);
    EXPECT_NEAR(found[1].step, 1.511e-3, 1e-6);
}

TEST(Fragments, ComeInDrawOrder) {
    // The patch comes first, then the objects in the scene's order. Here the nearest object is last, so each one passes
    // and the next one draws over it.
    const Params params = params_with({"camera.position=[0,5,0]", "camera.pitch=-90", "camera.yaw=0"});
    SceneObject low = object("low", quad_mesh(), {0, 1, 0}), high = object("high", quad_mesh(), {0, 2, 0});
    std::vector<Fragment> found = fragments_of(params, scene_of({low, high}));
    ASSERT_EQ(found.size(), 3U);
    EXPECT_EQ(found[0].object + " " + found[1].object + " " + found[2].object, "plane low high");
    for (const Fragment& fragment : found) EXPECT_TRUE(fragment.passes && fragment.drawn && fragment.front_facing);
    found = fragments_of(params, scene_of({high, low}));
    EXPECT_TRUE(found[1].drawn);
    EXPECT_FALSE(found[2].passes || found[2].drawn);
    EXPECT_FALSE(found[2].tie);
}

/// Returns whether the comparison lets a new fragment pass. `nearer` is positive if the fragment is nearer than the
/// stored depth, 0 if it is equally far, and negative if it is farther.
bool lets_through(const std::string& func, int nearer) {
    static const std::map<std::string, std::string> passing{{"never", ""},    {"less", "+"},    {"equal", "0"},
                                                            {"lequal", "+0"}, {"greater", "-"}, {"notequal", "+-"},
                                                            {"gequal", "-0"}, {"always", "+0-"}};
    return passing.at(func).find(nearer > 0 ? '+' : nearer < 0 ? '-' : '0') != std::string::npos;
}

TEST(Fragments, PassLikeADistanceBasedSimulation) {
    Random random(seed);
    int passed = 0, ties = 0;
    for (const char* const func : {"never", "less", "equal", "lequal", "greater", "notequal", "gequal", "always"})
        for (const char* const mapping : {"standard", "reversed", "logarithmic"})
            for (int trial = 0; trial < 24; ++trial) {
                const bool test = trial % 6 != 5, write = trial % 4 != 3, clear = trial % 3 != 2;
                std::vector<SceneObject> quads;
                std::vector<double> distances;
                for (int i = 0; i < 7; ++i) {
                    distances.push_back(std::floor(random.number(2, 8)));  // some equal, all others far apart in codes
                    quads.push_back(facing_quad("quad", distances.back()));
                }
                const std::vector<Fragment> found =
                    fragments_of({std::string("depth.func=") + func, std::string("depth.mapping=") + mapping,
                                  std::string("depth.test=") + (test ? "true" : "false"),
                                  std::string("depth.write=") + (write ? "true" : "false"),
                                  std::string("depth.clear=") + (clear ? "true" : "false")},
                                 scene_of(quads));
                ASSERT_EQ(found.size(), distances.size());
                double kept = 1e9;  // the cleared depth is beyond all of them
                for (int frame = clear ? 1 : 0; frame < 2; ++frame)
                    for (std::size_t i = 0; i < distances.size(); ++i) {
                        const int nearer = kept > distances[i] ? 1 : kept < distances[i] ? -1 : 0;
                        const bool passes = !test || lets_through(func, nearer);
                        if (frame == 1) {
                            EXPECT_EQ(found[i].passes, passes) << func << " " << mapping << " " << trial << " " << i;
                            EXPECT_EQ(found[i].drawn, passes);
                            EXPECT_EQ(found[i].tie, test && nearer == 0);
                            passed += passes;
                            ties += found[i].tie;
                        }
                        if (passes && test && write) kept = distances[i];
                    }
            }
    EXPECT_GT(passed, 1000);
    EXPECT_GT(ties, 150);
}

TEST(Fragments, AreCulledByFacing) {
    const Scene scene = scene_of({facing_quad("back", 5, true), facing_quad("front", 6)});
    const auto culled = [&](const std::string& face, const std::string& front_face) {
        const std::vector<Fragment> found =
            fragments_of({"cull.enabled=true", "cull.face=" + face, "cull.front_face=" + front_face}, scene);
        EXPECT_EQ(found[0].front_facing, front_face == "cw");
        EXPECT_EQ(found[1].front_facing, front_face == "ccw");
        for (const Fragment& fragment : found) EXPECT_FALSE(fragment.culled && (fragment.passes || fragment.tie));
        return std::pair(found[0].culled, found[1].culled);
    };
    EXPECT_EQ(culled("back", "ccw"), std::pair(true, false));
    EXPECT_EQ(culled("front", "ccw"), std::pair(false, true));
    EXPECT_EQ(culled("back", "cw"), std::pair(false, true));
    EXPECT_EQ(culled("front_and_back", "ccw"), std::pair(true, true));
    // A culled fragment takes no depth test and writes no depth, so the farther fragment behind it passes.
    EXPECT_FALSE(
        fragments_of({"cull.enabled=true"}, scene_of({facing_quad("a", 5), facing_quad("b", 5, true)}))[1].tie);
    EXPECT_TRUE(fragments_of({"cull.enabled=true"}, scene)[1].drawn);
    EXPECT_FALSE(fragments_of(std::vector<std::string>{}, scene)[1].drawn);
}

TEST(Fragments, OfDecalsAreOffset) {
    SceneObject decal = facing_quad("decal", 5);
    decal.description.decal = true;
    const Scene scene = scene_of({facing_quad("wall", 5), decal});
    const auto difference = [&](const std::vector<std::string>& settings) {
        const std::vector<Fragment> found = fragments_of(settings, scene);
        EXPECT_EQ(found[1].tie, found[0].stored == found[1].stored);
        EXPECT_EQ(found[1].drawn, found[1].window_depth != found[0].window_depth);
        return static_cast<std::int64_t>(found[1].stored) - found[0].stored;
    };
    EXPECT_EQ(difference({}), 0);
    EXPECT_EQ(difference({"depth.offset.units=-3"}), -3);
    EXPECT_EQ(difference({"depth.offset.units=-3", "depth.mapping=reversed"}), 3);  // nearer is greater when reversed
    EXPECT_EQ(difference({"depth.offset.units=-3", "depth.format=d32f"}), -3);
    EXPECT_EQ(difference({"depth.offset.units=-3", "depth.format=d16", "depth.mapping=logarithmic"}), -3);
    EXPECT_EQ(difference({"depth.offset.factor=-3"}), 0);  // front-parallel: no slope
}

TEST(Fragments, OfDecalsAreOffsetByTheirSlope) {
    // This is the plane y = −1 seen from the origin at fovy 90. A row at slope Y below the horizon is at z = 1 / Y, so
    // its window depth f/(f−n) − f n Y/(f−n) changes by f n/(f−n) times 2/height from row to row.
    SceneObject decal = object("decal", quad_mesh(), {0, -1, 0}, {50, 1, 50});
    decal.description.decal = true;
    const Scene scene = scene_of({decal});
    const auto depth = [&](const std::string& factor) {
        const Params params = params_with(at_origin(
            {"projection.fovy=90", "projection.near=0.5", "projection.far=40", "depth.offset.factor=" + factor}));
        return fragments_of(params, scene, {32, 36})[0].window_depth;
    };
    const double per_row = 40.0 * 0.5 / 39.5 * 2.0 / 48.0;
    EXPECT_NEAR(depth("-0.25") - depth("0"), -0.25 * per_row, 1e-12);
    EXPECT_NEAR(depth("0.1") - depth("0"), 0.1 * per_row, 1e-12);
}

TEST(Fragments, OfAClosedSurfaceComeInPairs) {
    // By symmetry, edges run through pixel centers here; a ray hits exactly one of the two triangles that share an
    // edge.
    const Params params = params_with(at_origin());
    const std::vector<Mesh> meshes{box_mesh(), sphere_mesh(16, 8), torus_mesh(16, 8), cylinder_mesh(12), cone_mesh(12)};
    for (std::size_t i = 0; i < meshes.size(); ++i)
        for (const double turned : {0.0, 90.0}) {
            SceneObject solid = object("solid", meshes[i], {0, 0, 0});
            constexpr glm::ivec2 odd(33, 33);
            solid.world_from_model = world_from_model({0, 0, -5}, {0, turned, 0}, glm::dvec3(1.0));
            const Scene scene = scene_of({solid});
            const FramePlan frame = plan(params, derive(params, scene, {odd, true}));
            const FragmentFinder finder(scene);
            int covered = 0;
            for (int y = 0; y < odd.y; ++y)
                for (int x = 0; x < odd.x; ++x) {
                    const std::vector<Fragment> found = finder.at(frame, {x, y}, odd);
                    const auto fronts = std::ranges::count_if(found, &Fragment::front_facing);
                    EXPECT_EQ(2 * fronts, static_cast<std::ptrdiff_t>(found.size())) << i << " " << x << " " << y;
                    covered += !found.empty();
                }
            EXPECT_GT(covered, 60) << i;
        }
}

TEST(Fragments, MatchARayInTheWorld) {
    Random random(seed);
    int met = 0;
    for (int trial = 0; trial < 800; ++trial) {
        Mesh mesh;
        for (int i = 0; i < 60; ++i) {
            mesh.positions.emplace_back(random.vec3(6.0));
            mesh.indices.push_back(static_cast<std::uint32_t>(i));
        }
        mesh.normals.resize(mesh.positions.size(), glm::vec3(0, 1, 0));
        SceneObject soup = object("soup", mesh, {0, 0, 0});
        soup.world_from_model = world_from_model(random.vec3(2.0), random.angles(), {1.0, 2.0, -0.5});
        const Scene scene = scene_of({soup});
        Params params =
            params_with(at_origin({trial % 2 == 0 ? "projection.type=orthographic" : "projection.fovy=70"}));
        params.camera.position =
            random.vec3(3.0);  // among the triangles: some are behind the eye, some cross its plane
        params.camera.yaw = random.number(-180, 180);
        params.camera.pitch = random.number(-80, 80);
        params.projection.near = random.number(0.1, 2.0);
        params.projection.far = random.number(4.0, 12.0);
        const Derived derived = derive(params, scene, {fragment_px, true});
        const glm::ivec2 pixel(random.number(0, 64), random.number(0, 48));
        const glm::dvec2 ndc((pixel.x + 0.5) / 32.0 - 1.0, 1.0 - (pixel.y + 0.5) / 24.0);
        const Ray ray = ray_through_pixel(derived.clip_from_world, ndc);
        std::vector<double> expected;
        for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
            std::array<glm::dvec3, 3> corners;
            for (std::size_t k = 0; k < 3; ++k)
                corners[k] = soup.world_from_model * glm::dvec4(mesh.positions[3 * i + k], 1.0);
            const auto hit = intersect_triangle(ray, corners);
            if (!hit) continue;
            const double eye_z = (derived.view_from_world * glm::dvec4(ray.at(hit->t), 1.0)).z;
            if (-eye_z <= params.projection.far) expected.push_back(eye_z);  // the ray starts at the near plane
        }
        const std::vector<Fragment> found = fragments_of(params, scene, pixel);
        ASSERT_EQ(found.size(), expected.size()) << "seed " << seed << " trial " << trial;
        for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i].eye_z, expected[i], 1e-9) << trial;
        met += static_cast<int>(found.size());
    }
    EXPECT_GT(met, 400);
}

TEST(Fragments, OfManyTrianglesAreFoundThroughTheBoxes) {
    // A grid of separate squares at known positions. The boxes around runs of triangles must lose none of them,
    // whatever the order of the triangles.
    Random random(seed);
    constexpr int side = 60;
    Mesh grid;
    std::vector<int> places(side * side);
    std::iota(places.begin(), places.end(), 0);
    std::ranges::shuffle(places, std::mt19937(seed));
    for (const int place : places) {
        const auto first = static_cast<std::uint32_t>(grid.positions.size());
        const glm::vec3 corner(place % side - side / 2, place / side - side / 2, 0);
        for (const glm::vec3 step : {glm::vec3(0), glm::vec3(1, 0, 0), glm::vec3(1, 1, 0), glm::vec3(0, 1, 0)})
            grid.positions.push_back(corner + step);
        for (const std::uint32_t index : {0U, 1U, 2U, 0U, 2U, 3U}) grid.indices.push_back(first + index);
    }
    grid.normals.resize(grid.positions.size(), glm::vec3(0, 0, 1));
    const Scene scene = scene_of({object("grid", grid, {0, 0, -20}), object("again", grid, {0, 0, -25})});
    const Params params = params_with(at_origin());
    constexpr glm::ivec2 odd(65, 49);  // edges pass through the middle row and column
    const FramePlan frame = plan(params, derive(params, scene, {odd, true}));
    const FragmentFinder finder(scene);
    for (int y = 0; y < odd.y; ++y)
        for (int x = 0; x < odd.x; ++x) {
            const std::vector<Fragment> found = finder.at(frame, {x, y}, odd);
            ASSERT_EQ(found.size(), 2U) << x << " " << y;
            EXPECT_NEAR(found[0].eye_z, -20.0, 1e-9);
            EXPECT_NEAR(found[1].eye_z, -25.0, 1e-9);
        }
}

TEST(Fragments, OfThePatchNeedTheMirrorMask) {
    // The mask is drawn with the depth function, and the patch is drawn over it with ALWAYS. Without the mask, there is
    // no patch.
    const Scene scene = testing::box_scene();
    const auto of_patch = [&](const std::vector<std::string>& settings) {
        std::vector<std::string> all{"camera.position=[3,4,0]", "camera.yaw=0", "camera.pitch=-90"};
        all.insert(all.end(), settings.begin(), settings.end());
        const std::vector<Fragment> found = fragments_of(params_with(all), scene);
        EXPECT_EQ(found.size(), 1U);
        EXPECT_EQ(found.at(0).object, "plane");
        return found.at(0).drawn;
    };
    for (const char* const style : {"shadow.style=blend", "shadow.style=missing_light"}) {
        EXPECT_TRUE(of_patch({style, "reflection.enabled=true"}));
        EXPECT_FALSE(of_patch({style, "reflection.enabled=true", "depth.func=greater"}));
        EXPECT_FALSE(of_patch({style, "reflection.enabled=true", "reflection.stencil=false", "depth.func=never"}));
        EXPECT_FALSE(of_patch({style, "reflection.enabled=false", "depth.func=never"}));
    }
}

TEST(Fragments, AreEmptyWithoutASurface) {
    EXPECT_TRUE(fragments_of(std::vector<std::string>{}, scene_of({})).empty());
    EXPECT_TRUE(fragments_of(std::vector<std::string>{}, scene_of({object("empty", Mesh{}, {0, 0, -3})})).empty());
    EXPECT_TRUE(fragments_of(std::vector<std::string>{}, scene_of({facing_quad("behind", -3)})).empty());
    EXPECT_TRUE(fragments_of({"projection.near=4"}, scene_of({facing_quad("too near", 3)})).empty());
    EXPECT_TRUE(fragments_of({"projection.far=2"}, scene_of({facing_quad("too far", 3)})).empty());
    // The plane y = 0 is edge-on when it is seen from y = 0.
    EXPECT_TRUE(fragments_of(std::vector<std::string>{}, scene_of({object("edge", quad_mesh(), {0, 0, -3})})).empty());
}

TEST(Fragments, AreAllDrawnWithoutTheDepthTest) {
    const Scene scene = scene_of({facing_quad("near", 3), facing_quad("far", 6)});
    for (const char* const setting : {"depth.test=false", "visibility.method=none", "visibility.method=painter"})
        for (const Fragment& fragment : fragments_of({setting}, scene)) EXPECT_TRUE(fragment.drawn && !fragment.tie);
}

}  // namespace
}  // namespace viewing
