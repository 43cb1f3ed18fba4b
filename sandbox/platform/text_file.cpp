#include "platform/text_file.h"

#include <array>
#include <fstream>

namespace viewing {

Result<std::string> read_text(std::istream& stream, const std::string& name) {
    std::string text;
    std::array<char, 16U << 10U> block;
    while (stream) {
        stream.read(block.data(), block.size());
        text.append(block.data(), static_cast<std::size_t>(stream.gcount()));
        if (text.size() > max_document_bytes) {
            return Error{name + ": longer than 16 MiB"};
        }
    }
    if (stream.bad()) {
        return Error{name + ": cannot be read"};
    }
    return text;
}

Result<std::string> read_text_file(const std::filesystem::path& file) {
    const std::string name = file.string();
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status)) {
        return Error{name + ": no such file"};
    }
    if (std::filesystem::is_directory(status)) {
        return Error{name + ": is a directory, not a file"};
    }
    std::ifstream stream(file, std::ios::binary);
    if (!stream) {
        return Error{name + ": cannot be read"};
    }
    return read_text(stream, name);
}

}  // namespace viewing
