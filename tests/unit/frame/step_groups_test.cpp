// The two levels of a method's steps, the steps that touch a pixel, and the small raster. Each is compared with a
// method run step by step or with rays traced one by one.
#include "topics/hidden/numbers/step_groups.h"

#include <algorithm>
#include <set>

#include "topics/hidden/numbers/hidden_drawing.h"
#include "unit/frame/hidden_scenes.h"

namespace viewing {
namespace {

using testing::random_scene;
using testing::random_view;
using testing::request_of;

constexpr glm::ivec2 view_px(48, 36);
constexpr std::array grouped_methods{VisibilityMethod::painter, VisibilityMethod::newell, VisibilityMethod::bsp,
                                     VisibilityMethod::software_depth_buffer, VisibilityMethod::ray_cast};

class StepGroups : public ::testing::Test {
protected:
    StepGroups() {
        params.visibility.raster = glm::ivec2(11, 7);
        // Follow the pixel that is painted most often. Its position depends on the compiler, because the order in which
        // a compiler evaluates the calls for random numbers changes the scene.
        const auto drawn = at(VisibilityMethod::painter, -1);
        const auto& written = drawn->written_per_pixel;
        const auto most = static_cast<int>(std::max_element(written.begin(), written.end()) - written.begin());
        params.visibility.pixel = glm::ivec2(most % drawn->image.width, most / drawn->image.width);
    }
    std::shared_ptr<const HiddenResult> at(VisibilityMethod method, int step) {
        params.visibility.method = method;
        params.visibility.step = step;
        return solver.solve(request_of(params, scene, view_px));
    }
    /// Returns how many times the followed pixel has been written.
    unsigned written(const HiddenResult& result) const {
        const glm::ivec2 pixel = *params.visibility.pixel;
        return result.written_per_pixel[result.image.index(pixel.x, pixel.y)];
    }

    Random random{20261};
    Scene scene = random_scene(random);
    Params params = [] {
        Params made;
        made.camera.position = {0.3, 0.4, 6.0};
        made.camera.yaw = made.camera.pitch = 0.0;
        return made;
    }();
    HiddenSurfaceSolver solver{scene};
};

TEST_F(StepGroups, AddUpToAllSteps) {
    for (const VisibilityMethod method : grouped_methods) {
        SCOPED_TRACE("method " + std::to_string(static_cast<int>(method)));
        const auto result = at(method, -1);
        if (method == VisibilityMethod::painter) {
            EXPECT_FALSE(place_of_step(*result, 1)) << "each step is one polygon";
            continue;
        }
        ASSERT_FALSE(result->group_ends.empty());
        EXPECT_TRUE(std::is_sorted(result->group_ends.begin(), result->group_ends.end()));
        EXPECT_EQ(result->group_ends.back(), result->step_count);
        // Count by hand while stepping through.
        int group = 0, end = 0, within = 0;
        for (int step = 1; step <= result->step_count; ++step) {
            while (step > end) {
                end = end_of_group(*result, ++group);
                within = 0;
            }
            const std::optional<StepPlace> place = place_of_step(*result, step);
            ASSERT_TRUE(place);
            EXPECT_EQ(place->group, group) << step;
            EXPECT_EQ(place->within, ++within) << step;
            EXPECT_EQ(place->first + place->within, step);
            EXPECT_EQ(place->first + place->size, end);
        }
    }
}

TEST_F(StepGroups, CanBeSteppedForwardAndBackward) {
    for (const VisibilityMethod method : grouped_methods) {
        const auto result = at(method, -1);
        const std::set<int> ends(result->group_ends.begin(), result->group_ends.end());
        std::set<int> met;
        for (std::optional<int> step = next_group(*result, 0); step; step = next_group(*result, *step))
            EXPECT_TRUE(met.insert(*step).second);
        std::set<int> with_steps = ends;
        with_steps.erase(0);  // empty groups at the start end at 0, which is no step
        EXPECT_EQ(met, with_steps);
        met.clear();
        for (std::optional<int> step = previous_group(*result, -1); step; step = previous_group(*result, *step))
            EXPECT_TRUE(met.insert(*step).second);
        EXPECT_TRUE(met.contains(0));
        met.erase(0);
        with_steps.erase(result->step_count);
        if (method != VisibilityMethod::painter) {
            EXPECT_EQ(met, with_steps);
        }
    }
}

TEST_F(StepGroups, TouchesAreTheStepsThatTestThePixel) {
    std::vector<RasterStep> compares;
    const int count = at(VisibilityMethod::software_depth_buffer, -1)->step_count;
    for (int step = 1; step <= count; ++step)
        compares.push_back(*at(VisibilityMethod::software_depth_buffer, step == count ? -1 : step)->compare);
    const auto tests_of = [&](const RasterStep& one) {
        return std::count_if(compares.begin(), compares.end(),
                             [&](const RasterStep& other) { return other.x == one.x && other.y == one.y; });
    };
    const RasterStep most = *std::max_element(compares.begin(), compares.end(),
                                              [&](const auto& a, const auto& b) { return tests_of(a) < tests_of(b); });
    params.visibility.pixel = glm::ivec2(most.x, most.y);
    const auto all = at(VisibilityMethod::software_depth_buffer, -1);
    ASSERT_FALSE(all->touches.empty());
    std::vector<int> expected;
    for (int step = 1; step <= count; ++step) {
        const RasterStep& compare = compares[static_cast<std::size_t>(step - 1)];
        if (compare.x != most.x || compare.y != most.y) continue;
        ASSERT_LT(expected.size(), all->touches.size());
        const RasterStep& told = all->touches[expected.size()].fragment;
        EXPECT_EQ(told.polygon, compare.polygon);
        EXPECT_EQ(told.depth, compare.depth);
        EXPECT_EQ(told.stored_depth, compare.stored_depth);
        EXPECT_EQ(told.written, compare.written);
        expected.push_back(step);
    }
    std::vector<int> forwards, backwards;
    for (auto step = next_touch(*all, 0); step; step = next_touch(*all, *step)) forwards.push_back(*step);
    for (auto step = previous_touch(*all, all->step_count + 1); step; step = previous_touch(*all, *step))
        backwards.insert(backwards.begin(), *step);
    EXPECT_EQ(forwards, expected);
    if (expected.back() == all->step_count) expected.pop_back();  // the finished picture is already at this step
    EXPECT_EQ(backwards, expected);
}

TEST_F(StepGroups, OrdersTouchWhenTheyDrawOverThePixel) {
    for (const VisibilityMethod method : {VisibilityMethod::painter, VisibilityMethod::newell, VisibilityMethod::bsp}) {
        SCOPED_TRACE("method " + std::to_string(static_cast<int>(method)));
        const auto all = at(method, -1);
        std::vector<int> expected, told;
        unsigned before = written(*at(method, 0));
        for (int step = 1; step <= all->step_count; ++step) {
            const unsigned now = written(*at(method, step == all->step_count ? -1 : step));
            for (; before < now; ++before) expected.push_back(step);
        }
        for (const PixelTouch& touch : all->touches) told.push_back(touch.step);
        EXPECT_FALSE(expected.empty());
        EXPECT_EQ(told, expected);
    }
}

TEST_F(StepGroups, EachItemOfAnOrderIsDrawnByItsStepAndNotBefore) {
    for (const VisibilityMethod method : {VisibilityMethod::painter, VisibilityMethod::newell, VisibilityMethod::bsp}) {
        const auto all = at(method, -1);
        const std::vector<int>& steps = all->order_steps;
        ASSERT_EQ(steps.size(), all->order.size());
        for (std::size_t place = 0; place < steps.size(); ++place) {
            const int step = steps[place] == all->step_count ? -1 : steps[place];
            EXPECT_GT(at(method, step)->drawn, static_cast<int>(place));
            EXPECT_LE(at(method, steps[place] - 1)->drawn, static_cast<int>(place));
        }
    }
}

TEST_F(StepGroups, FollowedPixelOutsideThePictureIsNeverTouched) {
    params.visibility.pixel = glm::ivec2(11, 2);
    for (const VisibilityMethod method : grouped_methods) {
        const auto result = at(method, -1);
        EXPECT_TRUE(result->touches.empty());
        EXPECT_FALSE(result->traced);
        EXPECT_FALSE(next_touch(*result, 0));
    }
}

TEST_F(StepGroups, FollowedPixelKeepsItsRayUntilAStepHasAnother) {
    const auto all = at(VisibilityMethod::ray_cast, -1);
    ASSERT_TRUE(all->traced);
    EXPECT_EQ(all->traced->pixel, *params.visibility.pixel);
    EXPECT_EQ(at(VisibilityMethod::ray_cast, 11 * 2 + 4)->traced->pixel, glm::ivec2(3, 2));
    params.visibility.pixel.reset();
    EXPECT_FALSE(at(VisibilityMethod::ray_cast, -1)->traced);
}

/// Returns the triangle that the ray through a point of the view hits first, or −1.
int groups_seen_at(const glm::dvec2& place_px, const Params& params, const Scene& scene,
                   const std::vector<Polygon>& polygons) {
    const Derived derived = derive(params, scene, Viewport{view_px});
    const glm::dmat4 world_from_clip =
        glm::inverse(clip_from_view(params.lens(), derived.aspect) * derived.view_from_world);
    const auto unproject = [&](double z) {
        const glm::dvec2 ndc = place_px / glm::dvec2(view_px) * glm::dvec2(2.0, -2.0) + glm::dvec2(-1.0, 1.0);
        const glm::dvec4 point = world_from_clip * glm::dvec4(ndc, z, 1.0);
        return glm::dvec3(point) / point.w;
    };
    const glm::dvec3 from = unproject(-1.0), along = unproject(1.0) - from;
    double nearest = 1.0;
    int seen = -1;
    for (const Polygon& polygon : polygons) {
        const glm::dvec3 &a = polygon.vertices[0], ab = polygon.vertices[1] - a, ac = polygon.vertices[2] - a;
        const glm::dmat3 system(ab, ac, -along);
        if (std::abs(glm::determinant(system)) < 1e-12) continue;
        const glm::dvec3 uvt = glm::inverse(system) * (from - a);
        if (uvt.x < 0.0 || uvt.y < 0.0 || uvt.x + uvt.y > 1.0 || uvt.z < 0.0 || uvt.z >= nearest) continue;
        nearest = uvt.z;
        seen = polygon.source;
    }
    return seen;
}

TEST_F(StepGroups, SmallRasterSamplesTheCentersOfItsSquares) {
    params.visibility.pixel.reset();
    int seen = 0;
    for (const glm::ivec2 raster : {glm::ivec2(11, 7), glm::ivec2(5, 9), glm::ivec2(1, 1), glm::ivec2(48, 36)}) {
        params.visibility.raster = raster;
        // The raster is centered and as large as fits.
        const double side = std::min(48.0 / raster.x, 36.0 / raster.y);
        const glm::dvec2 corner = 0.5 * (glm::dvec2(view_px) - side * glm::dvec2(raster));
        for (const VisibilityMethod method : {VisibilityMethod::newell, VisibilityMethod::bsp,
                                              VisibilityMethod::software_depth_buffer, VisibilityMethod::ray_cast}) {
            const auto result = at(method, -1);
            ASSERT_EQ(glm::ivec2(result->image.width, result->image.height), raster);
            for (int y = 0; y < raster.y; ++y)
                for (int x = 0; x < raster.x; ++x) {
                    const glm::dvec2 middle = corner + side * (glm::dvec2(x, y) + 0.5);
                    const int expected = groups_seen_at(middle, params, scene, solver.surface()->polygons);
                    seen += expected >= 0 ? 1 : 0;
                    EXPECT_EQ(result->image.id(x, y), expected) << x << " " << y;
                    // Every point of a square belongs to its pixel.
                    for (const double within : {0.02, 0.98})
                        EXPECT_EQ(raster_pixel(corner + side * (glm::dvec2(x, y) + within), view_px, raster,
                                               result->request.share),
                                  glm::ivec2(x, y));
                }
        }
        if (corner.x > 0.5) {
            EXPECT_FALSE(
                raster_pixel({corner.x - 0.1, 18.0}, view_px, raster, request_of(params, scene, view_px).share));
        }
    }
    EXPECT_GT(seen, 50);
}

TEST_F(StepGroups, GlAloneKeepsTheViewsPixels) {
    params.visibility.method = VisibilityMethod::depth_buffer;
    const HiddenRequest request = request_of(params, scene, view_px);
    EXPECT_EQ(request.size_px, view_px);
    EXPECT_EQ(request.share, glm::dvec2(1.0));
}

}  // namespace
}  // namespace viewing
