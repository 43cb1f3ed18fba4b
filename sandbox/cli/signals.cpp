#include "cli/signals.h"

#include <signal.h>
#include <unistd.h>

#include <array>
#include <string_view>

#include "cli/exit_status.h"
#include "platform/last_words.h"

#if defined(__has_feature)
#define VIEWING_HAS_FEATURE(feature) __has_feature(feature)
#else
#define VIEWING_HAS_FEATURE(feature) 0
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || VIEWING_HAS_FEATURE(address_sanitizer) || \
    VIEWING_HAS_FEATURE(thread_sanitizer)
#define VIEWING_IS_SANITIZED 1
#else
#define VIEWING_IS_SANITIZED 0
#endif

namespace viewing {
namespace {

void end_process(int) {
    constexpr int status = static_cast<int>(ExitStatus::internal_error);
    for (const std::string_view part : {std::string_view(fault_sentence), std::string_view("\n")})
        [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, part.data(), part.size());
    say_last_words(status);
    ::_exit(status);
}

void catch_faults() {
    // Of its own, since a stack that has run out is a fault too.
    static std::array<char, 64U << 10U> stack_bytes;
    stack_t stack{};
    stack.ss_sp = stack_bytes.data();
    stack.ss_size = stack_bytes.size();
    ::sigaltstack(&stack, nullptr);
    struct sigaction action {};
    action.sa_handler = end_process;
    action.sa_flags = SA_ONSTACK;
    for (const int fault : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) ::sigaction(fault, &action, nullptr);
}

}  // namespace

void end_faults_with_a_status() {
    struct sigaction ignore {};
    ignore.sa_handler = SIG_IGN;
    ::sigaction(SIGXFSZ, &ignore, nullptr);
    if (VIEWING_IS_SANITIZED == 0) catch_faults();
}

}  // namespace viewing
