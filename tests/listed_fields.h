// The golden list of all fields, tests/fields.txt. Each field has the line that `params --format text` prints. The
// indented lines after it list the field's controls in the panel, with every section expanded in the opening state. A
// control that is not available in fly mode is followed by a mode in which it is, such as "[walk]". "elsewhere" means
// that only another state or view has a control, which has a test of its own; "none" means that there is no control.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace viewing::testing {

struct ListedField {
    std::string description;  ///< "shadow.lift number a number from 0 to 10; default 0.002; in world units"
    std::vector<std::string> controls;

    std::string path() const { return description.substr(0, description.find(' ')); }
};

inline std::vector<ListedField> listed_fields() {
    std::ifstream file(std::filesystem::path(std::getenv("TEST_SOURCE_DIR")) / "fields.txt");
    EXPECT_TRUE(file) << "tests/fields.txt";
    std::vector<ListedField> listed;
    for (std::string line; std::getline(file, line);) {
        const bool is_control = line.starts_with("    ") && !listed.empty();
        if (is_control)
            listed.back().controls.push_back(line.substr(4));
        else
            listed.push_back({line, {}});
    }
    return listed;
}

}  // namespace viewing::testing
