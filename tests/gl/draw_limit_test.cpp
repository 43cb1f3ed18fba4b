// A frame that stops at a draw call equals a frame without the later draw calls, and depths are not cleared while the
// depth mask is off.
#include "frame/plan/draw_calls.h"
#include "gl_test.h"
#include "unit/geometry/random.h"

namespace viewing {
namespace {

using testing::params_with;
using testing::scene_named;

constexpr glm::ivec2 limited_px(160, 90);

class DrawLimits : public testing::GlTest {
protected:
    static FramePlan plan_of(const std::vector<std::string>& settings, const Scene& scene) {
        const Params params = params_with(settings);
        return plan(params, derive_for(params, scene, limited_px));
    }
    static Image stopped_at(FramePlan frame, const DrawLimit& limit, const Scene& scene) {
        frame.limit = limit;
        return draw(frame, scene, limited_px);
    }
};

TEST_F(DrawLimits, WithinObjectsDrawASmallerScene) {
    const Scene scene = scene_named("torus-and-boxes");
    const FramePlan frame = plan_of({"shadow.enabled=false", "reflection.enabled=false", "view.samples=0"}, scene);
    Random random(seed);
    for (int trial = 0; trial < 12; ++trial) {
        const auto last = static_cast<std::size_t>(random.number(0, static_cast<double>(scene.objects.size())));
        const auto all = static_cast<double>(scene.objects[last].mesh->indices.size() / 3);
        const int triangles = static_cast<int>(random.number(0, all + 1.0));
        Scene smaller = scene;
        smaller.objects.resize(last + 1);
        Mesh cut = *scene.objects[last].mesh;
        cut.indices.resize(static_cast<std::size_t>(triangles) * 3);
        smaller.objects[last].mesh = std::make_shared<const Mesh>(cut);
        EXPECT_EQ(stopped_at(frame, {static_cast<int>(last) + 1, triangles}, scene), draw(frame, smaller, limited_px))
            << "seed " << seed << " object " << last << " triangles " << triangles;
    }
}

TEST_F(DrawLimits, BetweenPassesDrawFewerPasses) {
    const Scene scene = scene_named("torus-and-boxes");
    for (const char* const method : {"depth_buffer", "none"})
        for (const char* const decals : {"offset", "stencil"}) {
            const FramePlan frame = plan_of({std::string("visibility.method=") + method,
                                             std::string("depth.decals=") + decals, "reflection.enabled=true"},
                                            scene);
            const std::vector<DrawCall> calls = draw_calls(frame, scene);
            for (std::size_t i = 0; i < calls.size(); ++i) {
                if (i + 1 < calls.size() && calls[i + 1].pass == calls[i].pass) continue;
                FramePlan shorter = frame;
                shorter.passes.resize(calls[i].pass + 1);
                EXPECT_EQ(stopped_at(frame, {static_cast<int>(i), -1}, scene), draw(shorter, scene, limited_px))
                    << method << " pass " << calls[i].pass;
            }
        }
}

TEST_F(DrawLimits, PastTheLastCallDrawTheWholeFrame) {
    const Scene scene = scene_named("torus-and-boxes");
    const FramePlan frame = plan_of({}, scene);
    const Image whole = draw(frame, scene, limited_px);
    const std::vector<DrawCall> calls = draw_calls(frame, scene);
    const int last = static_cast<int>(calls.size()) - 1;
    for (const DrawLimit limit : {DrawLimit{}, DrawLimit{-1, 3}, DrawLimit{last, -1},
                                  DrawLimit{last, calls.back().triangles}, DrawLimit{last + 1, 0}})
        EXPECT_EQ(stopped_at(frame, limit, scene), whole) << limit.call << ", " << limit.triangles;
    EXPECT_NE(stopped_at(frame, {last - 1, -1}, scene), whole) << "the last object is visible";

    FramePlan empty = frame;
    empty.passes.clear();
    EXPECT_EQ(stopped_at(frame, {0, 0}, scene), draw(empty, scene, limited_px));
}

TEST_F(DrawLimits, ClearingWithTheMaskOffEqualsNotClearing) {
    const Scene near_scene = testing::box_scene(), far_scene = scene_named("torus-and-boxes");
    const auto second_frame = [&](const std::vector<std::string>& settings) {
        View view;
        draw(plan_of(settings, near_scene), near_scene, limited_px, renderer(), view);
        return draw(plan_of(settings, far_scene), far_scene, limited_px, renderer(), view);
    };
    for (const std::string mapping : {"depth.mapping=standard", "depth.mapping=reversed"}) {
        const Image cleared = second_frame({mapping}),
                    masked = second_frame({mapping, "depth.write_while_clearing=false"}),
                    kept = second_frame({mapping, "depth.clear=false"});
        EXPECT_EQ(masked, kept) << mapping;
        EXPECT_GT(testing::pixels_beyond(masked, cleared, 20), 100) << mapping;
        // A view's first frame has no predecessor whose depths could remain, so both settings give the same picture.
        EXPECT_EQ(draw(params_with({mapping, "depth.write_while_clearing=false"}), far_scene, limited_px),
                  draw(params_with({mapping, "depth.clear=false"}), far_scene, limited_px));
    }
}

}  // namespace
}  // namespace viewing
