// Write beside, then rename: see file.h.
#include "platform/file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

namespace viewing {

namespace {

/// Writes all bytes to a new or opened file and closes it; 0 or the errno of what failed.
int write_all(const std::filesystem::path& path, int flags, std::span<const std::uint8_t> bytes) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | flags, 0666);
    if (file < 0) return errno;
    int failure = 0;
    while (!bytes.empty() && failure == 0) {
        const ssize_t written = ::write(file, bytes.data(), bytes.size());
        if (written >= 0) {
            bytes = bytes.subspan(static_cast<std::size_t>(written));
        } else if (errno != EINTR) {
            failure = errno;
        }
    }
    if (::close(file) != 0 && failure == 0) failure = errno;
    return failure;
}

Error cannot_write(const std::filesystem::path& path, int code) {
    return {path.string() + ": cannot be written: " + std::generic_category().message(code)};
}

}  // namespace

Status write_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes) {
    namespace fs = std::filesystem;
    if (path.empty()) return Error{"an output needs a file name, and this one is empty"};
    std::error_code ignored;
    const fs::file_status there = fs::status(path, ignored);
    if (fs::is_directory(there)) return Error{path.string() + ": cannot be written: it is a directory"};
    if (fs::exists(there) && !fs::is_regular_file(there)) {
        const int failure = write_all(path, 0, bytes);
        return failure == 0 ? Status(std::monostate{}) : Status(cannot_write(path, failure));
    }

    fs::path target = path;
    if (fs::is_symlink(fs::symlink_status(path, ignored))) {
        target = fs::weakly_canonical(path, ignored);
        if (ignored) target = path;
    }
    fs::path beside = target;
    beside += ".partial-" + std::to_string(::getpid());
    int failure = write_all(beside, O_CREAT | O_TRUNC, bytes);
    if (failure == 0 && ::rename(beside.c_str(), target.c_str()) != 0) failure = errno;
    if (failure == 0) return std::monostate{};
    ::unlink(beside.c_str());
    return cannot_write(path, failure);
}

}  // namespace viewing
