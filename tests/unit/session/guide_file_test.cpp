// A lesson in a user's file is read again when the file changes.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "session/guide.h"

namespace viewing::test {
namespace {

namespace fs = std::filesystem;

class GuideFile : public ::testing::Test {
protected:
    GuideFile() { fs::create_directories(folder_); }
    ~GuideFile() override { fs::remove_all(folder_); }

    /// Writes a lesson with these steps and a new modification time.
    void write(const std::string& steps) {
        std::ofstream(file()) << R"({"lesson": 1, "id": "mine", "title": "Mine", "steps": [)" << steps << "]}";
        fs::last_write_time(file(), fs::file_time_type::clock::now() + std::chrono::seconds(++writes_));
    }
    static std::string step(const std::string& id, const std::string& say) {
        return R"({"id": ")" + id + R"(", "say": ")" + say + R"(", "ask": {"kind": "choice", "question": "Which?",
            "choices": [{"say": "a", "right": true}, {"say": "b", "why": "No."}]}, "reveal": {"say": "So."}})";
    }
    std::string file() const { return (folder_ / "mine.json").string(); }
    void update_for_a_while() {
        for (int i = 0; i < 300; ++i) {
            guide.update(session, 0.1);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }

    fs::path folder_ = fs::temp_directory_path() / ("guide_file_test_" + std::to_string(getpid()));
    int writes_ = 0;
    Session session = *Session::make(*load_state(""));
    Guide guide;
};

TEST_F(GuideFile, IsReadAgainAndStaysAtItsStep) {
    write(step("one", "First.") + "," + step("two", "Second."));
    guide.begin(*load_lesson(file()), 1, session);
    EXPECT_TRUE(guide.watches_file());
    guide.moves = false;
    guide.reveal(session);
    write(step("zero", "New.") + "," + step("one", "First.") + "," + step("two", "Better."));
    update_for_a_while();
    EXPECT_EQ(guide.run()->step().say.in_english(), "Better.");
    EXPECT_EQ(guide.run()->index(), 2U);
    EXPECT_TRUE(guide.run()->is_revealed());

    write("{");  // an editor may have written half the file
    update_for_a_while();
    EXPECT_TRUE(session.message.is_error);
    EXPECT_EQ(guide.run()->step().say.in_english(), "Better.") << "the last valid lesson stays";
    write(step("two", "Best."));
    update_for_a_while();
    EXPECT_EQ(guide.run()->step().say.in_english(), "Best.");
    EXPECT_FALSE(session.message.is_error);
}

TEST_F(GuideFile, TheProgramsOwnLessonsAreNotWatched) {
    guide.begin(*load_lesson("lens"), 0, session);
    EXPECT_FALSE(guide.watches_file());
}

}  // namespace
}  // namespace viewing::test
