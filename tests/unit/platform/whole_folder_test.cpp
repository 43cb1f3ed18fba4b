// A folder that appears complete or not at all and never replaces a foreign folder.
#include "platform/whole_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "platform/file.h"

namespace viewing {
namespace {

namespace fs = std::filesystem;

class WholeFolders : public ::testing::Test {
protected:
    WholeFolders() {
        std::string name = (fs::temp_directory_path() / "viewing-folders-XXXXXX").string();
        place = ::mkdtemp(name.data());
    }
    ~WholeFolders() override { fs::remove_all(place); }
    static bool is_text(const fs::path& file) { return file.extension() == ".txt"; }
    static void put(const fs::path& file) { std::ofstream(file) << "x"; }
    std::size_t count() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(place), fs::directory_iterator()));
    }
    fs::path place;
};

TEST_F(WholeFolders, AppearOnlyUnderTheirFinalName) {
    {
        Result<WholeFolder> folder = WholeFolder::begin(place / "a/b/new/");
        ASSERT_TRUE(folder) << folder.error();
        put(folder->beside() / "1.txt");
        EXPECT_FALSE(fs::exists(place / "a"));
    }
    EXPECT_EQ(count(), 0U) << "abandoned: nothing remains, not even a parent";
    Result<WholeFolder> folder = WholeFolder::begin(place / "a/b/new/");
    put(folder->beside() / "1.txt");
    EXPECT_TRUE(folder->take_name());
    EXPECT_TRUE(fs::exists(place / "a/b/new/1.txt"));
    EXPECT_EQ(count(), 1U);
}

TEST_F(WholeFolders, ReplaceOnlyTheirOwnKind) {
    fs::create_directory(place / "old");
    put(place / "old/1.txt");
    put(place / "old/2.txt");
    EXPECT_FALSE(WholeFolder::begin(place / "old")) << "no file is declared as its own";
    {
        Result<WholeFolder> folder = WholeFolder::begin(place / "old", is_text);
        ASSERT_TRUE(folder) << folder.error();
        put(folder->beside() / "3.txt");
        put(place / "old/b.foreign");  // appears while the new folder grows
        put(place / "old/a.foreign");
        const Status taken = folder->take_name();
        ASSERT_FALSE(taken);
        EXPECT_NE(taken.error().find("it contains a.foreign"), std::string::npos) << taken.error();
    }
    EXPECT_TRUE(fs::exists(place / "old/2.txt"));
    EXPECT_EQ(count(), 1U);
    fs::remove(place / "old/a.foreign");
    fs::remove(place / "old/b.foreign");
    {
        Result<WholeFolder> folder = WholeFolder::begin(place / "old", is_text);
        put(folder->beside() / "3.txt");
        EXPECT_TRUE(folder->take_name());
    }
    EXPECT_TRUE(fs::exists(place / "old/3.txt"));
    EXPECT_FALSE(fs::exists(place / "old/1.txt"));
    EXPECT_EQ(count(), 1U);
}

/// Calls remove_unfinished_files() directly, as a signal handler does.
TEST_F(WholeFolders, AreRemovedWithTheirContents) {
    Result<WholeFolder> folder = WholeFolder::begin(place / "new");
    ASSERT_TRUE(folder) << folder.error();
    fs::create_directories(folder->beside() / "deep/deeper");
    for (int i = 0; i < 3000; ++i) put(folder->beside() / ("deep/" + std::to_string(i) + std::string(100, 'n')));
    put(folder->beside() / "deep/deeper/last");
    put(place / "kept");
    fs::create_directory_symlink(place, folder->beside() / "link");
    remove_unfinished_files();
    EXPECT_EQ(count(), 1U);
    EXPECT_TRUE(fs::exists(place / "kept")) << "a link is not followed";
}

}  // namespace
}  // namespace viewing
