// A file that several windows of one user write. Each window adds its changes to the file's current content while no
// other window writes. If a window is killed during that time (kill -9), the system releases the lock, and the file has
// the previous or the new content.
#pragma once

#include <filesystem>

#include "platform/file.h"

namespace viewing {

/// While an object of this class exists, other processes and threads have to wait before they can lock the folder.
/// Creates the folder if it is missing. If the folder cannot be locked, or a stopped process has held the lock for ten
/// seconds, the caller continues without a lock, because not writing at all would lose more. In a browser, nothing is
/// locked; the page merges changes by other tabs (kept.js).
class FolderLock {
public:
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

    /// The locked file in the folder. It is empty and is not removed.
    static constexpr const char* file_name = ".viewing-sandbox-lock";

private:
    [[maybe_unused]] int file_ = -1;
};

/// Renames a file that cannot be parsed to FILE.unreadable, FILE.unreadable-2 …
Status set_aside(const std::filesystem::path& file);

/// Reads `file`, merges changes into it and writes it, all under the folder's lock. Returns its new content. `load`
/// returns a Result<T> for a file; a file that it cannot parse is set aside, never overwritten. `merge` makes the new
/// content from the current one, or from T{} if there is none. `write` stores a T; it is not called if nothing has
/// changed.
template <typename T, typename Load, typename Merge, typename Write>
Result<T> merge_into_file(const std::filesystem::path& file, const Load& load, const Merge& merge, const Write& write) {
    const FolderLock lock(file.parent_path());
    T there{};
    if (is_there(file)) {
        if (Result<T> read = load(file))
            there = *std::move(read);
        else if (const Status done = set_aside(file); !done)
            return Error{done.error()};
    }
    T merged = merge(there);
    if (merged == there) return merged;
    if (const Status done = write(merged); !done) return Error{done.error()};
    return merged;
}

}  // namespace viewing
