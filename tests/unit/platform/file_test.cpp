// Files are written completely or not at all, even if other files are planted beside them. Files that would block a
// reader are refused.
#include "platform/file.h"

#include <gtest/gtest.h>
#include <sys/fsuid.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <vector>

#include "platform/text_file.h"

namespace viewing {
namespace {

namespace fs = std::filesystem;

class Files : public ::testing::Test {
protected:
    Files() {
        std::string name = (fs::temp_directory_path() / "viewing-files-XXXXXX").string();
        folder = ::mkdtemp(name.data());
    }
    ~Files() override { fs::remove_all(folder); }

    static Status write(const fs::path& path, const std::string& text) {
        return write_file(path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    }
    static std::string read(const fs::path& path) {
        std::ifstream stream(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    std::size_t file_count() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
    }

    fs::path folder;
};

TEST_F(Files, WriteFollowsNoPlantedLink) {
    std::ofstream(folder / "victim") << "kept";
    fs::create_symlink(folder / "victim", folder / ("shot.png.partial-" + std::to_string(::getpid())));
    ASSERT_TRUE(write(folder / "shot.png", "new"));
    EXPECT_EQ(read(folder / "victim"), "kept");
    EXPECT_EQ(read(folder / "shot.png"), "new");
    EXPECT_EQ(file_count(), 3U) << "nothing is left over";
}

TEST_F(Files, AreTheSameUnderAnyName) {
    std::ofstream(folder / "a") << "a";
    std::ofstream(folder / "b") << "a";
    fs::create_directory(folder / "in");
    fs::create_hard_link(folder / "a", folder / "hard");
    fs::create_symlink("a", folder / "soft");
    fs::create_symlink("nowhere", folder / "dangling");
    fs::create_symlink("round", folder / "round");
    fs::create_directory_symlink("in", folder / "link");
    for (const char* const name : {"a", "hard", "soft", "in/../a", "./a"})
        EXPECT_TRUE(are_same_file(folder / "a", folder / name)) << name;
    EXPECT_TRUE(are_same_file(folder / "nowhere", folder / "dangling"));
    EXPECT_TRUE(are_same_file(folder / "in/new", folder / "link/new"));
    EXPECT_TRUE(are_same_file(folder / "in", folder / "link"));
    EXPECT_FALSE(are_same_file(folder / "a", folder / "b"));
    EXPECT_FALSE(are_same_file(folder / "a", folder / "new"));
    EXPECT_FALSE(are_same_file(folder / "new", folder / "in/new"));
    EXPECT_FALSE(are_same_file(folder / "round", folder / "new"));
    EXPECT_FALSE(are_same_file("/dev/null", "/dev/null"));
    EXPECT_FALSE(are_same_file("", ""));
}

TEST_F(Files, KeepTheirPermissions) {
    std::ofstream(folder / "old") << "old";
    fs::permissions(folder / "old", fs::perms(0640));
    ASSERT_TRUE(write(folder / "old", "new"));
    EXPECT_EQ(fs::status(folder / "old").permissions(), fs::perms(0640));
    const mode_t mask = ::umask(027);
    ASSERT_TRUE(write(folder / "fresh", "new"));
    ::umask(mask);
    EXPECT_EQ(fs::status(folder / "fresh").permissions(), fs::perms(0640)) << "like any new file";
}

TEST_F(Files, WriteFollowsLinksToMissingFiles) {
    fs::create_directory(folder / "below");
    fs::create_symlink("below/second", folder / "first");
    fs::create_symlink("third", folder / "below" / "second");
    ASSERT_TRUE(write(folder / "first", "new"));
    EXPECT_TRUE(fs::is_symlink(folder / "first"));
    EXPECT_TRUE(fs::is_symlink(folder / "below" / "second"));
    EXPECT_EQ(read(folder / "below" / "third"), "new");
    fs::create_symlink("round", folder / "round");
    const Status status = write(folder / "round", "new");
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().find((folder / "round").string() + ": cannot be written: "), 0U) << status.error();
}

TEST_F(Files, MayHaveTheLongestNameOfTheFileSystem) {
    const fs::path longest = folder / std::string(255, 'x');
    ASSERT_TRUE(write(longest, "new"));
    EXPECT_EQ(read(longest), "new");
    EXPECT_FALSE(write(folder / std::string(256, 'x'), "new"));
    EXPECT_EQ(file_count(), 1U) << "nothing is left over";
}

TEST_F(Files, OfOneResultAreWrittenTogether) {
    std::ofstream(folder / "old") << "old";
    const std::vector<std::uint8_t> bytes{'n', 'e', 'w'};
    const auto both = [&](const fs::path& second) {
        const FileBytes files[] = {{folder / "old", bytes}, {second, bytes}};
        return write_files(files);
    };
    for (const fs::path& impossible : {folder / "none" / "file", folder, fs::path("/dev/full"), fs::path()}) {
        EXPECT_FALSE(both(impossible)) << impossible;
        EXPECT_EQ(read(folder / "old"), "old") << impossible;
        EXPECT_EQ(file_count(), 1U) << "nothing is left over";
    }
    ASSERT_TRUE(both(folder / "second"));
    EXPECT_EQ(read(folder / "old") + read(folder / "second"), "newnew");
}

/// The second file cannot take its name once its folder is removed; the first write must then be rolled back.
TEST_F(Files, AreAllRolledBackWhenOneFails) {
    for (const bool was_there : {true, false}) {
        const fs::path first = folder / "first", sub = folder / "sub";
        fs::remove(first);
        if (was_there) {
            ASSERT_TRUE(write(first, "old"));
        }
        fs::create_directory(sub);
        const std::string bytes = "new";
        const std::span<const std::uint8_t> span(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
        const FileBytes files[] = {{first, span}, {sub / "second", span}};
        const Status written = write_files(files, [&sub] { fs::remove_all(sub); });
        ASSERT_FALSE(written);
        EXPECT_NE(written.error().find("second: cannot be written: No such file"), std::string::npos)
            << written.error();
        EXPECT_EQ(fs::exists(first), was_there);
        EXPECT_EQ(read(first), was_there ? "old" : "");
        EXPECT_EQ(file_count(), was_there ? 1U : 0U);
    }
}

TEST_F(Files, UnfinishedOnesAreRemovedOnTermination) {
    const std::string bytes = "new";
    const FileBytes file{folder / "file", {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}};
    std::size_t before = 0, after = 1;
    const Status written = write_files({&file, 1}, [&] {
        before = file_count();
        remove_unfinished_files();
        after = file_count();
    });
    EXPECT_FALSE(written);
    EXPECT_EQ(before, 1U);
    EXPECT_EQ(after, 0U);
    ASSERT_TRUE(write(folder / "file", "more"));
    remove_unfinished_files();
    EXPECT_EQ(file_count(), 1U) << "a file with its final name is finished";
}

TEST_F(Files, ProcFilesAreNotRead) {
    const Status readable = check_readable("/proc/self/status");
    ASSERT_FALSE(readable);
    EXPECT_EQ(readable.error(), "/proc/self/status: is not a file on a disk");
}

TEST_F(Files, PipeIsRefusedWithoutWaiting) {
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    const Result<std::string> text = read_text_file(folder / "pipe");
    ASSERT_FALSE(text);
    EXPECT_EQ(text.error(), (folder / "pipe").string() + ": is not a file");
    EXPECT_FALSE(check_readable("/dev/zero"));
    EXPECT_EQ(check_readable(folder / "missing").error(), (folder / "missing").string() + ": no such file");
}

TEST_F(Files, UnreadableOnesAreReported) {
    std::ofstream(folder / "secret") << "secret";
    fs::permissions(folder / "secret", fs::perms::none);
    fs::create_directory(folder / "closed");
    std::ofstream(folder / "closed" / "file") << "file";
    fs::permissions(folder / "closed", fs::perms::none);
    fs::permissions(folder, fs::perms(0711));
    // The superuser may read every file, so the test reads as another user. For an ordinary user, these calls change
    // nothing and are not needed.
    const auto own = static_cast<uid_t>(::setfsuid(65534));
    const Status secret = check_readable(folder / "secret"), inside = check_readable(folder / "closed" / "file");
    ::setfsuid(own);
    fs::permissions(folder / "closed", fs::perms(0700));
    ASSERT_FALSE(secret);
    EXPECT_EQ(secret.error(), (folder / "secret").string() + ": cannot be read: Permission denied");
    ASSERT_FALSE(inside);
    EXPECT_EQ(inside.error(), (folder / "closed" / "file").string() + ": cannot be read: Permission denied");
    const fs::path long_name = folder / std::string(256, 'x');
    EXPECT_EQ(check_readable(long_name).error(), long_name.string() + ": cannot be read: File name too long");
}

}  // namespace
}  // namespace viewing
