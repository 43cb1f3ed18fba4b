// shared_stencil_tests() replaces the stencil tests of passes with tests that pass the same fragments, for every value
// that the stencil can hold. This file enumerates these values for the passes of every preset and for random passes.
#include "render/shared_tests.h"

#include <gtest/gtest.h>

#include <set>

#include "state/compare_func.h"
#include "state/presets.h"
#include "unit/frame/frame_test.h"
#include "unit/geometry/random.h"

namespace viewing {
namespace {

bool lets_through(const StencilState& state, int value) {
    return !state.test || compare(state.func, state.reference & state.read_bits, value & state.read_bits);
}

int left_by(const StencilState& state, int value, int reference) {
    int after = value;
    switch (state.on_pass) {
        case StencilOp::keep:
            break;
        case StencilOp::replace:
            after = reference;
            break;
        case StencilOp::increment:
            after = std::min(value + 1, 255);
            break;
        case StencilOp::decrement:
            after = std::max(value - 1, 0);
            break;
        case StencilOp::invert:
            after = 255 - value;
            break;
        case StencilOp::zero:
            after = 0;
            break;
    }
    return (value & ~state.write_bits) | (after & state.write_bits);
}

/// Expects that the shared tests pass the same fragments, and returns how many of them differ from the original tests.
/// Assumes that a pass may touch a pixel zero, one, or several times.
int expect_the_same_fragments(std::span<const Pass> passes) {
    const std::vector<StencilState> tests = shared_stencil_tests(passes);
    EXPECT_EQ(tests.size(), passes.size());
    int changed = 0;
    std::set<int> values{0};
    for (std::size_t i = 0; i < passes.size(); ++i) {
        const StencilState& planned = passes[i].stencil;
        changed += tests[i] != planned;
        for (const int value : values)
            EXPECT_EQ(lets_through(tests[i], value), lets_through(planned, value))
                << say(passes[i].name) << ", " << value;
        if (!planned.test || planned.on_pass == StencilOp::keep) {
            // A pass that wrote no stencil must still write none.
            EXPECT_TRUE(tests[i] == planned || tests[i].on_pass == StencilOp::keep) << say(passes[i].name);
            continue;
        }
        EXPECT_EQ(tests[i], planned) << say(passes[i].name);
        std::set<int> references{planned.reference};
        if (passes[i].marks_objects)
            for (int mark = 0; mark < 256; ++mark) references.insert(mark);
        std::vector<int> open(values.begin(), values.end());
        while (!open.empty()) {
            const int value = open.back();
            open.pop_back();
            if (!lets_through(planned, value)) continue;
            for (const int reference : references)
                if (const int after = left_by(planned, value, reference); values.insert(after).second)
                    open.push_back(after);
        }
    }
    return changed;
}

std::vector<Pass> passes_of(const std::string& preset) {
    const auto [params, scene] = testing::preset_named(preset);
    return plan(params, derive(params, scene, {{640, 360}})).passes;
}

TEST(SharedTests, PassTheSameFragmentsInEveryPreset) {
    int changed = 0;
    for (const NamedFile& preset : presets()) {
        SCOPED_TRACE(preset.name);
        changed += expect_the_same_fragments(passes_of(preset.name)) > 0;
    }
    EXPECT_GE(changed, 3);  // otherwise sharing is useless
}

TEST(SharedTests, PassTheSameFragmentsForPassesOfEveryKind) {
    SCOPED_TRACE("seed 31");
    Random random(31);
    const auto one_of = [&](int count) { return static_cast<int>(random.number(0.0, count)) % count; };
    int changed = 0;
    for (int round = 0; round < 3000; ++round) {
        std::vector<Pass> passes(static_cast<std::size_t>(2 + one_of(6)));
        for (Pass& pass : passes) {
            const int region = one_of(4);
            const StencilState states[] = {{},
                                           marks(region),
                                           inside(region),
                                           enters_from(region),
                                           leaves(region),
                                           outside(region),
                                           inside(0),
                                           inside(1),
                                           marks(1),
                                           wipes_marks(),
                                           {},
                                           exactly(region),
                                           counts_once(region, 16)};
            pass.stencil = states[one_of(static_cast<int>(std::size(states)))];
            pass.color_write = one_of(4) > 0;
            pass.marks_objects = pass.stencil.on_pass == StencilOp::replace && one_of(8) == 0;
        }
        SCOPED_TRACE("round " + std::to_string(round));
        changed += expect_the_same_fragments(passes) > 0;
        if (::testing::Test::HasFailure()) return;
    }
    EXPECT_GT(changed, 200);
}

/// If only the reference differs, a software renderer needs just one shader for the mirror image and the objects.
TEST(SharedTests, MirrorImageAndObjectsDifferOnlyInTheReference) {
    const std::vector<Pass> passes = passes_of("opening");
    std::vector<StencilState> of_objects;
    const std::vector<StencilState> tests = shared_stencil_tests(passes);
    for (std::size_t i = 0; i < passes.size(); ++i)
        if (passes[i].subject == Subject::objects && passes[i].shading == Shading::lit) of_objects.push_back(tests[i]);
    ASSERT_EQ(of_objects.size(), 2U);
    EXPECT_NE(of_objects[0].reference, of_objects[1].reference);
    of_objects[0].reference = of_objects[1].reference;
    EXPECT_EQ(of_objects[0], of_objects[1]);
}

}  // namespace
}  // namespace viewing
