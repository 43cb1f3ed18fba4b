// Nothing jumps: each control stays in place when the user switches an option or follows a point, or when a problem is
// reported, so that the next click lands where the user aimed.
#include <map>

#include "desk.h"

namespace viewing::test {
namespace {

struct Steady : UiTest {
    /// Returns the top of each item in the columns, except the texts that may appear and disappear.
    std::map<std::string, float> tops() const {
        std::map<std::string, float> found;
        for (const RecordedItem& item : desk.recorded()) {
            const bool in_column = item.window == "panel" || item.window == "matrices";
            const bool is_text = item.label.ends_with("/note") || item.label.ends_with("/trouble");
            if (in_column && !is_text) found[item.window + ": " + item.label] = item.min.y;
        }
        return found;
    }
    /// Expects all controls to be at the same height as before.
    void expect_as_before(const std::map<std::string, float>& before, const std::string& what) const {
        const std::map<std::string, float> now = tops();
        for (const auto& [label, top] : before) {
            const auto found = now.find(label);
            if (found == now.end())
                ADD_FAILURE() << what << ": " << label << " is gone";
            else
                EXPECT_FLOAT_EQ(found->second, top) << what << ": " << label;
        }
    }
};

TEST_F(Steady, ControlsStayInPlaceInEveryModeAndWithEveryWarning) {
    ImGui::GetIO().DisplaySize = {1600, 3000};
    desk.settle();
    desk.fold_out_all();
    const std::map<std::string, float> before = tops();
    ASSERT_GT(before.size(), 80U);
    const Params opening = params;
    const std::pair<const char*, void (*)(Params&)> changes[] = {
        {"shadow problem", [](Params& p) { p.shadow.stencil_once = false; }},
        {"light problem",
         [](Params& p) {
             p.lights.front().position = {1, 0, 1, 1};
         }},
        {"no unit normal",
         [](Params& p) {
             p.planes.front().equation = {0, 3, 0, 1};
         }},
        {"a mistake", [](Params& p) { p.slips.camera_as_view = true; }},
        {"orbit", [](Params& p) { p.camera.navigation = Navigation::orbit; }},
        {"missing light", [](Params& p) { p.shadow.style = ShadowStyle::missing_light; }},
        {"lifted", [](Params& p) { p.shadow.offset = ShadowOffset::lift; }},
        {"no shadow", [](Params& p) { p.shadow.enabled = false; }},
        {"no mirror", [](Params& p) { p.reflection.enabled = false; }},
        {"winding", [](Params& p) { p.reflection.flip_winding = false; }},
        {"reversed", [](Params& p) { p.depth.mapping = DepthMapping::reversed; }},
        {"logarithmic", [](Params& p) { p.depth.mapping = DepthMapping::logarithmic; }},
        {"decals by stencil", [](Params& p) { p.depth.decals = DecalMethod::stencil; }},
        {"the mirrored camera", [](Params& p) { p.reflection.mirrored = MirroredThing::camera; }},
        {"beside", [](Params& p) { p.view.beside.shows = Beside::other_depth; }},
        {"coplanar", [](Params& p) { p.scene = std::string("coplanar"); }},
    };
    for (const auto& [what, change] : changes) {
        params = opening;
        change(params);
        desk.settle();
        expect_as_before(before, what);
    }
}

TEST_F(Steady, MatricesStayInPlaceWhenEditedOrFollowingAPoint) {
    std::map<std::string, float> before = tops();
    std::erase_if(before, [](const auto& item) { return item.first.find("Edit") != std::string::npos; });
    const auto expect_while_edited = [&](const std::string& letter) {
        desk.settle();
        std::map<std::string, float> others = before;
        std::erase_if(others, [&](const auto& item) {  // the entries are fields now
            return item.first.find("matrices/" + letter + "/") != std::string::npos;
        });
        expect_as_before(others, letter + " by hand");
    };
    const Params unedited = params;
    params.overrides[0].shadowed_world_from_world[0] = glm::dmat4(2.0);
    expect_while_edited("S");
    params = unedited;
    params.camera_overrides.view_from_world = 12.3 * desk.derived.view_from_world;
    expect_while_edited("V");
    params = unedited;
    params.camera_overrides.clip_from_view = glm::transpose(desk.derived.clip_from_view);
    expect_while_edited("P");
    params = unedited;
    params.follow = Follow{"box", 3};
    desk.settle();
    for (auto& [label, top] : before)
        if (label.find("matrices/S/") != std::string::npos) top = tops()[label];
    expect_as_before(before, "a followed point");
}

/// From step to step, the window's scale and the question's vertical position stay the same.
TEST(SteadyStrip, StaysInPlaceFromStepToStep) {
    for (const LessonFile& file : lessons()) {
        SCOPED_TRACE(file.path.stem().string());
        Desk desk({1366, 768});
        const Result<Lesson> lesson = load_lesson(file.path.string());
        ASSERT_TRUE(lesson) << lesson.error();
        std::map<float, std::string> tops;
        for (std::size_t step = 0; step < lesson->steps.size(); ++step) {
            desk.workbench.guide.begin(*lesson, step, desk.session);
            desk.settle();
            desk.apply_looks();
            desk.ui.frames(3);
            EXPECT_EQ(desk.workbench.widgets.scale, 1.0F) << lesson->steps[step].id;
            tops[desk.ui.find("lesson strip/question").min.y] += " " + lesson->steps[step].id;
        }
        EXPECT_EQ(tops.size(), 1U);
        for (const auto& [top, steps] : tops) EXPECT_LT(top, 600.0F) << "from y = " << top << ":" << steps;
    }
}

/// A step's question, answers and Check button stay in place when hints, explanations or the right answer appear.
TEST(SteadyStrip, StaysInPlaceFromTheQuestionToTheAnswer) {
    struct Window {
        ImVec2 size;
        const char* lesson;
    };
    for (const auto& [size, id] : {Window{{1366, 768}, "similar-triangles"}, Window{{1366, 768}, "fly-and-walk"},
                                   Window{{800, 600}, "similar-triangles"}, Window{{800, 600}, "gl-depth"}}) {
        Desk desk(size);
        const Result<Lesson> lesson = load_lesson(id);
        ASSERT_TRUE(lesson) << lesson.error();
        for (std::size_t step = 0; step < lesson->steps.size(); ++step) {
            SCOPED_TRACE(lesson->steps[step].id + " in " + std::to_string(static_cast<int>(size.x)));
            desk.workbench.guide.begin(*lesson, step, desk.session);
            desk.settle();
            LessonRun& run = *desk.workbench.guide.run();
            const auto tops = [&] {
                std::map<std::string, float> found;
                for (const RecordedItem& item : desk.recorded()) {
                    const bool stays = item.label.starts_with("lesson strip/") &&
                                       (item.label.find("/answers/") != std::string::npos ||
                                        item.label == "lesson strip/Check" || item.label == "lesson strip/question");
                    if (stays) found[item.label] = item.min.y;
                }
                return found;
            };
            const std::map<std::string, float> before = tops();
            const Rect strip = desk.layout().strip;
            ASSERT_FALSE(before.empty());
            const auto expect_as_before = [&](const char* what) {
                desk.ui.frames(3);
                EXPECT_EQ(tops(), before) << what;
                EXPECT_EQ(desk.layout().strip.min.y, strip.min.y) << what;
            };
            while (run.hints_shown() < static_cast<int>(run.step().ask.hints.size())) run.show_hint();
            expect_as_before("all hints");
            for (const WrongAnswer& wrong : run.step().ask.wrong) {
                run.take({.say = wrong.say});
                expect_as_before("a wrong answer");
            }
            run.take({.near = Near::right_parts, .places = {1, 2, 4}, .other_row = 3, .other_light = {1, 4, 2, 1}});
            expect_as_before("an unknown wrong answer");
            desk.workbench.guide.reveal(desk.session);
            desk.workbench.guide.next(desk.session);  // without animation
            desk.settle();
            const bool sorts = run.step().ask.kind == AskKind::order || run.step().ask.kind == AskKind::product;
            const float check = before.contains("lesson strip/Check") ? before.at("lesson strip/Check") : 0.0F;
            if (!sorts)
                expect_as_before("the answer");
            else  // the right answer moves the tiles
                EXPECT_EQ(desk.ui.find("lesson strip/Check").min.y, check);
        }
    }
}

}  // namespace
}  // namespace viewing::test
