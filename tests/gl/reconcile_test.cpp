// Where surfaces fight, a pixel's fragments are reconciled with the values read back. After that, the last fragment in
// the list that was drawn is the visible one, and rounding is blamed only where the computed list had a different
// winner.
#include "topics/depth/numbers/reconcile.h"

#include <bit>
#include <cmath>

#include "gl_test.h"
#include "render/probe.h"
#include "state/presets.h"
#include "unit/geometry/random.h"

namespace viewing {
namespace {

constexpr glm::ivec2 reconciled_px(602, 356);
constexpr int pixels = 1000;

class Reconcile : public testing::GlTest {
protected:
    struct Seen {
        int surfaces = 0;      ///< pixels that show a surface
        int other_winner = 0;  ///< pixels where the computed list has a different winner
        int blamed = 0;        ///< pixels where rounding is reported to decide some fragment
        double worst = 0.0;    ///< difference between the computed and read-back depth in codes, for the same winner
    };

    static int last_drawn(const std::vector<Fragment>& fragments) {
        int last = -1;
        for (std::size_t i = 0; i < fragments.size(); ++i)
            if (fragments[i].drawn) last = static_cast<int>(i);
        return last;
    }

    /// Calls visit(report, fragments, clears_depth) for `pixels` random pixels of the state's picture. The report holds
    /// the values read back; the fragments hold the computed ones.
    template <typename Visit>
    static void for_pixels_of(const Params& params, const Scene& scene, const Visit& visit) {
        const Derived derived = derive_for(params, scene, reconciled_px);
        const FramePlan frame = plan(params, derived);
        PixelProbe probe;
        EXPECT_TRUE(probe.prepare(renderer(), frame, scene, derived, reconciled_px));
        const FragmentFinder finder(scene);
        Random random(seed);
        for (int trial = 0; trial < pixels; ++trial) {
            const glm::ivec2 pixel(random.number(0, reconciled_px.x), random.number(0, reconciled_px.y));
            SCOPED_TRACE("seed " + std::to_string(seed) + ", pixel " + std::to_string(pixel.x) + " " +
                         std::to_string(pixel.y));
            visit(probe.at(pixel, scene), finder.at(frame, pixel, reconciled_px), frame.clears_depth());
        }
    }

    static Seen compare(const char* preset, DepthFormat format) {
        const Result<LoadedState> state = load_state(preset);
        EXPECT_TRUE(state) << state.error();
        Params params = probed(state->params);
        params.depth.format = format;
        const Scene scene = testing::scene_named(std::get<std::string>(params.scene));
        Seen seen;
        for_pixels_of(params, scene, [&seen](const PixelReport& report, std::vector<Fragment> fragments, bool clears) {
            const int computed = last_drawn(fragments);
            if (computed >= 0) {
                const Fragment& one = fragments[static_cast<std::size_t>(computed)];
                if (one.object != report.object)
                    ++seen.other_winner;
                else
                    seen.worst = std::max(seen.worst, std::abs(static_cast<double>(report.stored) - one.stored));
            }
            reconcile(fragments, report, clears);
            const int last = last_drawn(fragments);
            EXPECT_EQ(last < 0 ? "" : fragments[static_cast<std::size_t>(last)].object, report.object);
            if (last < 0) return;
            ++seen.surfaces;
            EXPECT_EQ(fragments[static_cast<std::size_t>(last)].stored, report.stored);
            seen.blamed += std::ranges::any_of(fragments, &Fragment::decided_by_rounding) ? 1 : 0;
        });
        std::printf("%s: %d surfaces, %d other winners, %d blamed on rounding, worst %g codes\n", preset, seen.surfaces,
                    seen.other_winner, seen.blamed, seen.worst);
        return seen;
    }
};

TEST_F(Reconcile, TheVisibleFragmentIsTheOneReadBack) {
    for (const DepthFormat format : {DepthFormat::d24, DepthFormat::d32f}) {
        const Seen seen = compare("depth-fighting", format);
        EXPECT_GT(seen.surfaces, 200);
        EXPECT_GT(seen.other_winner, 0) << "nothing to reconcile";
        EXPECT_GE(seen.blamed, seen.other_winner);
    }
}

TEST_F(Reconcile, TheSameHoldsWithoutClipControl) {
    const Seen seen = compare("fighting-reversed-clip-range", DepthFormat::d32f);
    EXPECT_GT(seen.surfaces, 200);
}

TEST_F(Reconcile, ComparesWithThePreviousFramesDepth) {
    for (const CompareFunc func : {CompareFunc::less, CompareFunc::lequal}) {
        Params params = probed(load_state("depth-not-cleared")->params);
        params.depth.func = func;
        const Scene scene = testing::scene_named("torus-and-boxes");
        int compared = 0, blamed = 0;
        for_pixels_of(params, scene, [&](const PixelReport& report, std::vector<Fragment> fragments, bool clears) {
            reconcile(fragments, report, clears);
            for (const Fragment& fragment : fragments) {
                ++compared;
                // Both frames draw the same picture, so the first leaves the code that is read back after the second.
                EXPECT_EQ(fragment.compared_with, report.stored) << fragment.object;
                blamed += fragment.decided_by_rounding ? 1 : 0;
            }
        });
        EXPECT_GT(compared, 400);
        EXPECT_EQ(blamed, 0) << "no surfaces fight here";
    }
}

TEST_F(Reconcile, RoundingIsNotBlamedWithoutFighting) {
    const Seen seen = compare("fighting-near-raised", DepthFormat::d24);
    EXPECT_GT(seen.surfaces, 200);
    EXPECT_EQ(seen.other_winner, 0);
    EXPECT_EQ(seen.blamed, 0);
}

}  // namespace
}  // namespace viewing
