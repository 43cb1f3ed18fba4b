// Opening, pasting and saving on a background thread: the previous state stays until the new one is ready, and input
// that cannot be read changes nothing.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "session/session.h"
#include "state/file/state_json.h"

namespace viewing {
namespace {

namespace fs = std::filesystem;

constexpr const char* triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

class SessionOpen : public ::testing::Test {
protected:
    SessionOpen() {
        fs::create_directories(folder_ / "own");
        fs::create_directories(folder_ / "other");
        folder_ = fs::canonical(folder_);
    }
    ~SessionOpen() override { fs::remove_all(folder_); }

    fs::path write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name, std::ios::binary) << text;
        return folder_ / name;
    }
    /// Returns a state whose scene is one mesh and whose camera identifies it.
    static std::string state_with(const std::string& mesh, double yaw) {
        Params params;
        params.camera.yaw = yaw;
        ObjectDescription object;
        object.name = "one";
        object.shape = ShapeKind::mesh;
        object.file = mesh;
        params.scene = SceneDescription{{object}};
        return write_state(params);
    }
    void open(const fs::path& file) {
        session.open(file.string());
        session.finish_loading();
        session.rest();
    }
    bool shows_mesh() const {
        return session.scene().objects.size() == 1 && session.scene().objects[0].mesh->triangle_count() == 1;
    }

    fs::path folder_ = fs::temp_directory_path() / ("viewing-open-" + std::to_string(getpid()));
    Session session = *Session::make(*load_state(""));
    const Params opening = session.params;
};

TEST_F(SessionOpen, PreviousStateStaysUntilTheNewOneIsRead) {
    write("own/m.obj", triangle);
    session.open(write("own/s.json", state_with("m.obj", 7)).string());
    EXPECT_EQ(session.params, opening) << "nothing has been read yet";
    EXPECT_EQ(session.opening(), (folder_ / "own/s.json").string());
    session.finish_loading();
    EXPECT_EQ(session.params.camera.yaw, 7);
    EXPECT_TRUE(shows_mesh());
    EXPECT_EQ(session.opening(), "");
    ASSERT_TRUE(session.take_outcome());
    session.rest();
    session.undo();
    session.finish_loading();
    EXPECT_EQ(session.params, opening);
}

TEST_F(SessionOpen, UnreadableFileChangesNothing) {
    write("own/broken.obj", "v 0 0 x\n");
    ASSERT_EQ(::mkfifo((folder_ / "own/pipe.json").c_str(), 0600), 0);
    for (const fs::path& file :
         {write("own/a.json", "{\"camera\": 3}"), write("own/b.json", state_with("broken.obj", 3)),
          write("own/c.json", "{\"scene\": \"./pipe.json\"}"), folder_ / "own/pipe.json",
          folder_ / "own/missing.json"}) {
        session.message = {};
        open(file);
        EXPECT_TRUE(session.message.is_error) << file;
        const std::optional<Status> outcome = session.take_outcome();
        EXPECT_TRUE(outcome && !*outcome) << file;
        EXPECT_EQ(session.params, opening) << file;
        EXPECT_FALSE(session.can_undo()) << file;
    }
    session.undo();
    EXPECT_EQ(session.params, opening);
}

/// Theme and type size belong to the user: an open state shows its own values only while it is open.
TEST_F(SessionOpen, AppearanceSetByAFileIsTemporary) {
    const UiParams own{.theme = Theme::light, .scale = 1.2};
    const fs::path plain = write("own/plain.json", R"({"camera": {"yaw": 5}})");
    const fs::path large = write("own/large.json", R"({"ui": {"theme": "projector", "scale": 1.5}})");
    const fs::path dark = write("own/dark.json", R"({"ui": {"scale": 0.8}})");
    session.params.ui = own;
    open(large);
    EXPECT_EQ(session.params.ui, (UiParams{.theme = Theme::projector, .scale = 1.5}));
    open(dark);
    EXPECT_EQ(session.params.ui, (UiParams{.scale = 0.8}));
    open(plain);
    EXPECT_EQ(session.params.ui, own) << "also after two states that set other values";

    open(large);
    session.params.ui.language = Language::ko;
    open(plain);
    EXPECT_EQ(session.params.ui, (UiParams{own.theme, own.scale, Language::ko})) << "the language is never temporary";

    open(large);
    session.params.ui.scale = 1.0;
    session.rest();
    open(plain);
    EXPECT_EQ(session.params.ui, (UiParams{Theme::projector, 1.0, Language::ko})) << "the user has chosen since";

    open(dark);
    session.reset();
    EXPECT_EQ(session.params.ui, (UiParams{Theme::projector, 1.0, Language::ko}))
        << "the start has the user's own appearance";
}

TEST_F(SessionOpen, OutcomeIsThatOfTheLatestOpen) {
    open(write("own/good.json", "{}"));  // its outcome is never taken
    session.open(write("own/broken.json", "{\"camera\": 3}").string());
    EXPECT_FALSE(session.take_outcome()) << "not read yet";
    session.finish_loading();
    const std::optional<Status> outcome = session.take_outcome();
    EXPECT_TRUE(outcome && !*outcome);
}

TEST_F(SessionOpen, PipeWithoutAWriterBlocksNothing) {
    const fs::path pipe = folder_ / "own/pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    session.save(pipe);
    for (int frame = 0; frame < 100; ++frame) session.update_scene();
    EXPECT_FALSE(session.take_outcome()) << "still waiting on its own thread";
    const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    ASSERT_GE(reader, 0);
    char byte = 0;
    while (!session.take_outcome()) {
        while (::read(reader, &byte, 1) == 1) continue;
        session.update_scene();
    }
    ::close(reader);
    EXPECT_FALSE(session.message.is_error) << session.message.text;
}

TEST_F(SessionOpen, UndoRestoresTheFolderOfTheState) {
    write("own/m.obj", triangle);
    write("other/n.obj", triangle);
    open(write("own/s.json", state_with("m.obj", 1)));
    open(write("other/s.json", state_with("n.obj", 2)));
    ASSERT_EQ(session.params.camera.yaw, 2);
    session.undo();
    session.finish_loading();
    EXPECT_FALSE(session.message.is_error) << session.message.text;
    EXPECT_EQ(session.params.camera.yaw, 1);
    EXPECT_EQ(session.scene().objects[0].description.file, "m.obj");
    EXPECT_NE(session.text().find((folder_ / "own/m.obj").string()), std::string::npos);
}

TEST_F(SessionOpen, UndoOfAMissingFileKeepsStateAndHistory) {
    write("own/m.obj", triangle);
    open(write("own/s.json", state_with("m.obj", 1)));
    session.params.scene = std::string("teapot");
    session.finish_loading();
    session.rest();
    session.params.camera.yaw = 9;
    session.rest();
    const Params now = session.params;
    fs::remove(folder_ / "own/m.obj");
    session.undo();
    session.undo();
    session.finish_loading();
    EXPECT_TRUE(session.message.is_error);
    EXPECT_EQ(session.params, now);
    EXPECT_FALSE(session.can_redo());
    session.undo();
    session.finish_loading();
    EXPECT_NE(session.params, now) << "the previous step is still there";
    EXPECT_EQ(session.params.scene, SceneSource(std::string("teapot")));
}

TEST_F(SessionOpen, FileOutsideTheStatesFolderNeedsPermission) {
    const fs::path mesh = write("other/m.obj", triangle);
    write("other/n.obj", triangle);
    const fs::path state = write("own/s.json", state_with("../other/m.obj", 5));
    open(state);
    ASSERT_NE(session.asks_to_read(), nullptr);
    EXPECT_EQ(session.asks_to_read()->file, mesh);
    EXPECT_EQ(session.asks_to_read()->named_by, state.string());
    EXPECT_EQ(session.params, opening);
    session.answer(false);
    session.finish_loading();
    EXPECT_EQ(session.asks_to_read(), nullptr);
    EXPECT_EQ(session.params, opening);
    EXPECT_FALSE(session.message.is_error);

    open(state);
    ASSERT_NE(session.asks_to_read(), nullptr) << "a refusal is not permanent";
    session.answer(true);
    session.finish_loading();
    EXPECT_TRUE(shows_mesh());
    EXPECT_EQ(session.params.camera.yaw, 5);
    open(write("own/t.json", state_with((folder_ / "other/n.obj").string(), 6)));
    EXPECT_EQ(session.asks_to_read(), nullptr) << "same folder, same session";
    EXPECT_EQ(session.params.camera.yaw, 6);
}

TEST_F(SessionOpen, FollowsLinksBeforeAsking) {
    const fs::path mesh = write("other/m.obj", triangle);
    fs::create_symlink(mesh, folder_ / "own/m.obj");
    open(write("own/s.json", state_with("m.obj", 5)));
    ASSERT_NE(session.asks_to_read(), nullptr);
    EXPECT_EQ(session.asks_to_read()->file, mesh);
}

TEST_F(SessionOpen, PastedStateHasNoFolder) {
    const fs::path mesh = write("own/m.obj", triangle);
    ASSERT_TRUE(session.paste("{\"scene\": \"teapot\"}"));
    session.finish_loading();
    EXPECT_EQ(session.asks_to_read(), nullptr) << "assets need no permission";
    EXPECT_EQ(session.params.scene, SceneSource(std::string("teapot")));
    ASSERT_TRUE(session.paste(state_with(mesh.string(), 5)));
    session.finish_loading();
    ASSERT_NE(session.asks_to_read(), nullptr);
    EXPECT_EQ(session.asks_to_read()->named_by, "clipboard");
    session.answer(false);

    open(write("own/s.json", state_with("m.obj", 4)));
    ASSERT_EQ(session.params.camera.yaw, 4);
    const std::string copied = session.text();
    session.params.scene = std::string("teapot");
    session.finish_loading();
    session.rest();
    ASSERT_TRUE(session.paste(copied));
    session.finish_loading();
    EXPECT_EQ(session.asks_to_read(), nullptr) << "already read in this session";
    EXPECT_TRUE(shows_mesh());
}

TEST_F(SessionOpen, StartingWithSuchAStateAsksForPermission) {
    write("other/m.obj", triangle);
    Result<Session> begun =
        Session::begin(*load_state(write("own/s.json", state_with("../other/m.obj", 5)).string()), -1.0);
    ASSERT_TRUE(begun) << begun.error();
    ASSERT_NE(begun->asks_to_read(), nullptr);
    begun->answer(true);
    begun->finish_loading();
    EXPECT_EQ(begun->params.camera.yaw, 5);
    EXPECT_FALSE(begun->can_undo()) << "the session began with this state";
}

}  // namespace
}  // namespace viewing
