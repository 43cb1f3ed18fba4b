// Framing: the whole box is in the picture, and the camera could not be much closer.
#include "geometry/framing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "unit/geometry/random.h"

namespace viewing {
namespace {

/// Returns how far the box reaches from the picture's center, where 1 is the picture's edge, or 1e9 if a corner is not
/// in front of the eye.
double reach_of(const Bounds& box, const glm::dvec3& eye, const Angles& angles, const Lens& lens, double aspect) {
    const glm::dmat4 clip_from_world = clip_from_view(lens, aspect) * view_from_world(world_from_view(eye, angles));
    double reach = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec4 clip =
            clip_from_world * glm::dvec4(corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y,
                                         corner & 4 ? box.max.z : box.min.z, 1.0);
        if (clip.w <= 0.0) return 1e9;
        reach = std::max({reach, std::abs(clip.x / clip.w), std::abs(clip.y / clip.w)});
    }
    return reach;
}

TEST(Framing, FillsThePictureWithTheWholeBox) {
    Random random(11);
    for (int i = 0; i < 400; ++i) {
        Bounds box;
        box.add(random.vec3(8.0));
        box.add(random.vec3(8.0));
        const Angles angles{random.number(-180, 180), random.number(-90, 90), random.number(-180, 180)};
        Lens lens{.orthographic = i % 4 == 0, .fovy_deg = random.number(5, 120)};
        const double aspect = random.number(0.3, 3.0);
        if (i % 3 == 0) {
            const double l = random.number(-2, 1), b = random.number(-2, 1);
            lens.window = Edges{l, l + random.number(0.3, 2), b, b + random.number(0.3, 2)};
        }
        const Framing found = framing(box, angles, lens, aspect);
        if (lens.window && lens.orthographic) lens.window = lens.window->scaled(found.height / lens.window->height());
        lens.height = found.height;
        const double reach = reach_of(box, found.eye, angles, lens, aspect);
        EXPECT_LE(reach, 0.95) << i;
        EXPECT_GE(reach, 0.7) << i;  // a deep box close to the camera fills less of the picture
    }
}

TEST(Framing, IsDefinedForPointsAndEmptyBoxes) {
    Bounds point;
    point.add({1, 2, 3});
    EXPECT_LT(glm::distance(framing(point, {}, {}, 1.0).eye, glm::dvec3(1, 2, 4)), 1e-12);
    EXPECT_EQ(framing({}, {}, {}, 1.0).eye, glm::dvec3(0, 0, 1));
    EXPECT_GT(framing(point, {}, {.orthographic = true}, 1.0).height, 0.0);
}

}  // namespace
}  // namespace viewing
