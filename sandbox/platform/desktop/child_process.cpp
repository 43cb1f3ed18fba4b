#include "platform/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <utility>

#include "platform/ending_signals.h"

namespace viewing {
namespace {

constexpr std::size_t most_complaints = 64U << 10U;

/// One end of a pipe, closed by the destructor.
class PipeEnd {
public:
    PipeEnd() = default;
    explicit PipeEnd(int file) : file_(file) {}
    PipeEnd(PipeEnd&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
    PipeEnd& operator=(PipeEnd&& other) noexcept {
        std::swap(file_, other.file_);
        return *this;
    }
    ~PipeEnd() { close(); }
    void close() {
        if (file_ >= 0) ::close(file_);
        file_ = -1;
    }
    int file() const { return file_; }
    bool is_open() const { return file_ >= 0; }

private:
    int file_ = -1;
};

struct Pipe {
    PipeEnd read, write;
};

Result<Pipe> make_pipe() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
        return Error{std::string("cannot create a pipe: ") + std::strerror(errno)};
    return Pipe{PipeEnd(ends[0]), PipeEnd(ends[1])};
}

/// Reads available output without waiting; closes the pipe at the end of its data.
void read_available(PipeEnd& pipe, std::string& text) {
    std::array<char, 16384> part{};
    while (pipe.is_open()) {
        const ssize_t count = ::read(pipe.file(), part.data(), part.size());
        if (count > 0) {
            text.append(part.data(), static_cast<std::size_t>(count));
        } else if (count == 0) {
            pipe.close();
        } else if (errno != EINTR) {
            if (errno != EAGAIN) pipe.close();
            return;
        }
    }
}

}  // namespace

struct ChildProcess::State {
    pid_t process = -1;
    PipeEnd input, output, complaints;
    std::string said, complained;
    int status = 0;
    bool has_ended = false;

    void read_all() {
        read_available(output, said);
        read_available(complaints, complained);
        if (complained.size() > most_complaints) complained.erase(0, complained.size() - most_complaints);
    }
};

ChildProcess::ChildProcess(std::unique_ptr<State> state) : state_(std::move(state)) {}
ChildProcess::ChildProcess(ChildProcess&&) noexcept = default;
ChildProcess& ChildProcess::operator=(ChildProcess&& other) noexcept {
    std::swap(state_, other.state_);
    return *this;
}

ChildProcess::~ChildProcess() {
    if (state_ && !state_->has_ended) end();
}

Result<ChildProcess> ChildProcess::start(const std::vector<std::string>& arguments) {
    Result<Pipe> input = make_pipe(), output = make_pipe(), complaints = make_pipe();
    for (const Result<Pipe>* const pipe : {&input, &output, &complaints})
        if (!*pipe) return Error{pipe->error()};
    std::vector<char*> words;
    words.reserve(arguments.size() + 1);
    for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);

    posix_spawn_file_actions_t files;
    ::posix_spawn_file_actions_init(&files);
    ::posix_spawn_file_actions_adddup2(&files, input->read.file(), STDIN_FILENO);
    ::posix_spawn_file_actions_adddup2(&files, output->write.file(), STDOUT_FILENO);
    ::posix_spawn_file_actions_adddup2(&files, complaints->write.file(), STDERR_FILENO);
    auto state = std::make_unique<State>();
    const int failure = ::posix_spawn(&state->process, words.front(), &files, nullptr, words.data(), environ);
    ::posix_spawn_file_actions_destroy(&files);
    if (failure != 0) return Error{arguments.front() + " cannot be started: " + std::strerror(failure)};

    state->input = std::move(input->write);
    state->output = std::move(output->read);
    state->complaints = std::move(complaints->read);
    for (const PipeEnd* const end : {&state->output, &state->complaints}) ::fcntl(end->file(), F_SETFL, O_NONBLOCK);
    return ChildProcess(std::move(state));
}

bool ChildProcess::give(std::string_view text) {
    struct sigaction ignore {};
    struct sigaction before {};
    ignore.sa_handler = SIG_IGN;  // writing to a child that has ended must not end this process
    ::sigaction(SIGPIPE, &ignore, &before);
    std::size_t written = 0;
    while (state_->input.is_open() && written < text.size()) {
        const ssize_t count = ::write(state_->input.file(), text.data() + written, text.size() - written);
        if (count >= 0)
            written += static_cast<std::size_t>(count);
        else if (errno != EINTR)
            state_->input.close();
    }
    ::sigaction(SIGPIPE, &before, nullptr);
    return written == text.size();
}

void ChildProcess::finish_telling() {
    state_->input.close();
}

std::vector<std::string> ChildProcess::take_lines() {
    state_->read_all();
    std::vector<std::string> lines;
    std::size_t begin = 0;
    for (std::size_t end = state_->said.find('\n'); end != std::string::npos; end = state_->said.find('\n', begin)) {
        lines.push_back(state_->said.substr(begin, end - begin));
        begin = end + 1;
    }
    state_->said.erase(0, begin);
    return lines;
}

std::string ChildProcess::take_complaints() {
    state_->read_all();
    return std::exchange(state_->complained, "");
}

bool ChildProcess::is_running() const {
    return state_->output.is_open();
}

void ChildProcess::send(int signal) {
    if (!state_->has_ended) ::kill(state_->process, signal);
}

std::string ChildProcess::end() {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point latest = Clock::now() + std::chrono::seconds(2);
    send(SIGTERM);
    finish_telling();
    ChildProcess* const self = this;
    while (is_running() && Clock::now() < latest)
        listen({&self, 1}, std::chrono::duration<double>(latest - Clock::now()).count());
    send(SIGKILL);
    return wait();
}

std::string ChildProcess::wait() {
    if (!state_->has_ended) {
        while (::waitpid(state_->process, &state_->status, 0) < 0 && errno == EINTR) {
        }
        state_->has_ended = true;
        state_->read_all();
    }
    if (WIFSIGNALED(state_->status)) {
        const int signal = WTERMSIG(state_->status);
        return "signal " + std::to_string(signal) + " (" + ::strsignal(signal) + ")";
    }
    return "exit status " + std::to_string(exit_status());
}

int ChildProcess::exit_status() const {
    return WIFEXITED(state_->status) ? WEXITSTATUS(state_->status) : -1;
}

void ChildProcess::listen(std::span<ChildProcess* const> children, double seconds, int wake_file) {
    std::vector<pollfd> files{{wake_file, POLLIN, 0}};  // poll() ignores −1
    for (const ChildProcess* const child : children)
        for (const PipeEnd* const end : {&child->state_->output, &child->state_->complaints})
            if (end->is_open()) files.push_back({end->file(), POLLIN, 0});
    constexpr double longest_s = 3600.0;
    const double waited_s = std::clamp(seconds, 0.0, longest_s);
    ::poll(files.data(), files.size(), static_cast<int>(waited_s * 1e3));
    for (ChildProcess* const child : children) child->state_->read_all();
}

void end_with_parent() {
    leave_terminal_to_parent();
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    // If the parent ended before this call, no signal will come, but standard input then has no writer.
    pollfd input{STDIN_FILENO, 0, 0};
    if (::poll(&input, 1, 0) == 1 && (input.revents & POLLHUP) != 0) ::_exit(EXIT_FAILURE);
}

std::string own_program() {
    std::error_code unknown;
    return std::filesystem::read_symlink("/proc/self/exe", unknown).string();
}

}  // namespace viewing
