// Tests `help TOPIC`, and runs the manual's commands exactly as printed.
#include <fstream>

#include "cli/program.h"
#include "text/manual.h"

namespace cli_tests {
namespace {

class Manual : public Program {};
class ManualSlowTest : public Program {};

TEST_F(Manual, HelpShowsATopic) {
    const std::string text = expect(0, {"help", "lessons"}).out;
    EXPECT_TRUE(text.starts_with(viewing::manual_text(viewing::manual_topic("lessons"))));
    EXPECT_NE(text.find("viewing-sandbox lesson --list"), std::string::npos);
    const std::string help = expect(0, {"help"}).out;
    for (const char* topic : viewing::manual_topics()) EXPECT_NE(help.find(topic), std::string::npos) << topic;
}

TEST_F(Manual, HelpShowsATopicThatIsAlsoACommand) {
    for (const char* topic : viewing::manual_topics()) {
        const std::string text = expect(0, {"help", topic}).out;
        EXPECT_TRUE(text.starts_with(viewing::manual_text(viewing::manual_topic(topic)))) << topic;
        const bool is_command = topic == std::string("exercises") || topic == std::string("compare");
        EXPECT_EQ(text.find("Usage: viewing-sandbox " + std::string(topic)) != std::string::npos, is_command);
    }
    EXPECT_EQ(expect(0, {"help", "snapshot"}).out, expect(0, {"snapshot", "--help"}).out);
}

TEST_F(Manual, HelpListsTheTopicsForAnUnknownOne) {
    const std::string sentence = expect(2, {"help", "lessns"}).err;
    EXPECT_NE(sentence.find("lessns"), std::string::npos);
    for (const char* topic : viewing::manual_topics()) EXPECT_NE(sentence.find(topic), std::string::npos) << topic;
}

/// Returns the lines of all ```sh blocks of a topic, in order.
std::vector<std::string> commands_of(const std::string& topic) {
    std::ifstream file(std::string(std::getenv("VIEWING_SANDBOX_ASSETS")) + "/manual/" + topic + ".md");
    std::vector<std::string> commands;
    bool in_commands = false;
    for (std::string line; std::getline(file, line);) {
        const std::size_t begin = std::min(line.find_first_not_of(' '), line.size());
        if (line.compare(begin, 3, "```") == 0)
            in_commands = !in_commands && line.compare(begin, 5, "```sh") == 0;
        else if (in_commands && begin < line.size())
            commands.push_back(line);
    }
    return commands;
}

TEST_F(ManualSlowTest, CommandsRunAsTyped) {
    const std::string beside = std::filesystem::path(std::getenv("VIEWING_SANDBOX")).parent_path().string();
    std::size_t count = 0;
    for (const char* topic : viewing::manual_topics()) {
        const std::filesystem::path place = folder() / topic;
        std::filesystem::create_directory(place);
        for (const std::string& line : commands_of(topic)) {
            write("line.sh", line);
            const std::string shell =
                "cd '" + place.string() + "' && PATH='" + beside + "':$PATH bash -e ../line.sh > ../said 2>&1";
            EXPECT_EQ(std::system(shell.c_str()), 0) << topic << ": " << line << "\n" << read("said");
            ++count;
        }
    }
    EXPECT_GT(count, 50U);
}

}  // namespace
}  // namespace cli_tests
