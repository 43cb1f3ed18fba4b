#include "image/deflate.h"

#include <zlib.h>

#include <array>
#include <new>

namespace viewing {
namespace {

/// Calls inflateEnd() on every exit.
struct Inflating {
    z_stream stream{};
    bool has_begun = inflateInit(&stream) == Z_OK;
    Inflating() = default;
    Inflating(const Inflating&) = delete;
    Inflating& operator=(const Inflating&) = delete;
    ~Inflating() {
        if (has_begun) inflateEnd(&stream);
    }
};

}  // namespace

std::vector<std::uint8_t> deflated(std::string_view text) {
    uLongf size = compressBound(text.size());
    std::vector<std::uint8_t> bytes(size);
    compress2(bytes.data(), &size, reinterpret_cast<const Bytef*>(text.data()), text.size(), Z_BEST_COMPRESSION);
    bytes.resize(size);
    return bytes;
}

Inflated inflated(std::span<const std::uint8_t> bytes, std::size_t most) {
    Inflating inflating;
    z_stream& stream = inflating.stream;
    if (!inflating.has_begun) throw std::bad_alloc();
    stream.next_in = const_cast<Bytef*>(bytes.data());
    stream.avail_in = static_cast<uInt>(bytes.size());
    std::string text;
    std::array<char, 65536> part{};
    for (int state = Z_OK; state != Z_STREAM_END;) {
        stream.next_out = reinterpret_cast<Bytef*>(part.data());
        stream.avail_out = static_cast<uInt>(part.size());
        state = inflate(&stream, Z_NO_FLUSH);
        if (state != Z_OK && state != Z_STREAM_END) return {InflateEnd::damaged, ""};
        text.append(part.data(), part.size() - stream.avail_out);
        if (text.size() > most) return {InflateEnd::too_long, ""};
    }
    if (stream.avail_in > 0) return {InflateEnd::followed, ""};
    return {InflateEnd::whole, std::move(text)};
}

}  // namespace viewing
