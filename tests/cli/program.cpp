#include "cli/program.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>
#include <utility>

extern char** environ;

namespace cli_tests {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds longest_run{100};

std::string contents(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::map<std::string, std::string> environment_for(const Surroundings& surroundings) {
    std::map<std::string, std::string> variables;
    for (char** entry = environ; *entry != nullptr; ++entry) {
        const std::string text = *entry;
        const std::size_t equals = text.find('=');
        variables[text.substr(0, equals)] = text.substr(equals + 1);
    }
    for (const char* display : {"DISPLAY", "WAYLAND_DISPLAY"}) variables.erase(display);
    for (const auto& [name, value] : surroundings.environment) variables[name] = value;
    for (const std::string& name : surroundings.without) variables.erase(name);
    return variables;
}

/// Runs in the child, so it makes only calls that are allowed between fork and exec. The parent has prepared the rest.
[[noreturn]] void become(const char* program, char** arguments, char** variables, const char* folder, int in, int out,
                         int err, const std::map<int, unsigned long>& limits) {
    for (const auto& [resource, value] : limits) {
        const rlimit limit{value, value};
        ::setrlimit(static_cast<__rlimit_resource_t>(resource), &limit);
    }
    if (::chdir(folder) == 0 && ::dup2(in, STDIN_FILENO) >= 0 && ::dup2(out, STDOUT_FILENO) >= 0 &&
        ::dup2(err, STDERR_FILENO) >= 0)
        ::execve(program, arguments, variables);
    ::_exit(127);
}

/// Waits until the child ends, and returns its exit status and peak memory.
Ended wait_for(pid_t child, const Surroundings& surroundings) {
    const Clock::time_point latest = Clock::now() + longest_run;
    int state = 0, signal = surroundings.signal;
    rusage usage{};
    while (::wait4(child, &state, WNOHANG, &usage) == 0) {
        if (signal != 0 && surroundings.signal_when()) ::kill(child, std::exchange(signal, 0));
        if (Clock::now() > latest) {
            ::kill(child, SIGKILL);
            ::waitpid(child, &state, 0);
            ADD_FAILURE() << "the program hung";
            break;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return {.status = WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state),
            .out = {},
            .err = {},
            .peak_bytes = std::int64_t{usage.ru_maxrss} * 1024};
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
    std::vector<char*> result;
    for (std::string& text : texts) result.push_back(text.data());
    result.push_back(nullptr);
    return result;
}

}  // namespace

Program::Program() {
    std::string name = (fs::temp_directory_path() / "viewing-sandbox-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder_ = name;
}

Program::~Program() {
    std::error_code error;
    fs::remove_all(folder_, error);
}

Ended Program::run(const std::vector<std::string>& arguments, const Surroundings& surroundings) const {
    const char* program = std::getenv("VIEWING_SANDBOX");
    if (program == nullptr) throw std::runtime_error("VIEWING_SANDBOX has to hold the program's path");
    const fs::path captured = folder_.string() + ".run";
    fs::create_directory(captured);
    std::ofstream(captured / "in", std::ios::binary) << surroundings.input;

    std::vector<std::string> words{program};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<std::string> variables;
    for (const auto& [name, value] : environment_for(surroundings)) variables.push_back(name + "=" + value);
    const std::vector<char*> argument_pointers = pointers(words);
    const std::vector<char*> variable_pointers = pointers(variables);
    const fs::path where = surroundings.folder.empty() ? folder_ : surroundings.folder;

    int open_pipe[2] = {-1, -1};
    if (surroundings.input_stays_open && ::pipe(open_pipe) != 0) throw std::runtime_error("no pipe");
    const int in = surroundings.input_stays_open ? open_pipe[0] : ::open((captured / "in").c_str(), O_RDONLY);
    const std::string out_file = surroundings.output.empty() ? (captured / "out").string() : surroundings.output;
    int closed_pipe[2] = {-1, -1};
    if (surroundings.output_has_no_reader) {
        if (::pipe(closed_pipe) != 0) throw std::runtime_error("no pipe");
        ::close(closed_pipe[0]);
    }
    const int out = surroundings.output_has_no_reader ? closed_pipe[1]
                                                      : ::open(out_file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const int err = ::open((captured / "err").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const pid_t child = ::fork();
    if (child == 0)
        become(program, const_cast<char**>(argument_pointers.data()), const_cast<char**>(variable_pointers.data()),
               where.c_str(), in, out, err, surroundings.limits);

    Ended result = wait_for(child, surroundings);
    for (const int descriptor : {in, out, err, open_pipe[1]})
        if (descriptor >= 0) ::close(descriptor);
    result.out = contents(captured / "out");
    result.err = contents(captured / "err");
    fs::remove_all(captured);
    return result;
}

void Program::write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
}

std::string Program::read(const std::string& name) const {
    return contents(folder_ / name);
}

std::size_t Program::files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
}

Ended Program::expect(int status, const std::vector<std::string>& arguments, const Surroundings& surroundings) const {
    Ended result = run(arguments, surroundings);
    EXPECT_EQ(result.status, status) << result.told();
    const auto lines = std::ranges::count(result.err, '\n');
    EXPECT_EQ(lines, status == 0 ? 0 : 1) << result.told();
    return result;
}

void Program::refused(const std::vector<std::string>& arguments, const std::vector<std::string>& words,
                      const Surroundings& surroundings) const {
    const std::size_t before = files();
    const Ended result = expect(2, arguments, surroundings);
    for (const std::string& word : words)
        EXPECT_NE(result.err.find(word), std::string::npos) << "should say: " << word << "\n" << result.told();
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(files(), before) << "a file was left";
}

}  // namespace cli_tests
