// Shared by the fuzz targets: a check that aborts the fuzzer if it fails, and an in-memory file for readers that take a
// file name.
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

namespace viewing::fuzz {

inline void check(bool holds) {
    if (!holds) std::abort();
}

/// Checks that a message is a single line and not empty.
inline void check_message(const std::string& message) {
    check(!message.empty() && message.find('\n') == std::string::npos);
}

inline std::string_view as_text(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

/// A regular file in memory.
class MemoryFile {
public:
    explicit MemoryFile(std::string_view content) : file_(memfd_create("fuzz", 0)) {
        check(file_ >= 0 && write(file_, content.data(), content.size()) == static_cast<ssize_t>(content.size()));
    }
    ~MemoryFile() { close(file_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    std::filesystem::path path() const { return "/proc/self/fd/" + std::to_string(file_); }

private:
    int file_;
};

}  // namespace viewing::fuzz
