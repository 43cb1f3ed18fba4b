// Checks the JSON Schemas with an independent validator: every preset and scene is valid, and files that the program
// refuses are not.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "cli/program.h"

namespace cli_tests {
namespace {

using Words = std::vector<std::string>;

class Schema : public Program {
protected:
    /// Returns whether each of the files is valid; for three files, for example "yes no yes".
    std::string valid(const std::string& schema, const Words& names) const {
        write("valid.py", R"(
import json, sys, jsonschema
schema = json.load(open(sys.argv[1]))
jsonschema.Draft202012Validator.check_schema(schema)
validator = jsonschema.Draft202012Validator(schema)
print(" ".join("yes" if validator.is_valid(json.load(open(name))) else "no" for name in sys.argv[2:]))
)");
        std::string command = "cd '" + folder().string() + "' && /usr/bin/python3 valid.py " + schema;
        for (const std::string& name : names) command += " '" + name + "'";
        EXPECT_EQ(std::system((command + " > told 2>&1").c_str()), 0) << read("told");
        return read("told");
    }
    static bool has_validator() {
        return std::system("/usr/bin/python3 -c 'from jsonschema import Draft202012Validator' 2>/dev/null") == 0;
    }
    void write_schemas() const {
        write("state.schema", expect(0, {"params", "--format", "schema"}).out);
        write("scene.schema", expect(0, {"params", "--format", "scene-schema"}).out);
    }
    static std::string repeated(const char* word, std::size_t count) {
        std::string text;
        for (std::size_t i = 0; i < count; ++i) text += (i == 0 ? "" : " ") + std::string(word);
        return text + "\n";
    }
};

constexpr const char* no_validator = "no validator: Debian's package python3-jsonschema has it";

TEST_F(Schema, EveryPresetAndSceneIsValid) {
    if (!has_validator()) GTEST_SKIP() << no_validator;
    write_schemas();
    for (const char* kind : {"preset", "scene"}) {
        Words files;
        const std::filesystem::path place = std::filesystem::path(std::getenv("VIEWING_SANDBOX_ASSETS")) / kind;
        for (const auto& entry : std::filesystem::directory_iterator(place.string() + "s"))
            files.push_back(entry.path().string());
        ASSERT_GT(files.size(), 10U);
        EXPECT_EQ(valid(std::string(kind == std::string("scene") ? "scene" : "state") + ".schema", files),
                  repeated("yes", files.size()));
    }
}

TEST_F(Schema, EveryLessonLectureAndExerciseIsValid) {
    if (!has_validator()) GTEST_SKIP() << no_validator;
    for (const std::string form : {"lesson", "lecture", "exercise"}) {
        write(form + ".schema", expect(0, {"params", "--format", form + "-schema"}).out);
        Words files;
        for (const auto& entry :
             std::filesystem::directory_iterator(std::string(std::getenv("VIEWING_SANDBOX_ASSETS")) + "/" + form + "s"))
            files.push_back(entry.path().string());
        ASSERT_FALSE(files.empty());
        EXPECT_EQ(valid(form + ".schema", files), repeated("yes", files.size())) << form;
    }
}

TEST_F(Schema, KnowsSuites) {
    if (!has_validator()) GTEST_SKIP() << no_validator;
    write("suite.schema", expect(0, {"params", "--format", "suite-schema"}).out);
    const std::filesystem::path tests = std::getenv("TEST_SOURCE_DIR");
    std::ifstream manual(tests.parent_path() / "assets/manual/suites.md");
    const std::string page{std::istreambuf_iterator<char>(manual), {}};
    const std::size_t begin = page.find("{\n  \"suite\": 1");
    ASSERT_NE(begin, std::string::npos) << "the manual has an example";
    write("example.json", page.substr(begin, page.find("```", begin) - begin));
    EXPECT_EQ(valid("suite.schema", {(tests / "golden/suite.json").string(), "example.json"}), "yes yes\n");

    const Words broken{R"({"suite": 2, "entries": [{"name": "a"}]})",
                       R"({"suite": 1})",
                       R"({"suite": 1, "entries": []})",
                       R"({"suite": 1, "entries": [{"name": "a", "veiw": "camera"}]})",
                       R"({"suite": 1, "entries": [{"name": "a", "view": "cam"}]})",
                       R"({"suite": 1, "entries": [{"name": "a", "size": [0, 5]}]})",
                       R"({"suite": 1, "entries": [{"name": "a", "samples": 8}]})",
                       R"({"suite": 1, "entries": [{"name": "a", "masks": [[0, 0, 5]]}]})",
                       R"({"suite": 1, "entries": [{"each": "preset", "name": "p"}]})",
                       R"({"suite": 1, "entries": [{"name": "a"}], "loosened": [{"name": "a", "worst": 9}]})"};
    Words names;
    for (const std::string& text : broken) {
        names.push_back("broken" + std::to_string(names.size()) + ".json");
        write(names.back(), text);
        EXPECT_EQ(run({"suite", "run", names.back()}).status, 2) << text;
    }
    EXPECT_EQ(valid("suite.schema", names), repeated("no", names.size()));
}

TEST_F(Schema, TheProgramsOutputIsValid) {
    if (!has_validator()) GTEST_SKIP() << no_validator;
    write_schemas();
    Words files;
    for (const char* preset : {"opening", "mirror-ways", "shadow-anti", "depth-pixel", "lecture-code", "passes"}) {
        files.push_back(preset + std::string(".json"));
        write(files.back(), expect(0, {"state", preset, "--set", R"(follow={"object":"box","vertex":0})", "--set",
                                       "scene=torus-and-boxes", "--set", R"(view.pin={"at":[0.5,0.5]})", "--set",
                                       R"(planes=[{"equation":[1,0,0,3]}])"})
                                .out);
    }
    EXPECT_EQ(valid("state.schema", files), repeated("yes", files.size()));
}

TEST_F(Schema, FilesThatTheProgramRefusesAreInvalid) {
    if (!has_validator()) GTEST_SKIP() << no_validator;
    write_schemas();
    const Words broken{R"({"version": 2})",
                       R"({"projection": {"naer": 0.1}})",
                       R"({"projection": {"near": "0.1"}})",
                       R"({"projection": {"near": 0}})",
                       R"({"projection": {"fovy": 400}})",
                       R"({"projection": {"aspect": 0.05}})",
                       R"({"camera": {"position": [1, 2]}})",
                       R"({"camera": {"position": [1, 2, 1e9]}})",
                       R"({"camera": {"navigation": "swim"}})",
                       R"({"camera": []})",
                       R"({"projection": {"near": -1}})",
                       R"({"projection": {"type": "orthographic", "near": -1}, "depth": {"mapping": "logarithmic"}})",
                       R"({"camera": {"look_at": {"eye": [1, 2, 3]}}})",
                       R"({"camera": {"look_at": {"eye": [1, 2, 3], "center": [0, 0, 0]}, "roll": 3}})",
                       R"({"camera": {"look_at": {"eye": [1, 2, 3], "centre": [0, 0, 0]}}})",
                       R"({"depth": {"test": 1}})",
                       R"({"light": {"position": [1, 2, 3, 2]}})",
                       R"({"lights": [{"positon": [1, 2, 3, 1]}]})",
                       R"({"lights": [{}, {}, {}, {}, {}, {}, {}, {}, {}, {}]})",
                       R"({"shadow": {"color": "red"}})",
                       R"({"overrides": {"shadow_from_world": [[1, 0, 0, 0]]}})",
                       R"({"follow": {"vertex": 1}})",
                       R"({"view": {"samples": 2}})",
                       R"({"view": {"pixel": [1.5, 2]}})",
                       R"({"view": {"pin": {}}})",
                       R"({"title": 7})",
                       R"({"scene": ""})",
                       R"({"scene": {}})",
                       R"({"scene": {"objects": [{"name": "a"}]}})",
                       R"({"scene": {"objects": [{"name": "a", "shape": "triangle"}]}})",
                       R"({"scene": {"objects": [{"name": "a", "shape": "box", "file": "a.obj"}]}})",
                       R"({"scene": {"objects": [{"name": "a", "shape": "box", "scale": [1, 0, 1]}]}})",
                       R"([])"};
    Words files;
    for (const std::string& text : broken) {
        files.push_back(std::to_string(files.size()) + ".json");
        write(files.back(), text);
        EXPECT_EQ(run({"state", files.back()}).status, 2) << text;
    }
    EXPECT_EQ(valid("state.schema", files), repeated("no", files.size()));
}

TEST_F(Schema, StatesAndScenesMayNameTheirSchema) {
    write("mine.json", R"({"$schema": "./state.schema.json", "scene": "room.json"})");
    write("room.json", R"({"$schema": "./scene.schema.json", "objects": [{"name": "a", "shape": "box"}]})");
    EXPECT_EQ(expect(0, {"state", "mine.json"}).json()["$schema"], "./state.schema.json");
    write("bad.json", R"({"$schema": 1})");
    refused({"state", "bad.json"}, {"bad.json: $schema", "a string"});
}

}  // namespace
}  // namespace cli_tests
