// Tests files that a state names outside its own folder, and checks that messages reveal little about other files.
#include <gtest/gtest.h>

#include "cli/program.h"

namespace cli_tests {
namespace {

class Outside : public Program {
protected:
    Outside() {
        for (const char* name : {"own", "other"}) std::filesystem::create_directory(folder() / name);
        write("other/m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        write("other/room.json", R"({"objects": [{"name": "m", "shape": "mesh", "file": "m.obj"}]})");
        write("own/mesh.json", R"({"scene": {"objects": [{"name": "m", "shape": "mesh", "file": "../other/m.obj"}]}})");
        write("own/room.json", R"({"scene": "../other/room.json"})");
        write("own/plain.json", "{}");
    }
};

TEST_F(Outside, NeedsPermission) {
    for (const char* state : {"own/mesh.json", "own/room.json"}) {
        refused({"state", state}, {state, "../other/", "--allow-outside"});
        refused({"matrices", state}, {"--allow-outside"});
        refused({"snapshot", state, "-o", "a.png"}, {"--allow-outside"});
        expect(0, {"state", state, "--allow-outside"});
    }
    refused({"state", "-"}, {"--allow-outside"}, {.input = read("own/mesh.json"), .folder = folder() / "own"});
    expect(0, {"state", "-"}, {.input = R"({"scene": "other/room.json"})"});
}

TEST_F(Outside, TypedFilesNeedNoPermission) {
    expect(0, {"state", "own/plain.json", "--mesh", "other/m.obj"});
    expect(0, {"state", "other/m.obj"}, {.folder = folder()});
    expect(0, {"state", "own/plain.json", "--set", "scene=other/room.json"});
    expect(0, {"state", "own/plain.json", "--set",
               R"(scene={"objects": [{"name": "m", "shape": "mesh", "file": "other/m.obj"}]})"});
    refused({"state", "own/mesh.json", "--set", "scene.objects[0].color=#ff0000"}, {"--allow-outside"});
}

TEST_F(Outside, MessagesQuoteAtMostOneWord) {
    write("own/secret", "root:x:0:0:root:/root:/bin/bash and a long line of secrets\n");
    write("own/secret.obj", "v 0 0 root:x:0:0:root:/root:/bin/bash\n");
    write("own/a.json", R"({"scene": "./secret"})");
    write("own/b.json", R"({"scene": "./secret.obj"})");
    write("own/c.json", R"({"camera": {"yaw": "root:x:0:0:root:/root:/bin/bash"}})");
    for (const char* state : {"own/a.json", "own/b.json", "own/c.json"}) {
        const Ended ended = expect(2, {"state", state});
        EXPECT_EQ(ended.err.find("root:/root:/bin/bash"), std::string::npos) << ended.told();
        EXPECT_EQ(ended.err.find("secrets"), std::string::npos) << ended.told();
    }
}

TEST_F(Outside, MessagesShowDirectionMarks) {
    const Ended ended = expect(2, {"state",
                                   "a\xe2\x80\xae"
                                   "b\x1b[31m.json"});
    EXPECT_NE(ended.err.find("a\\u202eb\\u001b[31m.json"), std::string::npos) << ended.told();
}

TEST_F(Outside, ScenesTooLargeForAMethodAreRefusedBeforeTheyAreSorted) {
    std::string objects;
    for (int i = 0; i < 300; ++i)
        objects +=
            (i == 0 ? "" : ", ") + std::string(R"({"name": "t)") + std::to_string(i) + R"(", "shape": "teapot"})";
    write("own/teapots.json", R"({"scene": {"objects": [)" + objects + R"(]}, "visibility": {"method": "bsp"}})");
    refused({"snapshot", "own/teapots.json", "-o", "a.png"}, {"polygons", "100,000", "remove objects"});
    refused({"inspect", "own/teapots.json", "--pixel", "0,0"}, {"polygons", "100,000"});
    refused({"measure", "own/teapots.json", "--what", "visibility"}, {"polygons", "100,000"});
    refused({"snapshot", "own/teapots.json", "-o", "a.png", "--set", "visibility.method=painter"}, {"400,000"});
}

}  // namespace
}  // namespace cli_tests
