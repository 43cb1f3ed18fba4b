// Every exact method draws the same picture as ray casting, except at edges, on random scenes with interpenetration,
// cycles and polygons cut by the near plane. VIEWING_TEST_SCENES=5000 tries more than the usual 300.
#include <gtest/gtest.h>

#include "topics/hidden/methods/bsp.h"
#include "topics/hidden/methods/newell.h"
#include "topics/hidden/methods/painter.h"
#include "unit/methods/scenes.h"

namespace viewing {
namespace {

double area_of(std::span<const Polygon> fragments, std::span<const int> order) {
    double sum = 0.0;
    for (const int fragment : order) sum += area(fragments[fragment]);
    return sum;
}

TEST(Agreement, ExactMethodsMatchRayCasting) {
    std::int64_t compared = 0, cuts = 0;
    int painter_wrong = 0;
    const int count = random_scene_count();
    for (int scene = 0; scene < count; ++scene) {
        SCOPED_TRACE("seed " + std::to_string(seed + scene));
        Random random(seed + scene);
        const std::vector<Polygon> polygons = random_polygons(random);
        const Viewpoint viewpoint = random_viewpoint(random);
        const double whole_area = total_area(polygons);
        const IdImage reference = ray_cast_image(polygons, viewpoint);
        const auto wrong = [&](const IdImage& image) { return difference(reference, image).different; };

        EXPECT_EQ(wrong(zbuffer_image(polygons, viewpoint)), 0);

        const BspTree tree = build_bsp(polygons);
        EXPECT_NEAR(total_area(tree.fragments), whole_area, 1e-9 * whole_area);
        const BspWalk back_to_front = walk_bsp(tree, viewpoint.eye_world(), BspOrder::back_to_front);
        const BspWalk front_to_back = walk_bsp(tree, viewpoint.eye_world(), BspOrder::front_to_back);
        EXPECT_EQ(wrong(paint(tree.fragments, back_to_front.fragments, viewpoint)), 0);
        EXPECT_EQ(wrong(paint(tree.fragments, front_to_back.fragments, viewpoint, PaintRule::keep_first)), 0);

        const NewellOrder newell = newell_order(polygons, viewpoint);
        EXPECT_EQ(say(newell.problem), "");
        EXPECT_EQ(newell.counters.forced, 0);
        EXPECT_NEAR(area_of(newell.fragments, newell.order) + newell.clipped_area, whole_area, 1e-9 * whole_area);
        EXPECT_EQ(wrong(paint(newell.fragments, newell.order, viewpoint)), 0);

        const PainterOrder painter = painter_order(polygons, viewpoint, PainterKey::farthest);
        painter_wrong += wrong(paint(polygons, painter.order, viewpoint)) > 0;
        compared += difference(reference, reference).compared;
        cuts += newell.counters.splits;
    }
    EXPECT_GT(painter_wrong, count / 2) << "the scenes need an exact method";
    EXPECT_GT(cuts, 5 * count);
    EXPECT_GT(compared, count * test_width * test_height / 2) << "most pixels are not at edges";
}

TEST(Difference, ForgivesValuesOfTheReferenceWithinAPixel) {
    IdImage reference(6, 5);
    for (int y = 0; y < 5; ++y) {
        for (int x = 3; x < 6; ++x) reference.ids[reference.index(x, y)] = 7;
    }
    IdImage image = reference;
    image.ids[image.index(0, 1)] = 7;
    image.ids[image.index(2, 4)] = 7;
    const IdDifference result = difference(reference, image);
    EXPECT_EQ(result.compared, 30);
    EXPECT_EQ(result.different, 1);
    EXPECT_EQ(result.different_at_edges, 1);
    EXPECT_EQ(result.differs[image.index(0, 1)], 1);
    EXPECT_EQ(result.differs[image.index(2, 4)], 0);
    EXPECT_EQ(with_ids(reference, std::vector<int>{0, 0, 0, 0, 0, 0, 0, 5}).id(4, 0), 5);
    EXPECT_EQ(with_ids(reference, std::vector<int>{0, 0, 0, 0, 0, 0, 0, 5}).id(0, 0), IdImage::background);
}

}  // namespace
}  // namespace viewing
