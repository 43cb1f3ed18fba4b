// Cracks at BSP cuts: where a cut ends in the middle of another piece's edge (a T-junction), corners rounded to a grid
// leave uncovered pixels between the two pieces. The opposite fault is an epsilon so large that cuts are skipped.
#include <gtest/gtest.h>

#include "topics/hidden/methods/bsp.h"
#include "unit/methods/scenes.h"

namespace viewing {
namespace {

/// Returns a cone and a box that pierce a wall, as in the scene "t-junctions".
std::vector<Polygon> pierced_wall() {
    const Mesh cone = cone_mesh(), box = box_mesh(), quad = quad_mesh();
    const std::array instances{
        MeshInstance{&cone, world_from_model({-1.0, 1.75, -0.1}, {-20, 70, 0}, {0.75, 1.0, 0.75})},
        MeshInstance{&box, world_from_model({1.3, 1.3, 0}, {30, 25, 15}, glm::dvec3(0.4))},
        MeshInstance{&quad, world_from_model({0, 1.75, 0}, {0, 90, 0}, {2.6, 1.0, 1.6})}};
    return polygons_of(std::span(instances)).polygons;
}

/// Replaces every polygon's index with 0, which leaves only the coverage.
IdImage covered(const IdImage& image, const std::vector<Polygon>& polygons) {
    return with_ids(image, std::vector<int>(polygons.size(), 0));
}

struct Seams {
    std::int64_t holes = 0;  ///< background pixels surrounded by surface
    std::int64_t wrong = 0;  ///< wrong pixels away from edges
};

/// Adds up the holes and wrong pixels in nine views of 480 × 270 pixels from the front.
Seams seams_of(const std::vector<Polygon>& polygons, double relative_epsilon, int subpixel_bits) {
    constexpr int width = 480, height = 270;
    const RayScene rays{polygons};
    const double diagonal = glm::length(bounds_of(polygons).size());
    const BspTree tree = build_bsp(polygons, {.splitter = BspSplitter::first, .epsilon = relative_epsilon * diagonal});
    EXPECT_NEAR(total_area(tree.fragments), total_area(polygons), 1e-9 * total_area(polygons));
    Seams seams;
    for (int i = 0; i < 9; ++i) {
        const glm::dvec3 eye(0.9 + 0.211 * (i - 4), 2.1 + 0.087 * i, 4.9);
        const Viewpoint viewpoint{view_from_world(world_from_view(eye, angles_looking_at(eye, {0, 1.7, 0}))),
                                  clip_from_view({}, 16.0 / 9.0)};
        const glm::dmat4 clip_from_world = viewpoint.clip_from_world();
        const BspWalk walk = walk_bsp(tree, viewpoint.eye_world(), BspOrder::back_to_front);
        const IdImage image =
            rasterize(tree.fragments, walk.fragments, clip_from_world,
                      {.rule = PaintRule::overwrite, .width = width, .height = height, .subpixel_bits = subpixel_bits})
                .image;
        const IdImage reference = cast_rays(rays, clip_from_world, {.width = width, .height = height}).image;
        seams.wrong += difference(reference, image).different;
        seams.holes += difference(covered(reference, polygons), covered(image, polygons)).different;
    }
    return seams;
}

TEST(Cracks, OpenAtTJunctionsWhenCornersAreRounded) {
    const std::vector<Polygon> polygons = pierced_wall();
    const Seams exact = seams_of(polygons, 1e-9, -1);
    EXPECT_EQ(exact.holes, 0);
    EXPECT_EQ(exact.wrong, 0);
    const Seams fine = seams_of(polygons, 1e-9, 8), coarse = seams_of(polygons, 1e-9, 4);
    RecordProperty("holes_8_bits", static_cast<int>(fine.holes));
    RecordProperty("holes_4_bits", static_cast<int>(coarse.holes));
    EXPECT_GT(fine.holes, 3) << "GL's grid of 1/256 pixel";
    EXPECT_LT(fine.holes, 100) << "isolated pixels";
    EXPECT_GT(coarse.holes, 4 * fine.holes) << "the grid is sixteen times as coarse";
}

TEST(Cracks, DoNotAppearWithoutCuts) {
    const std::vector<Polygon> polygons = pierced_wall();
    for (int i = 0; i < 9; ++i) {
        const Viewpoint viewpoint = viewpoint_at({0.9 + 0.211 * (i - 4), 2.1 + 0.087 * i, 4.9}, {0, 1.7, 0});
        const glm::dmat4 clip_from_world = viewpoint.clip_from_world();
        const IdImage rounded =
            rasterize(polygons, clip_from_world, {.width = test_width, .height = test_height, .subpixel_bits = 4})
                .image;
        const IdImage reference = zbuffer_image(polygons, viewpoint);
        EXPECT_EQ(difference(covered(reference, polygons), covered(rounded, polygons)).different, 0);
    }
}

TEST(Cracks, LargeEpsilonSkipsCutsAndTearsSeams) {
    const std::vector<Polygon> polygons = pierced_wall();
    std::int64_t wrong_before = 0;
    for (const double epsilon : {1e-9, 1e-6, 1e-4}) EXPECT_EQ(seams_of(polygons, epsilon, -1).wrong, 0) << epsilon;
    for (const double epsilon : {3e-3, 1e-2, 3e-2}) {
        const Seams seams = seams_of(polygons, epsilon, -1);
        RecordProperty("wrong_at_" + std::to_string(epsilon), static_cast<int>(seams.wrong));
        EXPECT_GT(seams.wrong, wrong_before) << epsilon;
        EXPECT_EQ(seams.holes, 0) << "the pieces still cover the whole";
        wrong_before = seams.wrong;
    }
    EXPECT_GT(wrong_before, 1000);
}

}  // namespace
}  // namespace viewing
