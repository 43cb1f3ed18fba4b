// Calls flock() on a file in the folder. The lock belongs to the open file, so it ends with the process, however the
// process ends, and it also excludes other threads. NFS locks only files that are open for writing, so the folder
// itself cannot be locked.
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
    std::error_code ignored;  // the next write reports the problem
    std::filesystem::create_directories(folder, ignored);
    file_ = ::open((folder / file_name).c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (file_ < 0) return;
    // Do not wait in the kernel: a window that is closing must not wait forever for a stopped process.
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
