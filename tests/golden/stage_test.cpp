// Measured tables on stage: tables of pixels and of fighting pairs fit completely at projector sizes after each answer,
// and at the smallest size also before it. The test needs no reference pictures. tests/ui/lesson_test.cpp tests the
// parts that need no GL.
#include "app/resting_window.h"
#include "gl/gl_test.h"
#include "lesson/lesson.h"
#include "ui/parts/topics.h"

namespace viewing {
namespace {

class StageTablesTest : public testing::GlTest, public ::testing::WithParamInterface<glm::ivec2> {};

TEST_P(StageTablesTest, TablesOfPixelsAndFightingPairsFitCompletely) {
    int count = 0;
    for (const LessonFile& file : lessons()) {
        const Result<Lesson> lesson = load_lesson(file.path.string());
        ASSERT_TRUE(lesson) << lesson.error();
        for (std::size_t step = 0; step < lesson->steps.size(); ++step) {
            const LoadedState& start = lesson->steps[step].start;
            const bool has_table = is_shown(start.params, Topic::pixel) || is_shown(start.params, Topic::fighting);
            if (!has_table || start.params.view.layout.big != BigView::none) continue;
            const Result<Scene> scene = load_scene(start.params.scene, start.base, start.params.coplanar);
            ASSERT_TRUE(scene) << scene.error();
            for (const bool revealed : {false, true}) {
                if (!revealed && GetParam().x > 1024) continue;
                PictureRequest request{.view = PictureView::window, .size_px = GetParam()};
                request.lesson = std::make_shared<LessonPicture>(LessonPicture{*lesson, step, revealed, true});
                RestingWindow window(renderer(), start, *scene);
                const Status rested = window.rest(request);
                ASSERT_TRUE(rested) << rested.error();
                EXPECT_TRUE(window.fits()) << lesson->id << ", step " << step + 1 << (revealed ? ", answered" : "");
                ++count;
            }
        }
    }
    EXPECT_GE(count, 10);
}

INSTANTIATE_TEST_SUITE_P(Projectors, StageTablesTest, ::testing::Values(glm::ivec2(1024, 768), glm::ivec2(1280, 720)));

}  // namespace
}  // namespace viewing
