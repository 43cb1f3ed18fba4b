// Checks the promises of the hidden-surface presets against ray casting: the methods and sort keys that fail from the
// preset's camera, and those that do not.
#include <gtest/gtest.h>

#include <algorithm>

#include "state/presets.h"
#include "state/scene.h"
#include "topics/hidden/methods/bsp.h"
#include "topics/hidden/methods/difference.h"
#include "topics/hidden/methods/newell.h"
#include "topics/hidden/methods/painter.h"
#include "topics/hidden/methods/ray_cast.h"
#include "topics/hidden/methods/software_zbuffer.h"
#include "topics/hidden/numbers/hidden_views.h"

namespace viewing {
namespace {

constexpr int width = 640, height = 360;

/// A preset, its scene as polygons, its camera, and the picture that ray casting gives.
class Stage {
public:
    explicit Stage(const std::string& preset) {
        const Result<LoadedState> loaded = load_state(preset);
        EXPECT_TRUE(loaded) << preset << ": " << loaded.error();
        if (!loaded) return;
        params = loaded->params;
        const Result<Scene> scene = load_scene(params.scene, loaded->base, params.coplanar);
        EXPECT_TRUE(scene) << preset << ": " << scene.error();
        if (!scene) return;
        std::vector<MeshInstance> instances;
        for (const SceneObject& object : scene->objects) {
            instances.push_back({object.mesh.get(), object.world_from_model});
        }
        polygons = polygons_of(instances).polygons;
        viewpoint = {view_from_world(world_from_view(params.camera.position, params.camera.angles())),
                     clip_from_view(params.lens(), static_cast<double>(width) / height)};
        reference =
            cast_rays(RayScene(polygons), viewpoint.clip_from_world(), {.width = width, .height = height}).image;
    }

    IdImage draw(std::span<const Polygon> drawn, std::span<const int> order, int subpixel_bits = -1) const {
        return rasterize(
                   drawn, order, viewpoint.clip_from_world(),
                   {.rule = PaintRule::overwrite, .width = width, .height = height, .subpixel_bits = subpixel_bits})
            .image;
    }

    std::int64_t wrong(const IdImage& image) const { return difference(reference, image).different; }

    /// Counts only the pixels that show the wrong object and therefore have the wrong color.
    std::int64_t objects_wrong(const IdImage& image) const {
        int last = 0;
        for (const Polygon& polygon : polygons) last = std::max(last, polygon.source);
        std::vector<int> object_of(static_cast<std::size_t>(last) + 1);
        for (const Polygon& polygon : polygons) object_of[polygon.source] = polygon.object;
        return difference(with_ids(reference, object_of), with_ids(image, object_of)).different;
    }

    IdImage painted(PainterKey key) const { return draw(polygons, painter_order(polygons, viewpoint, key).order); }
    BspTree tree() const {
        return build_bsp(polygons, {.splitter = static_cast<BspSplitter>(params.visibility.splitter),
                                    .epsilon = params.visibility.epsilon * glm::length(bounds_of(polygons).size())});
    }
    IdImage walked(const BspTree& built, int subpixel_bits = -1) const {
        const BspWalk walk = walk_bsp(built, viewpoint.eye_world(), BspOrder::back_to_front);
        return draw(built.fragments, walk.fragments, subpixel_bits);
    }

    Params params;
    std::vector<Polygon> polygons;
    Viewpoint viewpoint;
    IdImage reference;
};

/// A hundredth of the picture in another color is enough to be noticed.
constexpr std::int64_t many = width * height / 100;
constexpr std::array keys{PainterKey::nearest, PainterKey::farthest, PainterKey::centroid};

TEST(VisibilityPresets, UseTheMethodOfTheirName) {
    const std::vector<std::pair<std::string, VisibilityMethod>> methods{
        {"painter-nearest-fails", VisibilityMethod::painter},
        {"painter-farthest-fails", VisibilityMethod::painter},
        {"painter-centroid-fails", VisibilityMethod::painter},
        {"painter-interpenetration", VisibilityMethod::painter},
        {"painter-cycle", VisibilityMethod::painter},
        {"newell-cycle", VisibilityMethod::newell},
        {"newell-interpenetration", VisibilityMethod::newell},
        {"bsp-walk", VisibilityMethod::bsp},
        {"bsp-many-splits", VisibilityMethod::bsp},
        {"bsp-cracks", VisibilityMethod::bsp},
        {"newell-two-cuts", VisibilityMethod::newell},
        {"z-buffer", VisibilityMethod::software_depth_buffer},
        {"z-buffer-small", VisibilityMethod::software_depth_buffer},
        {"rays-small", VisibilityMethod::ray_cast},
        {"ray-cast-curved", VisibilityMethod::ray_cast}};
    for (const auto& [preset, method] : methods) {
        SCOPED_TRACE(preset);
        const Stage stage(preset);
        EXPECT_EQ(stage.params.visibility.method, method);
        EXPECT_FALSE(stage.params.shadow.enabled);
        EXPECT_FALSE(stage.params.reflection.enabled);
        // Nothing reaches below the ground, so the ground hides nothing.
        EXPECT_GE(bounds_of(stage.polygons).min.y, -1e-6);
        EXPECT_GT(stage.viewpoint.eye_world().y, 0.0);
        EXPECT_GT(std::count_if(stage.reference.ids.begin(), stage.reference.ids.end(), [](int id) { return id >= 0; }),
                  5 * many)
            << "the scene fills much of the picture";
    }
}

TEST(VisibilityPresets, OnlyTheNamedSortKeyFails) {
    for (const auto& [preset, fails] : {std::pair{"painter-nearest-fails", PainterKey::nearest},
                                        {"painter-farthest-fails", PainterKey::farthest},
                                        {"painter-centroid-fails", PainterKey::centroid}}) {
        SCOPED_TRACE(preset);
        const Stage stage(preset);
        EXPECT_EQ(static_cast<int>(stage.params.visibility.sort_key), static_cast<int>(fails));
        for (const PainterKey key : keys) {
            const IdImage image = stage.painted(key);
            if (key == fails) {
                EXPECT_GT(stage.objects_wrong(image), many);
            } else {
                EXPECT_EQ(stage.wrong(image), 0) << "sort key " << static_cast<int>(key);
            }
        }
    }
}

TEST(VisibilityPresets, NoSortKeySolvesInterpenetrationOrACycle) {
    for (const char* preset : {"painter-interpenetration", "painter-cycle"}) {
        SCOPED_TRACE(preset);
        const Stage stage(preset);
        for (const PainterKey key : keys) EXPECT_GT(stage.objects_wrong(stage.painted(key)), many / 3);
    }
}

TEST(VisibilityPresets, OfThePainterNameTheWrongPair) {
    for (const char* preset : {"painter-nearest-fails", "painter-farthest-fails", "painter-centroid-fails",
                               "painter-interpenetration", "painter-cycle", "newell-cycle"}) {
        SCOPED_TRACE(preset);
        const Result<LoadedState> loaded = load_state(preset);
        ASSERT_TRUE(loaded) << loaded.error();
        const Params& params = loaded->params;
        const Result<Scene> scene = load_scene(params.scene, loaded->base, params.coplanar);
        ASSERT_TRUE(scene) << scene.error();
        const glm::ivec2 size_px(480, 270);
        const Derived derived = derive(params, *scene, {size_px});
        HiddenSurfaceSolver solver(*scene);
        const auto question = hidden_question(params, derived, size_px);
        ASSERT_TRUE(question);
        const HiddenAnswer answer = answer_hidden_question(solver, *question);
        const bool is_painter = params.visibility.method == VisibilityMethod::painter;
        ASSERT_EQ(answer.painter_fails.has_value(), is_painter);
        if (!is_painter) continue;
        // Look for the reported pair in the view's own picture, which is larger than the picture that was searched.
        const WrongPair& wrong = *answer.painter_fails;
        HiddenRequest exact = question->camera;
        exact.visibility.method = VisibilityMethod::ray_cast;
        exact.visibility.exact_curves = false;
        const IdImage seen = solver.solve(exact)->image;
        int found = 0;
        for (int y = 0; y < size_px.y; ++y)
            for (int x = 0; x < size_px.x; ++x)
                found += seen.id(x, y) == wrong.seen && answer.camera->image.id(x, y) == wrong.drawn ? 1 : 0;
        EXPECT_GT(found, 5 * wrong.pixels) << "the small picture has a ninth of the pixels";
        EXPECT_LE(wrong.pixels, wrong.all_pixels);
    }
}

TEST(VisibilityPresets, NewellCutsAndIsRight) {
    for (const char* preset : {"newell-cycle", "newell-interpenetration"}) {
        SCOPED_TRACE(preset);
        const Stage stage(preset);
        const NewellOrder newell = newell_order(stage.polygons, stage.viewpoint);
        EXPECT_GT(newell.counters.splits, 0);
        EXPECT_EQ(newell.problem, "");
        EXPECT_EQ(stage.wrong(stage.draw(newell.fragments, newell.order)), 0);
    }
}

TEST(VisibilityPresets, TwoCutsTurnThreeCyclicTrianglesIntoFivePieces) {
    const Stage stage("newell-two-cuts");
    ASSERT_EQ(stage.polygons.size(), 3U);
    const NewellOrder newell = newell_order(stage.polygons, stage.viewpoint);
    EXPECT_EQ(newell.counters.splits, 2);
    EXPECT_EQ(newell.counters.forced, 0);
    EXPECT_EQ(newell.order.size(), 5U);
    EXPECT_EQ(newell.problem, "");
    EXPECT_EQ(stage.wrong(stage.draw(newell.fragments, newell.order)), 0);
    std::vector<int> order{0, 1, 2};
    do {
        EXPECT_GT(stage.wrong(stage.draw(stage.polygons, order)), many / 3) << order[0] << order[1] << order[2];
    } while (std::next_permutation(order.begin(), order.end()));
}

TEST(VisibilityPresets, SmallRastersHaveFewPolygonsAndSeveralAtTheChosenPixel) {
    for (const char* preset : {"z-buffer-small", "rays-small"}) {
        SCOPED_TRACE(preset);
        const Stage stage(preset);
        EXPECT_EQ(stage.polygons.size(), 4U);
        const Result<LoadedState> loaded = load_state(preset);
        ASSERT_TRUE(loaded) << loaded.error();
        const Params& params = loaded->params;
        EXPECT_EQ(params.visibility.raster, glm::ivec2(24, 16)) << "as in the preset's sentence";
        const Result<Scene> scene = load_scene(params.scene, loaded->base, params.coplanar);
        ASSERT_TRUE(scene) << scene.error();
        HiddenSurfaceSolver solver(*scene);
        const auto result = solver.solve(hidden_request(params, derive(params, *scene, {{900, 500}}), {900, 500}));
        EXPECT_GT(result->traced ? result->traced->hits.size() : result->touches.size(), 2U);
        if (params.visibility.step >= 0) {
            EXPECT_EQ(glm::ivec2(result->compare->x, result->compare->y), *params.visibility.pixel)
                << "opens at the test of the chosen pixel";
        }
    }
}

TEST(VisibilityPresets, WalkedTreeIsSmallAndManySplitsTreeIsLarge) {
    const Stage small("bsp-walk");
    const BspTree small_tree = small.tree();
    EXPECT_LT(small_tree.nodes.size(), 25U);
    EXPECT_EQ(small.wrong(small.walked(small_tree)), 0);

    const Stage large("bsp-many-splits");
    const BspTree large_tree = large.tree();
    EXPECT_EQ(large.polygons.size(), 144U);
    EXPECT_GT(large_tree.fragments.size(), 2000U);
    EXPECT_EQ(large_tree.problem, "");
    EXPECT_EQ(large.wrong(large.walked(large_tree)), 0);
    const NewellOrder newell = newell_order(large.polygons, large.viewpoint);
    EXPECT_GT(newell.counters.splits, 1000);
    EXPECT_EQ(newell.problem, "");
    EXPECT_EQ(large.wrong(large.draw(newell.fragments, newell.order)), 0);
}

TEST(VisibilityPresets, CracksOpenWithTheGivenEpsilonOnly) {
    Stage stage("bsp-cracks");
    const std::int64_t torn = stage.objects_wrong(stage.walked(stage.tree()));
    RecordProperty("torn", static_cast<int>(torn));
    EXPECT_GT(torn, 100);
    EXPECT_LT(torn, many);
    stage.params.visibility.epsilon = VisibilityParams{}.epsilon;
    const BspTree tree = stage.tree();
    EXPECT_EQ(stage.wrong(stage.walked(tree)), 0);
    const std::int64_t cracks = stage.wrong(stage.walked(tree, 4));
    RecordProperty("cracks", static_cast<int>(cracks));
    EXPECT_GT(cracks, 5) << "corners rounded to a grid of 1/16 pixel";
    EXPECT_LT(cracks, 200) << "isolated pixels";
}

TEST(VisibilityPresets, ZBufferIsRightAndTheCurvedSceneIsExact) {
    const Stage z_buffer("z-buffer");
    EXPECT_EQ(z_buffer.wrong(
                  rasterize(z_buffer.polygons, z_buffer.viewpoint.clip_from_world(), {.width = width, .height = height})
                      .image),
              0);
    EXPECT_TRUE(Stage("ray-cast-curved").params.visibility.exact_curves);
}

}  // namespace
}  // namespace viewing
