// A folder of results that nobody ever finds half of: it grows beside its name and takes it when it is complete. For
// one file read file.h.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "text/result.h"

namespace viewing {

/// What says of something in a folder that it is a result of the same kind, which a new one may replace.
using IsOwnResult = std::function<bool(const std::filesystem::path&)>;

/// Whether a folder of this name can be written: it is new, empty, or holds nothing but what is the program's own.
/// Links are followed. The sentence names the first thing that is not, or why there can be no such folder. Without
/// `is_own` only a new or empty one will do.
Status check_folder_free(const std::filesystem::path& target, const IsOwnResult& is_own = {});

class WholeFolder {
public:
    /// Begins it beside `target`, or beside the first of its parents that is missing: they are made with it. The error:
    /// check_folder_free, or what the system says.
    static Result<WholeFolder> begin(const std::filesystem::path& target, const IsOwnResult& is_own = {});
    WholeFolder(WholeFolder&& other) noexcept;
    WholeFolder& operator=(WholeFolder&&) = delete;
    /// Removed unless it has its name, as a signal's end removes it (remove_unfinished_files).
    ~WholeFolder();

    /// Where files go until then.
    const std::filesystem::path& beside() const;

    /// In place of the folder that was there, which is removed with what it held; its permissions are kept. Checks
    /// again that it holds nothing foreign.
    Status take_name();

private:
    struct Growing;
    explicit WholeFolder(std::unique_ptr<Growing> growing);
    std::unique_ptr<Growing> growing_;
};

}  // namespace viewing
