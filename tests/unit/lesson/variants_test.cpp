// The assignment of variants to students. The expected numbers are published by the authors of FNV-1a and SplitMix64
// or come from a second implementation in Python. A sheet that was handed out must never change.
#include "lesson/variants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <string>

namespace viewing {
namespace {

using Places = std::vector<std::size_t>;

constexpr std::uint64_t golden_gamma = 0x9e3779b97f4a7c15U;

TEST(Variants, Fnv1aMatchesThePublishedValues) {
    EXPECT_EQ(fnv1a(""), 0xcbf29ce484222325U);
    EXPECT_EQ(fnv1a("a"), 0xaf63dc4c8601ec8cU);
    EXPECT_EQ(fnv1a("foobar"), 0x85944171f73967e8U);
    EXPECT_EQ(fnv1a(std::string_view("\0", 1)), 0xaf63bd4c8601b7dfU) << "a zero byte counts";
    EXPECT_EQ(fnv1a("\xff"), 0xaf64724c8602eb6eU) << "bytes are unsigned";
}

TEST(Variants, FinalizerMatchesSplitMix64) {
    EXPECT_EQ(finalized(1234567 + golden_gamma), 6457827717110365317U);
    EXPECT_EQ(finalized(1234567 + 2 * golden_gamma), 3203168211198807973U);
    EXPECT_EQ(finalized(1234567 + 3 * golden_gamma), 9817491932198370423U);
    EXPECT_EQ(finalized(0), 0U);
}

TEST(Variants, ShuffleLosesNothing) {
    for (const std::uint64_t seed : {std::uint64_t{0}, ~std::uint64_t{0}, fnv1a("E16-shadow-matrix")})
        for (const std::size_t count : {0U, 1U, 2U, 3U, 17U, 1000U, 20'000U}) {
            Places order = shuffled(count, seed);
            EXPECT_TRUE(count < 17 || !std::is_sorted(order.begin(), order.end()));
            std::sort(order.begin(), order.end());
            Places all(count);
            std::iota(all.begin(), all.end(), std::size_t{0});
            EXPECT_EQ(order, all) << count << " with " << seed;
        }
}

TEST(Variants, ShuffleNeverChanges) {
    const std::uint64_t seed = fnv1a("E16-shadow-matrix");
    EXPECT_EQ(shuffled(2, seed), (Places{0, 1}));
    EXPECT_EQ(shuffled(8, seed), (Places{5, 7, 0, 4, 3, 2, 6, 1}));
    EXPECT_EQ(shuffled(26, seed),
              (Places{13, 17, 11, 10, 9, 23, 12, 8, 2, 20, 19, 7, 6, 21, 22, 1, 16, 15, 0, 3, 18, 5, 4, 14, 24, 25}));
    EXPECT_EQ(shuffled(10, 0), (Places{6, 3, 2, 9, 8, 1, 4, 7, 0, 5}));
}

TEST(Variants, VariantOfAStudentNeverChanges) {
    EXPECT_EQ(variant_of("viewing-2026", "32201234", "E16-shadow-matrix", 16), 8U);
    EXPECT_EQ(variant_of("viewing-2026", "32201234", "E01-view-matrix", 16), 12U);
    EXPECT_EQ(variant_of("", "", "E01-view-matrix", 16), 5U);
    EXPECT_EQ(variant_of("그래픽스", "김학생", "E18-place-the-light", 16), 5U);
    EXPECT_EQ(variant_of("cg", "1", "E18-place-the-light", 7), 2U);
    EXPECT_EQ(variant_of("cg", "1", "x", 1), 0U);
    EXPECT_EQ(variant_of("cg", "1", "x", 1'000'003), 404'973U);
}

/// Returns the variants that a class of 90 students gets in twelve exercises.
std::vector<Places> sheets_of(const std::string& course, std::size_t first_number) {
    std::vector<Places> sheets;
    for (std::size_t student = 0; student < 90; ++student) {
        Places& sheet = sheets.emplace_back();
        for (int exercise = 1; exercise <= 12; ++exercise)
            sheet.push_back(variant_of(course, std::to_string(first_number + student),
                                       "E" + std::to_string(100 + exercise).substr(1) + "-x", 16));
    }
    return sheets;
}

TEST(Variants, NoTwoStudentsOfAClassShareASheet) {
    for (const auto& [course, first] : {std::pair("viewing-2026", 32'200'000U), std::pair("cg", 1U)}) {
        const std::vector<Places> sheets = sheets_of(course, first);
        int pairs = 0, common = 0;
        for (std::size_t a = 0; a < sheets.size(); ++a)
            for (std::size_t b = a + 1; b < sheets.size(); ++b) {
                int equal = 0;
                for (std::size_t i = 0; i < 12; ++i) equal += sheets[a][i] == sheets[b][i] ? 1 : 0;
                EXPECT_LT(equal, 12) << course << ": " << a << " and " << b;
                common += equal;
                ++pairs;
            }
        EXPECT_EQ(pairs, 4005);
        // Two sheets agree in 0.75 exercises on average: there are 12, each equal with probability 1/16.
        EXPECT_GT(static_cast<double>(common) / pairs, 0.6) << course;
        EXPECT_LT(static_cast<double>(common) / pairs, 0.9) << course;
    }
}

TEST(Variants, EveryVariantIsAssigned) {
    std::set<std::size_t> seen;
    for (const Places& sheet : sheets_of("viewing-2026", 32'200'000)) seen.insert(sheet.begin(), sheet.end());
    EXPECT_EQ(seen.size(), 16U);
    EXPECT_EQ(*seen.rbegin(), 15U);
}

}  // namespace
}  // namespace viewing
