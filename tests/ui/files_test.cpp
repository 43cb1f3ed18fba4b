// Reading and writing states and scenes: clipboard, presets, dialogs, dropped files, and loading a large mesh.
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include "desk.h"
#include "trials.h"
#include "ui/window/clipboard.h"

namespace viewing::test {
namespace {

namespace fs = std::filesystem;

/// Works in its own folder, where the dialogs open.
class FilesTest : public ::testing::Test {
protected:
    FilesTest() {
        start_ = fs::current_path();
        folder_ = fs::temp_directory_path() /
                  ("viewing-files-" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()) +
                   "-" + std::to_string(getpid()));
        fs::create_directories(folder_);
        fs::current_path(folder_);
    }
    ~FilesTest() override {
        fs::current_path(start_);
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
    void write(const char* name, const std::string& text) { std::ofstream(folder_ / name) << text; }
    static std::string read(const fs::path& file) {
        std::ostringstream text;
        text << std::ifstream(file).rdbuf();
        return text.str();
    }
    void drop(const char* name) {
        desk.input.dropped_files = {folder_ / name};
        ui.frame();
    }
    /// Writes an OBJ file with 2 · side² triangles.
    void write_grid(const char* name, int side) {
        std::ofstream file(folder_ / name);
        for (int y = 0; y <= side; ++y)
            for (int x = 0; x <= side; ++x) file << "v " << x << ' ' << (x * y) % 7 << ' ' << y << '\n';
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const int corner = y * (side + 1) + x + 1;
                file << "f " << corner << ' ' << corner + 1 << ' ' << corner + side + 2 << ' ' << corner + side + 1
                     << '\n';
            }
    }
    std::string trouble() const {
        const RecordedItem* item = ui.try_find("file/trouble");
        return item ? item->text : "";
    }
    /// Opens the scene list, scrolls if needed, and picks an entry.
    void choose_scene(const std::string& name) {
        const std::string label = "top/" + name;
        desk.click("top/scene");
        ui.frames(2);
        const RecordedItem first = ui.find("top/" + scenes().front().name);
        const float lowest = first.min.y + 12.0F * (first.max.y - first.min.y);
        for (float last = 0.0F; ui.find(label).max.y > lowest && ui.find(label).max.y != last;) {
            last = ui.find(label).max.y;
            ui.move_to({first.min.x + 5.0F, first.max.y + 5.0F});
            ImGui::GetIO().MouseWheel = -1.0F;
            ui.frame();
            ImGui::GetIO().MouseWheel = 0.0F;
            ui.frame();
        }
        ui.click(label);
        desk.settle();
    }
    /// Types the preset's name into the list's search field and picks it.
    void choose_preset(const std::string& name) {
        desk.click("top/preset");
        ui.frames(2);
        ui.type(name.c_str());
        ui.frames(2);
        ui.click("top/" + name);
        desk.settle();
    }

    fs::path start_, folder_;
    Desk desk;
    widgets::test::Harness& ui = desk.ui;
    Params& params = desk.session.params;
};

TEST_F(FilesTest, CopyAndPasteRestoreTheState) {
    const Params copied = params;
    desk.press_with(Key::ctrl, Key::c);
    const Result<Params> read_back = parse_state(desk.clipboard, "clipboard");
    ASSERT_TRUE(read_back) << read_back.error();
    EXPECT_EQ(*read_back, copied);
    desk.click("depth/Depth test");
    desk.enter("camera/position/y", "9");
    const Params edited = params;
    desk.press_with(Key::ctrl, Key::v);
    EXPECT_EQ(params, copied);
    desk.undo();
    EXPECT_EQ(params, edited);
}

TEST_F(FilesTest, TheFileMenuAlsoCopiesAndPastes) {
    const Params copied = params;
    desk.choose("top/File", "top/Copy state");
    EXPECT_EQ(*parse_state(desk.clipboard, "clipboard"), copied);
    desk.click("depth/Depth test");
    desk.choose("top/File", "top/Paste state");
    EXPECT_EQ(params, copied);
}

TEST_F(FilesTest, LinksGoThroughTheClipboard) {
    desk.click("depth/Depth test");
    desk.enter("camera/position/y", "9");
    const Params copied = params;
    desk.choose("top/File", "top/Copy link");
    EXPECT_TRUE(desk.clipboard.starts_with("viewing-sandbox.html#1")) << desk.clipboard;
    desk.undo();
    params.ui.theme = Theme::light;
    desk.settle();
    desk.clipboard = "https://example.org/" + desk.clipboard + "\n";
    desk.press_with(Key::ctrl, Key::v);
    desk.settle();
    EXPECT_FALSE(desk.session.message.is_error) << desk.session.message.text;
    EXPECT_EQ(differing_fields(params, copied), Paths{"ui.theme"}) << "the looks belong to the user";
    desk.clipboard = "#preset=walkthrough";
    desk.press_with(Key::ctrl, Key::v);
    desk.settle();
    EXPECT_EQ(params.scene, SceneSource("walkthrough"));
    desk.clipboard = "#1abc";
    desk.press_with(Key::ctrl, Key::v);
    EXPECT_TRUE(desk.session.message.is_error && desk.session.message.text.starts_with("link: "));
}

TEST_F(FilesTest, ALessonLinkContinuesFromItsStep) {
    Guide& guide = desk.workbench.guide;
    const auto paste = [&](const std::string& text) {
        desk.clipboard = text;
        desk.press_with(Key::ctrl, Key::v);
        for (int i = 0; i < 1000 && guide.is_reading(); ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            ui.frame();
        }
        desk.settle();
    };
    paste("#lesson=depth-fighting&step=99");
    EXPECT_TRUE(desk.session.message.is_error) << desk.session.message.text;
    EXPECT_FALSE(guide.run());
    desk.session.message = {};
    paste("https://example.org/#lesson=depth-fighting&step=3\n");
    EXPECT_FALSE(desk.session.message.is_error) << desk.session.message.text;
    ASSERT_TRUE(guide.is_shown());
    EXPECT_EQ(guide.run()->lesson().id, "depth-fighting");
    EXPECT_EQ(guide.run()->index(), 2U);
    EXPECT_EQ(params, desk.session.in_own_looks(guide.run()->step().start.params));

    // The link of an untouched step names the step; the link of a changed or answered one holds its current state.
    const auto copied = [&] {
        copy_link(guide, desk.session, link_base());
        return desk.clipboard.substr(0, desk.clipboard.find_first_of("#") + 2);
    };
    EXPECT_EQ(copied(), "viewing-sandbox.html#l");
    EXPECT_EQ(desk.clipboard, "viewing-sandbox.html#lesson=depth-fighting&step=3");
    const double near = params.projection.near;
    params.projection.near = near * 1.5;
    EXPECT_EQ(copied(), "viewing-sandbox.html#1");
    params.projection.near = near;
    EXPECT_EQ(copied(), "viewing-sandbox.html#l");
    guide.leave();
    EXPECT_EQ(copied(), "viewing-sandbox.html#1");
}

TEST_F(FilesTest, PastingJunkChangesNothingAndSaysWhy) {
    const Params before = params;
    for (const char* junk :
         {"", "hello", "{\"projection\": {\"naer\": 1}}", "{\"projection\": {\"near\": -1}}", "[]"}) {
        desk.clipboard = junk;
        desk.session.message = {};
        desk.press_with(Key::ctrl, Key::v);
        EXPECT_TRUE(desk.session.message.is_error) << junk;
        EXPECT_TRUE(desk.session.message.text.starts_with("clipboard")) << desk.session.message.text;
        EXPECT_EQ(params, before) << junk;
    }
    EXPECT_FALSE(desk.session.can_undo());
    ASSERT_TRUE(ui.has("Dismiss"));
    ui.click("Dismiss");
    EXPECT_FALSE(ui.has("Dismiss"));
}

TEST_F(FilesTest, EveryPresetOpensFromTheList) {
    params.ui.theme = Theme::light;
    std::size_t index = 0;
    for (const NamedFile& preset : presets()) {
        if (!testing::takes(index++)) continue;
        SCOPED_TRACE(preset.name);
        choose_preset(preset.name);
        EXPECT_FALSE(desk.session.message.is_error) << desk.session.message.text;
        const Params expected = load_state(preset.name)->params;
        Params shown = params;
        shown.ui = expected.ui;
        EXPECT_EQ(differing_fields(shown, expected), Paths{});
    }
}

TEST_F(FilesTest, EverySceneOpensFromTheList) {
    for (const NamedFile& scene : scenes()) {
        SCOPED_TRACE(scene.name);
        const Params before = params;
        choose_scene(scene.name);
        EXPECT_EQ(params.scene, SceneSource(scene.name));
        EXPECT_FALSE(desk.session.message.is_error) << desk.session.message.text;
        EXPECT_FALSE(desk.session.scene().objects.empty());
        const Paths changed = differing_fields(before, params);
        EXPECT_TRUE(changed.empty() || changed == Paths{"scene"});
    }
}

TEST_F(FilesTest, DialogsSaveAndOpen) {
    desk.enter("projection/z-near", "0.25");
    const Params saved = params;
    desk.press_with(Key::ctrl, Key::s);
    ASSERT_TRUE(ui.has("file/name"));
    ui.type("mine.json");
    ui.click("file/Save");
    desk.settle();
    EXPECT_FALSE(ui.has("file/name"));
    ASSERT_TRUE(fs::exists(folder_ / "mine.json"));
    EXPECT_EQ(*parse_state(read(folder_ / "mine.json"), "mine.json"), saved);

    desk.choose("top/File", "top/Reset all");
    ASSERT_NE(params, saved);
    desk.press_with(Key::ctrl, Key::o);
    ui.type("mine.json");
    ui.key(ImGuiKey_Enter);
    desk.settle();
    EXPECT_FALSE(ui.has("file/name"));
    EXPECT_EQ(params, saved);

    desk.choose("top/File", "top/Reset all");
    desk.choose("top/File", "top/Open…");
    ui.frames(2);
    ui.double_click("file/mine.json");
    desk.settle();
    EXPECT_EQ(params, saved);
}

TEST_F(FilesTest, EnterConfirmsReplacingAFile) {
    write("mine.json", "old");
    desk.press_with(Key::ctrl, Key::s);
    ui.type("mine.json");
    ui.key(ImGuiKey_Enter);
    EXPECT_NE(trouble().find("save again"), std::string::npos);
    EXPECT_EQ(read(folder_ / "mine.json"), "old");
    ui.key(ImGuiKey_Enter);
    desk.settle();
    EXPECT_FALSE(ui.has("file/name"));
    EXPECT_EQ(*parse_state(read(folder_ / "mine.json"), "mine.json"), params);
}

TEST_F(FilesTest, ADialogReportsErrorsAndStaysOpen) {
    write("broken.json", "{\"projection\": {\"near\": 0}}");
    const Params before = params;
    desk.press_with(Key::ctrl, Key::s);
    ui.type("no-such-folder/mine.json");
    ui.click("file/Save");
    desk.settle();
    EXPECT_NE(trouble().find("cannot be written"), std::string::npos) << trouble();
    ui.click("file/Cancel");
    EXPECT_FALSE(ui.has("file/name"));

    desk.press_with(Key::ctrl, Key::o);
    EXPECT_EQ(trouble(), "");
    ui.double_click("file/broken.json");
    desk.settle();
    EXPECT_NE(trouble().find("projection.near"), std::string::npos) << trouble();
    desk.press(Key::escape);
    ui.frames(2);
    EXPECT_FALSE(ui.has("file/name"));
    EXPECT_EQ(params, before);
}

TEST_F(FilesTest, KeysDoNothingWhileADialogIsOpen) {
    params.follow = Follow{"box", 0};
    desk.settle();
    const Params before = params;
    desk.press_with(Key::ctrl, Key::o);
    write("one.json", "{}");
    for (const auto& [key, letter] : {std::pair{Key::w, 'w'}, {Key::n, 'n'}, {Key::m, 'm'}})
        desk.press_letter(key, letter);
    ui.move_to({5, 5});
    ui.press();
    ui.release();  // moves the keyboard focus away from the name field
    for (const Key key : {Key::w, Key::n, Key::b, Key::m}) desk.press(key);
    EXPECT_EQ(params, before);
    EXPECT_EQ(desk.params().view.layout.big, ViewName::none);
    EXPECT_TRUE(desk.workbench.views.handles);
    desk.press(Key::escape);
    EXPECT_FALSE(ui.has("file/name"));
    EXPECT_EQ(params, before);
}

TEST_F(FilesTest, ADroppedMeshIsShownAndCanBeUndone) {
    write("tetrahedron.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
    const Params before = params;
    drop("tetrahedron.obj");
    desk.settle();
    EXPECT_FALSE(desk.session.message.is_error) << desk.session.message.text;
    ASSERT_EQ(desk.session.scene().objects.size(), 1U);
    EXPECT_EQ(desk.session.scene().objects.front().mesh->indices.size(), 12U);
    EXPECT_EQ(differing_fields(before, params), Paths{"scene"});
    desk.undo();
    desk.settle();
    EXPECT_EQ(params, before);
    EXPECT_EQ(desk.session.scene().objects.size(), 3U);
}

TEST_F(FilesTest, ABrokenFileChangesNothingAndSaysWhy) {
    write("broken.obj", "v 0 0 0\nv 1 0 0\nf 1 2 3\n");
    write("empty.obj", "");
    write("broken.json", "{\"camera\": 3}");
    write("no-mesh.json",
          "{\"camera\": {\"yaw\": 3}, \"scene\": {\"objects\": "
          "[{\"name\": \"a\", \"shape\": \"mesh\", \"file\": \"gone.obj\"}]}}");
    const Params before = params;
    for (const char* name : {"broken.obj", "empty.obj", "broken.json", "no-mesh.json", "gone.obj"}) {
        SCOPED_TRACE(name);
        desk.session.message = {};
        drop(name);
        desk.settle();
        EXPECT_TRUE(desk.session.message.is_error);
        EXPECT_NE(desk.session.message.text.find(std::string(name) == "no-mesh.json" ? "gone.obj" : name),
                  std::string::npos)
            << desk.session.message.text;
        EXPECT_EQ(differing_fields(before, params), Paths{});
        EXPECT_EQ(desk.session.scene().objects.size(), 3U);
        EXPECT_FALSE(desk.session.can_undo());
        EXPECT_TRUE(ui.has("Dismiss"));
    }
}

TEST_F(FilesTest, AFileOutsideTheStatesFolderNeedsPermission) {
    fs::create_directories(folder_ / "own");
    fs::create_directories(folder_ / "other");
    write("other/m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    write("own/s.json", R"({"camera": {"yaw": 3}, "scene": {"objects": [)"
                        R"({"name": "m", "shape": "mesh", "file": "../other/m.obj"}]}})");
    const Params before = params;
    const int objects = static_cast<int>(desk.session.scene().objects.size());
    for (const char* answer : {"outside/No", "escape", "outside/Yes, read it"}) {
        SCOPED_TRACE(answer);
        drop("own/s.json");
        desk.settle();
        ASSERT_TRUE(ui.has("outside/Yes, read it"));
        EXPECT_TRUE(ui.has("outside/file"));
        ASSERT_NE(desk.session.asks_to_read(), nullptr);
        EXPECT_EQ(desk.session.asks_to_read()->file, fs::canonical(folder_ / "other/m.obj"));
        desk.press(Key::n);
        EXPECT_EQ(params, before) << "keys have no effect";
        EXPECT_EQ(desk.session.scene().objects.size(), objects);
        if (std::string(answer) == "escape")
            desk.press(Key::escape);
        else
            ui.click(answer);
        desk.settle();
        EXPECT_FALSE(ui.has("outside/Yes, read it"));
        EXPECT_FALSE(desk.session.message.is_error) << desk.session.message.text;
    }
    EXPECT_EQ(params.camera.yaw, 3);
    EXPECT_EQ(desk.session.scene().objects.size(), 1U);
    desk.undo();
    desk.settle();
    EXPECT_EQ(params, before);
}

TEST_F(FilesTest, ALargeMeshShowsProgressAndCanBeCanceled) {
    write_grid("huge.obj", 1000);  // 2 million triangles load in seconds; a click takes 0.1 s
    write_grid("big.obj", 400);    // 320,000 triangles
    const Params before = params;
    drop("huge.obj");
    ui.frames(2);
    ASSERT_TRUE(desk.session.loading_fraction());
    ASSERT_TRUE(ui.has("Cancel"));
    const float fraction = *desk.session.loading_fraction();
    EXPECT_GE(fraction, 0.0F);
    EXPECT_LE(fraction, 1.0F);
    EXPECT_EQ(desk.session.scene().objects.size(), 3U);  // the old scene stays until the new one is loaded
    desk.session.message = {};
    ui.click("Cancel");
    ui.frames(2);
    EXPECT_FALSE(desk.session.loading_fraction());
    EXPECT_FALSE(ui.has("Cancel"));
    EXPECT_EQ(params, before);
    EXPECT_FALSE(desk.session.can_undo());
    EXPECT_FALSE(desk.session.message.is_error);
    EXPECT_FALSE(desk.session.message.text.empty());

    drop("big.obj");
    float last = 0.0F;
    for (int i = 0; i < 2000; ++i) {
        ui.frame();
        const std::optional<float> now = desk.session.loading_fraction();
        if (!now) break;
        EXPECT_GE(*now, last);
        last = *now;
    }
    EXPECT_GT(last, 0.0F);
    ASSERT_EQ(desk.session.scene().objects.size(), 1U);
    EXPECT_EQ(desk.session.scene().objects.front().mesh->indices.size(), 3U * 320000U);
    desk.undo();
    desk.settle();
    EXPECT_EQ(params, before);
}

}  // namespace
}  // namespace viewing::test
