// An edit is drawn in the frame whose input makes it: the camera's picture is the snapshot of the edited state, the
// marks over it lie where that state puts them, and the whole window already looks as it does at rest. During a drag,
// each frame is derived and planned once. The test needs no reference pictures.
#include "app/studio.h"
#include "gl/gl_test.h"
#include "topics/hidden/measured/camera_picture.h"
#include "ui/window/theme.h"

// The linker redirects calls from other source files to the functions below (--wrap in CMakeLists.txt).
#define DERIVE "_ZN7viewing6deriveERKNS_6ParamsERKNS_5SceneERKNS_8ViewportE"
#define PLAN "_ZN7viewing4planERKNS_6ParamsERKNS_7DerivedERKNS_14HiddenPicturesE"

namespace viewing {

Derived real_derive(const Params&, const Scene&, const Viewport&) asm("__real_" DERIVE);
Derived counted_derive(const Params&, const Scene&, const Viewport&) asm("__wrap_" DERIVE);
FramePlan real_plan(const Params&, const Derived&, const HiddenPictures&) asm("__real_" PLAN);
FramePlan counted_plan(const Params&, const Derived&, const HiddenPictures&) asm("__wrap_" PLAN);

static int derived_count = 0, planned_count = 0;

Derived counted_derive(const Params& params, const Scene& scene, const Viewport& viewport) {
    ++derived_count;
    return real_derive(params, scene, viewport);
}

FramePlan counted_plan(const Params& params, const Derived& derived, const HiddenPictures& pictures) {
    ++planned_count;
    return real_plan(params, derived, pictures);
}

namespace {

/// A window without a screen, its mouse and its keys.
class SameFrameTest : public testing::GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        const Result<LoadedState> state = load_state("");
        const Result<Scene> scene = load_scene(state->params.scene, state->base, state->params.coplanar);
        studio_ = std::make_unique<Studio>(renderer(), Session(*state, *scene));
        studio_->workbench.widgets.record = true;
        ImGui::GetIO().MousePos = {-1e6F, -1e6F};
        rest();
        studio_->session.frame_all(static_cast<double>(camera().width() / camera().height()));  // shows the light
        rest();
    }
    void TearDown() override {
        studio_.reset();
        GlTest::TearDown();
    }

    Params& params() { return studio_->session.params; }
    Rect camera() const { return layout().camera; }
    Layout layout() const { return studio_->workbench.layout(ImGui::GetIO().DisplaySize, studio_->session); }

    void frame() {
        derived_count = planned_count = 0;
        input_.dt_s = 1.0 / 60.0;
        studio_->frame({.size_px = window_px, .input = input_});
        input_.pressed.clear();
    }
    void rest() {
        for (int i = 0; i < 12; ++i) frame();
    }
    void move_to(ImVec2 place) {
        ImGui::GetIO().MousePos = place;
        frame();
    }
    void press(ImVec2 place, int button = ImGuiMouseButton_Left) {
        move_to(place);
        ImGui::GetIO().MouseDown[button] = true;
        frame();
    }
    void release(int button = ImGuiMouseButton_Left) {
        ImGui::GetIO().MouseDown[button] = false;
        frame();
    }
    ImVec2 middle_of(std::string_view label) const {
        for (const widgets::RecordedItem& item : studio_->workbench.widgets.recorded)
            if (item.label == label) return {0.5F * (item.min.x + item.max.x), 0.5F * (item.min.y + item.max.y)};
        throw std::runtime_error("no widget " + std::string(label));
    }

    Image snapshot() const {
        const Rect rect = camera();
        Result<Image> picture =
            camera_picture(renderer(), studio_->session.params, studio_->session.scene(), rect.size_px());
        if (!picture) throw std::runtime_error(picture.error());
        return *std::move(picture);
    }
    Image in_window(const Rect& rect) const {
        return cropped(studio_->read(), static_cast<int>(rect.min.x), static_cast<int>(rect.min.y),
                       static_cast<int>(rect.max.x), static_cast<int>(rect.max.y));
    }

    /// Expects that the frame shows what this state's snapshot shows, and that further frames change nothing in the
    /// `steady` part of the window. `before` is the snapshot of the state before the edit.
    void expect_its_state(const Image& before, const Rect& steady = {{0.0F, 0.0F}, {1280.0F, 1200.0F}}) {
        const Image after = snapshot(), window = in_window(camera()), whole = in_window(steady);
        EXPECT_EQ(renderer().read(studio_->camera_view()), after);
        int changed = 0, shown = 0;
        for (int y = 0; y < after.height; ++y)
            for (int x = 0; x < after.width; ++x) {
                const auto color = testing::rgb_at(after, {x, y});
                if (testing::worst_channel(color, testing::rgb_at(before, {x, y})) < 20) continue;
                ++changed;
                shown += testing::rgb_at(window, {x, y}) == color ? 1 : 0;
            }
        EXPECT_GT(changed, 100) << "the edit changes too little";
        EXPECT_GT(shown, 0.8 * changed) << "the overlay hides the others";
        const Params edited = params();
        frame();
        frame();
        EXPECT_EQ(params(), edited);
        EXPECT_EQ(in_window(steady), whole) << "the interface lags behind";
    }

    /// Returns where a world point lies in a view of the window.
    static ImVec2 place_in(const Rect& rect, const glm::dmat4& clip_from_world, const glm::dvec3& world) {
        const glm::dvec4 clip = clip_from_world * glm::dvec4(world, 1.0);
        return {rect.min.x + rect.width() * static_cast<float>(0.5 + 0.5 * clip.x / clip.w),
                rect.min.y + rect.height() * static_cast<float>(0.5 - 0.5 * clip.y / clip.w)};
    }
    ImVec2 light_in_camera() {
        const Derived derived = derive_for(params(), studio_->session.scene(), camera().size_px());
        return place_in(camera(), derived.clip_from_world, glm::dvec3(params().lights.front().position));
    }
    ImVec2 eye_in_observer() {
        const Rect rect = layout().lower_left;
        const ObserverView observer = derive_observer(params().observer, {rect.size_px()});
        return place_in(rect, observer.clip_from_world, params().camera.position);
    }
    testing::Rgb color_at(ImVec2 place) const {
        return testing::rgb_at(studio_->read(), {static_cast<int>(place.x), static_cast<int>(place.y)});
    }
    static testing::Rgb rgb(ImU32 color) {
        return {static_cast<int>(color >> IM_COL32_R_SHIFT & 0xFF), static_cast<int>(color >> IM_COL32_G_SHIFT & 0xFF),
                static_cast<int>(color >> IM_COL32_B_SHIFT & 0xFF)};
    }
    const widgets::Palette& palette() const { return studio_->workbench.widgets.palette; }

    static constexpr glm::ivec2 window_px{1280, 1200};  // so tall that the panel shows the light without scrolling
    std::unique_ptr<Studio> studio_;
    FrameInput input_;
};

TEST_F(SameFrameTest, ASliderMovesTheShadow) {
    const ImVec2 slider = middle_of("light/position/x");
    press(slider);
    for (int step = 1; step <= 3; ++step) {
        const Image before = snapshot();
        const glm::dvec4 light = params().lights.front().position;
        move_to({slider.x + 12.0F * static_cast<float>(step), slider.y});
        EXPECT_NE(params().lights.front().position, light);
        expect_its_state(before);
    }
}

TEST_F(SameFrameTest, AHandleMovesTheShadowAndStaysOnTheLight) {
    const ImVec2 light = light_in_camera();
    press(light);
    for (int step = 1; step <= 3; ++step) {
        const Image before = snapshot();
        const float by = 12.0F * static_cast<float>(step);
        move_to({light.x + by, light.y + 0.3F * by});
        const ImVec2 now = light_in_camera();
        EXPECT_NEAR(now.x, light.x + by, 0.5F);
        EXPECT_EQ(color_at(now), rgb(palette().light));
        expect_its_state(before);
    }
}

TEST_F(SameFrameTest, TheMouseTurnsTheCamera) {
    const Rect rect = camera();
    const ImVec2 empty{rect.max.x - 30.0F, rect.max.y - 30.0F};
    press(empty);
    for (int step = 1; step <= 3; ++step) {
        const Image before = snapshot();
        move_to({empty.x - 15.0F * static_cast<float>(step), empty.y});
        EXPECT_EQ(color_at(light_in_camera()), rgb(palette().light));
        expect_its_state(before, {{layout().panel.max.x, 0.0F}, {1280.0F, 1200.0F}});  // the panel marks what moves
    }
}

TEST_F(SameFrameTest, AHandleInTheObserversViewMovesTheCamera) {
    params().camera = Params().camera;  // near enough for the observer to see it
    rest();
    const ImVec2 eye = eye_in_observer();
    press(eye);
    for (int step = 1; step <= 3; ++step) {
        const Image before = snapshot();
        move_to({eye.x + 6.0F * static_cast<float>(step), eye.y});
        EXPECT_NEAR(eye_in_observer().x, eye.x + 6.0F * static_cast<float>(step), 0.5F);
        EXPECT_EQ(color_at(eye_in_observer()), rgb(palette().camera));
        expect_its_state(before);
    }
}

TEST_F(SameFrameTest, KeysUndoAndFly) {
    params().lights.front().position.x += 2.0;
    rest();
    const Image moved = snapshot();
    input_.pressed.push_back({Key::z, true, false});
    frame();
    EXPECT_EQ(params().lights, Params().lights);
    expect_its_state(moved);

    input_.down[static_cast<std::size_t>(Key::w)] = true;
    for (int step = 0; step < 5; ++step) {
        frame();
        EXPECT_EQ(renderer().read(studio_->camera_view()), snapshot());
        EXPECT_EQ(color_at(light_in_camera()), rgb(palette().light));
    }
    EXPECT_NE(params().camera.position, Params().camera.position);
}

TEST_F(SameFrameTest, TheNextStepOfALessonIsCoveredAtOnce) {
    const Result<Lesson> lesson = load_lesson(lessons().front().path.string());
    ASSERT_TRUE(lesson) << lesson.error();
    Guide& guide = studio_->workbench.guide;
    const std::vector<std::string>& covered = studio_->workbench.widgets.targets.covered;
    std::size_t count = 0;
    for (std::size_t next = 1; next < lesson->steps.size(); ++next) {
        guide.begin(*lesson, next - 1, studio_->session);
        guide.run()->reveal();
        rest();
        press(middle_of("lesson strip/Next ▸"));
        release();
        ASSERT_EQ(guide.run()->index(), next);
        for (const std::string& part : lesson->steps[next].cover) {
            EXPECT_TRUE(std::find(covered.begin(), covered.end(), part) != covered.end())
                << part << ", step " << next + 1;
            ++count;
        }
        move_to({-1e6F, -1e6F});
        rest();
    }
    EXPECT_GT(count, 3U);
}

TEST_F(SameFrameTest, EachFrameOfADragIsDerivedAndPlannedOnce) {
    params().view.lower_right =
        Topic::from_light;  // unlike the depth buffer's view, derives nothing for a size of its own
    rest();
    EXPECT_EQ(derived_count, 0) << "at rest";
    EXPECT_EQ(planned_count, 0) << "at rest";
    for (const bool by_slider : {true, false}) {
        const ImVec2 from = by_slider ? middle_of("light/position/x") : light_in_camera();
        press(from);
        for (int step = 1; step <= 4; ++step) {
            const glm::dvec4 position = params().lights.front().position;
            move_to({from.x + 9.0F * static_cast<float>(step), from.y});
            EXPECT_NE(params().lights.front().position, position);
            EXPECT_EQ(derived_count, 1);
            EXPECT_EQ(planned_count, 1);
        }
        release();
        rest();
    }
}

}  // namespace
}  // namespace viewing
