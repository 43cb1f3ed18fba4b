// libpng reports errors with longjmp: a function here that calls setjmp must not hold an object with a destructor; its
// caller owns the resources to free.
#include "image/png.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cerrno>
#include <cmath>
#include <csetjmp>
#include <cstdio>
#include <fstream>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>

#include "image/deflate.h"
#include "image/note_parts.h"
#include "platform/file.h"
#include "platform/text_file.h"

namespace viewing {

namespace {

/// State that libpng's callbacks may change while libpng runs.
struct PngFailure {
    char message[160] = "";
    bool file_ended = false;
    int read_errno = 0;
};

[[noreturn]] void on_error(png_structp png, png_const_charp message) {
    auto* failure = static_cast<PngFailure*>(png_get_error_ptr(png));
    std::snprintf(failure->message, sizeof failure->message, "%s", message);
    png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

struct ReadSource {
    std::FILE* file;
    PngFailure* failure;
};

void read_bytes(png_structp png, png_bytep bytes, std::size_t count) {
    const auto* source = static_cast<const ReadSource*>(png_get_io_ptr(png));
    if (std::fread(bytes, 1, count, source->file) == count) return;
    source->failure->file_ended = std::feof(source->file) != 0;
    source->failure->read_errno = errno;
    png_error(png, "read error");
}

struct Reader {
    png_structp png = nullptr;
    png_infop info = nullptr;

    explicit Reader(PngFailure& failure)
        : png(png_create_read_struct(PNG_LIBPNG_VER_STRING, &failure, on_error, on_warning)),
          info(png != nullptr ? png_create_info_struct(png) : nullptr) {}
    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
};

/// The note read so far. Its chunks are handled here and not by libpng, which would unpack every text in the file,
/// however large.
struct FoundNote {
    std::string text;
    int parts = 0;
    InflateEnd end = InflateEnd::whole;  ///< how unpacking the latest part ended
};

Inflated copied(std::span<const std::uint8_t> bytes, std::size_t most) {
    if (bytes.size() > most) return {InflateEnd::too_long, ""};
    return {InflateEnd::whole, std::string(bytes.begin(), bytes.end())};
}

/// Adds the next part to the note; skips other chunks. Layouts: "tEXt": key, 0, text. "zTXt": key, 0, 0, packed text.
/// "iTXt": key, 0, whether packed, 0, language, 0, translated key, 0, text.
void take_note(FoundNote& note, std::string_view type, std::span<const std::uint8_t> chunk) {
    const std::string_view bytes(reinterpret_cast<const char*>(chunk.data()), chunk.size());
    const std::string key = note_part_name(png_note_key, " ", note.parts + 1) + '\0';
    if (note.end != InflateEnd::whole || !bytes.starts_with(key)) return;
    std::size_t begin = key.size();
    if (type == "zTXt") ++begin;
    if (type == "iTXt") {
        const std::size_t language_end = bytes.find('\0', begin + 2);
        const std::size_t end =
            language_end == std::string_view::npos ? std::string_view::npos : bytes.find('\0', language_end + 1);
        if (end == std::string_view::npos) return;
        begin = end + 1;
    }
    if (begin > bytes.size()) return;
    ++note.parts;
    const bool is_packed = type == "zTXt" || (type == "iTXt" && bytes[key.size()] != 0);
    const std::size_t most = max_document_bytes - note.text.size();
    const Inflated part = is_packed ? inflated(chunk.subspan(begin), most) : copied(chunk.subspan(begin), most);
    note.end = part.end;
    note.text += part.text;
}

constexpr png_byte text_chunks[] = "tEXt\0zTXt\0iTXt";

/// Returns 1, because libpng does not need to keep the chunk, or −1 if out of memory.
int on_chunk(png_structp png, png_unknown_chunkp chunk) {
    const std::string_view type(reinterpret_cast<const char*>(chunk->name));
    if (type != "tEXt" && type != "zTXt" && type != "iTXt") return 1;
    try {
        take_note(*static_cast<FoundNote*>(png_get_user_chunk_ptr(png)), type, {chunk->data, chunk->size});
    } catch (const std::bad_alloc&) {
        return -1;
    }
    return 1;
}

/// Reads everything before the pixels. `note` is null if the note was not requested. Skips all other chunks that are
/// not part of the picture, without reading them.
bool read_header(const Reader& reader, ReadSource& source, FoundNote* note = nullptr) {
    if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
    png_set_read_fn(reader.png, &source, read_bytes);
    png_set_keep_unknown_chunks(reader.png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
    if (note != nullptr) {
        png_set_keep_unknown_chunks(reader.png, PNG_HANDLE_CHUNK_ALWAYS, text_chunks, 3);
        png_set_read_user_chunk_fn(reader.png, note, on_chunk);
    }
    png_set_sig_bytes(reader.png, 8);
    png_set_user_limits(reader.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_read_info(reader.png, reader.info);
    return true;
}

/// Reads all rows as 8-bit RGBA, and then the rest of the file, so that a truncated file is detected.
bool read_rows(const Reader& reader, png_bytepp rows) {
    if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
    png_set_expand(reader.png);
    png_set_scale_16(reader.png);
    png_set_gray_to_rgb(reader.png);
    png_set_add_alpha(reader.png, 255, PNG_FILLER_AFTER);
    png_set_interlace_handling(reader.png);
    png_read_update_info(reader.png, reader.info);
    png_read_image(reader.png, rows);
    png_read_end(reader.png, nullptr);
    return true;
}

Error read_failure(const std::string& name, const PngFailure& failure) {
    if (failure.file_ended) return {name + ": the PNG file is cut off before its end"};
    if (failure.read_errno != 0)
        return {name + ": cannot be read: " + std::generic_category().message(failure.read_errno)};
    return {name + ": the PNG file is broken: " + failure.message};
}

/// Whether a file of this size can contain the pixels. Deflate never compresses better than 1032 to 1, so a header that
/// promises more pixels would only waste memory.
bool file_can_hold(std::uintmax_t file_bytes, png_uint_32 height, std::size_t row_bytes) {
    return file_bytes > static_cast<std::uintmax_t>(height) * row_bytes / 1032;
}

bool begins_as_png(std::FILE* file) {
    unsigned char signature[8];
    return std::fread(signature, 1, sizeof signature, file) == sizeof signature &&
           png_sig_cmp(signature, 0, sizeof signature) == 0;
}

/// Opens a PNG file and reads past its signature.
Result<File> opened(const std::filesystem::path& path) {
    const std::string name = path.string();
    if (Status checked = check_readable(path); !checked) return Error{checked.error()};
    File file(std::fopen(path.c_str(), "rb"));
    if (!file) return Error{name + ": cannot be read: " + std::generic_category().message(errno)};
    if (!begins_as_png(file.get())) return Error{name + ": is not a PNG file"};
    return file;
}

Error not_enough_memory(const std::string& name) {
    return {name + ": not enough memory for this picture"};
}

/// Reads the rest of the file after the signature. `file_bytes` is empty for a pipe, whose size is unknown.
Result<Image> read_picture(std::FILE* file, const std::string& name, std::optional<std::uintmax_t> file_bytes) try {
    PngFailure failure;
    const Reader reader(failure);
    if (reader.info == nullptr) throw std::bad_alloc();
    ReadSource source{file, &failure};
    if (!read_header(reader, source)) return read_failure(name, failure);

    const png_uint_32 width = png_get_image_width(reader.png, reader.info);
    const png_uint_32 height = png_get_image_height(reader.png, reader.info);
    if (width > largest_image_side || height > largest_image_side)
        return Error{name + ": the picture is " + std::to_string(width) + " × " + std::to_string(height) +
                     " pixels; at most " + std::to_string(largest_image_side) + " per side are allowed"};
    if (static_cast<std::uint64_t>(width) * height > most_image_pixels)
        return Error{name + ": the picture is " + std::to_string(width) + " × " + std::to_string(height) +
                     " pixels; at most " + std::to_string(most_image_pixels / 1'000'000) +
                     " million are allowed; make it smaller"};
    if (file_bytes && !file_can_hold(*file_bytes, height, png_get_rowbytes(reader.png, reader.info)))
        return Error{name + ": the PNG file is cut off before its end"};

    Image image{static_cast<int>(width), static_cast<int>(height), {}};
    image.rgba.resize(image.row_bytes() * height);
    std::vector<png_bytep> rows(height);
    for (int y = 0; y < image.height; ++y) rows[y] = image.row(y);
    if (!read_rows(reader, rows.data())) return read_failure(name, failure);
    return image;
} catch (const std::bad_alloc&) {
    return not_enough_memory(name);
}

struct Writer {
    png_structp png = nullptr;
    png_infop info = nullptr;

    explicit Writer(PngFailure& failure)
        : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, &failure, on_error, on_warning)),
          info(png != nullptr ? png_create_info_struct(png) : nullptr) {}
    ~Writer() { png_destroy_write_struct(&png, &info); }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
};

void append_bytes(png_structp png, png_bytep bytes, std::size_t count) {
    auto* out = static_cast<std::vector<std::uint8_t>*>(png_get_io_ptr(png));
    out->insert(out->end(), bytes, bytes + count);
}

/// The note in libpng's form: packed chunks, each with its key.
class NoteChunks {
public:
    explicit NoteChunks(std::string_view note) {
        for (const std::string_view part : note_parts(note)) {
            const int number = static_cast<int>(parts_.size()) + 1;
            parts_.push_back({note_part_name(png_note_key, " ", number), std::string(part)});
        }
        for (Part& part : parts_) {
            png_text& chunk = chunks_.emplace_back();
            chunk.compression = PNG_ITXT_COMPRESSION_zTXt;
            chunk.key = part.key.data();
            chunk.text = part.text.data();
            chunk.itxt_length = part.text.size();
        }
    }

    const std::vector<png_text>& chunks() const { return chunks_; }

private:
    struct Part {
        std::string key, text;
    };
    std::vector<Part> parts_;
    std::vector<png_text> chunks_;
};

bool encode(const Writer& writer, const Image& image, const std::vector<png_text>& note, double dpi, bool opaque,
            std::vector<std::uint8_t>& out) {
    if (setjmp(png_jmpbuf(writer.png)) != 0) return false;
    png_set_write_fn(writer.png, &out, append_bytes, nullptr);
    png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height),
                 8, opaque ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGB_ALPHA, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_compression_level(writer.png, 1);
    png_set_filter(writer.png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
    // Store the note before the pixels. libpng copies its arguments.
    png_set_text(writer.png, writer.info, note.data(), static_cast<int>(note.size()));
    if (const auto per_meter = static_cast<png_uint_32>(std::lround(dpi / 0.0254)); dpi != usual_dpi)
        png_set_pHYs(writer.png, writer.info, per_meter, per_meter, PNG_RESOLUTION_METER);
    png_write_info(writer.png, writer.info);
    if (opaque) png_set_filler(writer.png, 0, PNG_FILLER_AFTER);
    for (int y = 0; y < image.height; ++y) png_write_row(writer.png, image.row(y));
    png_write_end(writer.png, nullptr);
    return true;
}

bool encode_gray(const Writer& writer, int width, int height, const std::vector<std::uint8_t>& big_endian,
                 std::vector<std::uint8_t>& out) {
    if (setjmp(png_jmpbuf(writer.png)) != 0) return false;
    png_set_write_fn(writer.png, &out, append_bytes, nullptr);
    png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), 16,
                 PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(writer.png, writer.info);
    const std::size_t row_bytes = 2 * static_cast<std::size_t>(width);
    for (int y = 0; y < height; ++y)
        png_write_row(writer.png, big_endian.data() + row_bytes * static_cast<std::size_t>(y));
    png_write_end(writer.png, nullptr);
    return true;
}

bool is_opaque(const Image& image) {
    std::uint8_t all = 255;
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) all &= image.rgba[i];
    return all == 255;
}

}  // namespace

Result<std::string> read_png_note(const std::filesystem::path& path) try {
    const Result<File> file = opened(path);
    if (!file) return Error{file.error()};
    PngFailure failure;
    const Reader reader(failure);
    if (reader.info == nullptr) throw std::bad_alloc();
    ReadSource source{file->get(), &failure};
    FoundNote note;
    if (!read_header(reader, source, &note)) return read_failure(path.string(), failure);
    if (note.end == InflateEnd::too_long)
        return Error{path.string() + ": the state in it is " + longer_than(max_document_bytes)};
    if (note.end != InflateEnd::whole) return Error{path.string() + ": the state in it is cut off or damaged"};
    return std::move(note.text);
} catch (const std::bad_alloc&) {
    return not_enough_memory(path.string());
}

Result<Image> read_png(const std::filesystem::path& path) {
    const Result<File> file = opened(path);
    if (!file) return Error{file.error()};
    std::error_code error;
    const std::uintmax_t bytes = std::filesystem::file_size(path, error);
    return read_picture(file->get(), path.string(), error ? std::nullopt : std::optional(bytes));
}

bool has_16_bits(const std::filesystem::path& path) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return false;  // reading a pipe would empty it
    constexpr std::size_t place_of_depth = 24;                         // after the signature, the width and the height
    std::array<char, place_of_depth + 1> head{};
    return std::ifstream(path, std::ios::binary).read(head.data(), head.size()) && head[place_of_depth] == 16;
}

Result<Image> read_png(std::FILE* stream, const std::string& name) {
    if (!begins_as_png(stream)) return Error{name + ": is not a PNG file"};
    return read_picture(stream, name, std::nullopt);
}

std::vector<std::uint8_t> encode_png(const Image& image, const std::string& note, double dpi) {
    assert(image.width >= 1 && image.width <= largest_image_side);
    assert(image.height >= 1 && image.height <= largest_image_side);
    assert(image.rgba.size() == image.row_bytes() * static_cast<std::size_t>(image.height));
    PngFailure failure;
    const Writer writer(failure);
    if (writer.info == nullptr) throw std::bad_alloc();
    const NoteChunks text(note);
    std::vector<std::uint8_t> out;
    // libpng can fail only for lack of memory: sizes are checked above and the output is a vector.
    if (!encode(writer, image, text.chunks(), dpi, is_opaque(image), out)) throw std::bad_alloc();
    return out;
}

std::vector<std::uint8_t> encode_gray_png(int width, int height, const std::vector<std::uint16_t>& gray) {
    assert(gray.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    std::vector<std::uint8_t> big_endian;
    big_endian.reserve(2 * gray.size());
    for (const std::uint16_t value : gray) {
        big_endian.push_back(static_cast<std::uint8_t>(value >> 8U));
        big_endian.push_back(static_cast<std::uint8_t>(value & 0xffU));
    }
    PngFailure failure;
    const Writer writer(failure);
    if (writer.info == nullptr) throw std::bad_alloc();
    std::vector<std::uint8_t> out;
    if (!encode_gray(writer, width, height, big_endian, out)) throw std::bad_alloc();
    return out;
}

Status write_png(const std::filesystem::path& path, const Image& image) {
    return write_file(path, encode_png(image));
}

}  // namespace viewing
