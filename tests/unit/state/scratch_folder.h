// A temporary folder for a test, deleted when the test ends.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace viewing::testing {

class ScratchFolder : public ::testing::Test {
protected:
    ScratchFolder() {
        const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::temp_directory_path() / (std::string("viewing-") + info->test_suite_name() + "-" +
                                                            info->name() + "-" + std::to_string(getpid()));
        std::filesystem::create_directories(folder_);
    }
    ~ScratchFolder() override {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }

    std::filesystem::path write(const std::string& name, const std::string& content) const {
        std::ofstream(folder_ / name, std::ios::binary) << content;
        return folder_ / name;
    }

    std::filesystem::path folder_;
};

}  // namespace viewing::testing
