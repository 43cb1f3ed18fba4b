// The values read for the lower views equal those that a fresh probe reads at each step, and are never older than the
// picture.
#include "topics/depth/measured/depth_inspector.h"

#include <numeric>

#include "gl/gl_test.h"
#include "state/presets.h"

namespace viewing {
namespace {

constexpr glm::ivec2 inspected_px(160, 90);

class Inspector : public testing::GlTest {
protected:
    const DepthData& tell(const DepthWishes& wishes) {
        const Derived derived = derive(params, scene, Viewport{inspected_px});
        const Status done =
            inspector.update(renderer(), plan(params, derived), scene, version, derived, inspected_px, wishes);
        EXPECT_TRUE(done) << done.error();
        return inspector.data();
    }
    const DepthData& tell_anew(const DepthWishes& wishes) {
        inspector.forget();
        return tell(wishes);
    }

    Params params = load_state("depth-cells")->params;
    Scene scene = testing::scene_named("torus-and-boxes");
    int version = 1;
    DepthInspector inspector;
};

TEST_F(Inspector, ReadsOnlyWhatIsRequested) {
    const DepthData& nothing = tell({});
    EXPECT_FALSE(nothing.pixel);
    EXPECT_TRUE(nothing.calls.empty() && nothing.fragments.empty() && nothing.depth_counts.counts.empty());
    const DepthData& counted = tell({.counts = true});
    const auto& counts = counted.depth_counts;
    EXPECT_EQ(std::accumulate(counts.counts.begin(), counts.counts.end(), std::uint64_t{0}) + counts.unwritten,
              static_cast<std::uint64_t>(inspected_px.x * inspected_px.y));
    EXPECT_FALSE(counted.pixel);
    EXPECT_EQ(tell({.calls = true}).calls.size(), 4U);  // the patch and three objects
}

TEST_F(Inspector, RereadsWhenThePictureHasChanged) {
    const DepthWishes wishes{.pixel = glm::ivec2(80, 45), .fragments = true};
    const double before = tell(wishes).pixel->eye_z;
    params.camera.position.z += 1.0;
    EXPECT_EQ(tell(wishes).pixel->eye_z, before);  // no change was announced
    EXPECT_NE(tell_anew(wishes).pixel->eye_z, before);
}

TEST_F(Inspector, FindsFragmentsOfTheCurrentScene) {
    const DepthWishes wishes{.pixel = glm::ivec2(80, 45), .fragments = true};
    ASSERT_FALSE(tell(wishes).fragments.empty());
    scene = testing::scene_named("coplanar");
    ++version;
    for (const Fragment& fragment : tell_anew(wishes).fragments)
        EXPECT_EQ(fragment.object.find("box"), std::string::npos) << fragment.object;
}

/// A triangle touches the pixel if it adds a surface on the ray through the pixel.
TEST_F(Inspector, TouchesAreTrianglesThatSendThePixelAFragment) {
    const glm::ivec2 pixel(77, 48);
    const DepthWishes wishes{.pixel = pixel, .calls = true};
    const std::vector<DrawCall> calls = tell(wishes).calls;
    const std::vector<DrawLimit> touches = tell(wishes).touches;
    const FragmentFinder finder(scene);
    const Derived derived = derive(params, scene, Viewport{inspected_px});
    std::vector<DrawLimit> expected;
    std::size_t before = 0;
    for (int call = 0; call < static_cast<int>(calls.size()); ++call)
        for (int triangle = 1; triangle <= calls[static_cast<std::size_t>(call)].triangles; ++triangle) {
            FramePlan frame = plan(params, derived);
            frame.limit = {call, triangle};
            const std::size_t now = finder.at(frame, pixel, inspected_px).size();
            if (now > before) expected.push_back({call, triangle});
            before = now;
        }
    EXPECT_GT(expected.size(), 2U);
    EXPECT_EQ(touches, expected);
    params.view.call = 1;  // a limited frame also lists the touches after its limit
    params.view.triangle = 1;
    EXPECT_EQ(tell_anew(wishes).touches, expected);
}

/// At each step, a cell differs between the blocks before and after the step only if the fragment there is drawn.
TEST_F(Inspector, StepsChangeTheCellsWhoseFragmentsPass) {
    const DepthWishes wishes{.pixel = glm::ivec2(77, 48), .calls = true, .cells = glm::ivec2(9, 7)};
    const std::vector<DrawCall> calls = tell(wishes).calls;
    int changed = 0, sent = 0;
    for (std::size_t call = 0; call < calls.size(); ++call) {
        for (int triangle = 1; triangle <= calls[call].triangles; triangle += calls[call].triangles > 100 ? 37 : 1) {
            params.view.call = static_cast<int>(call);
            params.view.triangle = triangle;
            const DepthData& data = tell_anew(wishes);
            ASSERT_EQ(data.incoming.size(), 63U);
            for (std::size_t cell = 0; cell < data.incoming.size(); ++cell) {
                const bool differs = data.before.cells[cell] != data.now.cells[cell];
                const bool is_drawn = data.incoming[cell] && data.incoming[cell]->drawn;
                changed += differs ? 1 : 0;
                sent += data.incoming[cell] ? 1 : 0;
                EXPECT_TRUE(!differs || is_drawn) << "call " << call << ", triangle " << triangle << ", cell " << cell;
            }
        }
    }
    EXPECT_GT(changed, 60);
    EXPECT_GT(sent, changed);
}

TEST_F(Inspector, KeepsTheBlockInsideThePicture) {
    for (const glm::ivec2 pixel : {glm::ivec2(0, 0), glm::ivec2(159, 89), glm::ivec2(3, 80)}) {
        const CellBlock block = tell({.pixel = pixel, .cells = glm::ivec2(11, 5)}).now;
        EXPECT_EQ(block.size, glm::ivec2(11, 5));
        EXPECT_TRUE(glm::all(glm::lessThanEqual(block.first_pixel, pixel)));
        EXPECT_TRUE(glm::all(glm::lessThan(pixel, block.first_pixel + block.size)));
        EXPECT_TRUE(glm::all(glm::lessThanEqual(block.first_pixel + block.size, inspected_px)));
    }
    EXPECT_EQ(tell({.pixel = glm::ivec2(5, 5), .cells = glm::ivec2(500, 400)}).now.size, inspected_px);
}

}  // namespace
}  // namespace viewing
