// README's lines of Python, run as they stand there.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "cli/program.h"

namespace cli_tests {
namespace {

namespace fs = std::filesystem;

class Notebook : public Program {};

TEST_F(Notebook, TheLinesOfTheReadmeRun) {
    if (std::system("/usr/bin/python3 -c 'import PIL' 2>/dev/null") != 0)
        GTEST_SKIP() << "no Pillow: Debian's package python3-pil has it";
    std::ifstream stream(fs::path(std::getenv("TEST_SOURCE_DIR")).parent_path() / "README.md");
    const std::string readme{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    const std::string begin = "```python\n";
    const std::size_t first = readme.find(begin);
    ASSERT_NE(first, std::string::npos);
    const std::size_t from = first + begin.size();
    write("cell.py",
          readme.substr(from, readme.find("```", from) - from) +
              "assert picture.size == (1280, 720) and picture.getextrema()[0][0] < picture.getextrema()[0][1]\n"
              "assert len(S) == 4 and all(len(row) == 4 for row in S)\n"
              "state = json.loads(ask('state', 'tilted-plane'))\n"
              "state['camera']['yaw'] = 3\n"
              "told = subprocess.run(['viewing-sandbox', 'state', '-'], input=json.dumps(state).encode(),"
              " check=True, capture_output=True).stdout\n"
              "assert json.loads(told) == state\n");
    const std::string beside = fs::path(std::getenv("VIEWING_SANDBOX")).parent_path().string();
    const std::string command =
        "cd '" + folder().string() + "' && PATH='" + beside + "':$PATH /usr/bin/python3 cell.py > told 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0) << read("told");
}

}  // namespace
}  // namespace cli_tests
