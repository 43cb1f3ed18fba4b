// A file that several windows of one person write: each adds what it has changed to what the file holds at that moment,
// while no other does. Where a window ends in between (kill -9), the system lets go of the lock and the file is the one
// before or the one after.
#pragma once

#include <filesystem>

#include "platform/file.h"

namespace viewing {

/// Keeps everybody else who has such a lock on the folder waiting while it lives: other processes and other threads. A
/// folder that is missing is made. Where the folder cannot be locked, or a stopped process has held the lock for ten
/// seconds, the work goes on without: to write without a lock loses less than not to write. In a browser nothing is
/// locked: the page merges what another tab has written since (kept.js).
class FolderLock {
public:
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

    /// The name of the file in the folder that is locked. It stays there, empty.
    static constexpr const char* file_name = ".viewing-sandbox-lock";

private:
    [[maybe_unused]] int file_ = -1;
};

/// Gives a file that cannot be understood another name beside it (FILE.unreadable, FILE.unreadable-2 …).
Status set_aside(const std::filesystem::path& file);

/// Reads `file`, merges and writes it under the folder's lock; the result is what the file holds then. `load` gives a
/// Result<T> of a file; one that it cannot understand is set aside, never written over. `merge` makes what is to be
/// written from what is there, T{} where nothing is. `write` puts a T there; it is not called where nothing changes.
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
