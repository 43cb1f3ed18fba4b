#include "platform/free_file.h"

#include <system_error>

#include "platform/file.h"

namespace viewing {

std::filesystem::path free_file(const std::string& stem, const std::string& extension) {
    std::error_code ignored;
    const std::filesystem::path folder = std::filesystem::current_path(ignored);
    for (int number = 1;; ++number) {
        const std::string suffix = number == 1 ? "" : "-" + std::to_string(number);
        std::filesystem::path file = folder / (stem + suffix + extension);
        if (!is_there(file)) return file;
    }
}

}  // namespace viewing
