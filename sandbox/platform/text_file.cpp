#include "platform/text_file.h"

#include <array>
#include <cerrno>
#include <fstream>
#include <system_error>

#include "platform/file.h"

namespace viewing {

std::string longer_than(std::size_t bytes) {
    return "longer than " + std::to_string(bytes >> 20U) + " MiB";
}

Result<std::string> read_text(std::istream& stream, const std::string& name, std::size_t most_bytes) {
    std::string text;
    std::array<char, 16U << 10U> block;
    errno = 0;
    while (stream) {
        stream.read(block.data(), block.size());
        text.append(block.data(), static_cast<std::size_t>(stream.gcount()));
        if (text.size() > most_bytes) {
            return Error{name + ": " + longer_than(most_bytes)};
        }
    }
    if (stream.bad()) {
        const std::string why = errno != 0 ? ": " + std::generic_category().message(errno) : "";
        return Error{name + ": cannot be read" + why};
    }
    return text;
}

Result<std::string> read_text_file(const std::filesystem::path& file, std::size_t most_bytes) {
    const std::string name = file.string();
    if (Status checked = check_readable(file); !checked) {
        return Error{checked.error()};
    }
    std::ifstream stream(file, std::ios::binary);
    if (!stream) {
        return Error{name + ": cannot be read"};
    }
    return read_text(stream, name, most_bytes);
}

}  // namespace viewing
