// Tests the tables of members that end a topic of the manual, against schemas and against the files of the program.
#include <nlohmann/json.hpp>

#include "cli/program.h"

namespace cli_tests {
namespace {

class MemberTables : public Program {
protected:
    /// Returns the path → value of each row below the heading, in a topic as printed.
    std::map<std::string, std::string> table(const std::string& topic, const std::string& heading) {
        std::istringstream lines(expect(0, {"help", topic}).out);
        std::map<std::string, std::string> rows;
        bool is_inside = false;
        std::string last;
        for (std::string line; std::getline(lines, line);) {
            if (!line.starts_with("  ") && !line.empty()) is_inside = line == heading;
            if (!is_inside || !line.starts_with("  ")) continue;
            const std::size_t begin = line.find_first_not_of(' ');
            if (begin == 2) {
                const std::size_t end = line.find(' ', begin);
                last = line.substr(begin, end - begin);
                const std::size_t value = line.find_first_not_of(' ', end);
                rows[last] += (rows[last].empty() ? "" : " | ") + line.substr(value);
            } else {
                rows[last] += " " + line.substr(begin);
            }
        }
        return rows;
    }
};

/// Puts the path of each member of a file into `paths`; an item of a list has the path "list[]".
void find_paths(const nlohmann::json& value, const std::string& path, std::set<std::string>& paths) {
    if (value.is_array())
        for (const nlohmann::json& item : value) find_paths(item, path + "[]", paths);
    if (!value.is_object()) return;
    for (const auto& [name, member] : value.items()) {
        const std::string below = path.empty() ? name : path + "." + name;
        paths.insert(below);
        find_paths(member, below, paths);
    }
}

TEST_F(MemberTables, SayWhatALessonNeeds) {
    const auto rows = table("lessons", "The members of lesson files");
    EXPECT_EQ(rows.at("lesson"), "1; needed");
    EXPECT_EQ(rows.at("id"), "a name; needed");
    EXPECT_EQ(rows.at("minutes"), "a whole number from 1 to 600");
    EXPECT_EQ(rows.at("end.says"), "a list of 3: a text; needed");
    EXPECT_EQ(rows.at("steps[].ask.kind"),
              "one of choice, number, vector, matrix, sequence, order, product, subset, goal; needed");
    EXPECT_EQ(rows.at("steps[].ask.question"), "a text; needed");
    EXPECT_EQ(rows.at("steps[].ask.up_to_factor"), "true or false (number, vector, matrix)");
    EXPECT_TRUE(rows.at("steps[].ask.choices[].say").starts_with("a text; needed"));
    EXPECT_EQ(rows.count("steps[].ask.choices[].needed"), 0U);
}

TEST_F(MemberTables, NameEveryMemberThatTheLessonsUse) {
    const auto rows = table("lessons", "The members of lesson files");
    std::set<std::string> paths;
    for (const auto& file : fs::directory_iterator(std::string(std::getenv("VIEWING_SANDBOX_ASSETS")) + "/lessons")) {
        std::ifstream stream(file.path());
        find_paths(nlohmann::json::parse(stream), "", paths);
    }
    ASSERT_GT(paths.size(), 60U);
    // Below settings, free objects and texts, names are anyone's.
    const auto is_free = [&](const std::string& path) {
        if (path.ends_with(".en") || path.ends_with(".ko")) return true;
        for (std::size_t dot = path.find('.'); dot != std::string::npos; dot = path.find('.', dot + 1)) {
            const auto holder = rows.find(path.substr(0, dot));
            if (holder == rows.end()) continue;
            for (const char* free : {"settings", "members of your choice", "a text"})
                if (holder->second.find(free) != std::string::npos) return true;
        }
        return false;
    };
    for (const std::string& path : paths)
        if (!is_free(path)) {
            EXPECT_EQ(rows.count(path), 1U) << path;
        }
}

TEST_F(MemberTables, SayWhichPartsOfALectureHaveAMember) {
    const auto rows = table("lessons", "The members of lecture files");
    EXPECT_EQ(rows.at("parts[].steps"), "a list of at most 64: a whole number from 1 to 200 or a name (lesson)");
    EXPECT_EQ(rows.at("parts[].preset"), "a name; needed (preset)");
    EXPECT_EQ(rows.at("parts[].minutes"), "a whole number from 1 to 600; needed");
}

TEST_F(MemberTables, EndTheTopicsOfAllForms) {
    for (const auto& [topic, form] : std::map<std::string, std::string>{{"states", "scene"},
                                                                        {"suites", "suite"},
                                                                        {"lessons", "lecture"},
                                                                        {"exercises", "exercise"},
                                                                        {"grading", "hand-in"},
                                                                        {"sweeps", "flight"}}) {
        const auto rows = table(topic, "The members of " + form + " files");
        const nlohmann::json schema = nlohmann::json::parse(expect(0, {"params", "--format", form + "-schema"}).out);
        for (const auto& [name, member] : schema["properties"].items())
            if (member.is_object()) {
                EXPECT_EQ(rows.count(name), 1U) << form << ": " << name;
            }
    }
}

}  // namespace
}  // namespace cli_tests
