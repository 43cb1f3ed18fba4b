#include "platform/whole_folder.h"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "platform/file.h"
#include "platform/unfinished.h"
#include "text/words.h"

namespace viewing {
namespace {

namespace fs = std::filesystem;

Error no_folder(const fs::path& target, const std::string& why) {
    return {target.string() + ": cannot be used as the results folder: " + why};
}

/// Returns the first entry of a folder that is not one of the program's own results, or nothing.
std::optional<fs::path> stranger_in(const fs::path& folder, const IsOwnResult& is_own, std::error_code& error) {
    std::vector<fs::path> strangers;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        if (!is_own || !is_own(entry->path())) strangers.push_back(entry->path());
    if (strangers.empty()) return std::nullopt;
    return *std::min_element(strangers.begin(), strangers.end());
}

/// Returns the final path of the folder, without a trailing slash.
std::optional<fs::path> place_of(const fs::path& target) {
    fs::path place = target.lexically_normal();
    if (!place.has_filename()) place = place.parent_path();
    return end_of_links(place);
}

}  // namespace

struct WholeFolder::Growing {
    fs::path named;  ///< the target as given
    fs::path target;
    fs::path beside;  ///< empty until the folder is there
    IsOwnResult is_own;

    ~Growing() {
        if (beside.empty()) return;
        std::error_code none;
        fs::remove_all(beside, none);
        forget_unfinished(beside);
    }
};

WholeFolder::WholeFolder(std::unique_ptr<Growing> growing) : growing_(std::move(growing)) {}
WholeFolder::WholeFolder(WholeFolder&& other) noexcept = default;
WholeFolder::~WholeFolder() = default;

const fs::path& WholeFolder::beside() const {
    return growing_->beside;
}

Status check_folder_free(const fs::path& target, const IsOwnResult& is_own) {
    if (target.empty()) return Error{"a results folder name must not be empty"};
    const std::optional<fs::path> place = place_of(target);
    if (!place) return no_folder(target, std::generic_category().message(ELOOP));
    std::error_code error;
    const fs::file_status there = fs::status(*place, error);
    if (there.type() == fs::file_type::not_found) return std::monostate{};
    if (there.type() == fs::file_type::none) return no_folder(target, error.message());
    if (!fs::is_directory(there)) return no_folder(target, "it is a file");
    if (are_same_file(*place, ".")) return no_folder(target, "it is the working folder; name another folder");
    if (const std::optional<fs::path> stranger = stranger_in(*place, is_own, error))
        return no_folder(target, "it contains " + one_line(stranger->filename().string()) +
                                     ", which is not such a result; name a new or an empty folder");
    if (error) return no_folder(target, error.message());
    return std::monostate{};
}

Result<WholeFolder> WholeFolder::begin(const fs::path& target, const IsOwnResult& is_own) {
    if (const Status is_free = check_folder_free(target, is_own); !is_free) return Error{is_free.error()};
    auto growing = std::make_unique<Growing>();
    growing->named = target;
    growing->target = *place_of(target);
    growing->is_own = is_own;
    fs::path topmost = growing->target;
    while (topmost.has_parent_path() && topmost != topmost.parent_path() && !is_there(topmost.parent_path()))
        topmost = topmost.parent_path();
    const fs::path beside = name_beside(topmost);
    std::error_code error;
    fs::create_directory(beside, error);
    if (error) return no_folder(target, error.message());
    growing->beside = beside;
    note_unfinished(growing->beside);
    return WholeFolder(std::move(growing));
}

Status WholeFolder::take_name() {
    Growing& own = *growing_;
    if (const Status is_free = check_folder_free(own.named, own.is_own); !is_free) return Error{is_free.error()};
    struct stat old {};
    const bool replaces = ::stat(own.target.c_str(), &old) == 0;
    if (replaces) ::chmod(own.beside.c_str(), old.st_mode & 07777U);
    // ~Growing() removes what has the temporary name by then: after an exchange, the old folder.
    if (!replaces || !exchange_names(own.beside, own.target)) {
        std::error_code error;
        if (replaces) fs::remove_all(own.target, error);
        fs::create_directories(folder_of(own.target), error);
        if (!error) fs::rename(own.beside, own.target, error);
        if (error) return write_error(own.named, error.value());
    }
    keep_folder(folder_of(own.target));
    return std::monostate{};
}

}  // namespace viewing
