// `state --bundle` writes a folder that draws the same picture even after its sources are gone. Also, `state` keeps the
// names and titles that it is given.
#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "cli/program.h"

namespace cli_tests {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Words = std::vector<std::string>;

constexpr const char* roof = "mtllib stone.mtl\nv 0 0 0\nv 2 0 0\nv 1 1 0\nv 1 0 2\nf 1 2 3\nf 1 4 2\nf 1 3 4\n";

class Bundle : public Program {
protected:
    void make(const std::string& name, const std::string& text) const {
        fs::create_directories((folder() / name).parent_path());
        write(name, text);
    }
    std::string picture(const Words& state) const {
        Words words{"snapshot", "--view", "camera", "--size", "96x64", "-o", "-"};
        words.insert(words.end(), state.begin(), state.end());
        return without_note(expect(0, words).out);
    }
    /// Returns the PNG file without the state inside it, since a bundle's state has different file paths.
    static std::string without_note(const std::string& png) {
        std::string rest = png.substr(0, 8);
        for (std::size_t at = 8; at + 12 <= png.size();) {
            std::size_t length = 0;
            for (std::size_t i = at; i < at + 4; ++i) length = length * 256 + static_cast<unsigned char>(png[i]);
            const std::string chunk = png.substr(at, length + 12);
            if (chunk.substr(4, 4) != "iTXt") rest += chunk;
            at += length + 12;
        }
        return rest;
    }
    /// Returns the relative paths of all files in the folder.
    std::set<std::string> names(const std::string& below) const {
        std::set<std::string> found;
        for (const auto& entry : fs::recursive_directory_iterator(folder() / below))
            if (!entry.is_directory()) found.insert(fs::relative(entry.path(), folder() / below).string());
        return found;
    }
    /// Bundles the state, deletes the folder "from", moves the bundle, and compares the pictures.
    void expect_same(const Words& state, const std::set<std::string>& expected) const {
        const std::string before = picture(state);
        Words words{"state", "--bundle", "bundle"};
        words.insert(words.end(), state.begin(), state.end());
        EXPECT_EQ(expect(0, words).out, "bundle/state.json\n");
        fs::remove_all(folder() / "from");
        EXPECT_EQ(names("bundle"), expected);
        fs::rename(folder() / "bundle", folder() / "moved");
        EXPECT_TRUE(picture({"moved/state.json"}) == before);
        EXPECT_EQ(files(), 1U) << "no other file is left";
    }
};

TEST_F(Bundle, OfOneMesh) {
    make("from/mine.obj", tetrahedron);
    expect_same({"from/mine.obj"}, {"state.json", "mine.obj"});
    EXPECT_EQ(Json::parse(read("moved/state.json"))["scene"], "mine.obj");
}

TEST_F(Bundle, OfAStateWithASceneFileAndMeshesWhoseNamesCollide) {
    make("from/state.obj", tetrahedron);
    make("from/parts/T.obj", roof);
    make("from/parts/stone.mtl", "newmtl stone\n");
    make("from/parts/t.obj", tetrahedron);
    make("from/scenes/t.obj", roof);
    make("from/scenes/state.json", R"({"title": "Room", "objects": [
        {"name": "a", "shape": "mesh", "file": "t.obj"},
        {"name": "b", "shape": "mesh", "file": "../parts/T.obj", "position": [1, 1, 1]},
        {"name": "c", "shape": "mesh", "file": "../parts/t.obj", "position": [-2, 1, 1]},
        {"name": "again", "shape": "mesh", "file": "../parts/T.obj", "position": [0, 2, 0]},
        {"name": "d", "shape": "box"}]})");
    make("from/mine.json", R"({"title": "Mine", "about": "A room.", "group": "Own", "scene": "scenes/state.json"})");
    expect_same({"from/mine.json", "--allow-outside"},
                {"state.json", "state-2.json", "t.obj", "2/T.obj", "2/t-2.obj", "2/stone.mtl"});
    const Json state = Json::parse(read("moved/state.json"));
    EXPECT_EQ(state["title"], "Mine");
    EXPECT_EQ(state["scene"], "state-2.json");
    EXPECT_EQ(Json::parse(read("moved/state-2.json"))["title"], "Room");
}

TEST_F(Bundle, OfAnInlineSceneWithUnsafeNames) {
    make("from/-rf \n`x`.obj", tetrahedron);
    make("from/.hidden.obj", roof);
    make("from/mine.json", R"({"scene": {"objects": [{"name": "a", "shape": "mesh", "file": ".hidden.obj"}]}})");
    const std::string before = picture({"from/mine.json"});
    EXPECT_EQ(expect(0, {"state", "from/mine.json", "--bundle", "one"}).out, "one/state.json\n");
    EXPECT_EQ(names("one"), (std::set<std::string>{"state.json", "_hidden.obj"}));
    EXPECT_TRUE(picture({"one/state.json"}) == before);
    expect(0, {"state", "--bundle", "two", "--mesh", "from/-rf \n`x`.obj"});
    for (const std::string& name : names("two")) {
        EXPECT_EQ(name.find_first_of("`\n"), std::string::npos) << name;
        EXPECT_NE(name.front(), '-');
    }
}

TEST_F(Bundle, CopiesNothingThatShipsWithTheProgram) {
    expect_same({"teapot"}, {"state.json"});
}

TEST_F(Bundle, IgnoresAMaterialLibraryThatIsALink) {
    make("from/roof.obj", roof);
    write("secret", "secret");
    fs::create_symlink(folder() / "secret", folder() / "from" / "stone.mtl");
    expect(0, {"state", "from/roof.obj", "--bundle", "bundle"});
    EXPECT_EQ(names("bundle"), (std::set<std::string>{"state.json", "roof.obj"}));
}

TEST_F(Bundle, AppearsCompleteOrNotAtAll) {
    make("full/file", "kept");
    refused({"state", "--bundle", "full"}, {"full", "it contains file"});
    refused({"state", "--bundle", "full/file"}, {"full/file", "it is a file"});
    refused({"state", "broken.obj", "--bundle", "missing/bundle"}, {"broken.obj"});
    refused({"state", "--bundle", "/proc/bundle"}, {"/proc"});
    refused({"state", "broken.obj", "--bundle", "bundle"}, {"broken.obj"});
    make("outside.obj", tetrahedron);
    make("from/mine.json", R"({"scene": "../outside.obj"})");
    refused({"state", "from/mine.json", "--bundle", "bundle"}, {"--allow-outside"});
    EXPECT_EQ(read("full/file"), "kept");
    fs::create_directory(folder() / "empty");
    expect(0, {"state", "--bundle", "empty/"});
    EXPECT_EQ(names("empty"), std::set<std::string>{"state.json"});
    expect(0, {"state", "--bundle", "missing/bundle"});
    EXPECT_EQ(names("missing"), std::set<std::string>{"bundle/state.json"});
}

TEST_F(Bundle, AMeshKeepsItsGivenName) {
    make("sub/mine.obj", tetrahedron);
    EXPECT_EQ(expect(0, {"state", "sub/mine.obj"}).json()["scene"], "sub/mine.obj");
    EXPECT_EQ(expect(0, {"state", "--mesh", "./sub/mine.obj"}).json()["scene"], "./sub/mine.obj");
    const std::string absolute = (folder() / "sub" / "mine.obj").string();
    EXPECT_EQ(expect(0, {"state", absolute}).json()["scene"], absolute);
    write("printed.json", expect(0, {"state", "sub/mine.obj"}).out);
    EXPECT_TRUE(picture({"printed.json"}) == picture({"sub/mine.obj"}));
}

TEST_F(Bundle, StateKeepsTheTitlesOfAFile) {
    write("mine.json", R"({"$schema": "s.json", "title": "Mine", "about": "\"One\" – two.", "group": "Own",
                           "camera": {"yaw": 3}})");
    const std::string printed = expect(0, {"state", "mine.json", "--set", "camera.pitch=4"}).out;
    const auto state = nlohmann::ordered_json::parse(printed);
    std::string first;
    for (const auto& [key, value] : state.items()) first += key + " ";
    EXPECT_EQ(first.find("$schema version title about group scene camera "), 0U) << first;
    EXPECT_EQ(state["title"], "Mine");
    EXPECT_EQ(state["about"], "\"One\" – two.");
    write("again.json", printed);
    EXPECT_EQ(expect(0, {"state", "again.json"}).out, printed);
    const Json preset = expect(0, {"state", "shadow-anti"}).json();
    EXPECT_EQ(preset["title"], "Anti-shadow");
    EXPECT_EQ(preset["group"], "Shadow");
    EXPECT_FALSE(expect(0, {"state"}).json().contains("title"));
}

}  // namespace
}  // namespace cli_tests
