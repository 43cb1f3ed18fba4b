// libFuzzer: reads arbitrary bytes as a PNG file. Corrects the chunk checksums first, because libpng would otherwise
// reject nearly all inputs at their first chunk. An accepted picture must round-trip exactly.
#include <zlib.h>

#include "fuzz.h"
#include "image/png.h"

namespace {

using namespace viewing;

constexpr std::size_t signature_bytes = 8, head_bytes = 8, checksum_bytes = 4;

/// Corrects every chunk's checksum, and shortens a chunk that would extend beyond the end of the file.
std::string with_checksums(std::string_view bytes) {
    std::string file(bytes);
    std::size_t at = signature_bytes;
    while (at + head_bytes + checksum_bytes <= file.size()) {
        const auto* head = reinterpret_cast<const unsigned char*>(file.data()) + at;
        const std::size_t told =
            std::size_t{head[0]} << 24 | std::size_t{head[1]} << 16 | std::size_t{head[2]} << 8 | head[3];
        const std::size_t length = std::min(told, file.size() - at - head_bytes - checksum_bytes);
        for (std::size_t i = 0; i < 4; ++i) file[at + i] = static_cast<char>(length >> (24 - 8 * i));
        const auto* content = reinterpret_cast<const unsigned char*>(file.data()) + at + 4;
        const uLong sum = crc32(0, content, static_cast<uInt>(length + 4));
        const std::size_t end = at + head_bytes + length;
        for (std::size_t i = 0; i < 4; ++i) file[end + i] = static_cast<char>(sum >> (24 - 8 * i));
        at = end + checksum_bytes;
    }
    return file;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const fuzz::MemoryFile file(with_checksums(fuzz::as_text(data, size)));
    const Result<std::string> note = read_png_note(file.path());
    if (!note) fuzz::check_message(note.error());
    const Result<Image> image = read_png(file.path());
    if (!image) {
        fuzz::check_message(image.error());
        return 0;
    }
    fuzz::check(image->width > 0 && image->height > 0);
    fuzz::check(image->rgba.size() == image->row_bytes() * static_cast<std::size_t>(image->height));
    if (image->rgba.size() > 1'000'000) return 0;
    const std::vector<std::uint8_t> written = encode_png(*image);
    const fuzz::MemoryFile again(fuzz::as_text(written.data(), written.size()));
    const Result<Image> back = read_png(again.path());
    fuzz::check(back && *back == *image);
    return 0;
}
