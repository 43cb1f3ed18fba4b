// Runs the real program as a user or a script would, and keeps its output. VIEWING_SANDBOX holds its path.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "text/json.h"

namespace cli_tests {

/// Returns whether the text contains this part.
inline bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

inline std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

/// The text of a mesh file.
inline constexpr const char* tetrahedron = "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

/// How a run ended: exit status (128 + signal if killed), standard output, standard error, peak memory.
struct Ended {
    int status = -1;
    std::string out, err;
    std::int64_t peak_bytes = 0;

    /// Describes the run, for a failed expectation.
    std::string told() const { return "exit " + std::to_string(status) + "\nout: " + out + "\nerr: " + err; }
    nlohmann::json json() const { return nlohmann::json::parse(out); }
};

struct Surroundings {
    std::string input = {};                               ///< standard input
    std::filesystem::path folder = {};                    ///< working directory; the test's own if empty
    std::map<std::string, std::string> environment = {};  ///< variables to add to the test's own
    std::vector<std::string> without = {};                ///< environment variables to remove
    bool input_stays_open = false;                        ///< standard input is a pipe that stays open without any data
    std::string output = {};                              ///< the file that gets standard output, if not empty
    std::map<int, unsigned long> limits = {};             ///< limits of the process, by RLIMIT_…
    bool output_has_no_reader = false;                    ///< standard output is a pipe whose other end is closed
    int signal = 0;                                       ///< sent as soon as `signal_when` is true; 0: none
    std::function<bool()> signal_when = {};
};

/// Every test has its own folder, which is the program's working directory and is deleted afterwards. There is no
/// display unless a test provides one.
class Program : public testing::Test {
protected:
    Program();
    ~Program() override;

    Ended run(const std::vector<std::string>& arguments, const Surroundings& surroundings = {}) const;

    std::filesystem::path folder() const { return folder_; }
    void write(const std::string& name, const std::string& text) const;
    std::string read(const std::string& name) const;
    bool exists(const std::string& name) const { return std::filesystem::exists(folder_ / name); }
    std::size_t files() const;  ///< the number of files in the folder

    /// Runs the program and expects this status, and one line on stderr unless the status is 0.
    Ended expect(int status, const std::vector<std::string>& arguments, const Surroundings& surroundings = {}) const;
    /// Expects bad input to be refused: the line must contain each of `words`, and no file may appear.
    void refused(const std::vector<std::string>& arguments, const std::vector<std::string>& words,
                 const Surroundings& surroundings = {}) const;

private:
    std::filesystem::path folder_;
};

}  // namespace cli_tests
