// The screen and its snapshot have the same bytes, however often they are drawn. These tests need no reference
// pictures.
#include <chrono>
#include <set>
#include <thread>

#include "app/picture.h"
#include "app/resting_window.h"
#include "app/studio.h"
#include "golden/states.h"
#include "lesson/lesson.h"

namespace viewing {
namespace {

/// The result of driving a window frame by frame until it rests, as the main loop does.
struct Driven {
    Image window, camera;
    int frames = 0;
    bool rests = false;
};

class WindowTest : public testing::PictureTest {
protected:
    static Image snapshot(const LoadedState& state, const PictureRequest& request) {
        Result<Image> image = draw_picture(renderer(), state, scene_of(state), request);
        EXPECT_TRUE(image) << image.error();
        return *std::move(image);
    }
    static Driven drive(const LoadedState& state, glm::ivec2 size_px) {
        Studio studio(renderer(), Session(state, scene_of(state)));
        Driven driven;
        for (; driven.frames < 40 && !driven.rests; ++driven.frames) {
            studio.frame({.size_px = size_px, .input = {}});
            EXPECT_FALSE(studio.session.message.is_error) << studio.session.message.text;
            driven.rests = studio.redraw_in_s() != 0.0;
        }
        driven.window = studio.read();
        driven.camera = renderer().read(studio.camera_view());
        return driven;
    }
};

TEST_F(WindowTest, FramebufferAndSnapshotAreByteEqual) {
    for (const glm::ivec2 size_px : {glm::ivec2(1280, 720), glm::ivec2(800, 600)}) {
        const LoadedState state = state_with({});
        const Driven once = drive(state, size_px), again = drive(state, size_px);
        EXPECT_TRUE(once.rests);
        EXPECT_EQ(once.window, again.window);
        EXPECT_EQ(once.window, snapshot(state, {PictureView::window, size_px, std::nullopt}));
    }
}

TEST_F(WindowTest, ShowsTheSamePictureAsTheCameraSnapshot) {
    for (const char* const setting : {"view.samples=4", "view.samples=0", "view.shows=depth", "view.shows=facing"}) {
        const LoadedState state = state_with({setting});
        const Driven driven = drive(state, {1280, 720});
        const glm::ivec2 size_px(driven.camera.width, driven.camera.height);
        ASSERT_GT(size_px.x, 200) << setting;
        EXPECT_EQ(driven.camera, snapshot(state, {PictureView::camera, size_px, std::nullopt})) << setting;
    }
}

/// The studio's camera view is the picture that F12 writes.
TEST_F(WindowTest, TheCameraPictureMatchesItsStateWithAMaximizedView) {
    const LoadedState state = state_with({"view.layout.big=lower_left"});
    Studio studio(renderer(), Session(state, scene_of(state)));
    const auto expect_its_state = [&](const char* when) {
        SCOPED_TRACE(when);
        const Image shown = renderer().read(studio.camera_view());
        const Result<Params> params = parse_state(studio.shown_state(), "shown");
        ASSERT_TRUE(params) << params.error();
        const LoadedState carried{*params, {}};
        EXPECT_EQ(shown, snapshot(carried, {PictureView::camera, {shown.width, shown.height}, std::nullopt}));
    };
    studio.frame({.size_px = {800, 600}, .input = {}});
    expect_its_state("from the beginning");
    studio.session.params.view.layout.big = ViewName::none;
    studio.frame({.size_px = {800, 600}, .input = {}});
    expect_its_state("on screen");
    studio.session.params.view.layout.big = ViewName::lower_left;
    studio.session.params.camera.yaw += 10.0;
    studio.frame({.size_px = {800, 600}, .input = {}});
    expect_its_state("off screen, and turned");
}

TEST_F(WindowTest, TheCameraPictureMatchesItsStateWithAMovingLight) {
    const LoadedState state = state_with({"animation.light_orbit=true"});
    Studio studio(renderer(), Session(state, scene_of(state)));
    FrameInput input;
    input.dt_s = 0.1;
    for (int frame = 0; frame < 5; ++frame) studio.frame({.size_px = {800, 600}, .shows_time = true, .input = input});
    const Image shown = renderer().read(studio.camera_view());
    const Result<Params> params = parse_state(studio.shown_state(), "shown");
    ASSERT_TRUE(params) << params.error();
    EXPECT_NE(params->lights.front().position, state.params.lights.front().position);
    const LoadedState carried{*params, {}};
    EXPECT_EQ(shown, snapshot(carried, {PictureView::camera, {shown.width, shown.height}, std::nullopt}));
}

/// Runs frames until the coarse meshes are made, and returns the scene with them; null if drawing is fast enough.
const Scene* held(StandIns& stand_ins, const Scene& scene, int version, bool is_slow) {
    for (int frame = 0; frame < 10000; ++frame) {
        stand_ins.follow(scene, version);
        if (const Scene* coarse = stand_ins.choose(true, is_slow)) return coarse;
        if (!is_slow) return nullptr;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return nullptr;
}

TEST_F(WindowTest, DrawsALargeSlowSceneCoarselyWhileHeld) {
    const Scene small = scene_of(state_with({}));
    Scene large = small;
    large.objects.front().mesh = std::make_shared<const Mesh>(sphere_mesh(600, 300));
    ASSERT_GT(large.objects.front().mesh->triangle_count(), 300'000U);
    StandIns stand_ins;
    EXPECT_EQ(held(stand_ins, large, 1, false), nullptr) << "drawing is fast enough";
    const Scene* const coarse = held(stand_ins, large, 1, true);
    ASSERT_TRUE(coarse);
    EXPECT_LT(coarse->objects.front().mesh->triangle_count(), 30'001U);
    EXPECT_GT(coarse->objects.front().mesh->triangle_count(), 5'000U);
    EXPECT_EQ(coarse->objects.back().mesh, large.objects.back().mesh) << "the scene is small";
    EXPECT_NE(stand_ins.sentence().find(" of 358,824 triangles"), std::string::npos) << stand_ins.sentence();
    EXPECT_EQ(stand_ins.choose(false, true), nullptr) << "at rest";
    EXPECT_EQ(stand_ins.choose(true, false), coarse) << "drawing has been slow before";
    EXPECT_EQ(held(stand_ins, large, 2, false), nullptr) << "another scene";
    stand_ins.follow(small, 3);
    EXPECT_EQ(stand_ins.choose(true, true), nullptr) << "nothing is large";
}

TEST_F(WindowTest, RestsAfterItsFrameAndStaysUnchanged) {
    const LoadedState state = state_with({});
    Studio studio(renderer(), Session(state, scene_of(state)));
    const Studio::Surroundings surroundings{.size_px = {1280, 720}, .input = {}};
    const auto draw_frames = [&](int count) {
        for (int frame = 0; frame < count; ++frame) {
            studio.frame(surroundings);
            EXPECT_FALSE(studio.session.message.is_error) << studio.session.message.text;
        }
    };
    draw_frames(12);
    const Image resting = studio.read();
    EXPECT_NE(studio.redraw_in_s(), 0.0);
    draw_frames(5);
    EXPECT_EQ(studio.read(), resting);
}

TEST_F(WindowTest, APresentersClockDelaysNothingElse) {
    const LoadedState state = state_with({});
    Studio studio(renderer(), Session(state, scene_of(state)));
    const Result<Lesson> lesson = load_lesson("view-is-the-inverse");
    ASSERT_TRUE(lesson) << lesson.error();
    studio.workbench.guide.begin(*lesson, 0, studio.session);
    PresenterMode& presenter = studio.workbench.presenter;
    presenter.begin();
    const auto pass = [&](double seconds, std::vector<KeyPress> pressed = {}) {
        FrameInput input;
        input.dt_s = seconds;
        input.pressed = std::move(pressed);
        studio.frame({.size_px = {1280, 720}, .shows_time = true, .input = input});
    };
    for (int second = 0; second < 59; ++second) pass(1.0);
    EXPECT_NEAR(studio.redraw_in_s(), 1.0, 1e-6) << "the notes show the minute";
    pass(1.5);
    EXPECT_NEAR(studio.redraw_in_s(), 59.5, 1e-6);

    pass(0.01, {{Key::t}});
    ASSERT_TRUE(presenter.has_running_clock());
    for (int frame = 0; frame < 10; ++frame) pass(0.01);
    EXPECT_EQ(studio.redraw_in_s(), 0.5);
    studio.session.message = {"saved"};
    studio.session.message.shown_s = 7.75;
    pass(0.01);
    EXPECT_NEAR(studio.redraw_in_s(), 0.25, 0.02) << "the message expires in time";
}

TEST_F(WindowTest, ANarrowStageShowsTheWidthOfAWideOneUnlessItIsAboutTheLens) {
    const auto width_over_distance = [](const LoadedState& state, bool presents) {
        Studio studio(renderer(), Session(state, scene_of(state)));
        if (presents) studio.workbench.presenter.begin();
        for (int frame = 0; frame < 12; ++frame) studio.frame({.size_px = {1024, 768}, .input = {}});
        const glm::dmat4& p = studio.shown().derived.clip_from_view;
        EXPECT_EQ(studio.session.params.projection, state.params.projection) << "the state keeps its lens";
        EXPECT_EQ(studio.shown().before.clip_from_view, p) << "no entry is marked as changed";
        return std::pair(2.0 / p[0][0], p[1][1] / p[0][0]);
    };
    const LoadedState letters = state_with({}, "letters");
    const double wanted = 2.0 * Stage::written_for * std::tan(glm::radians(0.5 * letters.params.projection.fovy));
    const auto [on_stage, aspect] = width_over_distance(letters, true);
    EXPECT_LT(aspect, Stage::written_for);
    EXPECT_NEAR(on_stage, wanted, 1e-9);
    const auto [in_window, its_aspect] = width_over_distance(letters, false);
    EXPECT_NEAR(in_window, wanted / Stage::written_for * its_aspect, 1e-9);
    for (const char* const about : {R"({"controls": ["projection.fovy"]})", R"({"matrices": ["P"]})"}) {
        const LoadedState of_lens = state_with({"view.layout=" + std::string(about)}, "letters");
        const auto [width, lens_aspect] = width_over_distance(of_lens, true);
        EXPECT_NEAR(width, wanted / Stage::written_for * lens_aspect, 1e-9) << about;
    }
}

TEST_F(WindowTest, TheFightingTableCountsThePairsThatANarrowStageShows) {
    const LoadedState state = state_with({}, "depth-fighting");  // the stage shows P, which the preset does not list
    const Scene scene = scene_of(state);
    RestingWindow window(renderer(), state, scene);
    PictureRequest request;
    request.size_px = {1024, 768};
    request.presents = true;
    ASSERT_TRUE(window.rest(request));
    std::size_t counted = 0;
    bool says_angle = false;
    for (const SeenText& seen : window.texts()) {
        EXPECT_NE(seen.text, "–") << "a pair is not in the picture";
        counted += seen.text.ends_with('%') && seen.text.find('/') == std::string::npos ? 1U : 0U;
        says_angle = says_angle || seen.text.starts_with("c = cot(½ · 7");  // 78.6°, instead of the state's 40°
    }
    EXPECT_EQ(counted, 12U) << "a prediction and a count for each of six pairs";
    EXPECT_TRUE(says_angle);
}

/// The cost chart is redrawn for its file while the window continues unchanged.
TEST_F(WindowTest, WritesAPrintableCostChart) {
    const LoadedState state = state_with({"view.lower_left=growth"});
    Studio studio(renderer(), Session(state, scene_of(state)));
    GrowthViewState& growth = studio.workbench.views.hidden.growth;
    for (const int polygons : {10, 100, 1000})
        growth.rows[0].push_back({.method = GrowthMethod::z_buffer,
                                  .polygons = polygons,
                                  .time_ms = 0.1 * polygons,
                                  .operations = polygons});
    const Studio::Surroundings surroundings{.size_px = {800, 600}, .input = {}};
    for (int frame = 0; frame < 12; ++frame) studio.frame(surroundings);
    const Image before = studio.read();
    const Result<Image> chart = draw_growth_chart(renderer(), studio.session, growth);
    ASSERT_TRUE(chart) << chart.error();
    EXPECT_GE(chart->width, 1600);
    EXPECT_GE(chart->height, 700);
    std::set<std::uint32_t> colors;
    for (int y = 0; y < chart->height; ++y)
        for (int x = 0; x < chart->width; ++x) {
            const std::uint8_t* at = chart->pixel(x, y);
            colors.insert(at[0] | at[1] << 8 | at[2] << 16);
        }
    EXPECT_GT(colors.size(), 20U) << "axes, a curve and words";
    for (int frame = 0; frame < 3; ++frame) studio.frame(surroundings);
    EXPECT_EQ(studio.read(), before);
}

class WindowSlowTest : public WindowTest {};

TEST_F(WindowSlowTest, IsReproducibleAtFourTimesThePixels) {
    const LoadedState state = state_with({"ui.scale=2"});
    const PictureRequest request{PictureView::window, {3840, 2160}, std::nullopt};
    const Image picture = snapshot(state, request);
    ASSERT_EQ(picture.width, 3840);
    ASSERT_EQ(picture.height, 2160);
    EXPECT_EQ(snapshot(state, request), picture);
    EXPECT_GT(testing::pixels_beyond(picture, snapshot(state_with({"ui.scale=2", "ui.theme=light"}), request), 20),
              3840 * 2160 / 4);
}

TEST_F(WindowTest, EveryViewOfASnapshotIsReproducible) {
    for (const PictureView view :
         {PictureView::window, PictureView::camera, PictureView::depth, PictureView::stencil, PictureView::observer}) {
        const LoadedState state = state_with({});
        const PictureRequest request{view, {640, 480}, std::nullopt};
        EXPECT_EQ(snapshot(state, request), snapshot(state, request)) << static_cast<int>(view);
    }
}

}  // namespace
}  // namespace viewing
