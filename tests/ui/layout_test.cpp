// Nothing overlaps and nothing is cut off, at every size, in every theme, preset and view, and with texts 40% longer.
// The tests judge by the drawn letters (letters.h) as well as by the items' rectangles.
#include <map>
#include <ostream>
#include <sstream>

#include "desk.h"
#include "readable.h"
#include "recorded_letters.h"
#include "state/presets.h"
#include "text/catalogue.h"
#include "ui/parts/topics.h"

namespace viewing::test {
namespace {

bool is_picture(const RecordedItem& item) {
    return item.label == "view/camera view" || item.label == "left/observer/observer view" ||
           item.label == "lower/lower view";
}

bool overlap(const RecordedItem& a, const RecordedItem& b) {
    constexpr float touch = 0.51F;  // neighbors share an edge; half pixels are rounded away
    return a.min.x + touch < b.max.x && b.min.x + touch < a.max.x && a.min.y + touch < b.max.y &&
           b.min.y + touch < a.max.y;
}

std::string text_of(const RecordedItem& item) {
    std::ostringstream text;
    text << item.window << ": " << item.label << " (" << item.min.x << ", " << item.min.y << ")–(" << item.max.x << ", "
         << item.max.y << ")";
    return text.str();
}

/// Expects that items do not overlap. Only pictures may have other items over them, such as the labels of handles.
void expect_no_overlap(const std::vector<RecordedItem>& items) {
    for (std::size_t a = 0; a < items.size(); ++a)
        for (std::size_t b = a + 1; b < items.size(); ++b) {
            const bool is_sign = items[a].label.ends_with("/trouble") || items[b].label.ends_with("/trouble");
            if (is_sign) continue;  // at the end of its section's heading
            if (items[a].window != items[b].window || is_picture(items[a]) != is_picture(items[b])) continue;
            EXPECT_FALSE(overlap(items[a], items[b])) << text_of(items[a]) << "\n" << text_of(items[b]);
        }
}

void expect_inside_its_area(const Desk& desk) {
    for (const AreaFacts& area : desk.areas) {
        EXPECT_LE(area.overflow_x, 0.0F) << area.name << " is too narrow for its content";
        const bool scrolls = area.name == "panel" || area.name == "matrices";
        EXPECT_LE(scrolls ? 0.0F : area.overflow_y, 0.0F) << area.name << " is too low for its content";
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

/// States with the most text: long tables, extra controls, trouble messages.
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

enum class Texts { english, longer, korean };

struct Case {
    ImVec2 size;
    double scale;
    Theme theme;
    Texts texts;

    bool operator==(const Case& other) const {
        return size.x == other.size.x && size.y == other.size.y && theme == other.theme && texts == other.texts;
    }
    UiParams looks() const { return {theme, scale, texts == Texts::korean ? Language::ko : Language::en}; }
};
std::ostream& operator<<(std::ostream& out, const Case& shown) {
    return out << shown.size.x << "×" << shown.size.y << ", scale " << shown.scale << ", " << name_of(shown.theme)
               << std::array{"", ", longer texts", ", Korean"}[static_cast<std::size_t>(shown.texts)];
}

/// Tests each size in each theme, about half of them with longer texts, and each size and each theme also in Korean.
const Case cases[] = {
    {{1600, 900}, 1.0, Theme::dark, Texts::english},     {{1600, 900}, 1.0, Theme::light, Texts::longer},
    {{1600, 900}, 1.0, Theme::projector, Texts::longer}, {{1280, 720}, 1.0, Theme::dark, Texts::longer},
    {{1280, 720}, 1.0, Theme::light, Texts::english},    {{1280, 720}, 1.0, Theme::projector, Texts::longer},
    {{800, 600}, 1.0, Theme::dark, Texts::longer},       {{800, 600}, 1.0, Theme::light, Texts::english},
    {{800, 600}, 1.0, Theme::projector, Texts::longer},  {{3840, 2160}, 2.0, Theme::dark, Texts::english},
    {{3840, 2160}, 2.0, Theme::light, Texts::longer},    {{3840, 2160}, 2.0, Theme::projector, Texts::english},
    {{1600, 900}, 1.0, Theme::dark, Texts::korean},      {{1280, 720}, 1.0, Theme::light, Texts::korean},
    {{800, 600}, 1.0, Theme::projector, Texts::korean},  {{3840, 2160}, 2.0, Theme::projector, Texts::korean}};

class LayoutTest : public ::testing::TestWithParam<Case> {
protected:
    LayoutTest() {
        if (GetParam().texts == Texts::longer) speak_pseudo(catalogue());
    }
    ~LayoutTest() override { speak_english(); }

    static void open(Desk& desk, const Params& params) {
        const UiParams looks = desk.params().ui;
        desk.params() = params;
        desk.params().ui = looks;
        desk.settle();
        desk.ui.move_to({-1, -1});
        desk.ui.frames(2);
    }
    /// Checks every `stride`-th preset, from `first` on.
    void expect_readable_presets(std::size_t first, std::size_t stride) {
        Desk desk(GetParam().size);
        desk.params().ui = GetParam().looks();
        desk.apply_looks();
        std::map<std::string, std::string> wrong;
        const std::vector<NamedFile> all = presets();
        for (std::size_t i = first; i < all.size(); i += stride) {
            const Result<LoadedState> state = load_state(all[i].name);
            ASSERT_TRUE(state) << state.error();
            open(desk, state->params);
            for (const std::string& text : unreadable(desk)) wrong.emplace(text, all[i].name);
        }
        for (const auto& [text, preset] : wrong) ADD_FAILURE() << preset << ", " << text;
    }
};

TEST_P(LayoutTest, PresetsAreReadable) {
    const std::size_t place = static_cast<std::size_t>(
        std::find_if(std::begin(cases), std::end(cases), [](const Case& c) { return c == GetParam(); }) -
        std::begin(cases));
    expect_readable_presets(place, std::size(cases));
}

/// Takes a long time; run it manually with --gtest_also_run_disabled_tests.
TEST_P(LayoutTest, DISABLED_EveryPresetIsReadable) {
    expect_readable_presets(0, 1);
}

TEST_P(LayoutTest, EveryViewIsReadable) {
    Desk desk(GetParam().size);
    desk.params().ui = GetParam().looks();
    desk.apply_looks();
    std::map<std::string, std::string> wrong;
    for (std::size_t topic = 1; topic < names_of<Topic>().size(); ++topic) {
        Params params;
        params.follow = Follow{"box", 3};
        params.overrides[0].shadowed_world_from_world[0] = glm::dmat4(2.0);
        if (topic % 2 == 0) params.scene = std::string("coplanar");
        choose_topic(params, topic % 3 == 0 ? Slot::right : Slot::left, static_cast<Topic>(topic));
        open(desk, params);
        for (const std::string& text : unreadable(desk)) wrong.emplace(text, names_of<Topic>()[topic]);
    }
    for (const auto& [text, topic] : wrong) ADD_FAILURE() << topic << ", " << text;
}

TEST_P(LayoutTest, NothingOverlapsAndNothingIsCutOff) {
    Desk desk(GetParam().size);
    desk.params().ui = GetParam().looks();
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
            for (const std::string& text : unreadable(desk)) ADD_FAILURE() << text;
        }
}

INSTANTIATE_TEST_SUITE_P(Sizes, LayoutTest, ::testing::ValuesIn(cases));

// ---- these tests detect cut-off text -------------------------------------------------------------------------------

/// Returns the problems found when a column is narrower by `narrower` pixels and `texts` replace English ones.
std::vector<std::string> found_where(float Arrangement::*column, float narrower,
                                     const std::vector<PoEntry>& texts = {}) {
    speak(texts);
    Desk desk({1600, 1500});
    desk.workbench.arrangement.*column -= narrower;
    desk.ui.frames(4);
    desk.fold_out_all();
    desk.ui.move_to({-1, -1});
    desk.ui.frames(3);
    std::vector<std::string> found = unreadable(desk);
    for (const AreaFacts& area : desk.areas)
        if (area.overflow_x > 0.0F) found.push_back(area.name + " is too narrow");
    speak_english();
    return found;
}

/// Columns tolerate some narrowing. The test narrows a column in steps of 20 pixels until it finds a problem, and
/// expects to find one in the next step, too.
TEST(Layout, AColumnTwentyPixelsTooNarrowIsDetected) {
    for (float Arrangement::*const column : {&Arrangement::panel_width, &Arrangement::matrices_width}) {
        float narrower = 0.0F;
        while (narrower < 300.0F && found_where(column, narrower).empty()) narrower += 20.0F;
        SCOPED_TRACE(narrower);
        EXPECT_GE(narrower, 20.0F) << "at its default width everything fits";
        EXPECT_LT(narrower, 150.0F) << "nothing is detected though the column is nearly gone";
        EXPECT_FALSE(found_where(column, narrower + 20.0F).empty());
    }
}

TEST(Layout, AnOverlongWordIsDetected) {
    const std::string longer(70, 'm');
    for (const char* const word : {"Depth test", "Clear depth", "z-near", "Flip winding", "Show C"}) {
        SCOPED_TRACE(word);
        EXPECT_TRUE(found_where(&Arrangement::panel_width, 0.0F, {{word, word}}).empty());
        EXPECT_FALSE(found_where(&Arrangement::panel_width, 0.0F, {{word, longer}}).empty());
    }
}

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

TEST(Layout, TheTextOfAMaximizedViewGrowsWithIt) {
    Arrangement arrangement;
    EXPECT_EQ(enlargement({3840, 2160}, 1.0F, arrangement), 1.0F) << "nothing is maximized";
    arrangement.maximized = ViewName::lower_left;
    EXPECT_EQ(enlargement({3840, 2160}, 1.0F, arrangement), 1.5F);
    EXPECT_EQ(enlargement({3840, 2160}, 2.0F, arrangement), 1.5F);
    EXPECT_NEAR(enlargement({1280, 720}, 1.0F, arrangement), 1.2F, 1e-6F);
    EXPECT_EQ(enlargement({800, 600}, 1.0F, arrangement), 1.0F) << "the text never shrinks";
    arrangement.bare = true;
    EXPECT_EQ(enlargement({3840, 2160}, 1.0F, arrangement), 1.0F) << "a picture of only the view is not enlarged";
    arrangement.bare = false;
    arrangement.in_lesson = true;
    EXPECT_EQ(enlargement({3840, 2160}, 1.0F, arrangement), 1.0F) << "the next step may not maximize a view";
}

TEST(Layout, OneColumnGivesWayAtEightHundredBySixHundred) {
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

/// On a phone held sideways the views are side by side, and one button cycles through the rest.
TEST(Layout, AShortWindowShowsTheViewsFirstAndAColumnOnRequest) {
    Desk desk({844, 390});
    const auto is_shown = [&](bool panel, bool matrices) {
        desk.ui.frames(3);
        const Layout layout = desk.layout();
        EXPECT_TRUE(layout.is_short);
        EXPECT_FALSE(layout.camera.empty());
        EXPECT_FALSE(layout.lower_left.empty());
        EXPECT_GE(layout.lower_left.min.x, layout.camera.max.x) << "2nd picture";
        EXPECT_EQ(!layout.panel.empty(), panel);
        EXPECT_EQ(!layout.matrices.empty(), matrices);
        desk.ui.move_to({-1, -1});
        desk.ui.frames(2);
        for (const std::string& text : unreadable(desk)) ADD_FAILURE() << text;
    };
    is_shown(false, false);
    desk.click("top/Controls");
    is_shown(true, false);
    desk.click("top/Matrices");
    is_shown(false, true);
    desk.click("top/Views");
    is_shown(false, false);
}

TEST(Layout, EightHundredBySixHundredIsNotShort) {
    Desk desk({800, 600});
    desk.params().ui.theme = Theme::projector;
    desk.apply_looks();
    desk.ui.frames(3);
    EXPECT_FALSE(desk.layout().is_short);
    EXPECT_FALSE(desk.layout().panel.empty());
}

TEST(Layout, DigitsAreNineOrMorePixelsHigh) {
    for (const ImVec2 size : {ImVec2{1366, 768}, ImVec2{1280, 720}, ImVec2{800, 600}})
        for (const char* preset :
             {"opening", "shadow-derivation", "tilted-plane", "depth-fighting", "z-buffer-small"}) {
            Desk desk(size, preset);
            desk.settle();
            std::map<float, std::string> small;
            for (const Letter& letter : letters_of_frame())
                if (letter.character >= '0' && letter.character <= '9' && letter.line_height < 9.0F)
                    small[letter.line_height] += utf8(letter.character);
            for (const auto& [height, digits] : small)
                ADD_FAILURE() << preset << " at " << size.x << ": " << digits.substr(0, 40) << " are " << height
                              << " px";
        }
}

TEST(Layout, InALowWindowADerivationHasTheLowerViewsForItself) {
    for (const ImVec2 size : {ImVec2{1366, 768}, ImVec2{1280, 720}}) {
        Desk desk(size, "shadow-derivation");
        desk.settle();
        EXPECT_TRUE(desk.layout().lower_left.empty());
        EXPECT_EQ(desk.layout().lower_right.width(), desk.layout().camera.width());
    }
    Desk desk({1600, 900}, "shadow-derivation");
    EXPECT_FALSE(desk.layout().lower_left.empty());
}

TEST(Layout, TheLookMenuSetsTheMouse) {
    Desk desk({800, 600});
    desk.click("top/Look");
    desk.ui.frames(3);
    for (const char* label :
         {"right drag/pans", "middle drag/pans", "Dragging keeps the horizon level", "Dragging up looks down"}) {
        ASSERT_TRUE(desk.ui.has(std::string("top/") + label)) << label;
        desk.click(std::string("top/") + label);
    }
    const MouseHabits& mouse = desk.workbench.views.mouse;
    EXPECT_TRUE(mouse.right_pans);
    EXPECT_TRUE(mouse.middle_pans);
    EXPECT_FALSE(mouse.keeps_horizon);
    EXPECT_TRUE(mouse.inverts_y);
}

TEST(Layout, TheLookMenuSetsThemeAndScale) {
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
