// A frame that stops after a pass equals a frame without the later passes: colors, depths and stencil values.
#include "gl_test.h"
#include "render/buffer_read.h"
#include "unit/geometry/random.h"

namespace viewing {
namespace {

using testing::scene_named;

constexpr glm::ivec2 passes_px(96, 64);

/// The buffers after a frame.
struct Left {
    Image shown;
    std::vector<Color> colors;
    std::vector<StoredPixel> stored;
    bool operator==(const Left&) const = default;
};

class PassLimit : public testing::GlTest {
protected:
    static Left left_by(const FramePlan& frame, const Scene& scene) {
        Result<BufferReader> reader = BufferReader::make(renderer().capabilities());
        EXPECT_TRUE(reader) << reader.error();
        View view;
        Left left{.shown = draw(frame, scene, passes_px, renderer(), view), .colors = {}, .stored = {}};
        if (frame.samples > 0) return left;  // multisampled buffers cannot be read
        left.colors = reader->colors(view, {{0, 0}, passes_px});
        left.stored = reader->stored(view, frame.depth_format, {{0, 0}, passes_px});
        return left;
    }
    static FramePlan plan_of(const Params& params, const Scene& scene) {
        return plan(params, derive_for(params, scene, passes_px));
    }
    static FramePlan stopped_after(FramePlan frame, int pass) {
        frame.limit.pass = pass;
        return frame;
    }
};

/// Returns a random state that mixes modes of shadow, mirror and depth, seen from nearby.
Params random_state(Random& random) {
    const auto one_of = [&random](int count) { return static_cast<int>(random.number(0, count)); };
    const auto chance = [&random] { return random.number(0, 1) < 0.5; };
    Params params;
    params.camera.position += glm::dvec3(random.number(-1, 1), random.number(-0.5, 1), random.number(-1, 1));
    params.lights.front().position = {random.number(-3, 3), random.number(3, 6), random.number(-3, 3), one_of(2)};
    if (chance()) params.lights.push_back({{random.number(-3, 3), 5.0, random.number(-3, 3), 1.0}});
    params.planes.front().equation = {random.number(-0.2, 0.2), 1.0, random.number(-0.2, 0.2), 0.0};
    if (chance()) params.planes.push_back({.equation = {0.0, 0.0, 1.0, 3.0}});
    params.shadow.style = static_cast<ShadowStyle>(one_of(2));
    params.shadow.offset = static_cast<ShadowOffset>(one_of(4));
    params.reflection.clip = static_cast<MirrorClip>(one_of(3));
    params.reflection.mirrored = static_cast<MirroredThing>(one_of(2));
    params.reflection.bounces = 1 + one_of(2);
    params.reflection.after_objects = chance();
    params.reflection.stencil = random.number(0, 1) < 0.8;
    params.depth.mapping = static_cast<DepthMapping>(one_of(3));
    params.depth.format = std::array{DepthFormat::d8, DepthFormat::d16, DepthFormat::d24,
                                     DepthFormat::d32f}[static_cast<std::size_t>(one_of(4))];
    params.depth.decals = static_cast<DecalMethod>(one_of(3));
    params.view.shows =
        std::array{Shows::color, Shows::depth, Shows::stencil, Shows::facing}[static_cast<std::size_t>(one_of(4))];
    params.view.samples = random.number(0, 1) < 0.2 ? 4 : 0;
    return params;
}

TEST_F(PassLimit, EqualsAFrameWithoutTheLaterPasses) {
    Random random(seed);
    const Scene scene = scene_named("torus-and-boxes");
    int stops = 0, changes = 0;
    for (int trial = 0; trial < 12; ++trial) {
        const FramePlan frame = plan_of(random_state(random), scene);
        ASSERT_EQ(frame.limit, DrawLimit{});
        Left before;
        for (int pass = 0; pass < static_cast<int>(frame.passes.size()); ++pass) {
            FramePlan shorter = frame;
            shorter.passes.resize(static_cast<std::size_t>(pass) + 1);
            const Left stopped = left_by(stopped_after(frame, pass), scene);
            EXPECT_TRUE(stopped == left_by(shorter, scene))
                << "seed " << seed << " trial " << trial << " pass " << pass << " of " << frame.passes.size();
            ++stops;
            changes += stopped == before ? 0 : 1;
            before = stopped;
        }
    }
    EXPECT_GT(stops, 60);
    EXPECT_GT(changes, stops / 2) << "most passes have an effect";
}

TEST_F(PassLimit, DrawsTheWholeFrameAtOrPastTheLastPass) {
    Random random(seed + 1);
    const Scene scene = scene_named("decals");
    for (int trial = 0; trial < 4; ++trial) {
        const FramePlan frame = plan_of(random_state(random), scene);
        const int count = static_cast<int>(frame.passes.size());
        const Left whole = left_by(frame, scene);
        for (const int pass : {-1, count - 1, count, count + 7, 1'000'000})
            EXPECT_TRUE(left_by(stopped_after(frame, pass), scene) == whole) << "pass " << pass << " of " << count;
    }
}

TEST_F(PassLimit, ComesFromTheStateAndYieldsToAnEarlierDrawCall) {
    const Scene scene = scene_named("torus-and-boxes");
    Params params;
    params.view.samples = 0;
    const FramePlan whole = plan_of(params, scene);
    ASSERT_GT(whole.passes.size(), 3U);
    params.view.pass = 1;
    EXPECT_TRUE(left_by(plan_of(params, scene), scene) == left_by(stopped_after(whole, 1), scene));
    params.view.call = 0;
    FramePlan first_call = whole;
    first_call.limit.call = 0;
    EXPECT_TRUE(left_by(plan_of(params, scene), scene) == left_by(first_call, scene));
}

}  // namespace
}  // namespace viewing
