#include "platform/text_file.h"

#include <array>
#include <cerrno>
#include <fstream>
#include <system_error>

#include "platform/file.h"

namespace viewing {

Result<std::string> read_text(std::istream& stream, const std::string& name) {
    std::string text;
    std::array<char, 16U << 10U> block;
    errno = 0;
    while (stream) {
        stream.read(block.data(), block.size());
        text.append(block.data(), static_cast<std::size_t>(stream.gcount()));
        if (text.size() > max_document_bytes) {
            return Error{name + ": longer than 16 MiB"};
        }
    }
    if (stream.bad()) {
        const std::string why = errno != 0 ? ": " + std::generic_category().message(errno) : "";
        return Error{name + ": cannot be read" + why};
    }
    return text;
}

Result<std::string> read_text_file(const std::filesystem::path& file) {
    const std::string name = file.string();
    if (Status checked = check_readable(file); !checked) {
        return Error{checked.error()};
    }
    std::ifstream stream(file, std::ios::binary);
    if (!stream) {
        return Error{name + ": cannot be read"};
    }
    return read_text(stream, name);
}

}  // namespace viewing
