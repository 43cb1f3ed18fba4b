// What the window remembers from one time to the next: read back as written, and one sentence for what is broken.
#include "state/person/remembered.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>

#include "scratch_folder.h"

namespace viewing {
namespace {

namespace fs = std::filesystem;

class RememberedTest : public testing::ScratchFolder {
protected:
    fs::path file = folder_ / "config" / "viewing-sandbox" / "window.json";

    std::string error_of(const char* text) const {
        const Result<Remembered> read = read_remembered(write("broken.json", text));
        return read ? "" : read.error();
    }
};

TEST_F(RememberedTest, ReadsBackWhatWasWrittenAndNothingFromNoFile) {
    EXPECT_EQ(*read_remembered(file), Remembered{});
    EXPECT_EQ(*read_remembered({}), Remembered{});
    for (const Remembered& each :
         {Remembered{}, Remembered{Theme::projector, 1.3, WindowPlace{{-1600, 40}, {1200, 700}, true}},
          Remembered{Theme::light, std::nullopt, WindowPlace{{0, 0}, {800, 600}, false}},
          Remembered{
              {}, {}, {}, {{"lens", {3, {0, 2}}}, {"rays", {}}}, {"/home/ann/a b.json", "/tmp/x.obj"}, Language::ko}}) {
        ASSERT_TRUE(write_remembered(file, each));
        EXPECT_EQ(*read_remembered(file), each);
    }
    EXPECT_TRUE(write_remembered({}, Remembered{}));
}

TEST_F(RememberedTest, SaysInOneSentenceWhatIsBroken) {
    for (const char* text : {"", "hello", "[]", R"({"theme": "pink"})", R"({"theme": 3})", R"({"language": "xx"})",
                             R"({"scale": 1e9})", R"({"scale": "large"})", R"({"window": 3})", R"({"window": {}})",
                             R"({"window": {"position": [0], "size": [800, 600]}})",
                             R"({"window": {"position": [0, 0], "size": [0, 600]}})",
                             R"({"window": {"position": [0, 1e300], "size": [800, 600]}})", R"({"lessons": []})",
                             R"({"lessons": {"lens": 3}})", R"({"lessons": {"lens": {"step": 0}}})",
                             R"({"lessons": {"lens": {"done": [1e9]}}})", R"({"recent": "a"})", R"({"recent": [1]})"}) {
        const std::string error = error_of(text);
        EXPECT_NE(error.find("broken.json"), std::string::npos) << text << ": " << error;
        EXPECT_EQ(error.find('\n'), std::string::npos) << error;
    }
    EXPECT_EQ(error_of(R"({"theme": "dark", "later": "version"})"), "") << "of a later version is taken what is known";
}

TEST_F(RememberedTest, WhatCannotBeWrittenIsASentence) {
    const fs::path in_the_way = write("file", "in the way");
    const Status written = write_remembered(in_the_way / "window.json", {Theme::light, {}, {}});
    ASSERT_FALSE(written);
    EXPECT_NE(written.error().find(in_the_way.string()), std::string::npos);
}

TEST_F(RememberedTest, StandsWhereThePersonsSettingsAre) {
    const char* const home = std::getenv("HOME");
    const std::string home_before = home ? home : "";
    ::setenv("XDG_CONFIG_HOME", "/settings", 1);
    EXPECT_EQ(remembered_file(), "/settings/viewing-sandbox/window.json");
    ::setenv("XDG_CONFIG_HOME", "relative", 1);  // such ones do not count
    ::setenv("HOME", "/home/ann", 1);
    EXPECT_EQ(remembered_file(), "/home/ann/.config/viewing-sandbox/window.json");
    ::unsetenv("XDG_CONFIG_HOME");
    ::unsetenv("HOME");
    EXPECT_EQ(remembered_file(), "");
    if (home) ::setenv("HOME", home_before.c_str(), 1);
}

TEST(WindowPlaces, AreTakenOnlyWhereTheWindowCanBeTakenHoldOf) {
    const std::array screens{WindowPlace{{0, 0}, {1920, 1080}}, WindowPlace{{1920, 0}, {1280, 720}}};
    EXPECT_TRUE(is_reachable({{100, 100}, {800, 600}}, screens));
    EXPECT_TRUE(is_reachable({{-600, 0}, {800, 600}}, screens));
    EXPECT_TRUE(is_reachable({{3000, 300}, {800, 600}}, screens));
    EXPECT_FALSE(is_reachable({{-750, 0}, {800, 600}}, screens));
    EXPECT_FALSE(is_reachable({{100, -20}, {800, 600}}, screens)) << "its title is above the screen";
    EXPECT_FALSE(is_reachable({{2500, 900}, {800, 600}}, screens));
    EXPECT_FALSE(is_reachable({{100, 100}, {800, 600}}, std::span<const WindowPlace>()));
}

}  // namespace
}  // namespace viewing
