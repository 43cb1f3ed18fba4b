// A folder of results that is never visible half-complete: it is written next to its target and gets the target's name
// only when it is complete. See file.h for single files.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "text/result.h"

namespace viewing {

/// Returns whether a file in the folder is a result of the same kind, which a new result may replace.
using IsOwnResult = std::function<bool(const std::filesystem::path&)>;

/// Checks that a folder with this name can be written: it does not exist, is empty, or contains nothing but the
/// program's own results. Follows links. The error names the first foreign entry, or says why the folder cannot be
/// used. Without `is_own`, only a new or empty folder is accepted.
Status check_folder_free(const std::filesystem::path& target, const IsOwnResult& is_own = {});

class WholeFolder {
public:
    /// Creates the folder next to `target` or, if parents of `target` are missing, next to the topmost missing one;
    /// take_name() creates these parents. The error is that of check_folder_free, or the system's.
    static Result<WholeFolder> begin(const std::filesystem::path& target, const IsOwnResult& is_own = {});
    WholeFolder(WholeFolder&& other) noexcept;
    WholeFolder& operator=(WholeFolder&&) = delete;
    /// Removes the folder unless it has received its final name; a signal that ends the process does the same
    /// (remove_unfinished_files).
    ~WholeFolder();

    /// Returns the folder that the files must be written into until take_name().
    const std::filesystem::path& beside() const;

    /// Gives the folder its final name. If there is a previous folder, checks again that it contains nothing foreign,
    /// takes over its permissions, and removes it with its contents.
    Status take_name();

private:
    struct Growing;
    explicit WholeFolder(std::unique_ptr<Growing> growing);
    std::unique_ptr<Growing> growing_;
};

}  // namespace viewing
