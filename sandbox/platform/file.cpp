// Write beside, then rename: see file.h.
#include "platform/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <deque>
#include <fstream>
#include <iterator>
#include <optional>
#include <random>
#include <string>
#include <system_error>

#include "platform/person_files.h"

namespace viewing {

namespace {

namespace fs = std::filesystem;

/// Writes all bytes and closes the file; 0 or the errno of what failed. `keeps`: until they are on the disk.
int write_all(int file, std::span<const std::uint8_t> bytes, bool keeps) {
    int failure = 0;
    while (!bytes.empty() && failure == 0) {
        const ssize_t written = ::write(file, bytes.data(), bytes.size());
        if (written >= 0) {
            bytes = bytes.subspan(static_cast<std::size_t>(written));
        } else if (errno != EINTR) {
            failure = errno;
        }
    }
    if (keeps && failure == 0 && ::fsync(file) != 0 && errno != EINVAL) failure = errno;
    if (::close(file) != 0 && failure == 0) failure = errno;
    return failure;
}

/// A new file beside the target; −1 with errno.
int open_new(const fs::path& target, fs::path& made) {
    constexpr int tries = 100;
    int file = -1;
    for (int i = 0; i < tries && file < 0; ++i) {
        made = name_beside(target);
        file = ::open(made.c_str(), O_WRONLY | O_CLOEXEC | O_CREAT | O_EXCL | O_NOFOLLOW, 0666);
        if (file < 0 && errno != EEXIST) break;
    }
    return file;
}

fs::path folder_of(const fs::path& file) {
    return file.has_parent_path() ? file.parent_path() : ".";
}

void keep_folder(const fs::path& folder) {
    const int opened = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (opened < 0) return;
    ::fsync(opened);  // some file systems have nothing to do here and refuse
    ::close(opened);
}

/// A file that is complete beside its target and waits for its name; gone if that never comes.
class Prepared {
public:
    /// 0 or the errno of what failed.
    int prepare(const fs::path& target, std::span<const std::uint8_t> bytes) {
        target_ = target;
        const int file = open_new(target, beside_);
        if (file < 0) return errno;
        is_there_ = true;
        struct stat old {};
        if (::stat(target.c_str(), &old) == 0) ::fchmod(file, old.st_mode & 07777U);
        return write_all(file, bytes, true);
    }

    const fs::path& target() const { return target_; }

    /// 0 or the errno of what failed.
    int take_name() {
        if (::rename(beside_.c_str(), target_.c_str()) != 0) return errno;
        is_there_ = false;
        keep_folder(folder_of(target_));
        return 0;
    }

    Prepared() = default;
    Prepared(const Prepared&) = delete;
    Prepared& operator=(const Prepared&) = delete;
    ~Prepared() {
        if (is_there_) ::unlink(beside_.c_str());
    }

private:
    fs::path target_, beside_;
    bool is_there_ = false;
};

/// A device or pipe; 0 or the errno of what failed.
int write_into(const fs::path& path, std::span<const std::uint8_t> bytes) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    return file < 0 ? errno : write_all(file, bytes, false);
}

Error cannot_write(const fs::path& path, int code) {
    return {path.string() + ": cannot be written: " + std::generic_category().message(code)};
}

}  // namespace

std::optional<fs::path> end_of_links(fs::path path) {
    constexpr int longest_chain = 40;
    std::error_code error;
    for (int i = 0; i < longest_chain; ++i) {
        if (!fs::is_symlink(fs::symlink_status(path, error))) return path;
        const fs::path next = fs::read_symlink(path, error);
        if (error) return std::nullopt;
        path = path.parent_path() / next;  // which an absolute one replaces
    }
    return std::nullopt;
}

fs::path name_beside(const fs::path& file) {
    return folder_of(file) / (".viewing-sandbox-" + std::to_string(std::random_device()()) + ".partial");
}

Status write_file(const fs::path& path, std::string_view text) {
    return write_file(path, std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

Status write_files(std::span<const FileBytes> files, const std::function<void()>& before_names) {
    std::deque<Prepared> prepared;
    for (const FileBytes& file : files) {
        if (file.path.empty()) return Error{"an output needs a file name, and this one is empty"};
        std::error_code ignored;
        const fs::file_status there = fs::status(file.path, ignored);
        if (fs::is_directory(there)) return Error{file.path.string() + ": cannot be written: it is a directory"};
        const bool is_replaced = !fs::exists(there) || fs::is_regular_file(there);
        const std::optional<fs::path> target = end_of_links(file.path);
        const int failure = !is_replaced ? write_into(file.path, file.bytes)
                            : target     ? prepared.emplace_back().prepare(*target, file.bytes)
                                         : ELOOP;
        if (failure != 0) return cannot_write(file.path, failure);
    }
    if (before_names) before_names();
    for (Prepared& file : prepared)
        if (const int failure = file.take_name(); failure != 0) return cannot_write(file.target(), failure);
    for (const FileBytes& file : files) hand_over(file.path);
    return std::monostate{};
}

Status write_file(const fs::path& path, std::span<const std::uint8_t> bytes) {
    const FileBytes file{path, bytes};
    return write_files({&file, 1});
}

bool is_there(const fs::path& file) {
    std::error_code unknown;
    return fs::exists(file, unknown);
}

bool are_same_file(const fs::path& a, const fs::path& b) {
    struct stat of_a {
    }, of_b{};
    const bool a_is_there = ::stat(a.c_str(), &of_a) == 0, b_is_there = ::stat(b.c_str(), &of_b) == 0;
    if (a_is_there != b_is_there) return false;
    if (a_is_there)
        return (S_ISREG(of_a.st_mode) || S_ISDIR(of_a.st_mode)) && of_a.st_dev == of_b.st_dev &&
               of_a.st_ino == of_b.st_ino;
    const auto place_of = [](const fs::path& path) {
        std::error_code error;
        return fs::weakly_canonical(fs::absolute(end_of_links(path).value_or(path), error), error);
    };
    return !a.empty() && !b.empty() && place_of(a) == place_of(b);
}

Status check_readable(const fs::path& file) {
    if (file.empty()) return Error{"an input needs a file name, and this one is empty"};
    const auto cannot_read = [&file](const std::error_code& why) {
        return Error{file.string() + ": cannot be read: " + why.message()};
    };
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (status.type() == fs::file_type::not_found) return Error{file.string() + ": no such file"};
    if (status.type() == fs::file_type::none) return cannot_read(error);
    if (fs::is_directory(status)) return Error{file.string() + ": is a directory, not a file"};
    if (!fs::is_regular_file(status)) return Error{file.string() + ": is not a file"};
    const int opened = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (opened < 0) return cannot_read({errno, std::generic_category()});
    ::close(opened);
    return std::monostate{};
}

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder, std::string_view extension) {
    std::vector<std::filesystem::path> files;
    std::error_code error;
    for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        if (entry->path().extension() == extension) files.push_back(entry->path());
    std::sort(files.begin(), files.end());
    return files;
}

std::string all_bytes(const fs::path& file) {
    if (!check_readable(file)) return "";
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace viewing
