// In a column that is too short for everything, the matrices that the preset is about have priority and are shown in
// full, the other items give way, and one click leads to anything hidden.
#include <algorithm>
#include <numeric>
#include <random>

#include "desk.h"
#include "topics/matrices/shown/matrices.h"

namespace viewing::test {
namespace {

TEST(MatricesColumn, FitsAndGivesTheFirstOnesTheRoom) {
    std::mt19937 random(3501);
    const PerEnum<MatrixPart, float, 3> heights = {30.0F, 120.0F, 190.0F};
    for (int trial = 0; trial < 500; ++trial) {
        const float room = std::uniform_real_distribution<float>(120.0F, 900.0F)(random);
        std::vector<std::string> first;
        for (const char* name : matrices_in_order)
            if (random() % 2 == 0) first.emplace_back(name);
        const std::array<MatrixPart, 4> parts = fit_matrices(room, heights, first);
        const float used = std::accumulate(parts.begin(), parts.end(), 0.0F,
                                           [&](float sum, MatrixPart part) { return sum + heights[part]; });
        SCOPED_TRACE(room);
        EXPECT_LE(used, room);
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const bool is_first = std::find(first.begin(), first.end(), matrices_in_order[i]) != first.end();
            // Nothing that fits is left out.
            EXPECT_TRUE(parts[i] != MatrixPart::heading || used + heights[MatrixPart::numbers] - heights[0] > room);
            for (std::size_t j = 0; j < parts.size(); ++j) {
                const bool is_other_first = std::find(first.begin(), first.end(), matrices_in_order[j]) != first.end();
                EXPECT_TRUE(!is_first || is_other_first || parts[i] >= parts[j]) << i << " before " << j;
            }
        }
    }
}

TEST(MatricesColumn, ShowsWhatThePresetIsAboutInTheLecturesOrder) {
    for (const ImVec2 size : {ImVec2{1366, 768}, ImVec2{1280, 720}, ImVec2{1600, 900}}) {
        Desk desk(size, "room");
        const Rect column = desk.layout().matrices;
        for (const char* name : {"matrices/S", "matrices/R"}) {
            const RecordedItem item = desk.ui.find(std::string(name) + "/r3c3");
            EXPECT_GE(item.min.y, column.min.y) << name;
            EXPECT_LE(item.max.y, column.max.y) << name << " is cut at " << size.x;
        }
        const float v = desk.ui.find("matrices/V/r0c0").min.y, s = desk.ui.find("matrices/S/r0c0").min.y,
                    r = desk.ui.find("matrices/R/r0c0").min.y;
        EXPECT_LT(v, s);
        EXPECT_LT(s, r);
    }
}

TEST(MatricesColumn, AFoldedHeadingOpensItsMatrix) {
    Desk desk({1366, 768}, "room");
    ASSERT_FALSE(desk.ui.has("matrices/P/r3c3"));
    desk.ui.click("matrices/open P");
    desk.ui.frames(3);
    const RecordedItem item = desk.ui.find("matrices/P/r3c3");
    EXPECT_LE(item.max.y, desk.layout().matrices.max.y);
}

TEST(SectionLinks, LeadToWhatIsOutOfSightWithOneClick) {
    for (const ImVec2 size : {ImVec2{1366, 768}, ImVec2{1280, 720}, ImVec2{800, 600}}) {
        Desk desk(size);
        if (desk.layout().panel.empty()) continue;
        desk.ui.frames(3);
        const Layout before = desk.layout();
        ASSERT_FALSE(before.sections.empty()) << size.x;
        const RecordedItem hidden = desk.ui.find("shadow/Shadow");
        EXPECT_GT(hidden.max.y, before.panel.max.y) << "is seen at " << size.x << " already";
        desk.ui.click("sections/Shadow and reflection");
        desk.ui.frames(3);
        const RecordedItem shown = desk.ui.find("shadow/Shadow");
        EXPECT_GE(shown.min.y, desk.layout().panel.min.y);
        EXPECT_LE(shown.max.y, desk.layout().panel.max.y);
        EXPECT_EQ(desk.layout().panel.max.y, before.panel.max.y) << "the panel changes its height";
    }
}

TEST(SectionLinks, AreAbsentWhereEverythingIsSeen) {
    Desk desk({1600, 1500});
    desk.ui.frames(3);
    EXPECT_TRUE(desk.layout().sections.empty());
}

}  // namespace
}  // namespace viewing::test
