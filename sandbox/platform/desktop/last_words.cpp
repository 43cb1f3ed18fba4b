#include "platform/last_words.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <climits>
#include <memory>
#include <string_view>
#include <system_error>

#include "platform/file.h"

namespace viewing {
namespace {

namespace fs = std::filesystem;

struct LastWords {
    std::string target;  ///< "" for standard output
    std::string beside;  ///< the name under which a plain file is first written; "" for other files
    std::vector<std::pair<int, std::string>> text_by_status;
};

std::atomic<const LastWords*> current = nullptr;

/// Writes a text. Returns false if that would block, or if it fails.
bool write_without_waiting(int file, std::string_view text) {
    while (!text.empty()) {
        pollfd wanted{file, POLLOUT, 0};
        if (::poll(&wanted, 1, 0) != 1 || (wanted.revents & POLLOUT) == 0) return false;
        const ssize_t written = ::write(file, text.data(), std::min<std::size_t>(text.size(), PIPE_BUF));
        if (written <= 0) return false;
        text.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

void replace_file(const LastWords& words, std::string_view text) {
    const int file = ::open(words.beside.c_str(), O_WRONLY | O_CLOEXEC | O_CREAT | O_EXCL | O_NOFOLLOW, 0666);
    if (file < 0) return;
    struct stat old {};
    if (::stat(words.target.c_str(), &old) == 0) ::fchmod(file, old.st_mode & 07777U);
    const bool is_complete = write_without_waiting(file, text);
    ::close(file);
    if (!is_complete || ::rename(words.beside.c_str(), words.target.c_str()) != 0) ::unlink(words.beside.c_str());
}

}  // namespace

void set_last_words(const fs::path& file, std::vector<std::pair<int, std::string>> text_by_status) {
    // Never freed, since a signal handler may be reading any of them.
    static std::vector<std::unique_ptr<const LastWords>> all;
    LastWords words{.target = {}, .beside = {}, .text_by_status = std::move(text_by_status)};
    if (file != "-") {
        std::error_code error;
        const fs::file_status there = fs::status(file, error);
        const fs::path target = end_of_links(file).value_or(file);
        words.target = target.string();
        if (!fs::exists(there) || fs::is_regular_file(there)) words.beside = name_beside(target).string();
    }
    all.push_back(std::make_unique<const LastWords>(std::move(words)));
    current = all.back().get();
}

void forget_last_words() {
    current = nullptr;
}

void say_last_words(int status) noexcept {
    const LastWords* const words = current.exchange(nullptr);
    if (words == nullptr) return;
    for (const auto& [of_status, text] : words->text_by_status) {
        if (of_status != status) continue;
        if (!words->beside.empty()) return replace_file(*words, text);
        const bool is_stdout = words->target.empty();
        const int file = is_stdout ? STDOUT_FILENO : ::open(words->target.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK);
        if (file >= 0) write_without_waiting(file, text);
        return;
    }
}

}  // namespace viewing
