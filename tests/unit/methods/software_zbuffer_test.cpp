// The scan converter: pixels, depths, counts, replay and cracks.
#include "topics/hidden/methods/software_zbuffer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "unit/methods/scenes.h"

namespace viewing {
namespace {

/// Makes a polygon from pixels of an 8 × 8 picture, with y down and z as window depth.
Polygon on_screen(std::vector<glm::dvec3> corners, int source) {
    for (glm::dvec3& c : corners) c = {c.x / 4 - 1, 1 - c.y / 4, 2 * c.z - 1};
    return make_polygon(std::move(corners), source, source).value();
}

constexpr RasterOptions eight{.width = 8, .height = 8};

std::string rows(const IdImage& image) {
    std::string text;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            text += image.id(x, y) < 0 ? '.' : static_cast<char>('0' + image.id(x, y));
        }
        text += '\n';
    }
    return text;
}

TEST(Rasterize, TopLeftRuleOnEdgesThroughPixelCenters) {
    // Every edge passes through pixel centers: top and left edges own them, but bottom and right edges do not.
    const std::vector<Polygon> polygons{
        on_screen({{1.5, 1.5, 0.5}, {5.5, 1.5, 0.5}, {5.5, 5.5, 0.5}}, 0),
        on_screen({{1.5, 1.5, 0.5}, {5.5, 5.5, 0.5}, {1.5, 5.5, 0.5}}, 1),
        on_screen({{5.5, 1.5, 0.5}, {7.5, 1.5, 0.5}, {7.5, 5.5, 0.5}, {5.5, 5.5, 0.5}}, 2)};
    RasterOptions options = eight;
    options.rule = PaintRule::overwrite;
    options.count_per_pixel = true;
    const RasterResult result = rasterize(polygons, glm::dmat4(1), options);
    EXPECT_EQ(rows(result.image),
              "........\n"
              ".000022.\n"
              ".100022.\n"
              ".110022.\n"
              ".111022.\n"
              "........\n"
              "........\n"
              "........\n");
    EXPECT_EQ(*std::max_element(result.written_per_pixel.begin(), result.written_per_pixel.end()), 1U);
    EXPECT_EQ(result.counters.pixels_tested, 24);
    EXPECT_EQ(result.counters.pixels_written, 24);
    EXPECT_EQ(result.counters.pixels_covered, 24);
    EXPECT_EQ(result.counters.overdraw(), 1.0);
}

TEST(Rasterize, DepthRulesAndOverdraw) {
    const std::vector<Polygon> polygons{on_screen({{0, 0, 0.6}, {4, 0, 0.6}, {4, 2, 0.6}, {0, 2, 0.6}}, 0),
                                        on_screen({{2, 0, 0.3}, {6, 0, 0.3}, {6, 2, 0.3}, {2, 2, 0.3}}, 1),
                                        on_screen({{3, 0, 0.4}, {8, 0, 0.4}, {8, 2, 0.4}, {3, 2, 0.4}}, 2)};
    const auto top_row = [&](PaintRule rule) {
        RasterOptions options = eight;
        options.rule = rule;
        const RasterResult result = rasterize(polygons, glm::dmat4(1), options);
        EXPECT_EQ(result.counters.pixels_tested, 2 * (4 + 4 + 5));
        EXPECT_DOUBLE_EQ(result.counters.overdraw(), 13.0 / 8.0);
        return rows(result.image).substr(0, 8);
    };
    EXPECT_EQ(top_row(PaintRule::overwrite), "00122222");
    EXPECT_EQ(top_row(PaintRule::keep_first), "00001122");
    EXPECT_EQ(top_row(PaintRule::depth_test), "00111122");
    const RasterResult reordered = rasterize(polygons, std::vector{2, 0}, glm::dmat4(1), eight);
    EXPECT_EQ(rows(reordered.image).substr(0, 8), "00022222");
    EXPECT_EQ(rasterize(polygons, std::vector<int>{}, glm::dmat4(1), eight).counters.pixels_tested, 0)
        << "an empty order draws nothing";
}

TEST(Rasterize, ReplayStopsAfterEachFragment) {
    const std::vector<Polygon> polygons{on_screen({{0, 0, 0.6}, {3, 0, 0.6}, {3, 2, 0.6}, {0, 2, 0.6}}, 4),
                                        on_screen({{1, 0, 0.3}, {4, 0, 0.9}, {4, 1, 0.9}, {1, 1, 0.3}}, 5)};
    const auto after = [&](std::int64_t count) {
        RasterOptions options = eight;
        options.stop_after = count;
        return rasterize(polygons, glm::dmat4(1), options);
    };
    EXPECT_EQ(after(0).counters.pixels_tested, 0);
    EXPECT_EQ(after(0).last.polygon, -1);
    for (int i = 1; i <= 9; ++i) EXPECT_EQ(after(i).counters.pixels_tested, i);
    const RasterStep fourth = after(4).last;
    EXPECT_EQ(std::tuple(fourth.x, fourth.y, fourth.polygon, fourth.written), std::tuple(0, 1, 0, true));
    const RasterStep hidden = after(8).last;
    EXPECT_EQ(std::tuple(hidden.x, hidden.y, hidden.polygon), std::tuple(2, 0, 1));
    EXPECT_NEAR(hidden.depth, 0.6, 1e-12);
    EXPECT_NEAR(hidden.stored_depth, 0.6, 1e-12);
    EXPECT_FALSE(hidden.written) << "at equal depths the first wins";
    EXPECT_EQ(after(9).image.ids, after(-1).image.ids);
    EXPECT_EQ(after(100).counters.pixels_tested, 9);
}

TEST(Rasterize, ReportsEachFragmentOfAWatchedPixel) {
    const std::vector<Polygon> polygons{on_screen({{0, 0, 0.6}, {8, 0, 0.6}, {8, 8, 0.6}, {0, 8, 0.6}}, 0),
                                        on_screen({{7, 7, 0.1}, {8, 7, 0.1}, {8, 8, 0.1}}, 1),
                                        on_screen({{0, 0, 0.7}, {8, 0, 0.7}, {8, 8, 0.7}, {0, 8, 0.7}}, 2),
                                        on_screen({{1, 1, 0.2}, {5, 1, 0.2}, {5, 5, 0.2}, {1, 5, 0.2}}, 3)};
    RasterOptions options = eight;
    options.watched = glm::ivec2(2, 3);
    const RasterResult all = rasterize(polygons, glm::dmat4(1), options);
    EXPECT_EQ(all.tested_after,
              (std::vector<std::int64_t>{64, all.tested_after[1], all.tested_after[1] + 64, all.tested_after[1] + 80}));
    ASSERT_EQ(all.touches.size(), 3U);
    std::size_t met = 0;
    for (std::int64_t number = 1; number <= all.counters.pixels_tested; ++number) {
        RasterOptions until = eight;
        until.stop_after = number;
        const RasterStep last = rasterize(polygons, glm::dmat4(1), until).last;
        if (last.x != 2 || last.y != 3) continue;
        const RasterTouch& touch = all.touches[met++];
        EXPECT_EQ(touch.number, number);
        EXPECT_EQ(touch.place, last.polygon);
        EXPECT_EQ(touch.fragment.depth, last.depth);
        EXPECT_EQ(touch.fragment.stored_depth, last.stored_depth);
        EXPECT_EQ(touch.fragment.written, last.written);
    }
    EXPECT_EQ(met, 3U);
}

TEST(Rasterize, MeshesAreWatertight) {
    // Every pixel that a convex closed mesh covers is drawn twice: by a front face and by a back face.
    SCOPED_TRACE(seed);
    Random random(seed);
    const Mesh mesh = sphere_mesh(40, 20);
    const MeshInstance instance{&mesh};
    const std::vector<Polygon> polygons = polygons_of(std::span(&instance, 1)).polygons;
    for (int i = 0; i < 10; ++i) {
        const Viewpoint viewpoint = viewpoint_at(random.number(2, 6) * random.direction(), {0, 0, 0});
        const RasterResult result =
            rasterize(polygons, viewpoint.clip_from_world(),
                      {.rule = PaintRule::overwrite, .width = 200, .height = 150, .count_per_pixel = true});
        for (const std::uint32_t count : result.written_per_pixel) EXPECT_TRUE(count == 0 || count == 2);
        EXPECT_EQ(result.counters.pixels_tested, 2 * result.counters.pixels_covered);
        EXPECT_GT(result.counters.pixels_covered, 1000);
    }
}

TEST(Rasterize, DepthsMatchRayCasting) {
    SCOPED_TRACE(seed);
    Random random(seed);
    std::int64_t compared = 0;
    for (int scene = 0; scene < 20; ++scene) {
        const std::vector<Polygon> polygons = random_polygons(random);
        const Viewpoint viewpoint = random_viewpoint(random);
        const IdImage cast = ray_cast_image(polygons, viewpoint), scanned = zbuffer_image(polygons, viewpoint);
        for (std::size_t i = 0; i < cast.ids.size(); ++i) {
            if (cast.ids[i] != scanned.ids[i] || cast.ids[i] == IdImage::background) continue;
            ASSERT_NEAR(cast.depths[i], scanned.depths[i], 1e-8);
            ++compared;
        }
    }
    EXPECT_GT(compared, 20000);
}

TEST(Rasterize, CoplanarPolygonsNeverFight) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (int scene = 0; scene < 20; ++scene) {
        const glm::dmat4 pose = world_from_model(random.vec3(0.3), random.angles(), glm::dvec3(1));
        std::vector<Polygon> polygons;
        while (polygons.size() < 8) {
            const auto corner = [&] {
                return glm::dvec3(pose * glm::dvec4(random.number(-1.5, 1.5), 0, random.number(-1.5, 1.5), 1));
            };
            add(polygons, {corner(), corner(), corner()});
        }
        std::vector<int> lowest_last(polygons.size());
        std::iota(lowest_last.rbegin(), lowest_last.rend(), 0);
        const Viewpoint viewpoint = random_viewpoint(random);
        const IdImage expected = paint(polygons, lowest_last, viewpoint);
        EXPECT_EQ(zbuffer_image(polygons, viewpoint).ids, expected.ids);
        EXPECT_EQ(difference(expected, ray_cast_image(polygons, viewpoint)).different, 0);
    }
}

TEST(Rasterize, CutsOpenCracksOnlyOnACoarseGrid) {
    // Many planes cut one polygon into pieces, which leaves T-junctions everywhere.
    SCOPED_TRACE(seed);
    Random random(seed);
    const Polygon whole = make_polygon({{-1.7, -1.4, 0}, {1.7, -1.4, 0}, {0.2, 1.6, 0}}, 0, 0).value();
    std::vector<Polygon> pieces{whole};
    for (int i = 0; i < 200; ++i) {
        const glm::dvec4 plane(random.direction(), random.number(-0.5, 0.5));
        Polygon& piece = pieces[static_cast<std::size_t>(whole_number(random, 0, static_cast<int>(pieces.size()) - 1))];
        if (side_of_plane(piece, plane, 1e-9) != PlaneSide::spanning) continue;
        auto [front, back] = split(piece, plane, 1e-9);
        piece = std::move(front);
        pieces.push_back(std::move(back));
    }
    ASSERT_GT(pieces.size(), 40U);
    const glm::dmat4 clip_from_world = viewpoint_on_z().clip_from_world();
    const auto covered = [&](std::span<const Polygon> polygons, int subpixel_bits) {
        return rasterize(polygons, clip_from_world, {.width = 400, .height = 300, .subpixel_bits = subpixel_bits})
            .image.ids;
    };
    EXPECT_EQ(covered(pieces, -1), covered(std::span(&whole, 1), -1));
    EXPECT_NE(covered(pieces, 1), covered(std::span(&whole, 1), 1));
}

TEST(Rasterize, HandlesCancellationAndDegenerateInput) {
    Random random(seed);
    const std::vector<Polygon> polygons = random_polygons(random);
    WorkProgress progress;
    progress.canceled = true;
    const glm::dmat4 clip_from_world = viewpoint_on_z().clip_from_world();
    const RasterOptions options{.width = test_width, .height = test_height};
    EXPECT_EQ(rasterize(polygons, clip_from_world, options, &progress).counters.pixels_tested, 0);
    EXPECT_EQ(rasterize({}, clip_from_world, options).counters.pixels_covered, 0);
    EXPECT_TRUE(rasterize(polygons, clip_from_world, {}).image.ids.empty()) << "no pixels";
    std::vector<Polygon> behind;
    add(behind, {{-1, -1, 12}, {1, -1, 12}, {0, 1, 12}});
    EXPECT_EQ(rasterize(behind, clip_from_world, options).counters.polygons, 0);
}

}  // namespace
}  // namespace viewing
