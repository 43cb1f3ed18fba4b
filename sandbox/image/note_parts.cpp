#include "image/note_parts.h"

#include <algorithm>
#include <cstddef>

#include "platform/text_file.h"

namespace viewing {

bool can_carry(std::string_view note) {
    return note.size() <= max_document_bytes;
}

std::vector<std::string_view> note_parts(std::string_view note) {
    constexpr std::size_t most_bytes = 1'000'000, longest_character = 4;
    std::vector<std::string_view> parts;
    while (!note.empty() && can_carry(note)) {
        std::size_t end = std::min(note.size(), most_bytes);
        const auto is_inside = [&] {
            return end < note.size() && (static_cast<unsigned char>(note[end]) & 0xC0U) == 0x80U;
        };
        while (is_inside() && end > most_bytes - longest_character) --end;
        parts.push_back(note.substr(0, end));
        note.remove_prefix(end);
    }
    return parts;
}

std::string note_part_name(std::string_view name, std::string_view between, int number) {
    std::string full(name);
    if (number > 1) full.append(between).append(std::to_string(number));
    return full;
}

}  // namespace viewing
