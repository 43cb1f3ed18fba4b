// Removing lights and planes from their lists: the remaining ones keep all their data.
#include "state/lists.h"

#include <gtest/gtest.h>

namespace viewing {
namespace {

/// Returns four lights and eight planes that all differ, as do their matrices.
Params full() {
    Params params;
    for (std::size_t light = 1; light < most_lights; ++light)
        params.lights.push_back({{static_cast<double>(light), 1.0, 0.0, 1.0}});
    for (std::size_t plane = 1; plane < most_planes; ++plane)
        params.planes.push_back({.extent = static_cast<double>(plane)});
    for (std::size_t plane = 0; plane < most_planes; ++plane) {
        params.overrides[plane].mirrored_world_from_world = glm::dmat4(static_cast<double>(10 * plane));
        for (std::size_t light = 0; light < most_lights; ++light)
            params.overrides[plane].shadowed_world_from_world[light] =
                glm::dmat4(static_cast<double>(100 * plane + light));
    }
    return params;
}

TEST(RemoveLight, MovesTheLaterOnesUp) {
    const Params before = full();
    Params params = before;
    remove_light(params, 1);
    EXPECT_EQ(params.lights, (std::vector<LightParams>{before.lights[0], before.lights[2], before.lights[3]}));
    EXPECT_EQ(params.planes, before.planes);
    for (std::size_t plane = 0; plane < most_planes; ++plane) {
        const auto &now = params.overrides[plane].shadowed_world_from_world,
                   &then = before.overrides[plane].shadowed_world_from_world;
        EXPECT_EQ(now[0], then[0]);
        EXPECT_EQ(now[1], then[2]);
        EXPECT_EQ(now[2], then[3]);
        EXPECT_FALSE(now[3]);
    }
}

TEST(RemovePlane, MovesTheLaterOnesUp) {
    const Params before = full();
    Params params = before;
    remove_plane(params, 6);
    ASSERT_EQ(params.planes.size(), 7U);
    EXPECT_EQ(params.planes[5], before.planes[5]);
    EXPECT_EQ(params.planes[6], before.planes[7]);
    EXPECT_EQ(params.overrides[5], before.overrides[5]);
    EXPECT_EQ(params.overrides[6], before.overrides[7]);
    EXPECT_EQ(params.overrides[7], PlaneOverrides{});
}

TEST(RemovePlane, KeepsTheChosenOneChosen) {
    struct Case {
        int chosen;
        std::size_t removed;
        int then;
    };
    for (const Case& one : {Case{1, 3, 1}, Case{5, 3, 4}, Case{4, 3, 4}, Case{8, 7, 7}, Case{8, 1, 7}}) {
        Params params = full();
        params.view.plane = one.chosen;
        remove_plane(params, one.removed);
        EXPECT_EQ(params.view.plane, one.then) << one.chosen << " without index " << one.removed;
    }
}

}  // namespace
}  // namespace viewing
