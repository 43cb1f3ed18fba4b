// Handmade fragments are reconciled with a pixel read back. The tests check which surface is visible afterward and
// which fragments stay unchanged.
#include "topics/depth/numbers/reconcile.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace viewing {
namespace {

constexpr double greatest = 16'777'215.0;
constexpr std::uint32_t cleared = 16'777'215;

/// Draws the surfaces one after the other with GL_LESS, as FragmentFinder does.
std::vector<Fragment> drawn_in_order(const std::vector<std::pair<const char*, std::uint32_t>>& surfaces) {
    std::vector<Fragment> fragments;
    std::uint32_t stands = cleared;
    for (const auto& [name, code] : surfaces) {
        Fragment made;
        made.object = name;
        made.stored = code;
        made.window_depth = code / greatest;
        made.depth_error = 4.0 / greatest;
        made.compared_with = stands;
        made.tie = code == stands;
        made.passes = made.drawn = code < stands;
        if (made.passes) stands = code;
        fragments.push_back(made);
    }
    return fragments;
}

PixelReport read_back(const char* object, std::uint32_t code) {
    PixelReport report;
    report.written = *object != '\0';
    report.has_depth = report.written;
    report.object = object;
    report.stored = code;
    report.window_depth = code / greatest;
    return report;
}

std::string seen(const std::vector<Fragment>& fragments) {
    std::string last;
    for (const Fragment& fragment : fragments)
        if (fragment.drawn) last = fragment.object;
    return last;
}

TEST(Reconcile, KeepsMatchingFragments) {
    std::vector<Fragment> fragments = drawn_in_order({{"far", 9'000}, {"near", 5'000}, {"hidden", 7'000}});
    reconcile(fragments, read_back("near", 5'000), true);
    EXPECT_EQ(seen(fragments), "near");
    for (const Fragment& fragment : fragments) EXPECT_FALSE(fragment.decided_by_rounding) << fragment.object;
    EXPECT_EQ(fragments[2].compared_with, 5'000U);
}

TEST(Reconcile, LaterFragmentThatIsNotReadBackFails) {
    std::vector<Fragment> fragments = drawn_in_order({{"back", 5'001}, {"front", 5'000}});
    reconcile(fragments, read_back("back", 4'999), true);
    EXPECT_EQ(seen(fragments), "back");
    EXPECT_EQ(fragments[0].stored, 4'999U);
    EXPECT_FALSE(fragments[0].decided_by_rounding) << "still passes";
    EXPECT_FALSE(fragments[1].passes || fragments[1].drawn);
    EXPECT_EQ(fragments[1].compared_with, 4'999U);
    EXPECT_TRUE(fragments[1].decided_by_rounding) << "it passed in the computation";

    fragments = drawn_in_order({{"back", 5'002}, {"front", 5'000}});
    reconcile(fragments, read_back("back", 5'002), true);
    EXPECT_FALSE(fragments[1].passes);
    EXPECT_TRUE(fragments[1].decided_by_rounding) << "5,000 < 5,002 is true";
}

TEST(Reconcile, FragmentThatIsReadBackPasses) {
    std::vector<Fragment> fragments = drawn_in_order({{"front", 5'000}, {"back", 5'001}});
    reconcile(fragments, read_back("back", 5'000), true);
    EXPECT_EQ(seen(fragments), "back");
    EXPECT_TRUE(fragments[1].passes && fragments[1].drawn && fragments[1].decided_by_rounding);
    EXPECT_EQ(fragments[1].stored, 5'000U);
    EXPECT_TRUE(fragments[0].drawn) << "drawn at its turn";
}

TEST(Reconcile, NearestFragmentOfTheObjectWins) {
    std::vector<Fragment> fragments = drawn_in_order({{"front", 5'000}, {"back", 5'009}, {"back", 5'001}});
    reconcile(fragments, read_back("back", 4'999), true);
    EXPECT_FALSE(fragments[1].drawn);
    EXPECT_TRUE(fragments[2].drawn);
}

TEST(Reconcile, TakesTheCodeReadBack) {
    std::vector<Fragment> fragments = drawn_in_order({{"near", 5'000}, {"behind", 5'002}});
    reconcile(fragments, read_back("near", 5'003), true);
    EXPECT_EQ(fragments[0].stored, 5'003U);
    EXPECT_EQ(fragments[1].compared_with, 5'003U);
    EXPECT_TRUE(fragments[1].decided_by_rounding) << "5,002 < 5,003 would pass";
    EXPECT_FALSE(fragments[1].passes);
}

TEST(Reconcile, ComparesWithThePreviousFrameIfDepthIsNotCleared) {
    // The previous frame left the code of "near", which GL rounds differently; no fragment is nearer now.
    std::vector<Fragment> fragments = drawn_in_order({{"far", 9'000}, {"near", 5'000}});
    for (Fragment& fragment : fragments) {
        fragment.compared_with = 5'000;
        fragment.passes = fragment.drawn = false;
    }
    std::vector<Fragment> again = fragments;
    reconcile(fragments, read_back("", 5'002), false);
    EXPECT_EQ(fragments[0].compared_with, 5'002U);
    EXPECT_EQ(fragments[1].stored, 5'002U) << "the buffer's code";
    EXPECT_TRUE(fragments[1].tie);
    for (const Fragment& fragment : fragments) EXPECT_FALSE(fragment.decided_by_rounding) << fragment.object;

    // With GL_LEQUAL, "near" passes against its own depth of the previous frame.
    again[1].depth.func = CompareFunc::lequal;
    again[1].tie = again[1].passes = again[1].drawn = true;
    reconcile(again, read_back("near", 5'002), false);
    EXPECT_EQ(again[1].compared_with, 5'002U);
    EXPECT_TRUE(again[1].tie);
    EXPECT_FALSE(again[1].decided_by_rounding);
    EXPECT_EQ(again[0].compared_with, 5'002U);
}

TEST(Reconcile, KeepsDifferencesThatRoundingCannotExplain) {
    const std::vector<Fragment> computed = drawn_in_order({{"far", 9'000'000}, {"near", 5'000'000}});
    for (const PixelReport& report :
         {read_back("", cleared), read_back("other", 5'000'000), read_back("far", 9'000'000)}) {
        std::vector<Fragment> fragments = computed;
        reconcile(fragments, report, true);
        EXPECT_EQ(seen(fragments), "near") << report.object;
        EXPECT_TRUE(std::ranges::none_of(fragments, &Fragment::decided_by_rounding));
    }
    std::vector<Fragment> culled = drawn_in_order({{"front", 5'000}, {"back", 5'001}});
    culled[1].culled = true;
    reconcile(culled, read_back("back", 5'001), true);
    EXPECT_EQ(seen(culled), "front");
    std::vector<Fragment> none;
    reconcile(none, read_back("far", 1), true);
    EXPECT_TRUE(none.empty());
}

}  // namespace
}  // namespace viewing
