// Every preset, every scene and some whole windows against the pictures beside this file. `tests/golden/update` draws
// them anew; look at what changed before they go in. On a difference what was drawn and the difference are left in
// golden-failures/ of the working directory. Read window_test.cpp next.
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <set>

#include "app/picture.h"
#include "gl/gl_test.h"
#include "image/compare.h"
#include "image/png.h"
#include "report/exercise_picture.h"
#include "state/json.h"
#include "state/language.h"

namespace viewing {
namespace {

namespace fs = std::filesystem;

/// 3 levels: as much as makers of processors differ by rounding alone. 0.2 %: pixels on outlines, which the last bit of
/// an edge gives to one side or the other. GALLIUM_OVERRIDE_CPU_CAPS=sse2 draws as an older processor does: at worst 1
/// level off but for a few pixels on text and outlines.
constexpr CompareOptions usual{3, 0.002};

/// Pictures that need looser thresholds, each with its reason.
struct Loosened {
    const char *name, *reason;
    CompareOptions options;
};
constexpr Loosened loosened[] = {
    {"preset-depth-fighting", "the last bit of depth decides which of two fighting surfaces shows", {3, 0.02}},
    {"preset-fighting-decals", "the last bit of depth decides where wall or poster shows (0.6 % with sse2)", {3, 0.02}},
    {"preset-fighting-decals-equal", "the last bit decides where depths are equal (1.4 % with sse2)", {3, 0.04}},
    {"preset-shadow-fights", "the last bit of depth decides where shadow or floor shows (2.8 %)", {3, 0.06}},
};

fs::path references() {
    const char* const tests = std::getenv("TEST_SOURCE_DIR");
    return fs::path(tests ? tests : ".") / "golden";
}

bool is_updating() {
    return std::getenv("VIEWING_UPDATE_GOLDEN") != nullptr;
}

CompareOptions options_for(const std::string& name) {
    for (const Loosened& each : loosened)
        if (name == each.name) return each.options;
    return usual;
}

void write(const fs::path& path, const Image& image) {
    const Status written = write_png(path, image);
    EXPECT_TRUE(written) << written.error();
}

void keep_failure(const std::string& name, const Image& drawn, const Image& reference, const CompareOptions& options) {
    const fs::path folder = "golden-failures";
    fs::create_directories(folder);
    write(folder / (name + ".png"), drawn);
    write(folder / (name + ".diff.png"), diff_picture(drawn, reference, options));
}

/// Compares with the reference of this name, or becomes it.
void check(const std::string& name, const Image& drawn) {
    const fs::path path = references() / (name + ".png");
    if (is_updating()) {
        write(path, drawn);
        return;
    }
    if (!fs::exists(path)) {
        ADD_FAILURE() << "reference missing: " << path.string() << " (tests/golden/update draws it)";
        return;
    }
    const Result<Image> reference = read_png(path);
    ASSERT_TRUE(reference) << reference.error();
    const CompareOptions options = options_for(name);
    const CompareReport report = compare_images(drawn, *reference, options);
    std::cout << name << ": " << sentence(report) << '\n';
    EXPECT_TRUE(report.equal) << name << ": " << sentence(report);
    if (!report.equal) keep_failure(name, drawn, *reference, options);
}

LoadedState state_of_scene(const std::string& name) {
    LoadedState state;
    state.params.scene = name;
    return state;
}

struct WindowCase {
    const char *name, *preset;
    glm::ivec2 size_px;
    Language language = Language::en;
};
constexpr WindowCase windows[] = {
    {"window-opening", "opening", {1600, 900}},
    {"window-small", "opening", {800, 600}},
    {"window-projector", "projector", {1600, 900}},
    {"window-light", "light-theme", {1600, 900}},
    {"window-depth-buffer", "depth-buffer", {1600, 900}},
    {"window-depth-cells", "depth-cells", {1600, 900}},
    {"window-z-buffer-small", "z-buffer-small", {1600, 900}},
    {"window-depth-precision", "depth-precision", {1600, 900}},
    {"window-fighting-map", "fighting-map", {1600, 900}},
    {"window-fighting-divider", "fighting-divider", {1280, 720}},
    {"window-shadow-derivation", "shadow-derivation", {1600, 900}},
    {"window-mirror-derivation", "mirror-derivation", {1600, 900}},
    {"window-lecture-code", "lecture-code", {1600, 900}},
    {"window-observer-rays", "observer-rays", {1600, 900}},
    {"window-passes", "passes", {1280, 720}},
    {"window-mirror-ways", "mirror-ways", {1280, 720}},
    {"window-korean-opening", "opening", {1600, 900}, Language::ko},
    {"window-korean-small", "opening", {800, 600}, Language::ko},
    {"window-korean-fighting-map", "fighting-map", {1600, 900}, Language::ko},
    {"window-korean-bsp-walk", "bsp-walk", {1600, 900}, Language::ko},
    {"window-korean-shadow-derivation", "shadow-derivation", {1600, 900}, Language::ko},
    {"window-korean-mirror-derivation", "mirror-derivation", {1280, 720}, Language::ko},
};

/// A step of a lesson, as a student or as a room sees it.
struct StepCase {
    const char *name, *lesson;
    std::size_t step;
    bool revealed, presents;
    Theme theme = Theme::dark;
    Language language = Language::en;
};
constexpr StepCase steps[] = {
    {"lesson-choice", "view-is-the-inverse", 0, false, false},
    {"lesson-revealed", "view-is-the-inverse", 0, true, false},
    {"lesson-matrix", "mirror-matrix", 1, false, false, Theme::light},
    {"lesson-on-stage", "depth-fighting", 1, true, true, Theme::projector},
    {"lesson-korean", "view-is-the-inverse", 0, true, false, Theme::dark, Language::ko},
    {"lesson-korean-on-stage", "depth-fighting", 1, false, true, Theme::projector, Language::ko},
};

struct ExerciseCase {
    const char *name, *exercise;
    Theme theme = Theme::dark;
    Language language = Language::en;
};
constexpr ExerciseCase exercise_cases[] = {
    {"exercise-matrix", "E16"},
    {"exercise-korean", "E20", Theme::projector, Language::ko},
};

class Golden : public testing::GlTest {
protected:
    /// The tests after it in this process speak English.
    ~Golden() override { EXPECT_TRUE(speak(Language::en)); }

    static Image picture_of(const LoadedState& state, const PictureRequest& request) {
        const Result<Scene> scene = load_scene(state.params.scene, state.base, state.params.coplanar);
        EXPECT_TRUE(scene) << scene.error();
        Result<Image> image = draw_picture(renderer(), state, *scene, request);
        EXPECT_TRUE(image) << image.error();
        return *std::move(image);
    }
    static Image camera_picture_of(const LoadedState& state) {
        return picture_of(state, {PictureView::camera, {480, 270}, 0});
    }
};

TEST_F(Golden, Presets) {
    const std::vector<NamedFile> files = presets();
    ASSERT_FALSE(files.empty()) << "no presets: VIEWING_SANDBOX_ASSETS";
    for (const NamedFile& preset : files) {
        const Result<LoadedState> state = load_state(preset.name);
        ASSERT_TRUE(state) << state.error();
        check("preset-" + preset.name, camera_picture_of(*state));
    }
}

/// Presets that break shadow or mirror, as their own setting mends them: the README's sheet shows both pictures.
TEST_F(Golden, Mended) {
    for (const NamedFile& preset : presets()) {
        if (preset.mended_by.empty()) continue;
        Result<LoadedState> state = load_state(preset.name);
        ASSERT_TRUE(state) << state.error();
        const Image broken = camera_picture_of(*state);
        const Result<Params> mended = apply_settings(state->params, std::vector<std::string>{preset.mended_by});
        ASSERT_TRUE(mended) << mended.error();
        state->params = *mended;
        const Image picture = camera_picture_of(*state);
        check("mended-" + preset.name, picture);
        EXPECT_GT(compare_images(broken, picture, usual).beyond, 40) << preset.name << ": the switch must show";
    }
}

TEST_F(Golden, Scenes) {
    const std::vector<NamedFile> files = scenes();
    ASSERT_FALSE(files.empty()) << "no scenes: VIEWING_SANDBOX_ASSETS";
    for (const NamedFile& scene : files) check("scene-" + scene.name, camera_picture_of(state_of_scene(scene.name)));
}

TEST_F(Golden, Windows) {
    for (const WindowCase& window : windows) {
        Result<LoadedState> state = load_state(window.preset);
        ASSERT_TRUE(state) << state.error();
        state->params.ui.language = window.language;
        check(window.name, picture_of(*state, {PictureView::window, window.size_px, std::nullopt}));
    }
}

TEST_F(Golden, LessonSteps) {
    for (const StepCase& step : steps) {
        Result<Lesson> lesson = load_lesson(step.lesson);
        ASSERT_TRUE(lesson) << lesson.error();
        LoadedState state = lesson->steps.at(step.step).start;
        state.params.ui.theme = step.theme;
        state.params.ui.language = step.language;
        PictureRequest request{PictureView::window, {1280, 720}, std::nullopt};
        request.lesson = std::make_shared<const LessonPicture>(
            LessonPicture{*std::move(lesson), step.step, step.revealed, step.presents, true});
        check(step.name, picture_of(state, request));
    }
}

TEST_F(Golden, Exercises) {
    for (const ExerciseCase& shown : exercise_cases) {
        const HandIn nobody{{}, "viewing-2026", "32201234", {}, {}};
        Result<ExercisePicture> exercise = exercise_picture(nobody, shown.exercise, renderer());
        ASSERT_TRUE(exercise) << exercise.error();
        LoadedState state = exercise->lesson.steps.front().start;
        state.params.ui.theme = shown.theme;
        state.params.ui.language = shown.language;
        PictureRequest request{PictureView::window, {1280, 720}, std::nullopt};
        request.lesson =
            std::make_shared<const LessonPicture>(LessonPicture{std::move(exercise->lesson), 0, false, false, true});
        check(shown.name, picture_of(state, request));
    }
}

TEST_F(Golden, OtherViews) {
    const Result<LoadedState> state = load_state("opening");
    ASSERT_TRUE(state) << state.error();
    check("view-depth", picture_of(*state, {PictureView::depth, {480, 270}, 0}));
    check("view-stencil", picture_of(*state, {PictureView::stencil, {480, 270}, 0}));
    check("view-observer", picture_of(*state, {PictureView::observer, {480, 270}, 0}));
}

TEST(GoldenReferences, EachBelongsToAPicture) {
    std::set<std::string> known = {"view-depth", "view-stencil", "view-observer"};
    for (const NamedFile& preset : presets()) {
        known.insert("preset-" + preset.name);
        if (!preset.mended_by.empty()) known.insert("mended-" + preset.name);
    }
    for (const NamedFile& scene : scenes()) known.insert("scene-" + scene.name);
    for (const WindowCase& window : windows) known.insert(window.name);
    for (const StepCase& step : steps) known.insert(step.name);
    for (const ExerciseCase& shown : exercise_cases) known.insert(shown.name);
    for (const Loosened& each : loosened) EXPECT_TRUE(known.contains(each.name)) << each.name << ": " << each.reason;
    for (const fs::directory_entry& file : fs::directory_iterator(references()))
        if (file.path().extension() == ".png") {
            EXPECT_TRUE(known.contains(file.path().stem().string())) << file.path() << " is nobody's reference";
        }
}

}  // namespace
}  // namespace viewing
