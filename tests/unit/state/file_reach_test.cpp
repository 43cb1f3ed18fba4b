// The files that a state may name.
#include "state/file_reach.h"

#include <gtest/gtest.h>

#include "scratch_folder.h"
#include "state/presets.h"
#include "state/scene.h"

namespace viewing {
namespace {

namespace fs = std::filesystem;

class FileReachTest : public testing::ScratchFolder {};

TEST_F(FileReachTest, IsTheFolderWithSubfoldersAndTheAssets) {
    fs::create_directories(folder_ / "own/deep");
    fs::create_directories(folder_ / "owner");
    const FileReach reach = reach_of_folder(folder_ / "own");
    EXPECT_TRUE(reach.includes(folder_ / "own/a.obj"));
    EXPECT_TRUE(reach.includes(folder_ / "own/deep/a.obj"));
    EXPECT_TRUE(reach.includes(folder_ / "owner/../own/a.obj"));
    EXPECT_TRUE(reach.includes(assets_directory() / "scenes" / "teapot.json"));
    EXPECT_FALSE(reach.includes(folder_ / "owner/a.obj")) << "a longer name";
    EXPECT_FALSE(reach.includes(folder_ / "a.obj"));
    EXPECT_FALSE(reach.includes(folder_ / "own/../a.obj"));
    EXPECT_FALSE(reach.includes("/etc/passwd"));
    EXPECT_TRUE(FileReach{}.includes("/etc/passwd"));
}

TEST_F(FileReachTest, FollowsLinks) {
    fs::create_directories(folder_ / "own");
    fs::create_directories(folder_ / "other");
    fs::create_directory_symlink(folder_ / "other", folder_ / "own/link");
    fs::create_directory_symlink(folder_ / "own", folder_ / "alias");
    const FileReach reach = reach_of_folder(folder_ / "alias");
    EXPECT_TRUE(reach.includes(folder_ / "own/a.obj"));
    EXPECT_FALSE(reach.includes(folder_ / "own/link/a.obj"));
}

TEST_F(FileReachTest, OfASceneFileIncludesItsOwnFolder) {
    fs::create_directories(folder_ / "own");
    fs::create_directories(folder_ / "other");
    write("other/m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const fs::path room = write("other/room.json", R"({"objects": [{"name": "m", "shape": "mesh", "file": "m.obj"}]})");
    const FileReach own = reach_of_folder(folder_ / "own");
    fs::path outside;
    const Result<Scene> refused =
        load_scene(room.string(), folder_ / "own", {}, {.origin = "s.json: scene", .reach = own, .outside = &outside});
    ASSERT_FALSE(refused);
    EXPECT_EQ(outside, resolved(room));
    EXPECT_NE(refused.error().find("s.json: scene: "), std::string::npos) << refused.error();
    EXPECT_NE(refused.error().find("--allow-outside"), std::string::npos) << refused.error();

    FileReach with_room = own;
    with_room.add(room);
    const Result<Scene> read = load_scene(room.string(), folder_ / "own", {}, {.reach = with_room});
    ASSERT_TRUE(read) << read.error();
    EXPECT_EQ(read->read.size(), 2U);
}

TEST_F(FileReachTest, OfAStateIsItsFolder) {
    const Result<LoadedState> state = load_state(write("s.json", "{}").string());
    ASSERT_TRUE(state);
    EXPECT_FALSE(state->reach.is_everywhere);
    EXPECT_TRUE(state->reach.includes(folder_ / "m.obj"));
    EXPECT_FALSE(state->reach.includes(folder_.parent_path() / "m.obj"));
    EXPECT_FALSE(load_state("teapot")->reach.is_everywhere);
}

}  // namespace
}  // namespace viewing
