// The second picture, which has other settings: it is chosen by one click or by search, named, swapped and removed.
#include "state/file/beside.h"
#include "desk.h"
#include "exercise_desk.h"
#include "ui/views/beside_view.h"
#include "ui/window/search_entries.h"

namespace viewing::test {
namespace {

using Settings = std::vector<std::string>;

class BesidePanel : public UiTest {
protected:
    void SetUp() override {
        const UiParams looks = params.ui;
        params = load_state("mirror-off-the-edge")->params;
        params.ui = looks;
        desk.fold_out_all();
        desk.settle();
    }
    const Settings& set() const { return params.view.beside.set.all; }
};

TEST_F(BesidePanel, TheFixedPictureIsShownBesideTheBrokenOne) {
    ASSERT_FALSE(desk.problems.empty());
    ASSERT_TRUE(ui.has("view/Compare"));
    desk.click("view/Compare");
    desk.settle();
    EXPECT_FALSE(params.reflection.stencil) << "the first picture stays";
    EXPECT_EQ(set(), Settings{"reflection.stencil=true"});
    EXPECT_FALSE(desk.layout().beside.empty());
    EXPECT_TRUE(ui.has("beside/beside view"));
    EXPECT_FALSE(ui.has("view/Compare"));
    EXPECT_EQ(beside_titles(params).camera, "stencil mirror off");
    EXPECT_EQ(beside_titles(params).beside, "stencil mirror on");
    desk.click("beside/Swap");
    EXPECT_TRUE(params.reflection.stencil);
    EXPECT_EQ(set(), Settings{"reflection.stencil=false"});
    desk.click("beside/×");
    EXPECT_EQ(set(), Settings{});
}

TEST_F(BesidePanel, TheStateBeforeTheLastEditAndThePreset) {
    desk.click("beside/The preset");  // the opening state, not the open preset
    desk.settle();
    EXPECT_EQ(beside_params(params).reflection.stencil, Params{}.reflection.stencil);
    desk.undo();
    desk.settle();
    const double near = params.projection.near;
    desk.drag("projection/z-near", 60.0F);
    desk.settle();
    const double edited = params.projection.near;
    ASSERT_NE(edited, near);
    desk.click("beside/Before the last edit");
    desk.settle();
    EXPECT_EQ(params.projection.near, edited);
    EXPECT_EQ(beside_params(params).projection.near, near);
    EXPECT_NE(beside_titles(params).camera, beside_titles(params).beside);
    EXPECT_FALSE(ui.find("beside/Before the last edit").enabled) << "the last edit showed the second picture";
    desk.undo();
    EXPECT_EQ(params.view.beside.shows, Beside::nothing);
}

TEST(BesideTitlesTest, NameOnlyWhatDiffersWithEnoughDigits) {
    Params params;
    params.projection.near = 0.5;
    params.view.beside.shows = Beside::settings;
    params.view.beside.set.all = {"projection.near=0.50000001", "depth.test=true", "light.position=[1,2,3,1]"};
    const BesideTitles titles = beside_titles(params);
    EXPECT_EQ(titles.beside.find("depth"), std::string::npos) << "the same in both";
    EXPECT_NE(titles.beside.find("(1, 2, 3, 1)"), std::string::npos) << titles.beside;
    params.view.beside.set.all = {"projection.near=0.50000001"};
    EXPECT_EQ(beside_titles(params).camera, "z-near 0.5");
    EXPECT_EQ(beside_titles(params).beside, "z-near 0.50000001");
    params.view.beside.set.all = {"projection.near=1", "projection.far=90", "projection.fovy=20", "depth.test=false"};
    EXPECT_EQ(beside_titles(params).beside.substr(0, 6), "fovy 2") << "in the order of the panel";
    EXPECT_NE(beside_titles(params).beside.find("and 2 more"), std::string::npos) << beside_titles(params).beside;
}

TEST(BesideSearch, AValueAfterBesideIsForTheSecondPicture) {
    const std::vector<SearchEntry> entries = search_entries({}, {}, {});
    const auto first = [&](const char* query) {
        const std::vector<SearchEntry> all = found(entries, query);
        const auto* const choice = all.empty() ? nullptr : std::get_if<FieldChoice>(&all.front().choice);
        return choice ? *choice : FieldChoice{};
    };
    EXPECT_EQ(first("beside near 0.0001").setting, "projection.near=0.0001");
    EXPECT_TRUE(first("beside near 0.0001").is_beside);
    EXPECT_TRUE(first("비교 near 0.0001").is_beside);
    EXPECT_FALSE(first("near 0.0001").is_beside);
    EXPECT_NE(first("beside theme dark").setting, "ui.theme=dark") << "the same in both pictures";
}

}  // namespace
}  // namespace viewing::test
