// The window's settings between runs: they read back as written, and broken ones are reported in one sentence.
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

TEST_F(RememberedTest, ReadsBackOrIsEmptyWithoutAFile) {
    EXPECT_EQ(*read_remembered(file), Remembered{});
    EXPECT_EQ(*read_remembered({}), Remembered{});
    for (const Remembered& each :
         {Remembered{}, Remembered{Theme::projector, 1.3, WindowPlace{{-1600, 40}, {1200, 700}, true}},
          Remembered{Theme::light, std::nullopt, WindowPlace{{0, 0}, {800, 600}, false}},
          Remembered{{},
                     {},
                     {},
                     {{"lens", {3, {0, 2}}}, {"rays", {}}},
                     {"/home/ann/a b.json", "/tmp/x.obj"},
                     Language::ko,
                     {},
                     "rays",
                     {false, true, true, true, 0.25}}}) {
        ASSERT_TRUE(write_remembered(file, each));
        EXPECT_EQ(*read_remembered(file), each);
    }
    EXPECT_TRUE(write_remembered({}, Remembered{}));
}

TEST_F(RememberedTest, ReportsABrokenFileInOneSentence) {
    for (const char* text : {"",
                             "hello",
                             "[]",
                             R"({"theme": "pink"})",
                             R"({"theme": 3})",
                             R"({"language": "xx"})",
                             R"({"scale": 1e9})",
                             R"({"scale": "large"})",
                             R"({"window": 3})",
                             R"({"window": {}})",
                             R"({"window": {"position": [0], "size": [800, 600]}})",
                             R"({"window": {"position": [0, 0], "size": [0, 600]}})",
                             R"({"window": {"position": [0, 1e300], "size": [800, 600]}})",
                             R"({"lessons": []})",
                             R"({"lessons": {"lens": 3}})",
                             R"({"lessons": {"lens": {"step": 0}}})",
                             R"({"lessons": {"lens": {"done": [1e9]}}})",
                             R"({"recent": "a"})",
                             R"({"recent": [1]})",
                             R"({"mouse": 3})",
                             R"({"mouse": {"keep_horizon": 1}})",
                             R"({"mouse": {"sensitivity": 0}})",
                             R"({"mouse": {"sensitivity": "fast"}})"}) {
        const std::string error = error_of(text);
        EXPECT_NE(error.find("broken.json"), std::string::npos) << text << ": " << error;
        EXPECT_EQ(error.find('\n'), std::string::npos) << error;
    }
    EXPECT_EQ(error_of(R"({"theme": "dark", "later": "version"})"), "") << "known fields of a later version are used";
}

/// A window's changes win; everything else comes from the file.
TEST(MergedRemembered, EachWindowChangesOnlyItsOwnFields) {
    const WindowPlace here{{1, 2}, {800, 600}}, there{{3, 4}, {900, 700}};
    const Remembered known{Theme::dark, 1.0, here, {{"lens", {1, {0}}}}, {}, Language::en, {"c", "1", "Kim"}};
    Remembered kept = known, now = known;
    EXPECT_EQ(merged(kept, known, now), known);
    kept.theme = Theme::light;
    kept.window = there;
    now.scale = 2.0;
    now.language = Language::ko;
    kept.student = {"c", "2", "Lee"};
    kept.lessons = {{"lens", {4, {0, 3}}}, {"rays", {2, {1}}}};
    now.lessons = {{"lens", {1, {0, 2}}}, {"planes", {5, {}}}};
    const Remembered both{Theme::light,
                          2.0,
                          there,
                          {{"lens", {4, {0, 2, 3}}}, {"planes", {5, {}}}, {"rays", {2, {1}}}},
                          {},
                          Language::ko,
                          {"c", "2", "Lee"}};
    EXPECT_EQ(merged(kept, known, now), both);
    EXPECT_EQ(merged(both, known, now), both) << "merging again changes nothing";
    now.student = {"c", "3", "Park"};
    now.lessons["lens"].step = 6;
    EXPECT_EQ(merged(kept, known, now).student.number, "3") << "the latest change wins";
    EXPECT_EQ(merged(kept, known, now).lessons.at("lens").step, 6U);
    EXPECT_EQ(merged({}, known, now).theme, std::nullopt) << "another window has cleared everything";
}

TEST(MergedRemembered, FilesAreInTheOrderOfOpening) {
    const auto recent = [](std::vector<std::string> kept, std::vector<std::string> known,
                           std::vector<std::string> now) {
        const auto of = [](std::vector<std::string> files) {
            Remembered remembered;
            remembered.recent = std::move(files);
            return remembered;
        };
        return merged(of(std::move(kept)), of(std::move(known)), of(std::move(now))).recent;
    };
    using Files = std::vector<std::string>;
    EXPECT_EQ(recent({"a", "b"}, {"a", "b"}, {"a", "b"}), (Files{"a", "b"}));
    EXPECT_EQ(recent({"x", "a", "b"}, {"a", "b"}, {"a", "b"}), (Files{"x", "a", "b"})) << "opened elsewhere";
    EXPECT_EQ(recent({"x", "a", "b"}, {"a", "b"}, {"n", "a", "b"}), (Files{"n", "x", "a", "b"})) << "opened in both";
    EXPECT_EQ(recent({"x", "a", "b"}, {"a", "b"}, {"b", "a"}), (Files{"b", "x", "a"})) << "opened again";
    EXPECT_EQ(recent({"a", "b"}, {"a", "b"}, {"a"}), (Files{"a", "b"})) << "a shorter list removes no file";
    EXPECT_EQ(recent({}, {}, {"a", "b"}), (Files{"a", "b"}));
    Files many;
    for (int i = 0; i < 25; ++i) many.push_back(std::to_string(i));
    EXPECT_EQ(recent(many, {}, {"new"}).front(), "new");
    EXPECT_LE(recent(many, {}, {"new"}).size(), 20U) << "the reader accepts no more";
}

TEST_F(RememberedTest, FailedWriteIsReported) {
    const fs::path in_the_way = write("file", "in the way");
    const Status written = write_remembered(in_the_way / "window.json", {Theme::light, {}, {}});
    ASSERT_FALSE(written);
    EXPECT_NE(written.error().find(in_the_way.string()), std::string::npos);
}

TEST_F(RememberedTest, UsesTheUsersSettingsFolder) {
    const char* const home = std::getenv("HOME");
    const std::string home_before = home ? home : "";
    ::setenv("XDG_CONFIG_HOME", "/settings", 1);
    EXPECT_EQ(remembered_file(), "/settings/viewing-sandbox/window.json");
    ::setenv("XDG_CONFIG_HOME", "relative", 1);  // relative paths do not count
    ::setenv("HOME", "/home/ann", 1);
    EXPECT_EQ(remembered_file(), "/home/ann/.config/viewing-sandbox/window.json");
    ::unsetenv("XDG_CONFIG_HOME");
    ::unsetenv("HOME");
    EXPECT_EQ(remembered_file(), "");
    if (home) ::setenv("HOME", home_before.c_str(), 1);
}

TEST(WindowPlaces, AreUsedOnlyIfTheWindowCanBeGrabbed) {
    const std::array screens{WindowPlace{{0, 0}, {1920, 1080}}, WindowPlace{{1920, 0}, {1280, 720}}};
    EXPECT_TRUE(is_reachable({{100, 100}, {800, 600}}, screens));
    EXPECT_TRUE(is_reachable({{-600, 0}, {800, 600}}, screens));
    EXPECT_TRUE(is_reachable({{3000, 300}, {800, 600}}, screens));
    EXPECT_FALSE(is_reachable({{-750, 0}, {800, 600}}, screens));
    EXPECT_FALSE(is_reachable({{100, -20}, {800, 600}}, screens)) << "its title bar is above the screen";
    EXPECT_FALSE(is_reachable({{2500, 900}, {800, 600}}, screens));
    EXPECT_FALSE(is_reachable({{100, 100}, {800, 600}}, std::span<const WindowPlace>()));
}

}  // namespace
}  // namespace viewing
