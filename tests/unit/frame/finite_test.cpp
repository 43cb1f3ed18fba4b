// Tests check_finite(). No state within the limits of the fields yields a non-finite entry, so the test corrupts the
// matrices by hand.
#include "frame/finite.h"

#include <gtest/gtest.h>

#include <limits>

namespace viewing {
namespace {

TEST(Finite, ChecksEachMatrix) {
    const Derived derived = derive(Params{}, Scene{}, Viewport{{640, 360}});
    EXPECT_TRUE(check_finite(derived));
    ASSERT_FALSE(derived.planes.empty());
    ASSERT_FALSE(derived.planes.front().shadows.empty());
    const auto error_with = [&](const auto& spoil) {
        Derived spoilt = derived;
        spoil(spoilt);
        const Status status = check_finite(spoilt);
        return status ? std::string() : status.error();
    };
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(), beyond_floats = 1e39;
    EXPECT_EQ(error_with([](Derived& d) { d.clip_from_view[2][3] = nan; }),
              "the projection has an entry that is not a finite number");
    EXPECT_EQ(error_with([](Derived& d) { d.view_from_world[3][0] = beyond_floats; }),
              "the view matrix has an entry that is not a finite number");
    EXPECT_EQ(error_with([](Derived& d) { d.planes[0].shadows[0].shadowed_world_from_world[1][1] = nan; }),
              "the shadow matrix has an entry that is not a finite number");
    EXPECT_EQ(error_with([](Derived& d) { d.planes[0].mirrored_world_from_world[0][0] = -beyond_floats; }),
              "the mirror matrix has an entry that is not a finite number");
}

}  // namespace
}  // namespace viewing
