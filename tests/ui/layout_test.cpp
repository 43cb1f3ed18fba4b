// Nothing covers anything else and nothing is cut off, at every size, in every theme, also with texts that are 40 %
// longer.
#include <sstream>
#include <tuple>

#include "desk.h"
#include "text/catalogue.h"

namespace viewing::test {
namespace {

bool is_picture(const RecordedItem& item) {
    return item.label == "view/camera view" || item.label == "left/observer/observer view" ||
           item.label == "lower/lower view";
}

bool overlap(const RecordedItem& a, const RecordedItem& b) {
    constexpr float touch = 0.51F;  // neighbours share an edge; halves of a pixel are rounded away
    return a.min.x + touch < b.max.x && b.min.x + touch < a.max.x && a.min.y + touch < b.max.y &&
           b.min.y + touch < a.max.y;
}

std::string text_of(const RecordedItem& item) {
    std::ostringstream text;
    text << item.window << ": " << item.label << " (" << item.min.x << ", " << item.min.y << ")–(" << item.max.x << ", "
         << item.max.y << ")";
    return text.str();
}

/// Handles' labels stand on a picture; everything else keeps to itself.
void expect_no_overlap(const std::vector<RecordedItem>& items) {
    for (std::size_t a = 0; a < items.size(); ++a)
        for (std::size_t b = a + 1; b < items.size(); ++b) {
            if (items[a].window != items[b].window || is_picture(items[a]) != is_picture(items[b])) continue;
            EXPECT_FALSE(overlap(items[a], items[b])) << text_of(items[a]) << "\n" << text_of(items[b]);
        }
}

void expect_inside_its_area(const Desk& desk) {
    for (const AreaFacts& area : desk.areas) {
        EXPECT_LE(area.overflow_x, 0.0F) << area.name << " is too narrow for what it shows";
        const bool scrolls = area.name == "panel" || area.name == "matrices";
        EXPECT_LE(scrolls ? 0.0F : area.overflow_y, 0.0F) << area.name << " is too low for what it shows";
        for (const RecordedItem& item : desk.recorded()) {
            if (item.window != area.name) continue;
            EXPECT_GE(item.min.x, area.rect.min.x) << text_of(item);
            EXPECT_LE(item.max.x, area.rect.max.x + 0.5F) << text_of(item);
            if (scrolls) continue;
            EXPECT_GE(item.min.y, area.rect.min.y) << text_of(item);
            EXPECT_LE(item.max.y, area.rect.max.y + 0.5F) << text_of(item);
        }
    }
}

/// The wordiest states: long tables, further controls, sentences of trouble.
const std::pair<const char*, void (*)(Params&)> moods[] = {{"opening", [](Params&) {}},
                                                           {"followed point",
                                                            [](Params& params) {
                                                                params.follow = Follow{"box", 3};
                                                                params.view.shows = Shows::depth;
                                                            }},
                                                           {"orbit, orthographic, lift",
                                                            [](Params& params) {
                                                                params.camera.navigation = Navigation::orbit;
                                                                params.projection.type = ProjectionType::orthographic;
                                                                params.shadow.offset = ShadowOffset::lift;
                                                                params.depth.mapping = DepthMapping::logarithmic;
                                                                params.depth.format = DepthFormat::d32f;
                                                                params.camera.position = {-123456.7, 0.0001, -99999.0};
                                                            }},
                                                           {"trouble", [](Params& params) {
                                                                params.lights.front().position = {1.0, 0.0, 1.0, 1.0};
                                                                params.planes.front().equation = {0.0, -1e6, 0.0, 0.0};
                                                                params.slips.camera_as_view = true;
                                                                params.shadow.style = ShadowStyle::missing_light;
                                                                params.cull.enabled = true;
                                                            }}};

using Case = std::tuple<ImVec2, double, Theme>;

class LayoutTest : public ::testing::TestWithParam<std::tuple<Case, bool>> {
protected:
    LayoutTest() {
        if (std::get<bool>(GetParam())) speak_pseudo(catalogue());
    }
    ~LayoutTest() override { speak_english(); }
};

TEST_P(LayoutTest, NothingOverlapsAndNothingIsCutOff) {
    const auto [size, scale, theme] = std::get<Case>(GetParam());
    Desk desk(size);
    desk.params().ui = {theme, scale};
    desk.apply_looks();
    desk.ui.frames(4);
    for (const auto& [name, apply] : moods)
        for (const bool prefers_matrices : {false, true}) {
            SCOPED_TRACE(std::string(name) + (prefers_matrices ? ", matrices first" : ""));
            const UiParams looks = desk.params().ui;
            desk.params() = Params{};
            desk.params().ui = looks;
            apply(desk.params());
            desk.workbench.arrangement.prefers_matrices = prefers_matrices;
            desk.ui.frames(4);
            if (!desk.layout().panel.empty()) desk.fold_out_all();
            desk.ui.move_to({-1, -1});
            desk.ui.frames(3);
            expect_no_overlap(desk.recorded());
            expect_inside_its_area(desk);
        }
}

INSTANTIATE_TEST_SUITE_P(
    Sizes, LayoutTest,
    ::testing::Combine(::testing::Values(Case{{1600, 900}, 1.0, Theme::dark}, Case{{1600, 900}, 1.0, Theme::light},
                                         Case{{1600, 900}, 1.0, Theme::projector}, Case{{1280, 720}, 1.0, Theme::dark},
                                         Case{{1280, 720}, 1.0, Theme::light}, Case{{1280, 720}, 1.0, Theme::projector},
                                         Case{{800, 600}, 1.0, Theme::dark}, Case{{800, 600}, 1.0, Theme::light},
                                         Case{{800, 600}, 1.0, Theme::projector}, Case{{3840, 2160}, 2.0, Theme::dark},
                                         Case{{3840, 2160}, 2.0, Theme::light},
                                         Case{{3840, 2160}, 2.0, Theme::projector}),
                       ::testing::Bool()));

TEST(Layout, AreasNeverOverlapAtAnySize) {
    for (int width = 480; width <= 2400; width += 37)
        for (int height = 360; height <= 1400; height += 53)
            for (const float scale : {0.5F, 1.0F, 1.3F, 2.0F})
                for (const bool prefers_matrices : {false, true}) {
                    Arrangement arrangement;
                    arrangement.prefers_matrices = prefers_matrices;
                    const Layout layout =
                        lay_out({static_cast<float>(width), static_cast<float>(height)}, scale, arrangement);
                    const Rect* rects[] = {&layout.top_bar, &layout.status_bar, &layout.panel,      &layout.matrices,
                                           &layout.camera,  &layout.lower_left, &layout.lower_right};
                    for (std::size_t a = 0; a < std::size(rects); ++a)
                        for (std::size_t b = a + 1; b < std::size(rects); ++b) {
                            const Rect &first = *rects[a], &second = *rects[b];
                            if (first.empty() || second.empty()) continue;
                            const bool apart = first.max.x <= second.min.x || second.max.x <= first.min.x ||
                                               first.max.y <= second.min.y || second.max.y <= first.min.y;
                            EXPECT_TRUE(apart)
                                << width << "×" << height << " at " << scale << ": areas " << a << ", " << b;
                        }
                }
}

TEST(Layout, AtEightHundredBySixHundredOneColumnGivesWay) {
    Desk desk({800, 600});
    EXPECT_FALSE(desk.layout().panel.empty());
    EXPECT_TRUE(desk.layout().matrices.empty());
    desk.click("top/Matrices");
    desk.ui.frames(2);
    EXPECT_TRUE(desk.layout().panel.empty());
    EXPECT_FALSE(desk.layout().matrices.empty());
    desk.click("top/Controls");
    desk.ui.frames(2);
    EXPECT_FALSE(desk.layout().panel.empty());
}

TEST(Layout, TheLookMenuChangesThemeAndScale) {
    Desk desk;
    desk.click("top/Look");
    desk.ui.frames(2);
    desk.ui.click("top/theme/Light");
    EXPECT_EQ(desk.params().ui.theme, Theme::light);
    for (const RecordedItem& item : desk.recorded())
        if (item.label.ends_with("/scale") || item.label.ends_with("/size")) {
            desk.ui.drag(std::string(item.label), 30.0F);
            break;
        }
    EXPECT_NE(desk.params().ui.scale, 1.0);
}

}  // namespace
}  // namespace viewing::test
