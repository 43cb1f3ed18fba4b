#include "program.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace viewing::bench {
namespace {

[[noreturn]] void fail(const std::string& program, const std::string& what) {
    std::fprintf(stderr, "bench-ratios: %s: %s\n", program.c_str(), what.c_str());
    std::exit(2);
}

double milliseconds(const timeval& time) {
    return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_usec) * 1e-3;
}

}  // namespace

Started start(const Command& command) {
    std::vector<char*> arguments;
    for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
    arguments.push_back(nullptr);
    std::array<int, 2> pipe_ends{};
    if (pipe2(pipe_ends.data(), O_CLOEXEC) != 0) fail(command.front(), std::strerror(errno));
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, pipe_ends[1], STDOUT_FILENO);
    Started started{0, pipe_ends[0]};
    const int failure = posix_spawnp(&started.process, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(pipe_ends[1]);
    if (failure != 0) fail(command.front(), std::strerror(failure));
    return started;
}

Measured run(const Command& command) {
    const auto begin = std::chrono::steady_clock::now();
    const Started started = start(command);
    Measured measured;
    std::array<char, 4096> bytes{};
    for (ssize_t count = 0; (count = read(started.output, bytes.data(), bytes.size())) > 0;)
        measured.output.append(bytes.data(), static_cast<std::size_t>(count));
    close(started.output);
    int status = 0;
    struct rusage usage {};
    while (wait4(started.process, &status, 0, &usage) < 0 && errno == EINTR) {
    }
    const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - begin;
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
        fail(command.front(), "did not end well (status " + std::to_string(status) + ")");
    measured.wall_ms = elapsed.count();
    measured.cpu_ms = milliseconds(usage.ru_utime) + milliseconds(usage.ru_stime);
    measured.peak_mb = static_cast<double>(usage.ru_maxrss) / 1024.0;
    return measured;
}

}  // namespace viewing::bench
