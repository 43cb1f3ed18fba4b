// Lessons in the window and on stage: every step is readable at projector sizes, the keys of a clicker do what the
// README says, and covered parts appear nowhere.
#include <gtest/gtest.h>

#include <chrono>
#include <map>
#include <set>
#include <thread>

#include "desk.h"
#include "main_view.h"
#include "readable.h"
#include "recorded_letters.h"
#include "trials.h"
#include "ui/views/lower_view.h"

namespace viewing::test {
namespace {

Lesson lesson_of(const std::string& id) {
    Result<Lesson> lesson = load_lesson(id);
    if (!lesson) throw std::runtime_error(lesson.error());
    return *std::move(lesson);
}

void begin(Desk& desk, const Lesson& lesson, std::size_t step, bool presents) {
    desk.workbench.guide.begin(lesson, step, desk.session);
    if (presents) desk.workbench.presenter.begin();
    desk.settle();
    desk.apply_looks();
    desk.ui.move_to({-1, -1});
    desk.ui.frames(3);
}

void show_answer(Desk& desk) {
    desk.workbench.guide.reveal(desk.session);
    desk.workbench.guide.next(desk.session);  // without animation
    desk.settle();
}

struct Room {
    ImVec2 size;
    Theme theme;
    Language language = Language::en;
};
std::ostream& operator<<(std::ostream& out, const Room& room) {
    return out << room.size.x << "x" << room.size.y << " " << name_of(room.theme) << " " << name_of(room.language);
}
const Room rooms[] = {{{1280, 720}, Theme::dark},
                      {{1920, 1080}, Theme::dark},
                      {{1024, 768}, Theme::dark},
                      {{1280, 720}, Theme::projector},
                      {{1920, 1080}, Theme::projector},
                      {{1024, 768}, Theme::projector},
                      {{1280, 720}, Theme::dark, Language::ko},
                      {{1920, 1080}, Theme::projector, Language::ko},
                      {{1024, 768}, Theme::projector, Language::ko}};

class StageSlowTest : public ::testing::TestWithParam<Room> {
protected:
    /// Checks every `stride`-th step of the lecture from `first` on, before and after its answer.
    static void expect_readable(std::size_t first, std::size_t stride, bool presents) {
        Desk desk(GetParam().size);
        desk.params().ui.theme = GetParam().theme;
        desk.params().ui.language = GetParam().language;
        desk.apply_looks();
        std::map<std::string, std::string> wrong;
        std::size_t count = 0;
        for (const LessonFile& file : lessons()) {
            const Lesson lesson = lesson_of(file.path.string());
            for (std::size_t step = 0; step < lesson.steps.size(); ++step) {
                if (count++ % stride != first) continue;
                begin(desk, lesson, step, presents);
                const std::string name = lesson.id + ", step " + std::to_string(step + 1);
                for (const std::string& text : unreadable(desk)) wrong.emplace(text, name);
                show_answer(desk);
                for (const std::string& text : unreadable(desk)) wrong.emplace(text, name + ", answered");
            }
        }
        for (const auto& [text, step] : wrong) ADD_FAILURE() << step << ", " << text;
    }
    static std::size_t place() {
        return static_cast<std::size_t>(std::find_if(std::begin(rooms), std::end(rooms),
                                                     [](const Room& room) {
                                                         return room.size.x == GetParam().size.x &&
                                                                room.theme == GetParam().theme &&
                                                                room.language == GetParam().language;
                                                     }) -
                                        std::begin(rooms));
    }
};

/// The three rooms of one size share the steps.
TEST_P(StageSlowTest, TheStageIsReadable) {
    expect_readable(place() / 3, 3, true);
}

TEST_P(StageSlowTest, TheWindowIsReadable) {
    expect_readable(place(), std::size(rooms), false);
}

/// Takes a long time; run it manually with --gtest_also_run_disabled_tests.
TEST_P(StageSlowTest, DISABLED_EveryStepIsReadable) {
    expect_readable(0, 1, true);
    expect_readable(0, 1, false);
}

INSTANTIATE_TEST_SUITE_P(Rooms, StageSlowTest, ::testing::ValuesIn(rooms));

/// Short choices share their rows, so that more height remains for the picture; long ones have a row each.
TEST(OnStage, ShortChoicesAreInTwoColumns) {
    struct Case {
        const char* lesson;
        std::size_t step;
        bool are_short;
    };
    Desk desk({1024, 768});
    for (const auto& [lesson, step, are_short] :
         {Case{"view-is-the-inverse", 0, true}, {"view-is-the-inverse", 3, false}, {"why-this-pixel", 0, false}}) {
        begin(desk, lesson_of(lesson), step, true);
        const RecordedItem first = desk.ui.find("lesson strip/answers/choice 1");
        const RecordedItem second = desk.ui.find("lesson strip/answers/choice 2");
        EXPECT_EQ(first.min.y == second.min.y, are_short) << lesson << ", step " << step + 1;
        EXPECT_EQ(first.max.x < second.min.x, are_short) << lesson << ", step " << step + 1;
    }
}

/// Next to the matrices, a followed point is shown with its products by the matrices of the step: no R p while
/// nothing is mirrored, and no S p while there is no shadow.
TEST(OnStage, AFollowedPointShowsTheNumbersOfItsMatrices) {
    Desk desk({1280, 720});
    const auto names = [&] {
        const std::set<std::string> known{"p", "V p", "P V p", "S p", "÷ w", "R p", "foot", "k"};
        std::set<std::string> found;
        for (const RecordedItem& item : desk.recorded())
            if (item.window == "matrices" && known.contains(item.text)) found.insert(item.text);
        return found;
    };
    using Names = std::set<std::string>;
    begin(desk, lesson_of("view-is-the-inverse"), 7, true);
    EXPECT_EQ(names(), (Names{"p", "V p"}));
    begin(desk, lesson_of("similar-triangles"), 4, true);
    show_answer(desk);
    EXPECT_EQ(names(), (Names{"p", "S p", "÷ w"}));
    desk.params().reflection.enabled = true;
    desk.settle();
    EXPECT_EQ(names(), (Names{"p", "S p", "÷ w", "R p", "foot", "k"}));
    desk.params().shadow.enabled = false;
    desk.settle();
    EXPECT_EQ(names(), (Names{"p", "R p", "foot", "k"}));
}

/// Returns the switches in the views and matrices, which should have none. Switches that the step names or offers do
/// not count, nor does the number field of a step bar.
std::vector<std::string> switches(const Desk& desk) {
    const Stage& stage = desk.workbench.stage;
    const auto is_named = [&](const std::string& label) {
        if (label == "matrices/Show C") return std::ranges::count(stage.highlight, "button:show C") > 0;
        const bool is_offered = label.ends_with("/Measure") && !desk.workbench.widgets.offered.empty();
        return is_offered || label.ends_with("/step") || label.ends_with("/triangle") || label.ends_with("/call");
    };
    std::vector<std::string> found;
    for (const RecordedItem& item : desk.recorded()) {
        const bool shows_something = item.window.find("views") != std::string::npos || item.window == "matrices";
        if (item.is_switch && shows_something && !is_named(item.label)) found.push_back(item.label);
    }
    return found;
}

/// Returns whether everything that a step shows is visible. Lists that the lecturer goes through line by line (GL
/// calls, lines of a derivation or of code, an order of polygons with the tests that found it) may scroll as long as
/// the current line is in view.
bool is_all_seen(const Desk& desk) {
    const auto is_list = [&](Topic topic) { return is_shown(desk.session.params, topic); };
    const bool has_list = std::ranges::any_of(std::array{Topic::passes, Topic::lecture_code, Topic::shadow_derivation,
                                                         Topic::mirror_derivation, Topic::order},
                                              is_list);
    return has_list || desk.workbench.widgets.seen_share == 1.0F;
}

/// Returns the views, matrices, controls, and highlighted parts that a step names but the window does not show.
std::vector<std::string> missing_parts(const Desk& desk, const LessonStep& step) {
    std::vector<std::string> missing;
    const Layout layout = desk.layout();
    const LayoutParams& listed = desk.session.params.view.layout;
    const auto require = [&](bool is_there, const std::string& what) {
        if (!is_there) missing.push_back(what);
    };
    const auto& found = desk.workbench.widgets.targets.found;
    const auto is_drawn = [&](const Rect& part) { return !part.empty() && part.max.y <= layout.strip.min.y + 1.0F; };
    const bool is_alone = listed.big != ViewName::none;
    require(is_alone || !step.names_lower_left || is_drawn(layout.lower_left), "the left view");
    require(is_alone || !step.names_lower_right || is_drawn(layout.lower_right), "the right view");
    // The control of view.call is in the view that it steps, not in the panel.
    const bool has_control = listed.controls != std::vector<std::string>{"view.call"};
    require(listed.controls.empty() || !has_control || is_drawn(layout.panel), "the controls");
    for (const std::string& matrix : listed.matrices) {
        if (matrix == "follow" || matrix == "display") continue;
        const auto last = std::ranges::find_if(desk.recorded(), [&](const RecordedItem& item) {
            return item.label == "matrices/" + matrix + "/r3c3" || item.label == "matrices/" + matrix;
        });
        require(last != desk.recorded().end() && last->max.y <= layout.matrices.max.y + 1.0F,
                "all of matrix " + matrix);
    }
    for (const std::string& name : desk.workbench.stage.highlight) {
        if (name.starts_with("column:")) continue;  // GL fills these tables; this desk has no GL
        require(std::ranges::find(found, name, &widgets::Targets::Found::name) != found.end(), name);
    }
    return missing;
}

/// Returns the objects that the plate with a step's controls may hide, that is, the objects with a triangle whose
/// bounding box on screen overlaps the plate.
std::set<std::string> objects_below_plate(const Desk& desk) {
    const Layout layout = desk.layout();
    std::set<std::string> below;
    if (!layout.panel_over_picture) return below;
    const auto is_below = [&](const ImVec2& a, const ImVec2& b, const ImVec2& c) {
        return std::max({a.x, b.x, c.x}) > layout.panel.min.x && std::max({a.y, b.y, c.y}) > layout.panel.min.y &&
               std::min({a.x, b.x, c.x}) < layout.panel.max.x && std::min({a.y, b.y, c.y}) < layout.panel.max.y;
    };
    for (const SceneObject& object : desk.session.scene().objects) {
        if (object.description.name == "planet") continue;  // the planet is the ground
        std::vector<ImVec2> places;
        for (const glm::vec3& position : object.mesh->positions)
            places.push_back(desk.in_camera_view(object.world_from_model * glm::dvec4(position, 1.0)));
        const std::vector<std::uint32_t>& indices = object.mesh->indices;
        for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
            if (is_below(places[indices[i]], places[indices[i + 1]], places[indices[i + 2]]))
                below.insert(object.description.name);
    }
    return below;
}

/// Returns whether a lower view shows lines that need so much height that the lesson's text may give way to them.
bool shows_many_lines(const Params& params) {
    const auto needs = [&](Slot slot) { return lower_view(params, slot).lowest >= 190.0F; };
    return needs(Slot::left) || needs(Slot::right);
}

/// The whole lecture, shared by the three rooms of one size (with VIEWING_LONG_TESTS, whole in each), before and after
/// each answer: everything that a step names is drawn whole and without switches, the main view is large, its objects
/// are not below the controls, and nothing moves when the answer appears. The text begins at the same height in all
/// steps of a lesson, except where a view shows many lines. For a report, records the fraction that the main view
/// occupies.
TEST_P(StageSlowTest, ShowsWholeStepsWithoutSwitches) {
    Desk desk(GetParam().size);
    desk.params().ui.theme = GetParam().theme;
    desk.params().ui.language = GetParam().language;
    desk.apply_looks();
    const bool is_wide = GetParam().size.x > 1.5F * GetParam().size.y;
    const float least_share = is_wide ? 0.44F : 0.38F;
    const std::size_t stride = testing::is_long() ? 1 : 3;
    std::size_t count = 0;
    std::vector<float> shares;
    for (const LessonFile& file : lessons()) {
        const Lesson lesson = lesson_of(file.path.string());
        std::map<std::size_t, float> tops;  // by step
        for (std::size_t step = 0; step < lesson.steps.size(); ++step) {
            if (count++ % stride != place() / 3 % stride) continue;
            begin(desk, lesson, step, true);
            const Layout asked = desk.layout();
            for (const bool is_answered : {false, true}) {
                if (is_answered) show_answer(desk);
                const std::string name =
                    lesson.id + ", step " + std::to_string(step + 1) + (is_answered ? ", answered" : "");
                for (const std::string& text : switches(desk)) ADD_FAILURE() << name << ": " << text;
                for (const std::string& part : missing_parts(desk, lesson.steps[step]))
                    ADD_FAILURE() << name << ": " << part << " is missing";
                for (const std::string& object : objects_below_plate(desk))
                    ADD_FAILURE() << name << ": " << object << " is below the controls";
                EXPECT_TRUE(is_all_seen(desk)) << name << ": " << desk.workbench.widgets.seen_share;
                EXPECT_EQ(asked.panel.min.y, desk.layout().panel.min.y) << name << ": the controls move";
                EXPECT_EQ(asked.strip.min.y, desk.layout().strip.min.y) << name << ": the text moves";
            }
            if (!shows_many_lines(desk.params())) tops[step] = asked.strip.min.y;
            shares.push_back(main_share(asked));
            EXPECT_GE(shares.back(), least_share) << lesson.id << ", step " << step + 1 << ": the main view is small";
        }
        for (const auto& [step, top] : tops)
            EXPECT_EQ(top, tops.begin()->second) << lesson.id << ", step " << step + 1 << ": the text begins elsewhere";
    }
    std::ranges::sort(shares);
    RecordProperty("smallest share of the main view", std::to_string(shares.front()));
    RecordProperty("median share of the main view", std::to_string(shares[shares.size() / 2]));
}

/// On stage, no button switches between the lower views, so both must be visible.
TEST(OnStage, BothLowerViewsAreVisibleOnSquareProjectors) {
    for (const ImVec2 size : {ImVec2(1280, 1024), ImVec2(1400, 1050)}) {
        Desk desk(size);
        begin(desk, lesson_of("depth-fighting"), 4, true);
        EXPECT_FALSE(desk.layout().panel.empty());
        EXPECT_FALSE(desk.layout().lower_left.empty() || desk.layout().lower_right.empty()) << size.x;
        EXPECT_EQ(unreadable(desk), std::vector<std::string>{}) << size.x;
    }
}

TEST(OnStage, TypeIsLargeEnoughForTheBackRow) {
    for (const Room& room : rooms) {
        Desk desk(room.size);
        desk.params().ui.theme = room.theme;
        begin(desk, lesson_of("depth-fighting"), 0, true);
        const widgets::Fonts& fonts = desk.workbench.widgets.fonts;
        EXPECT_GE(fonts.caption->FontSize, std::floor(room.size.y / 36.0F)) << room;
        // A 16-pixel font yields 14-pixel type.
        for (const ImFont* font : {fonts.number, fonts.small_number, fonts.note})
            EXPECT_GE(font->FontSize * 14.0F / 16.0F, std::floor(room.size.y / 48.0F)) << room;
    }
}

/// A resting pointer shows no tooltip, which would cover the stage. A tooltip appears only while the pointer moves over
/// a control.
TEST(OnStage, TooltipsEndWhenThePointerRests) {
    const auto has_tooltip = [](const Desk& desk) {
        return std::ranges::any_of(desk.recorded(),
                                   [](const RecordedItem& item) { return item.label.ends_with("tooltip"); });
    };
    for (const bool presents : {false, true}) {
        Desk desk({1280, 720});
        begin(desk, lesson_of("depth-fighting"), 0, presents);
        desk.ui.hover("projection/z-near");
        for (int frame = 0; frame < 10; ++frame) desk.ui.frame(0.06F);
        EXPECT_TRUE(has_tooltip(desk)) << presents;
        for (int frame = 0; frame < 20; ++frame) desk.ui.frame(0.06F);
        EXPECT_EQ(has_tooltip(desk), !presents) << "after a rest of more than a second";
    }
}

TEST(OnStage, F6CyclesThroughTheThemes) {
    Desk desk({1280, 720});
    begin(desk, lesson_of("lens"), 0, true);
    for (const Theme theme : {Theme::light, Theme::projector, Theme::dark}) {
        desk.press(Key::f6);
        EXPECT_EQ(desk.params().ui.theme, theme);
    }
    EXPECT_FALSE(desk.workbench.guide.departs(desk.session)) << "changing the theme does not count as improvising";
}

TEST(InALesson, UnnamedHandlesAreLockedUntilTheAnswer) {
    Desk desk({1280, 720});
    begin(desk, lesson_of("view-is-the-inverse"), 0, false);
    const auto drag_plane = [&desk] {
        const glm::dvec4 before = desk.params().planes.front().equation;
        const PlanePatch patch = plane_patch(before, desk.params().planes.front().extent);
        desk.drag_from(desk.in_camera_view(patch.center), 0.0F, -30.0F);
        return desk.params().planes.front().equation != before;
    };
    EXPECT_FALSE(drag_plane()) << "the plane is locked while the question is open";
    desk.workbench.guide.return_to_step(desk.session);
    desk.settle();
    desk.hold(Key::ctrl);
    EXPECT_TRUE(drag_plane()) << "with Ctrl";
    desk.let_go(Key::ctrl);
    desk.workbench.guide.return_to_step(desk.session);
    desk.settle();
    show_answer(desk);
    EXPECT_TRUE(drag_plane()) << "after the answer";
    desk.workbench.guide.leave();
    desk.settle();
    EXPECT_TRUE(drag_plane()) << "outside the lesson";
}

TEST(InALesson, HandlesNamedByTheStepMove) {
    Desk desk({1600, 900});
    const Lesson lesson = lesson_of("any-plane-any-light");
    for (std::size_t step = 0; step < lesson.steps.size(); ++step) {
        const std::vector<std::string>& controls = lesson.steps[step].start.params.view.layout.controls;
        if (std::find(controls.begin(), controls.end(), "light.position") == controls.end()) continue;
        begin(desk, lesson, step, false);
        EXPECT_EQ(movable_handle(desk.workbench.views, Handle::light), Handle::light) << step;
        EXPECT_EQ(movable_handle(desk.workbench.views, Handle::near_plane), Handle::none) << step;
        EXPECT_EQ(movable_handle(desk.workbench.views, Handle::camera), Handle::camera) << "flying is never locked";
        return;
    }
    FAIL() << "no step names the light";
}

TEST(OnStage, AClickerNeverSkipsAnAnswer) {
    Desk desk({1280, 720});
    const Lesson lesson = lesson_of("view-is-the-inverse");
    begin(desk, lesson, 0, true);
    Guide& guide = desk.workbench.guide;
    for (std::size_t step = 0; step < lesson.steps.size(); ++step) {
        EXPECT_EQ(guide.run()->index(), step);
        EXPECT_FALSE(guide.run()->is_revealed());
        EXPECT_EQ(desk.params(), lesson.steps[step].start.params) << step;
        desk.press(Key::page_down);
        EXPECT_TRUE(guide.run()->is_revealed());
        desk.press(Key::page_down);  // a second press shows the rest of a slow reveal immediately
        desk.settle();
        if (guide.run()->index() == step) {
            EXPECT_EQ(desk.params(), lesson.steps[step].revealed) << step;
            desk.press(Key::page_down);
        }
        desk.settle();
    }
    EXPECT_TRUE(guide.run()->is_last());
    EXPECT_TRUE(guide.run()->is_revealed());
    EXPECT_TRUE(guide.run()->shows_end());
    desk.press(Key::page_down);
    EXPECT_TRUE(guide.run()->shows_end()) << "nothing follows the end";
    desk.press(Key::page_up);
    desk.settle();
    EXPECT_FALSE(guide.run()->shows_end());
    EXPECT_TRUE(guide.run()->is_revealed()) << "Page Up first returns to the last answer";
    desk.press(Key::page_up);
    desk.settle();
    EXPECT_FALSE(guide.run()->is_revealed()) << "then it returns to the question";
    desk.press(Key::page_up);
    desk.settle();
    EXPECT_EQ(guide.run()->index(), lesson.steps.size() - 2);
}

/// Page Down alone leads through all parts of the lecture, with each question before its answer and a card after each
/// lesson that asks for one. Page Up leads back to the beginning.
TEST(OnStage, AWholeLectureWithOneKey) {
    Desk desk({1280, 720});
    const Lesson lecture = lesson_of("viewing-75");
    begin(desk, lecture, 0, true);
    Guide& guide = desk.workbench.guide;
    guide.moves = false;
    std::vector<std::string> seen, expected;
    for (std::size_t step = 0; step < lecture.steps.size(); ++step) {
        const std::string name = std::to_string(step);
        const Lecture::Part& part = lecture.lecture->parts[lecture.lecture->part_of(step)];
        if (!lecture.steps[step].only_shows()) expected.push_back(name + " asks");
        expected.push_back(name + " shows");
        if (step + 1 == part.first + part.count && !part.end.says.empty()) expected.push_back(name + " ends");
    }
    const auto now = [&] {
        const LessonRun& run = *guide.run();
        return std::to_string(run.index()) + (run.shows_end() ? " ends" : run.is_revealed() ? " shows" : " asks");
    };
    for (int press = 0; press < 300; ++press) {
        if (!seen.empty() && seen.back() == now() && !guide.is_revealing()) break;
        if (seen.empty() || seen.back() != now()) seen.push_back(now());
        desk.press(Key::page_down);
        if (guide.is_revealing()) desk.press(Key::page_down);
    }
    EXPECT_EQ(seen, expected);
    for (int press = 0; press < 300 && now() != "0 shows"; ++press) desk.press(Key::page_up);
    EXPECT_EQ(now(), "0 shows");
}

TEST(LessonEnd, TheCardNamesWhatComesNextAndOpensIt) {
    Desk desk({1280, 720});
    const Lesson lesson = lesson_of("depth-fighting");
    begin(desk, lesson, lesson.steps.size() - 1, false);
    EXPECT_FALSE(desk.ui.has("end/sentence 1"));
    desk.workbench.guide.run()->show_end(true);
    desk.ui.frames(3);
    for (const char* part : {"end/sentence 1", "end/sentence 2", "end/sentence 3", "end/needs", "end/exercise"})
        EXPECT_TRUE(desk.ui.has(part)) << part;
    desk.ui.click("end/Back to the last step");
    EXPECT_FALSE(desk.workbench.guide.run()->shows_end());
    desk.workbench.guide.run()->show_end(true);
    desk.ui.frames(3);
    desk.ui.click("end/next");
    for (int frame = 0; frame < 2000 && desk.workbench.guide.run()->lesson().id == lesson.id; ++frame) desk.ui.frame();
    EXPECT_EQ(desk.workbench.guide.run()->lesson().id, "similar-triangles");
    EXPECT_FALSE(desk.workbench.guide.run()->shows_end());
}

TEST(OnStage, AccidentalKeysDoNothing) {
    Desk desk({1280, 720});
    begin(desk, lesson_of("lens"), 1, true);
    const Params before = desk.params();
    for (const Key key : {Key::f5, Key::escape, Key::escape, Key::f1, Key::f5}) desk.press(key);
    EXPECT_TRUE(desk.workbench.presenter.is_on());
    EXPECT_EQ(desk.workbench.guide.run()->index(), 1U);
    EXPECT_FALSE(desk.workbench.guide.run()->is_revealed());
    EXPECT_EQ(desk.params(), before);
    desk.press_with(Key::shift, Key::escape);
    EXPECT_FALSE(desk.workbench.presenter.is_on());
    EXPECT_TRUE(desk.workbench.guide.is_shown()) << "the lesson continues in the window";
}

TEST(OnStage, WakingABlackScreenDoesNothingElse) {
    Desk desk({1280, 720});
    begin(desk, lesson_of("lens"), 0, true);
    for (const Key key : {Key::period, Key::b, Key::comma}) {
        desk.press(key);
        EXPECT_TRUE(desk.workbench.presenter.takes_mouse());
        desk.press(Key::page_down);
        EXPECT_FALSE(desk.workbench.presenter.takes_mouse());
        EXPECT_FALSE(desk.workbench.guide.run()->is_revealed());
    }
}

TEST(OnStage, HomeRestoresTheStepAsOneUndoStep) {
    Desk desk({1280, 720});
    const Lesson lesson = lesson_of("lens");
    begin(desk, lesson, 0, true);
    desk.params().camera.yaw += 20.0;
    desk.ui.frames(3);
    const Params improvised = desk.params();
    EXPECT_TRUE(desk.workbench.guide.departs(desk.session));
    desk.press(Key::home);
    desk.settle();
    EXPECT_EQ(desk.params(), lesson.steps[0].start.params);
    EXPECT_FALSE(desk.workbench.guide.departs(desk.session));
    desk.session.undo();
    EXPECT_EQ(desk.params(), improvised);
}

TEST(OnStage, HoldingXShowsTheStateBeforeTheAnswer) {
    Desk desk({1280, 720});
    const Lesson lesson = lesson_of("view-is-the-inverse");
    begin(desk, lesson, 0, true);
    show_answer(desk);
    ASSERT_EQ(desk.params(), lesson.steps[0].revealed);
    desk.hold(Key::x);
    desk.ui.frames(2);
    EXPECT_EQ(desk.params(), lesson.steps[0].start.params);
    desk.let_go(Key::x);
    EXPECT_EQ(desk.params(), lesson.steps[0].revealed);
}

TEST(OnStage, TheOverviewJumpsAndBackspaceGoesBack) {
    Desk desk({1280, 720});
    begin(desk, lesson_of("depth-fighting"), 1, true);
    desk.press(Key::o);
    EXPECT_TRUE(desk.workbench.presenter.shows_overview());
    desk.press(Key::six);
    desk.press(Key::enter);
    desk.settle();
    EXPECT_EQ(desk.workbench.guide.run()->index(), 5U);
    desk.press(Key::backspace);
    desk.settle();
    EXPECT_EQ(desk.workbench.guide.run()->index(), 1U);
    desk.press(Key::o);
    desk.press(Key::escape);
    EXPECT_FALSE(desk.workbench.presenter.shows_overview());
}

/// Types "A 80 b60" as keys.
void type_votes(Desk& desk, std::string_view text) {
    for (const char sign : text) {
        if (sign == ' ') desk.press(Key::space);
        if (sign == '0') desk.press(Key::zero);
        if (sign > '0' && sign <= '9') desk.press(static_cast<Key>(static_cast<int>(Key::one) + (sign - '1')));
        constexpr Key letters[] = {Key::a, Key::b, Key::c, Key::d, Key::e};
        if (sign >= 'a' && sign <= 'e') desk.press(letters[sign - 'a']);
    }
}

/// Returns the lines of text that are drawn on top of everything else.
std::vector<std::string> texts_on_top(const Desk& desk) {
    const widgets::Fonts& fonts = desk.workbench.widgets.fonts;
    const Page page{fonts.caption};
    const ImDrawData* data = ImGui::GetDrawData();
    std::vector<std::string> texts;
    for (const Line& line : lines_of(page.letters(*data->CmdLists[data->CmdListsCount - 1])))
        texts.push_back(line.text);
    return texts;
}

/// Returns the lines of texts_on_top(), joined by spaces.
std::string told_on_top(const Desk& desk) {
    std::string told;
    for (const std::string& line : texts_on_top(desk)) told += (told.empty() ? "" : " ") + line;
    return told;
}

bool is_on_top(const Desk& desk, const std::string& text) {
    return std::ranges::count(texts_on_top(desk), text) > 0;
}

TEST(OnStage, DigitsCountRaisedHands) {
    Desk desk({1280, 720});
    begin(desk, lesson_of("view-is-the-inverse"), 0, true);
    const Ballot& ballot = desk.workbench.guide.run()->ballot();
    desk.press(Key::two);
    desk.press(Key::two);
    desk.press(Key::one);
    desk.press(Key::nine);  // no such choice
    EXPECT_EQ(ballot.votes(), (std::vector{1, 2, 0, 0}));
    desk.press_with(Key::shift, Key::two);
    EXPECT_EQ(ballot.votes(), (std::vector{1, 1, 0, 0}));
    desk.undo();
    EXPECT_EQ(ballot.votes(), (std::vector{1, 2, 0, 0}));
}

TEST(OnStage, TypedVotesBecomeSharesBeforeAndAfterTheDiscussion) {
    for (const ImVec2 size : {ImVec2(1920, 1080), ImVec2(1024, 768)}) {
        Desk desk(size);
        begin(desk, lesson_of("view-is-the-inverse"), 0, true);
        const glm::dvec3 eye = desk.params().camera.position;
        desk.press(Key::v);
        EXPECT_TRUE(is_on_top(desk, "Type A 80 B 60, then Enter."));
        type_votes(desk, "a 80 60 b d45");
        EXPECT_TRUE(is_on_top(desk, "185 votes"));  // before Enter
        desk.press(Key::enter);
        const Ballot& ballot = desk.workbench.guide.run()->ballot();
        EXPECT_EQ(ballot.votes(), (std::vector{80, 60, 0, 45}));
        for (const char* text : {"43 % · 80", "33 % · 60", "0 % · 0", "24 % · 45"}) EXPECT_TRUE(is_on_top(desk, text));
        EXPECT_EQ(desk.params().camera.position, eye) << "letters do not move the camera";

        desk.press_with(Key::shift, Key::v);
        type_votes(desk, "a 20 b 160");
        desk.press(Key::enter);
        EXPECT_TRUE(is_on_top(desk, "Before the discussion: 185 votes"));
        EXPECT_TRUE(is_on_top(desk, "After the discussion: 180 votes"));
        EXPECT_TRUE(is_on_top(desk, "43 % · 80"));
        EXPECT_TRUE(is_on_top(desk, "89 % · 160"));
        EXPECT_EQ(unreadable(desk), std::vector<std::string>{});
        EXPECT_GE(desk.workbench.widgets.fonts.caption->FontSize, std::floor(size.y / 30.0F));

        desk.press(Key::page_down);
        desk.settle();
        EXPECT_TRUE(desk.workbench.guide.run()->is_revealed());
        EXPECT_FALSE(is_on_top(desk, "89 % · 160")) << "the answer is not hidden";
        desk.press(Key::v);
        EXPECT_TRUE(is_on_top(desk, "89 % · 160"));
        for (int i = 0; i < 2; ++i) desk.press(Key::page_down);  // ends the reveal, then goes to the next step
        desk.settle();
        ASSERT_EQ(desk.workbench.guide.run()->index(), 1U);
        EXPECT_FALSE(is_on_top(desk, "89 % · 160")) << "the next step has its own votes";
    }
}

TEST(OnStage, AVoteThatCannotBeReadIsExplainedAndATypoTakenBack) {
    Desk desk({1280, 720});
    begin(desk, lesson_of("view-is-the-inverse"), 0, true);
    const Ballot& ballot = desk.workbench.guide.run()->ballot();
    desk.press(Key::v);
    type_votes(desk, "a 8 b 6");
    desk.press(Key::enter);
    desk.press(Key::v);
    type_votes(desk, "e 5");
    desk.press(Key::enter);
    EXPECT_TRUE(is_on_top(desk, "E: the choices are A to D."));
    EXPECT_EQ(ballot.votes(), (std::vector{8, 6, 0, 0}));
    for (int i = 0; i < 3; ++i) desk.press(Key::backspace);
    type_votes(desk, "b 90");
    desk.press(Key::enter);
    EXPECT_EQ(ballot.votes(), (std::vector{8, 90, 0, 0}));
    desk.undo();
    EXPECT_EQ(ballot.votes(), (std::vector{8, 6, 0, 0}));
    desk.press(Key::escape);
    EXPECT_EQ(texts_on_top(desk), std::vector<std::string>{});
    EXPECT_EQ(ballot.votes(), (std::vector{8, 6, 0, 0}));
}

TEST(OnStage, QShowsTheCodeOfTheStepOrSaysHowToSetItsAddress) {
    Desk desk({1920, 1080});
    begin(desk, lesson_of("view-is-the-inverse"), 0, true);
    const double roll = desk.params().camera.roll;
    desk.press(Key::q);
    EXPECT_EQ(told_on_top(desk), "A QR code needs the address of the page: start the program with --base https://…");
    desk.workbench.link_address = "https://cg.example.edu/viewing/";
    desk.ui.frames(1);
    EXPECT_TRUE(is_on_top(desk, "https://cg.example.edu/viewing/#lesson=view-is-the-inverse&step=1"));
    EXPECT_EQ(desk.params().camera.roll, roll);
    EXPECT_EQ(unreadable(desk), std::vector<std::string>{});
    desk.press(Key::escape);
    EXPECT_EQ(texts_on_top(desk), std::vector<std::string>{});

    desk.press(Key::q);
    desk.press(Key::page_down);
    desk.settle();
    EXPECT_EQ(texts_on_top(desk), std::vector<std::string>{}) << "the code does not hide the answer";
    desk.press(Key::page_down);
    desk.params().camera.yaw += 20.0;  // the lecturer improvises
    desk.press(Key::q);
    EXPECT_TRUE(is_on_top(desk, "https://cg.example.edu/viewing/ …")) << "a link to a state is too long to read";
    desk.workbench.link_address = "https://" + std::string(3000, 'a');
    desk.ui.frames(1);
    EXPECT_TRUE(told_on_top(desk).starts_with("The link has 3,")) << told_on_top(desk);
    EXPECT_TRUE(told_on_top(desk).ends_with(" characters; a QR code holds at most 2,953.")) << told_on_top(desk);
}

TEST(LessonStrip, AWrongChoiceIsExplainedAndARightOneIsJudged) {
    Desk desk({1600, 900});
    const Lesson lesson = lesson_of("view-is-the-inverse");
    begin(desk, lesson, 0, false);
    const auto& choices = lesson.steps[0].ask.choices;
    const auto wrong = std::find_if(choices.begin(), choices.end(), [](const LessonChoice& one) { return !one.right; });
    const auto index = wrong - choices.begin();
    desk.click("lesson strip/answers/choice " + std::to_string(index + 1));
    EXPECT_EQ(desk.workbench.guide.run()->answer().items, std::vector{static_cast<int>(index)});
}

TEST(LessonStrip, AProductGrowsBelowItsTiles) {
    for (const ImVec2 size : {ImVec2{1600, 900}, ImVec2{1366, 768}, ImVec2{800, 600}}) {
        SCOPED_TRACE(size.x);
        Desk desk(size);
        const Lesson lesson = lesson_of("fly-and-walk");
        begin(desk, lesson, lesson.steps.size() - 1, false);
        LessonRun& run = *desk.workbench.guide.run();
        ASSERT_FALSE(run.step().ask.factors.empty());
        EXPECT_FALSE(desk.ui.has("lesson strip/product 1")) << "nothing is computed yet";
        const RecordedItem check = desk.ui.find("lesson strip/Check");
        run.products() = {desk.params(), run.shown_items(), std::vector<glm::dmat4>(4, glm::dmat4(-12.345))};
        desk.ui.frames(3);
        EXPECT_EQ(desk.ui.find("lesson strip/Check").min.y, check.min.y);
        ImVec2 before(0.0F, 0.0F);
        for (const char* name : {"product 1", "product 2", "product 3", "product 4"}) {
            ASSERT_TRUE(desk.ui.has("lesson strip/" + std::string(name))) << name;
            const RecordedItem item = desk.ui.find("lesson strip/" + std::string(name));
            EXPECT_TRUE(item.min.x >= before.x || item.min.y >= before.y) << name << " overlaps the one before";
            EXPECT_LE(item.max.y, check.min.y) << name;
            EXPECT_LE(item.max.x, desk.layout().strip.max.x) << name;
            before = item.max;
        }
        EXPECT_FALSE(desk.ui.find("lesson strip/What my matrix does").enabled) << "not before the answer is checked";
    }
}

TEST(InALesson, NoMistakeIsToldWhileAnAnswerMovesTheCamera) {
    Desk desk({1366, 768});
    begin(desk, lesson_of("fly-and-walk"), 2, false);
    desk.workbench.guide.reveal(desk.session);
    const glm::dvec3 before = desk.params().camera.position;
    int frames = 0;
    for (; frames < 300 && desk.workbench.guide.is_revealing(); ++frames) {
        desk.ui.frame();
        for (const Line& line : lines_of(letters_of_frame()))
            ASSERT_EQ(line.text.find("puts the eye"), std::string::npos) << "in frame " << frames;
    }
    EXPECT_GT(frames, 3);
    EXPECT_NE(desk.params().camera.position, before);
}

TEST(LessonStrip, AHintIsOfferedOnlyWhileThereIsOne) {
    Desk desk({1366, 768});
    begin(desk, lesson_of("similar-triangles"), 1, false);
    LessonRun& run = *desk.workbench.guide.run();
    const auto expect_told = [&](const std::string& sentence) {
        desk.ui.frames(3);
        const std::vector<Line> lines = lines_of(letters_of_frame());
        EXPECT_TRUE(std::ranges::any_of(lines, [&](const Line& line) { return line.text == sentence; })) << sentence;
    };
    run.take({});
    expect_told("Not yet. Try again, or ask for a hint.");
    while (run.hints_shown() < static_cast<int>(run.step().ask.hints.size())) run.show_hint();
    expect_told("Not yet. Look at the hints again.");
    run.take({.near = Near::half});
    expect_told("Not yet: this is half the right value.");
}

TEST(LessonStrip, CheckIsReachedAtTwiceTheSize) {
    Desk desk({1366, 768});
    desk.params().ui.scale = 2.0;
    const Lesson lesson = lesson_of("similar-triangles");
    const auto step = std::find_if(lesson.steps.begin(), lesson.steps.end(),
                                   [](const LessonStep& one) { return one.ask.kind == AskKind::matrix; });
    begin(desk, lesson, static_cast<std::size_t>(step - lesson.steps.begin()), false);
    ASSERT_EQ(desk.params().ui.scale, 2.0) << "the person's";
    const Rect strip = desk.layout().strip;
    const auto is_seen = [&] { return desk.ui.find("lesson strip/Check").max.y <= strip.max.y; };
    EXPECT_FALSE(is_seen());
    desk.ui.move_to({strip.min.x + 20.0F, strip.max.y - 20.0F});
    for (int turn = 0; turn < 20 && !is_seen(); ++turn) {
        ImGui::GetIO().MouseWheel = -1.0F;
        desk.ui.frames(2);
    }
    EXPECT_TRUE(is_seen());
    desk.ui.click("lesson strip/Check");
}

TEST(LessonStrip, LeavingAndReturningKeepsTheStep) {
    Desk desk({1600, 900});
    const Lesson lesson = lesson_of("lens");
    begin(desk, lesson, 2, false);
    desk.click("lesson strip/Explore freely");
    EXPECT_FALSE(desk.workbench.guide.is_shown());
    desk.params().camera.yaw += 33.0;
    desk.ui.frames(3);
    desk.click("top/Lesson");
    desk.settle();
    EXPECT_TRUE(desk.workbench.guide.is_shown());
    EXPECT_EQ(desk.params(), lesson.steps[2].start.params);
}

// ---- the first page ----------------------------------------------------------------------------------------------

class FirstPage : public ::testing::TestWithParam<Room> {
protected:
    static void open(Desk& desk) {
        desk.workbench.start_page.open();
        desk.apply_looks();
        desk.ui.move_to({-1, -1});
        desk.ui.frames(4);
    }
};

TEST_P(FirstPage, FitsWithoutScrollingAndIsReadable) {
    Desk desk(GetParam().size);
    desk.params().ui.theme = GetParam().theme;
    desk.params().ui.language = GetParam().language;
    desk.workbench.past.progress["lens"] = {2, {0, 1}};
    desk.workbench.past.last_lesson = "lens";
    open(desk);
    desk.apply_looks();
    desk.ui.frames(3);
    const std::vector<LessonFile> all = lessons();
    for (std::size_t i = 0; i < all.size(); ++i) {
        const RecordedItem card = desk.ui.find("start/card " + std::to_string(i + 1));
        EXPECT_LE(card.max.y, GetParam().size.y) << all[i].id;
        EXPECT_LE(card.max.x, GetParam().size.x) << all[i].id;
    }
    for (const char* group : {"Camera", "Hidden surfaces", "Depth buffer", "Shadow", "Mirror"})
        EXPECT_TRUE(desk.ui.has("start/" + std::string(group))) << group;
    for (const std::string& text : unreadable(desk)) ADD_FAILURE() << text;
}
INSTANTIATE_TEST_SUITE_P(Rooms, FirstPage,
                         ::testing::Values(Room{{1280, 720}, Theme::dark}, Room{{1920, 1080}, Theme::light},
                                           Room{{1280, 720}, Theme::dark, Language::ko},
                                           Room{{1024, 768}, Theme::dark}));

TEST(FirstPageLeads, StartOpensTheFirstLessonAndGoOnTheLastOne) {
    Desk desk({1280, 720});
    const auto wait = [&](const std::string& id) {
        for (int i = 0; i < 2000; ++i) {
            desk.ui.frame();
            std::this_thread::sleep_for(std::chrono::milliseconds(5));  // the file is read in the background
            const LessonRun* run = desk.workbench.guide.run();
            if (run && run->lesson().id == id) return true;
        }
        return false;
    };
    const auto open = [&] {
        desk.workbench.start_page.open();
        desk.ui.frames(4);
    };
    open();
    EXPECT_FALSE(desk.ui.has("start/Go on")) << "no lesson has been started yet";
    desk.ui.click("start/Start");
    ASSERT_TRUE(wait("view-is-the-inverse"));
    EXPECT_FALSE(desk.workbench.presenter.is_on());
    desk.press(Key::page_down);
    desk.press(Key::page_down);
    desk.press(Key::page_down);
    desk.settle();
    const std::size_t reached = desk.workbench.guide.run()->index();
    ASSERT_GE(reached, 1U);
    desk.workbench.guide.close();
    open();
    desk.ui.click("start/Go on");
    ASSERT_TRUE(wait("view-is-the-inverse"));
    EXPECT_EQ(desk.workbench.guide.run()->index(), reached);
    desk.workbench.guide.close();
    std::vector<std::size_t>& done = desk.workbench.past.progress["view-is-the-inverse"].done;
    done.clear();
    for (std::size_t step = 0; step < lesson_of("view-is-the-inverse").steps.size(); ++step) done.push_back(step);
    open();
    desk.ui.click("start/Go on");
    ASSERT_TRUE(wait("view-is-the-inverse"));
    desk.ui.frames(2);
    EXPECT_TRUE(desk.workbench.presenter.shows_overview()) << "a finished lesson opens with its steps";
    desk.workbench.presenter.close_overview();
    desk.workbench.guide.close();
    open();
    desk.ui.click("start/Give a lecture");
    desk.ui.frames(2);
    desk.ui.click("start/card 3");
    ASSERT_TRUE(wait("lens"));
    desk.ui.frames(2);
    EXPECT_TRUE(desk.workbench.presenter.is_on());
    EXPECT_EQ(desk.workbench.guide.run()->index(), 0U);
}

}  // namespace
}  // namespace viewing::test
