// The derivations of shadow and mirror image in the window: when selected as topics, while l_w is dragged, and in every
// special case.
#include <algorithm>

#include "desk.h"
#include "topics/planes/shown/derivation_lines.h"

namespace viewing::test {
namespace {

class DerivationViews : public ::testing::Test {
protected:
    Desk desk{{1600, 1100}, "shadow-derivation"};
    widgets::test::Harness& ui = desk.ui;
    Params& params = desk.session.params;

    void show(Topic topic) {
        params.view.lower_right = topic;
        desk.settle();
    }
    bool says(std::string_view start) const {
        return std::ranges::any_of(desk.recorded(), [&](const RecordedItem& item) {
            return item.label.starts_with("lower/" + std::string(start)) ||
                   (item.label.starts_with("lower/") && item.text.starts_with(start));
        });
    }
};

TEST_F(DerivationViews, AreTopicsOfTheLowerViews) {
    EXPECT_TRUE(says("figure"));
    EXPECT_TRUE(says("s = l + t (p − l)"));
    EXPECT_TRUE(says("t = (n·l + d)/(n·l − n·p)"));
    EXPECT_TRUE(says("t = l_y/(l_y − p_y)")) << "the plane is y = 0";
    EXPECT_TRUE(says("Largest difference between matching entries: 0."));
    desk.choose("lower/topic", "lower/topic/Mirror derivation");
    desk.settle();
    EXPECT_EQ(params.view.lower_right, Topic::mirror_derivation);
    EXPECT_TRUE(says("q′ = q − 2 k n"));
    EXPECT_TRUE(says("R for the xz-plane"));
    params.planes.front().equation = {0.3, 1.0, 0.1, 0.5};
    desk.settle();
    EXPECT_TRUE(says("R for any plane"));
    EXPECT_FALSE(says("R for the xz-plane"));
}

TEST_F(DerivationViews, TheLightSlidesFromPointToParallel) {
    const Params before = params;
    const glm::dvec4 light = params.lights.front().position;
    ASSERT_EQ(light.w, 1.0);
    ui.drag("lower/l_w", -40.0F, 0.0F, 5, 0.95F);
    desk.settle();
    EXPECT_EQ(differing_fields(before, params), (Paths{"light.position"}));
    EXPECT_EQ(glm::dvec3(params.lights.front().position), glm::dvec3(light));
    EXPECT_GT(params.lights.front().position.w, 0.0);
    EXPECT_LT(params.lights.front().position.w, 1.0);
    EXPECT_TRUE(says("l = (x, y, z)/l_w"));
    EXPECT_TRUE(says("only for l_w = 1"));

    ui.drag("lower/l_w", -2000.0F, 0.0F);
    desk.settle();
    EXPECT_EQ(params.lights.front().position, glm::dvec4(glm::dvec3(light), 0.0));
    EXPECT_TRUE(says("s = p + τ l"));
    desk.undo();
    desk.undo();
    EXPECT_EQ(params, before);
}

TEST_F(DerivationViews, ExplainSpecialCases) {
    params.lights.front().position = {1.0, 0.0, 2.0, 1.0};
    desk.settle();
    EXPECT_TRUE(says("The light lies in the plane"));
    EXPECT_TRUE(says("figure"));
    params.lights.front().position = {1.0, 0.2, 2.0, 1.0};
    desk.settle();
    EXPECT_TRUE(says("p is farther from the plane than the light"));
    ASSERT_TRUE(desk.derived.followed);
    params.lights.front().position = glm::dvec4(desk.derived.followed->point_world, 1.0);
    desk.settle();
    EXPECT_TRUE(says("p coincides with the light"));
    params.lights.front().position.x += 2.0;
    desk.settle();
    EXPECT_TRUE(says("The ray is parallel to the plane"));
    params.follow.reset();
    desk.settle();
    EXPECT_TRUE(says("Click an object to follow"));
    params.overrides[0].shadowed_world_from_world[0] = glm::dmat4(1.0);
    desk.settle();
    EXPECT_TRUE(says("S was entered by hand"));
}

/// A light at the world's origin has no direction, so it cannot become parallel.
TEST_F(DerivationViews, ALightAtTheOriginStaysAPointLight) {
    params.planes.front().equation = {0.0, 1.0, 0.0, 2.0};
    params.lights.front().position = {0.0, 0.0, 0.0, 1.0};
    desk.settle();
    ui.drag("lower/l_w", -2000.0F, 0.0F);
    desk.settle();
    EXPECT_GT(params.lights.front().position.w, 0.0);
}

/// The views can be drawn in every state and at every size, and drawing changes no state.
TEST_F(DerivationViews, DrawInEveryStateAndSize) {
    const glm::dvec4 lights[] = {{2.6, 5.2, 2.2, 1}, {2.6, 5.2, 2.2, 0}, {2.6, 5.2, 2.2, 1e-7}, {0, 5, 0, 1},
                                 {0, -5, 0, 0},      {1, 0, 0, 0},       {1e6, 1e6, 1e6, 1},    {0, 0, 0, 1},
                                 {0, 1e-9, 1, 0},    {1.4, 1.3, -0.6, 1}};
    const glm::dvec4 planes[] = {{0, 1, 0, 0}, {0, -3, 0, 1}, {1, 0, 0, 2}, {0.3, 0.2, -0.5, -1e5}};
    for (const ImVec2 size : {ImVec2{1600, 900}, ImVec2{700, 480}, ImVec2{420, 320}}) {
        ImGui::GetIO().DisplaySize = size;
        for (const Topic topic : {Topic::shadow_derivation, Topic::mirror_derivation}) {
            for (const glm::dvec4& light : lights) {
                for (const glm::dvec4& plane : planes) {
                    params.lights.front().position = light;
                    params.planes.front().equation = plane;
                    params.view.lower_left = Topic::observer;
                    params.view.lower_right = topic;
                    const Params before = params;
                    ui.frames(2);
                    EXPECT_EQ(params, before);
                }
            }
        }
    }
}

/// Expects these lines in the view without scrolling, each at least as high as a line with an em of 9 pixels.
void expect_whole(const Desk& desk, const std::vector<DerivationLine>& lines) {
    const Layout layout = desk.layout();
    const Rect view = layout.lower_right.empty() ? layout.lower_left : layout.lower_right;
    for (const DerivationLine& line : lines) {
        std::string label;
        for (const std::string& part : line.parts)
            if (!part.empty()) label += (label.empty() ? "" : " ") + part;
        const auto item = std::ranges::find_if(desk.recorded(), [&](const RecordedItem& one) {
            return one.label == "lower/" + label || (one.label == "lower/note" && one.text == label);
        });
        ASSERT_NE(item, desk.recorded().end()) << label;
        EXPECT_GE(item->min.y, view.min.y) << label;
        EXPECT_LE(item->max.y, view.max.y) << label;
        EXPECT_LE(item->max.x, view.max.x) << label;
        EXPECT_GE(item->max.y - item->min.y, 12.0F) << label << ": an em of 9 is a line of 12";
    }
}

struct LowWindow {
    ImVec2 size;
    Theme theme;
    Language language;

    void open(Desk& desk) const {
        desk.params().ui.theme = theme;
        desk.params().ui.language = language;
        desk.apply_looks();
        desk.settle();
    }
};
std::ostream& operator<<(std::ostream& out, const LowWindow& window) {
    return out << window.size.x << " " << name_of(window.theme) << " " << name_of(window.language);
}

class DerivationInALowWindow : public ::testing::TestWithParam<LowWindow> {};

TEST_P(DerivationInALowWindow, HasAllItsLines) {
    Desk desk(GetParam().size, "shadow-derivation");
    GetParam().open(desk);
    const std::vector<DerivationLine> lines =
        shadow_lines(derive_shadow(desk.derived.chosen_plane().unit_plane, desk.derived.chosen_light(),
                                   desk.derived.followed->point_world),
                     true);
    EXPECT_EQ(step_count(lines), 19);
    expect_whole(desk, lines);
    // Going from step to step moves nothing on the screen.
    const float top = desk.ui.find("lower/s = l + t (p − l)").min.y;
    desk.params().view.derivation_step = 3;
    desk.ui.frames(3);
    EXPECT_EQ(desk.ui.find("lower/s = l + t (p − l)").min.y, top);
}

TEST_P(DerivationInALowWindow, HasAllItsLinesAboveALesson) {
    Desk desk(GetParam().size);
    GetParam().open(desk);
    const auto show = [&](const char* id, std::size_t step) {
        const Result<Lesson> lesson = load_lesson(id);
        ASSERT_TRUE(lesson) << lesson.error();
        desk.workbench.guide.begin(*lesson, step, desk.session);
        desk.workbench.guide.reveal(desk.session);
        desk.workbench.guide.next(desk.session);  // without animation
        desk.settle();
    };
    show("mirror-matrix", 0);
    expect_whole(
        desk, mirror_lines(derive_mirror(desk.derived.chosen_plane().unit_plane, desk.derived.followed->point_world)));
    for (const std::size_t step : {1U, 2U}) {
        SCOPED_TRACE(step);
        show("similar-triangles", step);
        std::vector<DerivationLine> results =
            shadow_lines(derive_shadow(desk.derived.chosen_plane().unit_plane, desk.derived.chosen_light(),
                                       desk.derived.followed->point_world),
                         true);
        std::erase_if(results, [](const DerivationLine& line) { return line.is_step; });
        EXPECT_EQ(results.size(), 6U) << "the results";
        expect_whole(desk, results);
    }
}

INSTANTIATE_TEST_SUITE_P(Sizes, DerivationInALowWindow,
                         ::testing::Values(LowWindow{{1366, 768}, Theme::dark, Language::en},
                                           LowWindow{{1280, 720}, Theme::dark, Language::en},
                                           LowWindow{{1366, 768}, Theme::dark, Language::ko},
                                           LowWindow{{1280, 720}, Theme::dark, Language::ko},
                                           LowWindow{{1366, 768}, Theme::projector, Language::en},
                                           LowWindow{{1280, 720}, Theme::projector, Language::en},
                                           LowWindow{{1366, 768}, Theme::projector, Language::ko},
                                           LowWindow{{1280, 720}, Theme::projector, Language::ko}));

TEST_F(DerivationViews, FillTheWindow) {
    for (const Topic topic : {Topic::shadow_derivation, Topic::mirror_derivation}) {
        show(topic);
        desk.params().view.layout.big = ViewName::lower_right;
        desk.settle();
        const RecordedItem figure = ui.find("lower/figure");
        EXPECT_GT(figure.max.x - figure.min.x, 300.0F);
        EXPECT_GT(figure.max.y - figure.min.y, 300.0F);
    }
}

}  // namespace
}  // namespace viewing::test
