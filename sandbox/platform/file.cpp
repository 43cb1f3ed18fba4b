// Writes to a new file next to the target, then renames it: see file.h.
#include "platform/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#ifdef __linux__
#include <sys/syscall.h>
#include <sys/vfs.h>
#endif
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <deque>
#include <fstream>
#include <iterator>
#include <optional>
#include <random>
#include <string>
#include <system_error>

#include "platform/person_files.h"
#include "platform/unfinished.h"

namespace viewing {

namespace {

namespace fs = std::filesystem;

constexpr const char *unfinished_begin = ".viewing-sandbox-", *unfinished_end = ".partial";

/// Writes all bytes and closes the file. If `keeps`, also flushes them to the disk. Returns 0 or the errno of the
/// failure.
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

/// Opens a new file next to the target; on failure, returns −1, sets errno and leaves `made` empty. Notes the file as
/// unfinished before it exists, so that a signal at any moment removes it.
int open_new(const fs::path& target, fs::path& made) {
    constexpr int tries = 100;
    for (int i = 0; i < tries; ++i) {
        made = name_beside(target);
        note_unfinished(made);
        const int file = ::open(made.c_str(), O_WRONLY | O_CLOEXEC | O_CREAT | O_EXCL | O_NOFOLLOW, 0666);
        if (file >= 0) return file;
        const int failure = errno;
        forget_unfinished(made);
        errno = failure;
        if (failure != EEXIST) break;
    }
    made.clear();
    return -1;
}

/// The unfinished files and folders. A signal handler that ends the process can use this array, although it can neither
/// lock nor allocate.
std::array<std::atomic<const char*>, 64> unfinished{};

/// Removes a file, or a folder with its contents. Calls only functions that a signal handler may call.
void remove_at(int parent, const char* name) {  // NOLINT(misc-no-recursion): as deep as the folder
    if (::unlinkat(parent, name, 0) == 0) return;
#ifdef SYS_getdents64
    const int folder = ::openat(parent, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (folder < 0) return;
    // Offsets in struct linux_dirent64: the record's length is at 16, the name at 19. The folder is listed several
    // times, because some file systems skip entries while others are being removed.
    alignas(8) std::array<char, 2048> entries{};
    for (int pass = 0; pass < 8 && ::unlinkat(parent, name, AT_REMOVEDIR) != 0; ++pass) {
        ::lseek(folder, 0, SEEK_SET);
        for (long bytes = 1; bytes > 0;) {
            bytes = ::syscall(SYS_getdents64, folder, entries.data(), entries.size());
            for (long at = 0; at < bytes;) {
                const char* const entry = entries.data() + at;
                std::uint16_t length = 0;
                std::memcpy(&length, entry + 16, sizeof length);
                const std::string_view inner = entry + 19;
                if (inner != "." && inner != "..") remove_at(folder, inner.data());
                at += length;
            }
        }
    }
    ::close(folder);
#endif
}

/// A complete file next to its target, about to get the target's name. The destructor removes what has the temporary
/// name by then: this file, the one that it replaced, or nothing.
class Prepared {
public:
    explicit Prepared(fs::path target) : target_(std::move(target)) {}
    Prepared(const Prepared&) = delete;
    Prepared& operator=(const Prepared&) = delete;
    ~Prepared() {
        if (beside_.empty()) return;
        ::unlink(beside_.c_str());
        forget_unfinished(beside_);
        keep_folder(folder_of(target_));
    }

    const fs::path& target() const { return target_; }

    /// Writes the file, with the mode of the previous one. Returns 0 or the errno of the failure.
    int write(std::span<const std::uint8_t> bytes) {
        const int file = open_new(target_, beside_);
        if (file < 0) return errno;
        struct stat old {};
        if (::stat(target_.c_str(), &old) == 0) ::fchmod(file, old.st_mode & 07777U);
        return write_all(file, bytes, true);
    }

    /// Returns 0 or the errno of the failure.
    int take_name() {
        const bool was_there = is_there(target_);
        if (exchange_names(beside_, target_))
            undo_ = Undo::exchange;
        else if (::rename(beside_.c_str(), target_.c_str()) != 0)
            return errno;
        else if (!was_there)
            undo_ = Undo::remove;
        return 0;
    }

    /// Undoes take_name(), unless it replaced a file on a file system that cannot exchange names.
    void give_name_back() {
        if (undo_ == Undo::exchange) exchange_names(beside_, target_);
        if (undo_ == Undo::remove) ::unlink(target_.c_str());
    }

private:
    enum class Undo { nothing, exchange, remove };

    fs::path target_, beside_;
    Undo undo_ = Undo::nothing;
};

/// Writes to a device or pipe. Returns 0 or the errno of the failure.
int write_into(const fs::path& path, std::span<const std::uint8_t> bytes) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    return file < 0 ? errno : write_all(file, bytes, false);
}

/// Whether the kernel generates the file while it is read. A read from such a file may block until something happens
/// (/proc/kmsg).
bool is_made_up([[maybe_unused]] const fs::path& file) {
#ifdef __linux__
    // The magic numbers of the file systems proc, sysfs, debugfs and tracefs.
    constexpr std::array<unsigned long, 4> made_up{0x9fa0, 0x62656572, 0x64626720, 0x74726163};
    struct statfs system {};
    return ::statfs(file.c_str(), &system) == 0 &&
           std::find(made_up.begin(), made_up.end(), static_cast<unsigned long>(system.f_type)) != made_up.end();
#else
    return false;
#endif
}

}  // namespace

fs::path folder_of(const fs::path& file) {
    return file.has_parent_path() ? file.parent_path() : ".";
}

void keep_folder(const fs::path& folder) {
    const int opened = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (opened < 0) return;
    ::fsync(opened);  // fails on some file systems, because they have nothing to flush
    ::close(opened);
}

Error write_error(const fs::path& path, int code) {
    return {path.string() + ": cannot be written: " + std::generic_category().message(code)};
}

bool exchange_names([[maybe_unused]] const fs::path& a, [[maybe_unused]] const fs::path& b) {
#ifdef RENAME_EXCHANGE
    return ::renameat2(AT_FDCWD, a.c_str(), AT_FDCWD, b.c_str(), RENAME_EXCHANGE) == 0;
#else
    return false;
#endif
}

void note_unfinished(const fs::path& beside) {
    for (std::atomic<const char*>& place : unfinished)
        if (const char* nobody = nullptr; place.compare_exchange_strong(nobody, beside.c_str())) break;
}

void forget_unfinished(const fs::path& beside) {
    for (std::atomic<const char*>& place : unfinished)
        if (const char* own = beside.c_str(); place.compare_exchange_strong(own, nullptr)) break;
}

std::optional<fs::path> end_of_links(fs::path path) {
    constexpr int longest_chain = 40;
    std::error_code error;
    for (int i = 0; i < longest_chain; ++i) {
        if (!fs::is_symlink(fs::symlink_status(path, error))) return path;
        const fs::path next = fs::read_symlink(path, error);
        if (error) return std::nullopt;
        path = path.parent_path() / next;  // an absolute path replaces the whole path
    }
    return std::nullopt;
}

fs::path name_beside(const fs::path& file) {
    return folder_of(file) / (unfinished_begin + std::to_string(std::random_device()()) + unfinished_end);
}

std::vector<fs::path> unfinished_files_in(const fs::path& folder) {
    std::vector<fs::path> files = files_in(folder, unfinished_end);
    std::erase_if(files, [](const fs::path& file) { return !file.filename().string().starts_with(unfinished_begin); });
    return files;
}

Status write_file(const fs::path& path, std::string_view text) {
    return write_file(path, std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

Status write_files(std::span<const FileBytes> files, const std::function<void()>& before_names) {
    std::deque<Prepared> prepared;
    for (const FileBytes& file : files) {
        if (file.path.empty()) return Error{"an output file name must not be empty"};
        std::error_code ignored;
        const fs::file_status there = fs::status(file.path, ignored);
        if (fs::is_directory(there)) return Error{file.path.string() + ": cannot be written: it is a directory"};
        const bool is_replaced = !fs::exists(there) || fs::is_regular_file(there);
        const std::optional<fs::path> target = end_of_links(file.path);
        const int failure = !is_replaced ? write_into(file.path, file.bytes)
                            : target     ? prepared.emplace_back(*target).write(file.bytes)
                                         : ELOOP;
        if (failure != 0) return write_error(file.path, failure);
    }
    if (before_names) before_names();
    for (Prepared& file : prepared)
        if (const int failure = file.take_name(); failure != 0) {
            for (Prepared& earlier : prepared) earlier.give_name_back();
            return write_error(file.target(), failure);
        }
    for (const FileBytes& file : files) hand_over(file.path);
    return std::monostate{};
}

Status write_file(const fs::path& path, std::span<const std::uint8_t> bytes) {
    const FileBytes file{path, bytes};
    return write_files({&file, 1});
}

Status copy_bytes(const fs::path& from, const fs::path& to) {
    if (const Status readable = check_readable(from); !readable) return Error{readable.error()};
    return write_file(to, all_bytes(from));
}

void remove_unfinished_files() {
    for (const std::atomic<const char*>& place : unfinished)
        if (const char* const name = place.load(); name != nullptr) remove_at(AT_FDCWD, name);
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
    if (file.empty()) return Error{"an input file name must not be empty"};
    const auto cannot_read = [&file](const std::error_code& why) {
        return Error{file.string() + ": cannot be read: " + why.message()};
    };
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (status.type() == fs::file_type::not_found) return Error{file.string() + ": no such file"};
    if (status.type() == fs::file_type::none) return cannot_read(error);
    if (fs::is_directory(status)) return Error{file.string() + ": is a directory, not a file"};
    if (!fs::is_regular_file(status)) return Error{file.string() + ": is not a file"};
    if (is_made_up(file)) return Error{file.string() + ": is not a file on a disk"};
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
