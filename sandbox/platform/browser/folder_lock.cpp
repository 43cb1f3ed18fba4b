// One thread, and a file system of the page's own: what other tabs have written comes by storage events (page/kept.js).
#include <system_error>

#include "platform/shared_file.h"

namespace viewing {

FolderLock::FolderLock(const std::filesystem::path& folder) {
    std::error_code ignored;
    std::filesystem::create_directories(folder, ignored);
}

FolderLock::~FolderLock() = default;

}  // namespace viewing
