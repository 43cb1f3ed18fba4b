// Checks that the program can start threads before a driver needs them.
#include "platform/threads.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace viewing {
namespace {

TEST(Threads, CanBeStartedHere) {
    EXPECT_GE(threads_of_a_driver(), 5);
    EXPECT_TRUE(can_start_threads(threads_of_a_driver()));
}

TEST(Threads, CannotBeStartedBeyondTheLimit) {
    const pid_t child = ::fork();
    if (child == 0) {
        constexpr uid_t nobody = 65534;
        const rlimit limit{1, 1};
        const bool is_limited = (::geteuid() != 0 || ::setuid(nobody) == 0) && ::setrlimit(RLIMIT_NPROC, &limit) == 0;
        ::_exit(!is_limited ? 2 : can_start_threads(4) ? 1 : 0);
    }
    int state = 0;
    ASSERT_EQ(::waitpid(child, &state, 0), child);
    const int status = WIFEXITED(state) ? WEXITSTATUS(state) : -1;
    if (status == 2) GTEST_SKIP() << "root cannot become nobody here";
    EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace viewing
