// Locks nothing, since a page has one thread and its own file system. Changes by other tabs arrive in storage events
// (page/kept.js).
#include <system_error>

#include "platform/shared_file.h"

namespace viewing {

FolderLock::FolderLock(const std::filesystem::path& folder) {
    std::error_code ignored;
    std::filesystem::create_directories(folder, ignored);
}

FolderLock::~FolderLock() = default;

}  // namespace viewing
