// Two windows of one user write the same file and are killed while they do so. Every write that a window reported as
// done must be in the file at the end. The windows are processes; each reports its writes through a pipe and is killed
// after a seeded number of writes, usually in the middle of a write.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <functional>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <thread>

#include "lesson/hand_in.h"
#include "platform/shared_file.h"
#include "state/person/remembered.h"
#include "unit/state/scratch_folder.h"

namespace viewing {
namespace {

namespace fs = std::filesystem;

/// A process that runs until it is killed. It sends ints through the pipe.
class Child {
public:
    explicit Child(const std::function<void(const std::function<void(int)>& tell)>& work) {
        std::array<int, 2> ends{};
        if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
        pid_ = ::fork();
        if (pid_ == 0) {
            work([to = ends[1]](int told) { [[maybe_unused]] const auto sent = ::write(to, &told, sizeof told); });
            ::_exit(1);
        }
        ::close(ends[1]);
        from_ = ends[0];
    }
    ~Child() { kill(); }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    /// Returns the next reported int, or none after the end.
    std::optional<int> told() const {
        int number = 0;
        return ::read(from_, &number, sizeof number) == sizeof number ? std::optional(number) : std::nullopt;
    }
    int descriptor() const { return from_; }
    /// Sends SIGKILL and returns the reports sent before.
    std::vector<int> kill() {
        std::vector<int> rest;
        if (pid_ <= 0) return rest;
        ::kill(pid_, SIGKILL);
        while (const std::optional<int> number = told()) rest.push_back(*number);
        ::waitpid(pid_, nullptr, 0);
        ::close(from_);
        pid_ = 0;
        return rest;
    }

private:
    pid_t pid_ = 0;
    int from_ = -1;
};

/// A window that writes consecutive numbers, starting at `first`.
using Window = std::function<void(int first, const std::function<void(int)>& tell)>;

/// Runs two windows at a time, kills and replaces each after a random number of writes, and returns the numbers that
/// they reported as written, at least `wanted` of them.
std::set<int> written_by_two(const Window& window, int wanted, unsigned seed) {
    constexpr int most_by_one = 1'000'000;
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> life(1, 40);
    std::set<int> told;
    int begun = 0;
    struct One {
        std::unique_ptr<Child> child;
        int left = 0;
    };
    std::array<One, 2> two;
    while (static_cast<int>(told.size()) < wanted) {
        for (One& one : two)
            if (!one.child) {
                const int first = begun++ * most_by_one;
                one = {std::make_unique<Child>([&window, first](const auto& tell) { window(first, tell); }),
                       life(random)};
            }
        std::array<pollfd, 2> waits{{{two[0].child->descriptor(), POLLIN, 0}, {two[1].child->descriptor(), POLLIN, 0}}};
        ::poll(waits.data(), waits.size(), -1);
        for (std::size_t i = 0; i < two.size(); ++i) {
            if (waits[i].revents == 0) continue;
            const std::optional<int> number = two[i].child->told();
            if (!number) {
                ADD_FAILURE() << "a window failed to write";
                return told;
            }
            told.insert(*number);
            if (--two[i].left > 0) continue;
            for (const int last : two[i].child->kill()) told.insert(last);
            two[i].child.reset();
        }
    }
    for (One& one : two)
        if (one.child)
            for (const int last : one.child->kill()) told.insert(last);
    EXPECT_GT(begun, 2) << "some windows were killed";
    return told;
}

class TwoWindows : public testing::ScratchFolder {
protected:
    void expect_all_answers(int writes) const;
    void expect_all_steps(int writes) const;

    fs::path file = folder_ / "deep" / "kept.json";
    const unsigned seed = 20261126;
};

/// Runs two windows until they have reported at least `writes` answers, and expects to find each of these in the file
/// exactly once.
void TwoWindows::expect_all_answers(int writes) const {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const std::array ids{"E01", "E02", "E03", "E04", "E05"};
    const Window window = [&](int first, const std::function<void(int)>& tell) {
        HandIn known;
        if (const Result<HandIn> there = load_hand_in(file)) known = *there;
        HandIn now = known;
        for (int number = first;; ++number) {
            const std::string id = ids[static_cast<std::size_t>(number) % ids.size()];
            if (!now.find(id)) now.items.push_back({id, 3, {}, {}, {}, {}});
            Attempt attempt;
            attempt.at = std::to_string(number % 7);
            attempt.answer = {static_cast<double>(number)};
            now.find(id)->attempts.push_back(attempt);
            const Result<HandIn> written = merge_hand_in(file, known, now);
            if (!written) return;
            known = now = *written;
            tell(number);
        }
    };
    const std::set<int> told = written_by_two(window, writes, seed);
    const Result<HandIn> kept = load_hand_in(file);
    ASSERT_TRUE(kept) << kept.error();
    std::map<int, int> count;
    for (const HandInItem& item : kept->items)
        for (const Attempt& attempt : item.attempts) ++count[static_cast<int>(attempt.answer->front())];
    for (const int number : told) EXPECT_EQ(count[number], 1) << "the answer " << number;
}

/// Runs two windows until they have reported at least `writes` finished steps, and expects to find each of these in the
/// file.
void TwoWindows::expect_all_steps(int writes) const {
    SCOPED_TRACE("seed " + std::to_string(seed));
    constexpr int lessons = 5, steps = 150;
    const Window window = [&](int first, const std::function<void(int)>& tell) {
        Remembered known;
        if (const Result<Remembered> there = read_remembered(file)) known = *there;
        Remembered now = known;
        std::mt19937 random(static_cast<unsigned>(first));
        for (;;) {
            const int number = static_cast<int>(random() % (lessons * steps));
            std::vector<std::size_t>& done = now.lessons["lesson " + std::to_string(number / steps)].done;
            const auto step = static_cast<std::size_t>(number % steps);
            if (const auto at = std::lower_bound(done.begin(), done.end(), step); at == done.end() || *at != step)
                done.insert(at, step);
            const std::string opened = "/" + std::to_string(first);
            std::erase(now.recent, opened);
            now.recent.insert(now.recent.begin(), opened);
            const Result<Remembered> written = merge_remembered(file, known, now);
            if (!written) return;
            known = now = *written;
            tell(number);
        }
    };
    const std::set<int> told = written_by_two(window, writes, seed);
    const Result<Remembered> kept = read_remembered(file);
    ASSERT_TRUE(kept) << kept.error();
    for (const int number : told) {
        const std::vector<std::size_t>& done = kept->lessons.at("lesson " + std::to_string(number / steps)).done;
        EXPECT_TRUE(std::binary_search(done.begin(), done.end(), static_cast<std::size_t>(number % steps))) << number;
    }
}

TEST_F(TwoWindows, NoWrittenAnswerIsLost) {
    expect_all_answers(120);
}

TEST_F(TwoWindows, NoFinishedStepIsLost) {
    expect_all_steps(80);
}

using TwoWindowsSlowTest = TwoWindows;

TEST_F(TwoWindowsSlowTest, AThousandWritesLoseNothing) {
    expect_all_answers(700);
    file = folder_ / "deep" / "window.json";
    expect_all_steps(300);
}

TEST_F(TwoWindows, KilledWindowLeavesNoLock) {
    Child window([this](const std::function<void(int)>& tell) {
        const FolderLock lock(folder_);
        tell(1);
        ::pause();
    });
    ASSERT_EQ(window.told(), 1);
    const int lock = ::open((folder_ / FolderLock::file_name).c_str(), O_RDWR | O_CLOEXEC);
    ASSERT_GE(lock, 0);
    EXPECT_NE(::flock(lock, LOCK_EX | LOCK_NB), 0) << "the window does not hold the lock";
    window.kill();
    EXPECT_EQ(::flock(lock, LOCK_EX | LOCK_NB), 0) << "the lock outlived the window";
    ::close(lock);
}

TEST_F(TwoWindows, ThreadsTakeTurnsToo) {
    constexpr int times = 40;
    const auto count_on = [&] {
        for (int i = 0; i < times; ++i) {
            const Result<Remembered> written = merge_into_file<Remembered>(
                file, read_remembered,
                [](Remembered there) {
                    there.scale = there.scale.value_or(0.5) + 0.001;
                    return there;
                },
                [this](const Remembered& merged) { return write_remembered(file, merged); });
            ASSERT_TRUE(written) << written.error();
        }
    };
    std::thread other(count_on);
    count_on();
    other.join();
    EXPECT_NEAR(*read_remembered(file)->scale, 0.5 + 2 * times * 0.001, 1e-9);
}

TEST_F(TwoWindows, UnreadableFileIsSetAsideEachTime) {
    HandIn now;
    now.items.push_back({"E01", 0, {}, {}, {}, {}});
    fs::create_directories(file.parent_path());
    for (const char* broken : {"{broken", "[broken"}) {
        std::ofstream(file) << broken;
        const Result<HandIn> written = merge_hand_in(file, {}, now);
        ASSERT_TRUE(written) << written.error();
        EXPECT_EQ(*load_hand_in(file), now);
    }
    EXPECT_EQ(all_bytes(file.string() + ".unreadable"), "{broken");
    EXPECT_EQ(all_bytes(file.string() + ".unreadable-2"), "[broken");
}

}  // namespace
}  // namespace viewing
