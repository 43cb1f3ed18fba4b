// Runs the manual's Python lines exactly as printed.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "cli/program.h"
#include "text/json.h"

namespace cli_tests {
namespace {

namespace fs = std::filesystem;

class Notebook : public Program {
protected:
    void SetUp() override {
        if (std::system("/usr/bin/python3 -c 'import PIL' 2>/dev/null") != 0)
            GTEST_SKIP() << "no Pillow: Debian's package python3-pil has it";
    }

    static std::string lines_of_manual() {
        std::ifstream stream(fs::path(std::getenv("TEST_SOURCE_DIR")).parent_path() / "assets/manual/notebook.md");
        const std::string page{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
        const std::string begin = "```python\n";
        const std::size_t first = page.find(begin);
        if (first == std::string::npos) throw std::runtime_error("the manual has no lines of Python");
        const std::size_t from = first + begin.size();
        return page.substr(from, page.find("```", from) - from);
    }

    void expect_to_run(const std::string& lines) const {
        write("cell.py", lines);
        const std::string beside = fs::path(std::getenv("VIEWING_SANDBOX")).parent_path().string();
        const std::string command =
            "cd '" + folder().string() + "' && PATH='" + beside + "':$PATH /usr/bin/python3 cell.py > told 2>&1";
        EXPECT_EQ(std::system(command.c_str()), 0) << read("told");
    }
};

TEST_F(Notebook, LinesOfTheManualRun) {
    expect_to_run(
        lines_of_manual() +
        "assert picture.size == (1280, 720) and picture.getextrema()[0][0] < picture.getextrema()[0][1]\n"
        "assert len(S) == 4 and all(len(row) == 4 for row in S)\n"
        "state = json.loads(ask('state', 'tilted-plane'))\n"
        "assert shown == {key: state[key] for key in state if key not in ('title', 'about', 'group', 'slides')}\n"
        "state['camera']['yaw'] = 3\n"
        "told = subprocess.run(['viewing-sandbox', 'state', '-'], input=json.dumps(state).encode(),"
        " check=True, capture_output=True).stdout\n"
        "assert json.loads(told) == state\n");
}

/// Pillow rejects a text chunk of more than 1 MiB, but the state of a scene with thousands of triangles takes several
/// MiB.
TEST_F(Notebook, TheLinesRunWithAStateOfManyTriangles) {
    nlohmann::json objects = nlohmann::json::array();
    for (int i = 0; i < 4000; ++i) {
        const double x = i % 100, z = i / 100;
        objects.push_back({{"name", "삼각형 " + std::to_string(i)},
                           {"shape", "triangle"},
                           {"vertices", {{x, 0.5, z}, {x + 0.7, 0.5, z}, {x, 0.5, z + 0.7}}}});
    }
    write("many.json", nlohmann::json{{"scene", {{"objects", objects}}}}.dump());
    std::string lines = lines_of_manual();
    const std::string preset = "tilted-plane";
    for (std::size_t at = lines.find(preset); at != std::string::npos; at = lines.find(preset))
        lines.replace(at, preset.size(), "many.json");
    expect_to_run(lines +
                  "assert picture.size == (1280, 720)\n"
                  "assert sum(map(len, picture.text.values())) > 1 << 20 and len(shown['scene']['objects']) == 4000\n"
                  "for name in 'many.png', 'many.svg', 'many.pdf':\n"
                  "    ask('snapshot', 'many.json', '--view', 'camera', '--size', '160x90', '-o', name)\n"
                  "    assert json.loads(ask('state', name)) == shown, name\n");
}

}  // namespace
}  // namespace cli_tests
