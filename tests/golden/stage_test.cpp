// Measured texts on stage: after an answer, tables of pixels and of fighting pairs and the explanation of a pixel's
// color fit completely at every projector size; at the smallest size, they also fit before the answer. And the picture
// after an answer is what the answer says. The tests need no reference pictures. tests/ui/lesson_test.cpp tests the
// parts that need no GL.
#include "app/resting_window.h"
#include "gl/gl_test.h"
#include "lesson/lesson.h"
#include "ui/parts/topics.h"

namespace viewing {
namespace {

class StageTablesTest : public testing::GlTest, public ::testing::WithParamInterface<glm::ivec2> {
protected:
    /// Returns the window with a step on stage, at rest, in the size of the test's parameter; null after a failure.
    static std::unique_ptr<RestingWindow> stage_of(const Lesson& lesson, std::size_t step, bool is_revealed) {
        const LoadedState& start = lesson.steps[step].start;
        const Result<Scene> scene = load_scene(start.params.scene, start.base, start.params.coplanar);
        EXPECT_TRUE(scene) << scene.error();
        if (!scene) return nullptr;
        PictureRequest request{.view = PictureView::window, .size_px = GetParam()};
        request.lesson = std::make_shared<LessonPicture>(LessonPicture{lesson, step, is_revealed, true});
        auto window = std::make_unique<RestingWindow>(renderer(), start, *scene);
        const Status rested = window->rest(request);
        EXPECT_TRUE(rested) << rested.error();
        return rested ? std::move(window) : nullptr;
    }
};

TEST_P(StageTablesTest, TablesAndExplanationsFitCompletely) {
    int count = 0;
    for (const LessonFile& file : lessons()) {
        const Result<Lesson> lesson = load_lesson(file.path.string());
        ASSERT_TRUE(lesson) << lesson.error();
        for (std::size_t step = 0; step < lesson->steps.size(); ++step) {
            const LoadedState& start = lesson->steps[step].start;
            const bool is_measured = is_shown(start.params, Topic::pixel) || is_shown(start.params, Topic::fighting) ||
                                     is_shown(start.params, Topic::why);
            if (!is_measured || start.params.view.layout.big != ViewName::none) continue;
            for (const bool revealed : {false, true}) {
                if (!revealed && GetParam().x > 1024) continue;
                const std::unique_ptr<RestingWindow> window = stage_of(*lesson, step, revealed);
                ASSERT_TRUE(window);
                EXPECT_TRUE(window->fits()) << lesson->id << ", step " << step + 1 << (revealed ? ", answered" : "");
                ++count;
            }
        }
    }
    EXPECT_GE(count, 16);
}

/// A short table fills its column: its last row is in the lower half, and a drawing order has the type of sentences.
TEST_P(StageTablesTest, ShortTablesFillTheirColumn) {
    struct Case {
        const char* lesson;
        std::size_t step;
        const char* last;  ///< a number of the last row
        bool is_large;     ///< as large as the sentences
    };
    for (const Case& one : {Case{"who-hides-whom", 2, "4.238", true}, Case{"depth-fighting", 0, "83.48", false}}) {
        SCOPED_TRACE(one.lesson);
        const Result<Lesson> lesson = load_lesson(one.lesson);
        ASSERT_TRUE(lesson) << lesson.error();
        const std::unique_ptr<RestingWindow> window = stage_of(*lesson, one.step, false);
        ASSERT_TRUE(window);
        const Layout layout = window->layout();
        const Rect column = layout.lower_left.empty() ? layout.lower_right : layout.lower_left;
        const std::vector<SeenText> texts = window->texts();
        const auto seen = [&texts](const std::string& part) {
            return std::find_if(texts.begin(), texts.end(),
                                [&](const SeenText& text) { return text.text.find(part) != std::string::npos; });
        };
        const std::string say = lesson->steps[one.step].say.in_english();
        const auto last = seen(one.last), sentence = seen(say.substr(0, say.find(' ', 8)));
        ASSERT_TRUE(last != texts.end() && sentence != texts.end());
        EXPECT_GT(last->baseline_px, 0.5F * (column.min.y + column.max.y));
        EXPECT_TRUE(!one.is_large || last->em_px >= sentence->em_px) << last->em_px;
    }
}

/// The answer to "how far away may z-near be?" holds on every projector: a much smaller z-near gives the same picture.
TEST_P(StageTablesTest, AnsweredNearPlaneCutsNothing) {
    Result<Lesson> lesson = load_lesson("lens");
    ASSERT_TRUE(lesson) << lesson.error();
    constexpr std::size_t step = 5;
    ASSERT_EQ(lesson->steps[step].id, "near");
    Rect camera;
    const auto picture = [&](double near) {
        lesson->steps[step].revealed.projection.near = near;
        const std::unique_ptr<RestingWindow> window = stage_of(*lesson, step, true);
        if (!window) return Image();
        camera = window->layout().camera;
        return window->read();
    };
    const Image answered = picture(lesson->steps[step].revealed.projection.near), nearer = picture(1.0);
    ASSERT_EQ(answered.width, GetParam().x);
    ASSERT_EQ(nearer.width, GetParam().x);
    ASSERT_FALSE(camera.empty());
    int changed = 0;
    for (int y = static_cast<int>(camera.min.y); y < static_cast<int>(camera.max.y); ++y)
        for (int x = static_cast<int>(camera.min.x); x < static_cast<int>(camera.max.x); ++x)
            changed += testing::rgb_at(answered, {x, y}) == testing::rgb_at(nearer, {x, y}) ? 0 : 1;
    EXPECT_EQ(changed, 0) << "pixels of the camera view";
}

/// A sentence about the picture is in front of the lines that explain a pixel.
TEST_P(StageTablesTest, NoLineCrossesASentence) {
    const Result<Lesson> lesson = load_lesson("why-this-pixel");
    ASSERT_TRUE(lesson) << lesson.error();
    const std::unique_ptr<RestingWindow> window = stage_of(*lesson, 1, true);
    ASSERT_TRUE(window);
    const Rect camera = window->layout().camera;
    const Drawing drawing = window->record();
    const auto is_sentence = [&](const Mark& mark) {
        const auto* const line = std::get_if<Line>(&mark.what);
        return line && camera.contains({line->lefts_px.front(), line->baseline_px}) &&
               line->characters.find(U"each face") != std::u32string::npos;
    };
    const auto sentence = std::find_if(drawing.marks.begin(), drawing.marks.end(), is_sentence);
    ASSERT_TRUE(sentence != drawing.marks.end());
    const Line& text = std::get<Line>(sentence->what);
    for (auto above = sentence + 1; above != drawing.marks.end(); ++above) {
        const auto* const shape = std::get_if<Shape>(&above->what);
        if (!shape) continue;
        for (const Ring& ring : shape->rings) {
            glm::vec2 min = ring.front(), max = ring.front();
            for (const glm::vec2& corner : ring) {
                min = glm::min(min, corner);
                max = glm::max(max, corner);
            }
            const bool is_around_view = max.x - min.x > 0.9F * camera.width();
            const bool is_apart = max.x < text.lefts_px.front() || min.x > text.lefts_px.back() ||
                                  max.y < text.baseline_px - text.em_px || min.y > text.baseline_px;
            EXPECT_TRUE(is_around_view || is_apart) << min.x << ", " << min.y << " to " << max.x << ", " << max.y;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Projectors, StageTablesTest, ::testing::Values(glm::ivec2(1024, 768), glm::ivec2(1280, 720)));

}  // namespace
}  // namespace viewing
