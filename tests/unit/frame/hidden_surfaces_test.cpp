// The methods as the frame uses them: the meaning of an order and a counter, caching between requests, and nearly empty
// input. The tests in unit/methods check that the methods are correct. See also hidden_steps_test.cpp.
#include <algorithm>
#include <glm/gtc/matrix_inverse.hpp>
#include <numeric>
#include <set>

#include "geometry/shapes.h"
#include "topics/hidden/methods/difference.h"
#include "topics/hidden/numbers/hidden_views.h"
#include "unit/frame/hidden_scenes.h"

namespace viewing {
namespace {

using testing::hidden_px;
using testing::object;
using testing::params_with;
using testing::random_scene;
using testing::random_view;
using testing::request_of;
using testing::scene_of;
using testing::with_method;

constexpr std::array software_methods{VisibilityMethod::painter, VisibilityMethod::newell, VisibilityMethod::bsp,
                                      VisibilityMethod::software_depth_buffer, VisibilityMethod::ray_cast};

/// Expects two results to be equal except for their times.
void expect_same(const HiddenResult& a, const HiddenResult& b) {
    EXPECT_EQ(a.order, b.order);
    EXPECT_EQ(a.drawn, b.drawn);
    EXPECT_EQ(a.step, b.step);
    EXPECT_EQ(a.step_count, b.step_count);
    EXPECT_EQ(a.built_nodes, b.built_nodes);
    EXPECT_EQ(a.visited_nodes, b.visited_nodes);
    EXPECT_EQ(a.fragments->size(), b.fragments->size());
    EXPECT_EQ(a.image.ids, b.image.ids);
    EXPECT_EQ(a.image.depths, b.image.depths);
    EXPECT_EQ(a.written_per_pixel, b.written_per_pixel);
    EXPECT_EQ(a.problem, b.problem);
    EXPECT_EQ(a.compare.has_value(), b.compare.has_value());
    ASSERT_EQ(a.traced.has_value(), b.traced.has_value());
    if (a.traced) {
        EXPECT_EQ(a.traced->pixel, b.traced->pixel);
        EXPECT_EQ(a.traced->hits.size(), b.traced->hits.size());
    }
    const auto counters = [](const HiddenCounters& c) {
        return std::array{c.polygons,       c.culled,         c.comparisons, c.swaps,
                          c.splits,         c.fragments,      c.tree_depth,  c.pixels_tested,
                          c.pixels_written, c.pixels_covered, c.rays,        c.intersection_tests};
    };
    EXPECT_EQ(counters(a.counters), counters(b.counters));
}

/// Expects the order to have every index exactly once.
void expect_permutation(std::vector<int> order, std::size_t count) {
    std::sort(order.begin(), order.end());
    std::vector<int> all(count);
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(order, all);
}

double area_of_order(const HiddenResult& result) {
    double sum = 0.0;
    for (const int index : result.order) sum += area((*result.fragments)[static_cast<std::size_t>(index)]);
    return sum;
}

TEST(HiddenOrders, DrawEveryPolygonOrFragmentOnce) {
    for (unsigned run = 0; run < 40; ++run) {
        SCOPED_TRACE("seed " + std::to_string(seed + run));
        Random random(seed + run);
        const Scene scene = random_scene(random);
        HiddenSurfaceSolver solver(scene);
        const std::size_t polygons = solver.surface()->polygons.size();
        const double whole = total_area(solver.surface()->polygons);
        const HiddenRequest request = request_of(random_view(random), scene, hidden_px);
        for (const VisibilityMethod method : {VisibilityMethod::depth_buffer, VisibilityMethod::none,
                                              VisibilityMethod::painter, VisibilityMethod::software_depth_buffer}) {
            const auto result = solver.solve(with_method(request, method));
            expect_permutation(result->order, polygons);
            EXPECT_EQ(result->counters.polygons, static_cast<std::int64_t>(polygons));
            EXPECT_EQ(result->drawn, static_cast<int>(polygons));
        }
        const auto newell = solver.solve(with_method(request, VisibilityMethod::newell));
        EXPECT_EQ(std::set<int>(newell->order.begin(), newell->order.end()).size(), newell->order.size());
        EXPECT_NEAR(area_of_order(*newell) + newell->newell->clipped_area, whole, 1e-9 * whole);
        EXPECT_EQ(newell->counters.fragments, static_cast<std::int64_t>(newell->order.size()));

        const auto bsp = solver.solve(with_method(request, VisibilityMethod::bsp));
        expect_permutation(bsp->order, bsp->fragments->size());
        EXPECT_NEAR(area_of_order(*bsp), whole, 1e-9 * whole);
        EXPECT_EQ(bsp->counters.tree_depth, bsp->tree->counters.depth);
    }
}

TEST(HiddenOrders, MatchThePictureOfRayCasting) {
    for (unsigned run = 0; run < 40; ++run) {
        SCOPED_TRACE("seed " + std::to_string(seed + run));
        Random random(seed + run);
        const Scene scene = random_scene(random);
        HiddenSurfaceSolver solver(scene);
        const HiddenRequest request = request_of(random_view(random), scene, hidden_px);
        const auto rays = solver.solve(with_method(request, VisibilityMethod::ray_cast));
        for (const VisibilityMethod method :
             {VisibilityMethod::newell, VisibilityMethod::bsp, VisibilityMethod::software_depth_buffer}) {
            EXPECT_EQ(difference(rays->image, solver.solve(with_method(request, method))->image).different, 0);
        }
        HiddenRequest masked = with_method(request, VisibilityMethod::bsp);
        masked.visibility.walk = BspOrder::front_to_back;
        EXPECT_EQ(difference(rays->image, solver.solve(masked)->image).different, 0);
    }
}

/// Returns whether GL culls the triangle, by the sign of its area on the screen (OpenGL 3.3, section 3.6.1). The
/// triangle must be beyond the near plane.
bool is_culled_by_area(const Polygon& polygon, const HiddenRequest& request) {
    std::array<glm::dvec2, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec4 clip = request.viewpoint.clip_from_world() * glm::dvec4(polygon.vertices[i], 1.0);
        corners[i] = glm::dvec2(clip) / clip.w;
    }
    const glm::dvec2 ab = corners[1] - corners[0], ac = corners[2] - corners[0];
    const bool is_front = (ab.x * ac.y - ab.y * ac.x > 0.0) == (request.cull.front_face == FrontFace::ccw);
    switch (request.cull.face) {
        case CullFace::front:
            return is_front;
        case CullFace::back:
            return !is_front;
        default:
            return true;
    }
}

TEST(HiddenCulling, MatchesTheScreenAndTheMirror) {
    int culled = 0, kept = 0;
    for (unsigned run = 0; run < 60; ++run) {
        SCOPED_TRACE("seed " + std::to_string(seed + run));
        Random random(seed + run);
        const Scene scene = random_scene(random);
        Params params = random_view(random);
        params.camera.position *= 6.0 / glm::length(params.camera.position);  // puts everything beyond the near plane
        params.cull = {true, static_cast<CullFace>(run % 3), static_cast<FrontFace>(run / 3 % 2)};
        params.reflection.flip_winding = run % 5 != 0;
        params.planes.front().equation = glm::dvec4(random.direction(), 2.6);
        const Derived derived = derive(params, scene, Viewport{hidden_px});
        HiddenSurfaceSolver solver(scene);
        for (const HiddenRequest& asked :
             {hidden_request(params, derived, hidden_px), mirrored_request(params, derived, hidden_px)}) {
            const auto result = solver.solve(with_method(asked, VisibilityMethod::painter));
            std::set<int> left;
            for (const Polygon& polygon : *result->fragments) left.insert(polygon.source);
            bool all_before_near_plane = true;
            for (const Polygon& polygon : solver.surface()->polygons)
                for (const glm::dvec3& vertex : polygon.vertices)
                    all_before_near_plane &= asked.viewpoint.distance(vertex) > params.projection.near;
            if (!all_before_near_plane) continue;  // skips about half of the mirrored views
            for (const Polygon& polygon : solver.surface()->polygons) {
                EXPECT_EQ(!left.contains(polygon.source), is_culled_by_area(polygon, asked));
                ++(left.contains(polygon.source) ? kept : culled);
            }
            EXPECT_EQ(result->counters.culled + result->counters.polygons,
                      static_cast<std::int64_t>(solver.surface()->polygons.size()));
        }
    }
    EXPECT_GT(culled, 300);
    EXPECT_GT(kept, 300);
}

TEST(HiddenSolver, MatchesAFreshSolver) {
    Random random(seed + 3);
    const Scene scene = random_scene(random);
    const std::array views{random_view(random), random_view(random)};
    HiddenSurfaceSolver kept(scene);
    for (int asked = 0; asked < 400; ++asked) {
        SCOPED_TRACE("request " + std::to_string(asked));
        HiddenRequest request =
            request_of(views[static_cast<std::size_t>(whole_number(random, 0, 1))], scene, {24, 18});
        VisibilityParams& visibility = request.visibility;
        visibility.method = static_cast<VisibilityMethod>(whole_number(random, 0, 6));
        visibility.step = whole_number(random, 0, 2) == 0 ? -1 : whole_number(random, 0, 60);
        visibility.sort_key = static_cast<PainterKey>(whole_number(random, 0, 2));
        visibility.splitter = static_cast<BspSplitter>(whole_number(random, 0, 3));
        visibility.walk = static_cast<BspOrder>(whole_number(random, 0, 1));
        visibility.epsilon = whole_number(random, 0, 3) == 0 ? 1e-3 : 1e-9;
        visibility.exact_curves = whole_number(random, 0, 1) == 1;
        request.cull.enabled = whole_number(random, 0, 2) == 0;
        expect_same(*kept.solve(request), *HiddenSurfaceSolver(scene).solve(request));
    }
}

TEST(HiddenSolver, ReportsCancellationAndForgetsIt) {
    Random random(seed + 4);
    const Scene scene = random_scene(random);
    const HiddenRequest request = request_of(random_view(random), scene, hidden_px);
    HiddenSurfaceSolver solver(scene);
    for (const VisibilityMethod method : software_methods) {
        WorkProgress progress;
        progress.canceled = true;
        const auto canceled = solver.solve(with_method(request, method), &progress);
        EXPECT_TRUE(say(canceled->problem).ends_with(".")) << say(canceled->problem);
        expect_same(*solver.solve(with_method(request, method)),
                    *HiddenSurfaceSolver(scene).solve(with_method(request, method)));
        EXPECT_EQ(solver.solve(with_method(request, method))->problem, "");
    }
}

/// After cancellation, only the first 32,768 triangles of a large scene are drawn, and a sentence says that the picture
/// is not finished.
TEST(HiddenSolver, DrawsPartOfALargeSceneWhenCanceled) {
    Random random(seed + 5);
    Scene scene;
    scene.objects.push_back({{}, std::make_shared<const Mesh>(sphere_mesh(200, 101)), glm::dmat4(1.0)});
    const HiddenRequest request =
        with_method(request_of(random_view(random), scene, hidden_px), VisibilityMethod::painter);
    HiddenSurfaceSolver solver(scene);
    const auto whole = solver.solve(request);
    ASSERT_GT(whole->drawn, 32'768);
    WorkProgress progress;
    EXPECT_FALSE(hidden_drawing(*whole, &progress).is_cut);
    progress.canceled = true;
    const HiddenDrawing cut = hidden_drawing(*whole, &progress);
    EXPECT_TRUE(cut.is_cut);
    EXPECT_EQ(cut.triangles.size(), 3U * 32'768);
    ASSERT_EQ(cut.runs.size(), 1U);
    EXPECT_EQ(cut.runs.front().vertex_count, 3 * 32'768);

    const HiddenAnswer answer = answer_hidden_question(solver, {.camera = request}, &progress);
    EXPECT_EQ(answer.camera->drawn, whole->drawn) << "already known";
    EXPECT_EQ(answer.problem(), "The method was canceled: the picture is not finished.");
    EXPECT_EQ(answer_hidden_question(solver, {.camera = request}).problem(), "");

    const HiddenSurfaceSolver begun(scene, &progress);
    EXPECT_TRUE(begun.surface()->polygons.empty());
}

TEST(HiddenSurface, NormalsMatchThoseThatGlInterpolates) {
    for (unsigned run = 0; run < 200; ++run) {
        SCOPED_TRACE("seed " + std::to_string(seed + run));
        Random random(seed + run);
        Mesh mesh;
        for (int corner = 0; corner < 6; ++corner) {
            mesh.positions.emplace_back(random.vec3(2.0));
            mesh.normals.emplace_back(random.direction());
            mesh.indices.push_back(static_cast<std::uint32_t>(corner));
        }
        SceneObject placed = object("placed", mesh, {});
        placed.world_from_model =
            world_from_model(random.vec3(3.0), random.angles(), random.vec3(0.4) + glm::dvec3(run % 2 ? 1.0 : -1.0));
        const SceneSurface surface = surface_of(scene_of({object("other", box_mesh(), {}), placed}));
        const int source = surface.first_source[1] + whole_number(random, 0, 1);
        const auto first = static_cast<std::size_t>(3 * (source - surface.first_source[1]));
        const double a = random.number(0.1, 0.5), b = random.number(0.1, 0.4), c = 1.0 - a - b;
        const glm::dvec3 point = a * glm::dvec3(mesh.positions[first]) + b * glm::dvec3(mesh.positions[first + 1]) +
                                 c * glm::dvec3(mesh.positions[first + 2]);
        const glm::dvec3 normal = a * glm::dvec3(mesh.normals[first]) + b * glm::dvec3(mesh.normals[first + 1]) +
                                  c * glm::dvec3(mesh.normals[first + 2]);
        const glm::dvec3 expected = glm::normalize(glm::inverseTranspose(glm::dmat3(placed.world_from_model)) * normal);
        const glm::dvec3 found =
            glm::normalize(normal_at(surface, source, glm::dvec3(placed.world_from_model * glm::dvec4(point, 1.0))));
        EXPECT_NEAR(std::abs(glm::dot(found, expected)), 1.0, 1e-9);  // the shader flips it toward the eye
    }
}

TEST(HiddenDegenerate, EmptySceneHasEmptyPictures) {
    const Scene empty = scene_of({});
    HiddenSurfaceSolver solver(empty);
    for (int step = -1; step < 3; ++step)
        for (int method = 0; method <= static_cast<int>(VisibilityMethod::ray_cast); ++method) {
            const auto result = solver.solve(
                with_method(request_of(Params{}, empty, hidden_px), static_cast<VisibilityMethod>(method), step));
            EXPECT_TRUE(result->order.empty());
            EXPECT_EQ(result->problem, "");
            EXPECT_EQ(result->drawn, 0);
            EXPECT_TRUE(std::ranges::all_of(result->image.ids, [](int id) { return id == IdImage::background; }));
            EXPECT_TRUE(hidden_drawing(*result).triangles.empty());
        }
}

TEST(HiddenDegenerate, TrianglesWithoutAreaAreSkippedAndKeepTheirNumbers) {
    Mesh mesh = box_mesh();
    mesh.indices.insert(mesh.indices.begin(), {0, 0, 1, 2, 2, 2});
    const Scene scene = scene_of({object("box", mesh, {0, 1, 0})});
    HiddenSurfaceSolver solver(scene);
    EXPECT_EQ(solver.surface()->dropped, 2);
    EXPECT_EQ(solver.surface()->source_count(), 14);
    const HiddenRequest request = request_of(Params{}, scene, hidden_px);
    const auto rays = solver.solve(with_method(request, VisibilityMethod::ray_cast));
    EXPECT_TRUE(std::ranges::any_of(rays->image.ids, [](int id) { return id >= 0; }));
    for (const VisibilityMethod method : software_methods) {
        const auto result = solver.solve(with_method(request, method));
        EXPECT_EQ(result->counters.polygons, 12);
        EXPECT_TRUE(std::ranges::none_of(result->image.ids, [](int id) { return id == 0 || id == 1; }));
        hidden_drawing(*result);
    }
}

TEST(HiddenDegenerate, InsideOutObjectIsDrawnByEveryMethod) {
    const Scene scene = scene_of({object("mirrored", box_mesh(), {0, 1, 0}, {-1.0, 0.8, 1.2}),
                                  object("plain", box_mesh(), {1.2, 0.7, 0.4}, {0.7, 0.7, 0.7})});
    HiddenSurfaceSolver solver(scene);
    for (const bool culls : {false, true}) {
        HiddenRequest request = request_of(Params{}, scene, hidden_px);
        request.cull.enabled = culls;
        const auto rays = solver.solve(with_method(request, VisibilityMethod::ray_cast));
        for (const VisibilityMethod method : software_methods) {
            if (method == VisibilityMethod::painter) continue;
            EXPECT_EQ(difference(rays->image, solver.solve(with_method(request, method))->image).different, 0);
        }
    }
}

TEST(HiddenDegenerate, ManualMirrorHasNoMirroredEye) {
    const Scene scene = testing::box_scene();
    const auto asks_for_mirrored = [&](const std::vector<std::string>& settings) {
        const Params params = params_with(settings);
        return hidden_question(params, derive(params, scene, Viewport{hidden_px}), hidden_px)->mirrored.has_value();
    };
    EXPECT_TRUE(asks_for_mirrored({"visibility.method=bsp"}));
    EXPECT_FALSE(asks_for_mirrored({"visibility.method=bsp", "reflection.enabled=false"}));
    EXPECT_FALSE(asks_for_mirrored(
        {"visibility.method=bsp", "overrides.mirror_from_world=[[0,0,0,0],[0,0,0,0],[0,0,0,0],[0,0,0,0]]"}));
}

TEST(HiddenRays, HitExactCurvesUnlessCulled) {
    SceneObject ball = object("ball", sphere_mesh(8, 4), {0, 1, 0});
    ball.description.shape = ShapeKind::sphere;
    const Scene scene = scene_of({ball, object("box", box_mesh(), {1.5, 0.6, 0}, glm::dvec3(0.6))});
    HiddenSurfaceSolver solver(scene);
    const int triangles = static_cast<int>(ball.mesh->triangle_count()) + 12;
    EXPECT_EQ(solver.surface()->source_count(), triangles + 1);
    HiddenRequest request = with_method(request_of(Params{}, scene, hidden_px), VisibilityMethod::ray_cast);
    request.visibility.exact_curves = true;
    const auto exact = solver.solve(request);
    const std::vector<int> object_of = solver.surface()->object_of_source();
    EXPECT_EQ(exact->counters.polygons, 12 + 1);
    int curved = 0;
    for (const int id : exact->image.ids) {
        curved += id == triangles;
        if (id >= 0) {
            EXPECT_EQ(object_of[static_cast<std::size_t>(id)], id == triangles ? 0 : 1);
        }
    }
    EXPECT_GT(curved, 100);
    for (const bool is_exact : {false, true}) {
        request.visibility.exact_curves = is_exact;
        request.cull.enabled = is_exact;
        EXPECT_TRUE(std::ranges::none_of(solver.solve(request)->image.ids, [&](int id) { return id >= triangles; }));
    }
}

/// Makes large interpenetrating triangles, for which the number of cuts explodes.
Scene explosive_scene(int count) {
    Random random(seed);
    std::vector<Polygon> polygons;
    for (int i = 0; i < count; ++i) add(polygons, {random.vec3(1.5), random.vec3(1.5), random.vec3(1.5)});
    return scene_of({object("triangles", testing::mesh_of(polygons), {})});
}

TEST(HiddenBudgetSlowTest, EndsWithASentenceAndAWholePicture) {
    const Scene scene = explosive_scene(1000);
    HiddenSurfaceSolver solver(scene);
    const double whole = total_area(solver.surface()->polygons);
    for (const VisibilityMethod method : {VisibilityMethod::newell, VisibilityMethod::bsp}) {
        HiddenRequest request = with_method(request_of(Params{}, scene, {16, 12}), method);
        request.visibility.splitter = BspSplitter::first;
        const auto result = solver.solve(request);
        EXPECT_TRUE(say(result->problem).ends_with(".")) << say(result->problem);
        const double clipped = result->newell ? result->newell->clipped_area : 0.0;
        EXPECT_NEAR(area_of_order(*result) + clipped, whole, 1e-9 * whole) << "no area is lost";
    }
}

}  // namespace
}  // namespace viewing
