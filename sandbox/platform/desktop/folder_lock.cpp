// flock() on a file of the folder: it belongs to the open file, so the system ends it with the process, however that
// ends, and two threads exclude each other too. NFS has it for files that are open for writing alone, hence no lock on
// the folder itself.
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <system_error>
#include <thread>

#include "platform/shared_file.h"

namespace viewing {

FolderLock::FolderLock(const std::filesystem::path& folder) {
    std::error_code ignored;  // what is written next says what is wrong
    std::filesystem::create_directories(folder, ignored);
    file_ = ::open((folder / file_name).c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (file_ < 0) return;
    // No wait in the kernel: a window that closes must not wait for ever for a process that is stopped.
    constexpr std::chrono::milliseconds patience{10000}, pause{1};
    const auto end = std::chrono::steady_clock::now() + patience;
    while (::flock(file_, LOCK_EX | LOCK_NB) != 0 && (errno == EWOULDBLOCK || errno == EINTR) &&
           std::chrono::steady_clock::now() < end)
        std::this_thread::sleep_for(pause);
}

FolderLock::~FolderLock() {
    if (file_ >= 0) ::close(file_);
}

}  // namespace viewing
