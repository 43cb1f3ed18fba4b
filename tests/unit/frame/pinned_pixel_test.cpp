// Pins by object and by fraction hit the same object at every picture size. The tests decide this by intersecting rays
// with the objects' boxes, independently of fragments.
#include "frame/pinned_pixel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "frame_test.h"
#include "geometry/ray.h"

namespace viewing {
namespace {

using testing::object;
using testing::params_with;
using testing::scene_of;

constexpr glm::ivec2 sizes[] = {{64, 48}, {426, 520}, {800, 600}, {1187, 611}, {1920, 1080}};

/// Returns a state whose camera looks from the origin along −z. Of the three boxes below, one sticks out from behind
/// another, and the third is on the right.
Params looking() {
    return params_with({"camera.position=[0,0,0]", "camera.yaw=0", "camera.pitch=0", "shadow.enabled=false",
                        "reflection.enabled=false", "plane.extent=0.001", "plane.equation=[0,1,0,1000000]"});
}
Scene boxes() {
    return scene_of({object("hidden", box_mesh(), {-0.5, 2.2, -8}), object("front", box_mesh(), {-0.9, 0, -5}),
                     object("right", box_mesh(), {1.2, 0.3, -6})});
}

/// Returns the parameter at which a ray enters a box that is only translated, or infinity if the ray misses the box.
double entry(const Ray& ray, const SceneObject& box) {
    const glm::dvec3 middle(box.world_from_model[3]);
    const Bounds bounds = bounds_of(*box.mesh);
    double from = 0.0, to = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        double a = (middle[axis] + bounds.min[axis] - ray.origin[axis]) / ray.direction[axis];
        double b = (middle[axis] + bounds.max[axis] - ray.origin[axis]) / ray.direction[axis];
        if (a > b) std::swap(a, b);
        from = std::max(from, a);
        to = std::min(to, b);
    }
    return from <= to ? from : std::numeric_limits<double>::infinity();
}

std::string seen_at(const Scene& scene, const Derived& derived, glm::ivec2 pixel, glm::ivec2 size_px) {
    const glm::dvec2 ndc((pixel.x + 0.5) / size_px.x * 2.0 - 1.0, 1.0 - (pixel.y + 0.5) / size_px.y * 2.0);
    const Ray ray = ray_through_pixel(derived.clip_from_world, ndc);
    std::string nearest;
    double least = std::numeric_limits<double>::infinity();
    for (const SceneObject& one : scene.objects)
        if (const double at = entry(ray, one); at < least) {
            least = at;
            nearest = one.description.name;
        }
    return nearest;
}

PinnedPixel resolved(const Params& params, const Scene& scene, glm::ivec2 size_px) {
    const Derived derived = derive(params, scene, {size_px});
    return pinned_pixel(params, derived, plan(params, derived), scene, size_px);
}

TEST(PinnedPixel, NothingIsPinnedByDefault) {
    const PinnedPixel none = resolved(looking(), boxes(), sizes[0]);
    EXPECT_FALSE(none.pixel);
    EXPECT_TRUE(none.why_none.empty());
}

TEST(PinnedPixel, PixelByCoordinatesIsItselfOrOutside) {
    Params params = looking();
    params.view.pixel = glm::ivec2(60, 40);
    EXPECT_EQ(resolved(params, boxes(), {64, 48}).pixel, glm::ivec2(60, 40));
    const PinnedPixel outside = resolved(params, boxes(), {60, 48});
    EXPECT_FALSE(outside.pixel);
    EXPECT_NE(say(outside.why_none).find("outside"), std::string::npos);
}

TEST(PinnedPixel, FractionOfTheViewIsTheSamePlaceAtEverySize) {
    Params params = looking();
    for (const glm::ivec2 size : sizes) {
        params.view.pin = Pin{"", glm::dvec2(0.25, 0.75)};
        EXPECT_EQ(resolved(params, boxes(), size).pixel, glm::ivec2(size.x / 4, size.y * 3 / 4));
        params.view.pin = Pin{"", glm::dvec2(1.0)};
        EXPECT_EQ(resolved(params, boxes(), size).pixel, size - 1) << "the edge belongs to the last pixel";
    }
}

TEST(PinnedPixel, ObjectIsPinnedWhereItIsVisible) {
    Params params = looking();
    const Scene scene = boxes();
    for (const glm::ivec2 size : sizes)
        for (const char* name : {"front", "right", "hidden"}) {
            params.view.pin = Pin{name, {}};
            const PinnedPixel pinned = resolved(params, scene, size);
            ASSERT_TRUE(pinned.pixel) << name << " " << size.x << ": " << say(pinned.why_none);
            EXPECT_EQ(seen_at(scene, derive(params, scene, {size}), *pinned.pixel, size), name) << size.x;
        }
}

TEST(PinnedPixel, FractionOfAnObjectsBoxIsInsideIt) {
    Params params = looking();
    const Scene scene = boxes();
    for (const glm::ivec2 size : sizes) {
        const Derived derived = derive(params, scene, {size});
        glm::dvec2 least(1e9), most(-1e9);
        for (const glm::vec3& position : scene.objects[2].mesh->positions) {
            const glm::dvec4 clip =
                derived.clip_from_world * scene.objects[2].world_from_model * glm::dvec4(position, 1);
            const glm::dvec2 place =
                glm::dvec2(0.5 + 0.5 * clip.x / clip.w, 0.5 - 0.5 * clip.y / clip.w) * glm::dvec2(size);
            least = glm::min(least, place);
            most = glm::max(most, place);
        }
        params.view.pin = Pin{"right", glm::dvec2(0.2, 0.9)};
        const glm::dvec2 wanted = least + glm::dvec2(0.2, 0.9) * (most - least);
        EXPECT_EQ(resolved(params, scene, size).pixel, glm::ivec2(glm::floor(wanted)));
    }
}

TEST(PinnedPixel, ReportsInvisibleObjectsInASentence) {
    Params params = looking();
    const Scene behind_wall =
        scene_of({object("hidden", box_mesh(), {0, 0, -20}), object("front", box_mesh(), {0, 0, -3})});
    params.view.pin = Pin{"hidden", {}};
    EXPECT_EQ(say(resolved(params, behind_wall, sizes[1]).why_none), "No part of the pinned object hidden is visible.");
    params.camera.yaw = 180.0;
    params.view.pin = Pin{"front", {}};
    EXPECT_EQ(say(resolved(params, behind_wall, sizes[1]).why_none), "No part of the pinned object front is visible.");
    params.view.pin = Pin{"nobody", {}};
    EXPECT_EQ(say(resolved(params, behind_wall, sizes[1]).why_none), "The scene has no object nobody to pin.");
}

TEST(PinnedPixel, DoesNotDependOnTheLastDrawCall) {
    Params params = looking();
    params.view.pin = Pin{"right", {}};
    const std::optional<glm::ivec2> whole = resolved(params, boxes(), sizes[2]).pixel;
    ASSERT_TRUE(whole);
    for (const int call : {0, 1, 2}) {
        params.view.call = call;
        EXPECT_EQ(resolved(params, boxes(), sizes[2]).pixel, whole);
    }
}

}  // namespace
}  // namespace viewing
