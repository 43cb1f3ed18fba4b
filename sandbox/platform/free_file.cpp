#include "platform/free_file.h"

#include <system_error>

namespace viewing {

std::filesystem::path free_file(const std::string& stem, const std::string& extension) {
    std::error_code ignored;
    const std::filesystem::path folder = std::filesystem::current_path(ignored);
    for (int number = 1;; ++number) {
        const std::string suffix = number == 1 ? "" : "-" + std::to_string(number);
        std::filesystem::path file = folder / (stem + suffix + extension);
        if (!std::filesystem::exists(file, ignored)) return file;
    }
}

}  // namespace viewing
