// Compares the visible surfaces in GL's pictures, drawn with the depth buffer or in an order found in software, with
// ray casting on random scenes. Shading, mirror image and overdraw do not depend on the method.
#include <algorithm>
#include <iostream>

#include "gl_test.h"
#include "topics/hidden/methods/difference.h"
#include "topics/hidden/numbers/hidden_views.h"
#include "unit/frame/hidden_scenes.h"

namespace viewing {
namespace {

using testing::object;
using testing::params_with;
using testing::pixels_beyond;
using testing::random_scene;
using testing::random_view;
using testing::Rgb;
using testing::rgb_at;
using testing::scene_named;
using testing::scene_of;
using testing::worst_channel;

constexpr std::array software_methods{VisibilityMethod::painter, VisibilityMethod::newell, VisibilityMethod::bsp,
                                      VisibilityMethod::software_depth_buffer, VisibilityMethod::ray_cast};
constexpr std::array exact_methods{VisibilityMethod::newell, VisibilityMethod::bsp,
                                   VisibilityMethod::software_depth_buffer, VisibilityMethod::ray_cast};

class Hidden : public testing::GlTest {
protected:
    /// Returns the plan of the window's frame, with the complete result of the method.
    static FramePlan frame_of(const Params& params, const Scene& scene, glm::ivec2 size_px, Renderer& with) {
        const Derived derived = derive(params, scene, {size_px, with.capabilities().clip_control});
        const auto question = hidden_question(params, derived, size_px);
        if (!question) return plan(params, derived);
        HiddenSurfaceSolver solver(scene);
        return plan(params, derived, answer_hidden_question(solver, *question).pictures);
    }
    static Image picture(const Params& params, const Scene& scene, glm::ivec2 size_px, Renderer& with = renderer()) {
        View view;
        return draw(frame_of(params, scene, size_px, with), scene, size_px, with, view);
    }

    static IdImage ids_by_gl(const Params& params, const Scene& scene, const HiddenResult& result) {
        View view;
        const Derived derived = derive_for(params, scene, result.request.size_px);
        const Result<IdImage> image =
            renderer().read_polygon_ids(plan_polygon_ids(params, derived, result), scene, result.request.size_px, view);
        EXPECT_TRUE(image) << image.error();
        return *image;
    }
};

/// Returns the screen position of a point beyond the near plane, in pixels from the top left.
glm::dvec2 on_screen(const glm::dvec3& point_world, const HiddenRequest& request) {
    const glm::dvec4 clip = request.viewpoint.clip_from_world() * glm::dvec4(point_world, 1.0);
    return (glm::dvec2(clip) / clip.w * glm::dvec2(0.5, -0.5) + 0.5) * glm::dvec2(request.size_px);
}

double distance_px(const glm::dvec2& point, const glm::dvec2& from, const glm::dvec2& to) {
    const glm::dvec2 along = to - from;
    const double length_squared = glm::dot(along, along);
    const double share =
        length_squared > 0.0 ? std::clamp(glm::dot(point - from, along) / length_squared, 0.0, 1.0) : 0.0;
    return glm::length(point - from - share * along);
}

/// Returns the distance of a pixel's center from the nearest edge of the polygons in `sources`, or of all polygons if
/// `sources` is empty. Polygons are first clipped at the near plane.
double edge_distance_px(const HiddenResult& result, const std::vector<int>& sources, glm::ivec2 pixel) {
    const glm::dvec4 near_plane = result.request.viewpoint.near_plane_world();
    double nearest = std::numeric_limits<double>::infinity();
    for (const int index : result.order) {
        Polygon polygon = (*result.fragments)[static_cast<std::size_t>(index)];
        if (!sources.empty() && std::ranges::find(sources, polygon.source) == sources.end()) continue;
        const PlaneSide side = side_of_plane(polygon, near_plane, 0.0);
        if (side == PlaneSide::back) continue;
        if (side == PlaneSide::spanning) polygon = split(polygon, near_plane, 0.0).first;
        for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
            const glm::dvec3 &from = polygon.vertices[i], &to = polygon.vertices[(i + 1) % polygon.vertices.size()];
            nearest = std::min(nearest, distance_px(glm::dvec2(pixel) + 0.5, on_screen(from, result.request),
                                                    on_screen(to, result.request)));
        }
    }
    return nearest;
}

/// Counts the pixels whose ID the reference shows neither at the same pixel nor at a neighbor. GL rounds screen
/// positions to 1/256 of a pixel, so a pixel center closer than `rounding_px` to an edge may fall on either side of the
/// edge. Such pixels count as slivers; all others are unexplained.
struct Disagreement {
    static constexpr double rounding_px = 1.0 / 64.0;
    int at_slivers = 0, unexplained = 0;
};
Disagreement disagreement(const IdImage& reference, const IdImage& image, const HiddenResult& result) {
    Disagreement found;
    const IdDifference differing = difference(reference, image);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            if (differing.differs[image.index(x, y)] == 0) continue;
            const double away = edge_distance_px(result, {image.id(x, y), reference.id(x, y)}, {x, y});
            ++(away < Disagreement::rounding_px ? found.at_slivers : found.unexplained);
        }
    return found;
}

TEST_F(Hidden, GlAgreesWithRayCastingOnRandomScenes) {
    const glm::ivec2 size_px(test_width, test_height);
    const int count = random_scene_count();
    for (const VisibilityMethod method :
         {VisibilityMethod::depth_buffer, VisibilityMethod::newell, VisibilityMethod::bsp}) {
        SCOPED_TRACE("method " + std::to_string(static_cast<int>(method)));
        int slivers = 0, unexplained = 0, covered = 0;
        for (int run = 0; run < count; ++run) {
            Random random(seed + static_cast<unsigned>(run));
            const Scene scene = random_scene(random);
            const Params params = random_view(random);
            HiddenSurfaceSolver solver(scene);
            HiddenRequest request = hidden_request(params, derive_for(params, scene, size_px), size_px);
            request.visibility.method = VisibilityMethod::ray_cast;
            const IdImage reference = solver.solve(request)->image;
            request.visibility.method = method;
            const auto result = solver.solve(request);
            const Disagreement found = disagreement(reference, ids_by_gl(params, scene, *result), *result);
            slivers += found.at_slivers;
            unexplained += found.unexplained;
            covered += static_cast<int>(std::ranges::count_if(reference.ids, [](int id) { return id >= 0; }));
        }
        std::cout << slivers << " pixels at slivers and " << unexplained << " others of " << covered << "\n";
        // In 3000 scenes, a single pixel remains unexplained; its two depths are closer than 24 bits can distinguish.
        // In the first 300 scenes, none remains.
        EXPECT_LE(unexplained, count / 1000);
        EXPECT_LE(slivers, count / 8) << "28 were measured in 300 scenes";
        EXPECT_GT(covered, count * 500);
    }
}

/// Returns whether the color jumps between a pixel and a neighbor, as at an outline, a face's edge or a shadow's edge.
bool is_outline(const Image& image, glm::ivec2 pixel) {
    for (int y = std::max(pixel.y - 1, 0); y <= std::min(pixel.y + 1, image.height - 1); ++y)
        for (int x = std::max(pixel.x - 1, 0); x <= std::min(pixel.x + 1, image.width - 1); ++x)
            if (worst_channel(rgb_at(image, pixel), rgb_at(image, {x, y})) > 12) return true;
    return false;
}

struct Compared {
    int beyond = 0;    ///< pixels that differ by more than 3 levels
    int in_faces = 0;  ///< of these, pixels away from the first picture's outlines
    int outlines = 0;
};
Compared compared(const Image& reference, const Image& image) {
    Compared found;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const bool outline = is_outline(reference, {x, y});
            const bool differs = worst_channel(rgb_at(reference, {x, y}), rgb_at(image, {x, y})) > 3;
            found.outlines += outline;
            found.beyond += differs;
            found.in_faces += differs && !outline;
        }
    return found;
}

/// States in which mirror, shadow, culling and patch all matter. In some of them, the plane cuts through the objects.
const std::vector<std::vector<std::string>>& states() {
    static const std::vector<std::vector<std::string>> all{
        {},
        {"reflection.reflectance=1"},
        {"plane.equation=[0,1,0,-0.5]", "reflection.reflectance=1"},
        {"plane.equation=[0,-2,0,1]", "reflection.reflectance=0.6", "reflection.clip=oblique"},
        {"plane.equation=[0,1,0,-0.5]", "reflection.reflectance=1", "camera.position=[3,-3,6]", "camera.pitch=30"},
        {"plane.equation=[0.3,1,0.2,-0.9]", "reflection.reflectance=1"},
        {"plane.equation=[0,1,0,-0.5]", "reflection.enabled=false"},
        {"plane.equation=[0,1,0,0.3]", "cull.enabled=true", "cull.face=front", "reflection.reflectance=1"},
        {"cull.enabled=true", "cull.front_face=cw", "plane.equation=[0,1,0,0.3]"},
        {"projection.type=orthographic", "plane.equation=[0,1,0,-0.5]", "reflection.reflectance=1"},
        {"view.shows=facing", "plane.equation=[0,1,0,-0.5]", "reflection.reflectance=1"},
        {"view.shows=facing", "cull.enabled=true"}};
    return all;
}

std::string in_words(const std::vector<std::string>& settings) {
    std::string words;
    for (const std::string& setting : settings) words += setting + " ";
    return words;
}

/// The exact methods give the picture of GL's depth buffer except for single pixels on outlines, where GL rounds to
/// 1/256 of a pixel.
class HiddenPicturesTest : public Hidden {
protected:
    static void expect_those_of_the_depth_buffer(const std::string& scene_name, Renderer& with) {
        const Scene scene = scene_named(scene_name);
        for (std::vector<std::string> settings : states()) {
            settings.insert(settings.end(), {"view.samples=0", "shadow.offset=no_depth_test"});
            Params params = params_with(settings);
            const Image reference = picture(params, scene, picture_px, with);
            for (const VisibilityMethod method : exact_methods) {
                SCOPED_TRACE(scene_name + " " + in_words(settings) + std::to_string(static_cast<int>(method)));
                params.visibility.method = method;
                const Compared found = compared(reference, picture(params, scene, picture_px, with));
                // GL rounds each piece separately, so what is behind may show through at a single pixel where a vertex
                // meets an edge.
                EXPECT_LE(found.in_faces, draws_pixels(params.visibility) ? 0 : 1);
                EXPECT_LE(found.beyond, 6);
                EXPECT_LT(found.outlines, picture_px.x * picture_px.y / 3) << "otherwise nothing is tested";
            }
        }
    }

    static constexpr glm::ivec2 picture_px{320, 180};
};

TEST_F(HiddenPicturesTest, DoNotDependOnTheMethod) {
    expect_those_of_the_depth_buffer("torus-and-boxes", renderer());
}

TEST_F(HiddenPicturesTest, DoNotDependOnTheMethodWithSmoothShapes) {
    expect_those_of_the_depth_buffer("curved", renderer());
}

TEST_F(HiddenPicturesTest, DoNotDependOnTheMethodWithoutClipDistances) {
    Result<Renderer> plain = Renderer::make({});
    ASSERT_TRUE(plain) << plain.error();
    ASSERT_FALSE(plain->capabilities().clip_distance);
    expect_those_of_the_depth_buffer("torus-and-boxes", *plain);
}

TEST_F(HiddenPicturesTest, DifferOnlyInSmoothEdgesWithSamples) {
    const Scene scene = scene_named("torus-and-boxes");
    Params params = params_with({"view.samples=4"});
    const Image smooth = picture(params, scene, picture_px);
    params.view.samples = 0;
    const Image rough = picture(params, scene, picture_px);
    params.view.samples = 4;
    for (const VisibilityMethod method : exact_methods) {
        params.visibility.method = method;
        const Image image = picture(params, scene, picture_px);
        int elsewhere = 0;
        for (int y = 0; y < picture_px.y; ++y)
            for (int x = 0; x < picture_px.x; ++x) {
                const Rgb color = rgb_at(image, {x, y}), wanted = rgb_at(smooth, {x, y});
                const bool differs = worst_channel(color, wanted) > 3;
                const bool smoothed = worst_channel(wanted, rgb_at(rough, {x, y})) > 0 || is_outline(smooth, {x, y});
                elsewhere += differs && !smoothed;
            }
        EXPECT_LE(elsewhere, 1) << "software finds one sample per pixel";
        if (method == VisibilityMethod::newell || method == VisibilityMethod::bsp) {
            EXPECT_LE(compared(smooth, image).beyond, 8) << "GL draws these, so they are also smooth";
        }
    }
}

TEST_F(Hidden, ExactCurvesMatchTheirTriangles) {
    constexpr glm::ivec2 size_px(320, 180);
    const Scene scene = scene_named("curved");
    Params params = params_with({"view.samples=0", "visibility.method=ray_cast"});
    const Image triangles = picture(params, scene, size_px);
    params.visibility.exact_curves = true;
    const Compared found = compared(triangles, picture(params, scene, size_px));
    EXPECT_GT(found.beyond, 20) << "exact curves look rounder";
    EXPECT_LT(found.in_faces, size_px.x * size_px.y / 100);
}

TEST_F(Hidden, GlCountsOverdrawAsSoftwareDoes) {
    const glm::ivec2 size_px(test_width, test_height);
    const auto counted_by_gl = [&](const Params& params, const Scene& scene) {
        View view;
        draw(frame_of(params, scene, size_px, renderer()), scene, size_px, renderer(), view);
        std::vector<int> counts;
        const auto bytes = gl::read_pixels(view.target().single_framebuffer(), size_px);
        for (std::size_t at = 0; at < bytes.size(); at += 4) counts.push_back(bytes[at]);
        return counts;
    };
    for (int run = 0; run < 40; ++run) {
        SCOPED_TRACE("seed " + std::to_string(seed + static_cast<unsigned>(run)));
        Random random(seed + static_cast<unsigned>(run));
        const Scene scene = random_scene(random);
        Params params = random_view(random);
        params.view.shows = Shows::overdraw;
        const bool divided = run % 2 == 1;  // if true, the patch's plane cuts the counted polygons
        if (!divided) params.planes.front().equation = {0.0, 1.0, 0.0, 20.0};
        for (const VisibilityMethod method : software_methods) {
            params.visibility.method = method;
            HiddenSurfaceSolver solver(scene);
            const auto result = solver.solve(hidden_request(params, derive_for(params, scene, size_px), size_px));
            const std::vector<int> counts = counted_by_gl(params, scene);
            ASSERT_EQ(counts.size(), result->written_per_pixel.size());
            int different = 0, unexplained = 0;
            for (int y = 0; y < size_px.y; ++y)
                for (int x = 0; x < size_px.x; ++x) {
                    const std::size_t pixel = result->image.index(x, y);
                    if (counts[pixel] == static_cast<int>(result->written_per_pixel[pixel])) continue;
                    ++different;
                    unexplained += !(edge_distance_px(*result, {}, {x, y}) < Disagreement::rounding_px);
                }
            if (!divided && draws_pixels(params.visibility)) {
                EXPECT_EQ(different, 0);
            } else if (!divided) {
                EXPECT_EQ(unexplained, 0);
            } else {
                EXPECT_LE(unexplained, size_px.x * size_px.y / 50) << "except on the line of the cut";
            }
        }
    }
}

TEST_F(Hidden, ASmallRasterIsDrawnInSquares) {
    constexpr glm::ivec2 view_px(160, 90);
    const Scene scene = scene_named("few-triangles");
    Params params = params_with({"view.samples=0", "camera.position=[0,1.7,6]", "camera.yaw=0", "camera.pitch=0"});
    for (const auto& [raster, side] : {std::pair(glm::ivec2(16, 9), 10), std::pair(glm::ivec2(12, 9), 10),
                                       std::pair(glm::ivec2(16, 3), 10), std::pair(glm::ivec2(4, 18), 5)})
        for (const VisibilityMethod method : software_methods) {
            SCOPED_TRACE(std::to_string(raster.x) + " " + std::to_string(static_cast<int>(method)));
            params.visibility.raster = raster;
            params.visibility.method = method;
            const Image drawn = picture(params, scene, view_px);
            HiddenSurfaceSolver solver(scene);
            const IdImage ids =
                solver.solve(hidden_request(params, derive_for(params, scene, view_px), view_px))->image;
            const glm::ivec2 corner = (view_px - side * raster) / 2;
            const Color ground = frame_of(params, scene, view_px, renderer()).background;
            const Rgb background{ground.r, ground.g, ground.b};
            int covered = 0;
            for (int y = 0; y < view_px.y; ++y)
                for (int x = 0; x < view_px.x; ++x) {
                    const glm::ivec2 from_corner = glm::ivec2(x, y) - corner, pixel = from_corner / side;
                    const bool inside = glm::all(glm::greaterThanEqual(from_corner, glm::ivec2(0))) &&
                                        glm::all(glm::lessThan(pixel, raster));
                    const bool is_covered = inside && ids.id(pixel.x, pixel.y) >= 0;
                    covered += is_covered ? 1 : 0;
                    ASSERT_EQ(rgb_at(drawn, {x, y}) == background, !is_covered) << x << " " << y;
                    if (is_covered) {
                        EXPECT_EQ(rgb_at(drawn, {x, y}), rgb_at(drawn, corner + pixel * side)) << x << " " << y;
                    }
                }
            EXPECT_GT(covered, 200);
        }
}

TEST_F(Hidden, ASmallRasterAlsoComparesGlsOwnPolygons) {
    constexpr glm::ivec2 view_px(160, 90);
    const Scene scene = scene_named("few-triangles");
    Params params = params_with({"view.samples=0", "visibility.method=newell", "visibility.raster=[15,15]",
                                 "camera.position=[0,1.7,6]", "camera.yaw=0", "camera.pitch=0"});
    HiddenSurfaceSolver solver(scene);
    const Derived derived = derive_for(params, scene, view_px);
    HiddenRequest request = hidden_request(params, derived, view_px);
    const IdImage sorted = solver.solve(request)->image;
    request.visibility.method = VisibilityMethod::depth_buffer;
    const auto result = solver.solve(request);
    View view;
    const Result<IdImage> by_gl =
        renderer().read_polygon_ids(plan_polygon_ids(params, derived, *result), scene, request.size_px, view);
    ASSERT_TRUE(by_gl) << by_gl.error();
    const Disagreement found = disagreement(sorted, *by_gl, *result);
    EXPECT_EQ(found.unexplained, 0);
    EXPECT_GT(std::ranges::count_if(sorted.ids, [](int id) { return id >= 0; }), 60);
}

TEST_F(Hidden, TheDepthBuffersStepsAreAlsoReadBack) {
    constexpr glm::ivec2 size_px(64, 48);
    const Scene scene = scene_named("torus-and-boxes");
    const Params params = params_with({"view.samples=0"});
    HiddenSurfaceSolver solver(scene);
    HiddenRequest request = hidden_request(params, derive_for(params, scene, size_px), size_px);
    request.visibility.step = 0;
    const IdImage nothing = ids_by_gl(params, scene, *solver.solve(request));
    EXPECT_TRUE(std::ranges::all_of(nothing.ids, [](int id) { return id == IdImage::background; }));
    request.visibility.step = 100;
    const IdImage some = ids_by_gl(params, scene, *solver.solve(request));
    EXPECT_TRUE(std::ranges::any_of(some.ids, [](int id) { return id >= 0; }));
    EXPECT_TRUE(std::ranges::all_of(some.ids, [](int id) { return id < 100; }));
}

}  // namespace
}  // namespace viewing
