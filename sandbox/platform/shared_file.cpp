#include "platform/shared_file.h"

#include <string>
#include <system_error>

namespace viewing {

Status set_aside(const std::filesystem::path& file) {
    const std::string name = file.string() + ".unreadable";
    std::filesystem::path free = name;
    for (int i = 2; is_there(free); ++i) free = name + "-" + std::to_string(i);
    std::error_code failed;
    std::filesystem::rename(file, free, failed);
    if (failed) return Error{file.string() + ": cannot be renamed: " + failed.message()};
    return std::monostate{};
}

}  // namespace viewing
