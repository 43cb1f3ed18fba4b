// If an output is also an input or another output, the program exits with status 2 and touches no file.
#include <gtest/gtest.h>

#include "cli/program.h"

namespace cli_tests {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

class OutputNames : public Program {
protected:
    /// Expects that the command is refused with these words and leaves every file unchanged.
    void untouched(const Words& arguments, const Words& words) const {
        const auto contents = [this] {
            std::map<std::string, std::string> all;
            for (const auto& entry : fs::recursive_directory_iterator(folder()))
                all[entry.path().string()] = entry.is_regular_file() ? read(entry.path().string()) : "";
            return all;
        };
        const auto before = contents();
        std::string command;
        for (const std::string& word : arguments) command += word + " ";
        SCOPED_TRACE(command);
        refused(arguments, words);
        EXPECT_EQ(contents(), before);
    }

    /// Writes reference.png, state.json, and a scene with its mesh; for each of these files, a hard link and a symbolic
    /// link; and a folder with a symbolic link to it.
    void write_files() const {
        write("state.json", R"({"scene": "room.json"})");
        write("room.json", R"({"objects": [{"name": "it", "shape": "mesh", "file": "it.obj"}]})");
        write("it.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        expect(0, {"snapshot", "--view", "camera", "--size", "32x32", "-o", "reference.png"});
        for (const std::string name : {"reference.png", "state.json", "room.json", "it.obj"}) {
            fs::create_hard_link(folder() / name, folder() / ("hard-" + name));
            fs::create_symlink(name, folder() / ("soft-" + name));
        }
        fs::create_directory(folder() / "in");
        fs::create_directory_symlink("in", folder() / "link");
    }

    /// Returns the file's name and other names for the same file.
    static Words names_of(const std::string& name) {
        return {name, "./" + name, "in/../" + name, "hard-" + name, "soft-" + name};
    }
};

TEST_F(OutputNames, OfSnapshot) {
    write_files();
    const Words small{"snapshot", "state.json", "--view", "camera", "--size", "32x32"};
    const auto snapshot = [&](const Words& more, const Words& words) {
        Words arguments = small;
        arguments.insert(arguments.end(), more.begin(), more.end());
        untouched(arguments, words);
    };
    for (const std::string& name : names_of("reference.png")) {
        snapshot({"--compare", "reference.png", "-o", name}, {"-o", "--compare", "same file"});
        snapshot({"--compare", "reference.png", "--json", name}, {"--json", "--compare", "same file"});
        snapshot({"-o", "reference.png", "--json", name}, {"-o", "--json", "same file"});
    }
    for (const std::string& name : names_of("state.json"))
        snapshot({"-o", "a.png", "--json", name}, {"--json", "STATE", "same file"});
    for (const std::string file : {"room.json", "it.obj"})
        for (const std::string& name : names_of(file))
            snapshot({"-o", "a.png", "--json", name}, {"--json", "scene", "same file"});
    untouched({"snapshot", "state.json", "-o", "state.json"}, {"-o", "STATE", "same file"});
    untouched({"snapshot", "reference.png", "-o", "soft-reference.png"}, {"-o", "STATE", "same file"});
    untouched({"snapshot", "--mesh", "it.obj", "-o", "a.png", "--json", "hard-it.obj"}, {"--mesh", "same file"});
    snapshot({"-o", "new.png", "--json", "in/../new.png"}, {"-o", "--json", "same file"});
    snapshot({"-o", "link/new.png", "--json", "in/new.png"}, {"-o", "--json", "same file"});
    snapshot({"-o", "new.png", "--compare", "new.png"}, {"-o", "--compare", "same file"});
    snapshot({"-o", "-", "--json", "-"}, {"-o", "--json", "standard output"});
    fs::create_symlink("nowhere.png", folder() / "dangling.png");
    snapshot({"-o", "dangling.png", "--json", "nowhere.png"}, {"-o", "--json", "same file"});
    expect(0, {"snapshot", "--view", "camera", "--size", "32x32", "-o", "/dev/null", "--json", "/dev/null"});
}

TEST_F(OutputNames, OfCompare) {
    write_files();
    expect(0, {"snapshot", "--view", "camera", "--size", "32x32", "-o", "b.png"});
    for (const std::string& name : names_of("reference.png")) {
        untouched({"compare", "reference.png", "b.png", "-o", name}, {"-o", "A.png", "same file"});
        untouched({"compare", "b.png", "reference.png", "-o", name}, {"-o", "B.png", "same file"});
        untouched({"compare", "b.png", "reference.png", "--json", name}, {"--json", "B.png", "same file"});
    }
    untouched({"compare", "b.png", "reference.png", "-o", "x.png", "--json", "x.png"}, {"-o", "--json", "same file"});
    untouched({"compare", "b.png", "reference.png", "-o", "-", "--json", "-"}, {"-o", "--json", "standard output"});
    expect(0, {"compare", "b.png", "b.png"});
}

TEST_F(OutputNames, OfSweep) {
    write_files();
    const auto sweep = [&](const Words& more, const Words& words) {
        Words arguments{"sweep", "--vary", "light.position[0]=-1:1:2", "--size", "32x32"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        untouched(arguments, words);
    };
    for (const std::string& name : names_of("state.json"))
        sweep({"state.json", "-o", "a.png", "--csv", name}, {"--csv", "STATE", "same file"});
    for (const std::string& name : names_of("it.obj"))
        sweep({"state.json", "--csv", name}, {"--csv", "scene", "same file"});
    sweep({"reference.png", "-o", "hard-reference.png"}, {"-o", "STATE", "same file"});
    sweep({"-o", "a.png", "--csv", "a.png"}, {"-o", "--csv", "same file"});
    fs::create_directory(folder() / "frames");
    fs::copy_file(folder() / "reference.png", folder() / "frames/0002.png");
    sweep({"frames/0002.png", "-o", "frames"}, {"-o", "STATE", "frames/0002.png"});
    sweep({"-o", "frames", "--csv", "frames/0002.png"}, {"-o", "--csv", "frames/0002.png"});
}

TEST_F(OutputNames, OfGradeAndLesson) {
    fs::create_directory(folder() / "hand-ins");
    write("hand-ins/32201234.json", "{}");
    fs::create_symlink("hand-ins/32201234.json", folder() / "soft.json");
    for (const std::string name : {"hand-ins/32201234.json", "soft.json"}) {
        untouched({"grade", "hand-ins", "-o", name}, {"-o", "hand-in", "same file"});
        untouched({"grade", "hand-ins", "--html", name}, {"--html", "hand-in", "same file"});
        untouched({"grade", "x.json", "--exercises", "hand-ins", "-o", name}, {"-o", "--exercises", "same file"});
    }
    untouched({"grade", "hand-ins", "-o", "a", "--html", "a"}, {"-o", "--html", "same file"});
    write("lesson.json", "{}");
    fs::create_hard_link(folder() / "lesson.json", folder() / "hard.json");
    for (const std::string name : {"lesson.json", "hard.json"}) {
        untouched({"lesson", "lesson.json", "--handout", name}, {"--handout", "the lesson", "same file"});
        untouched({"lesson", "lesson.json", "--notes", name}, {"--notes", "the lesson", "same file"});
    }
}

TEST_F(OutputNames, OfSuite) {
    const auto suite = [&](const std::string& name, const std::string& folders, const std::string& entry,
                           const Words& words) {
        write(name, R"({"suite": 1, )" + folders + R"(, "entries": [)" + entry + "]}");
        untouched({"suite", "run", name}, words);
        untouched({"suite", "accept", name}, words);
    };
    const std::string opening = R"({"name": "opening"})";
    suite("suite.json", R"("report": "references")", opening, {"report", "references"});
    suite("report.json", R"("report": ".")", opening, {"report", "report.json"});
    suite("opening.json", R"("references": ".")", opening, {"references", "opening.json"});
    write("mine.json", "{}");
    suite("suite.json", R"("references": ".")", R"({"name": "mine", "state": "mine.json"})",
          {"references", "mine.json"});
}

}  // namespace
}  // namespace cli_tests
