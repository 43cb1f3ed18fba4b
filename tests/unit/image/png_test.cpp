// PNG files: written files read back, every kind of PNG is read as RGBA, and broken files yield an error sentence.
// Unusual kinds are written here with libpng directly, so that the reader and the writer cannot share a mistake.
#include "image/png.h"

#include <gtest/gtest.h>
#include <png.h>
#include <sys/resource.h>
#include <unistd.h>
#include <zlib.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include "platform/file.h"
#include "platform/text_file.h"

namespace viewing {
namespace {

namespace fs = std::filesystem;

/// A separate folder for a test, removed afterward.
class PngFiles : public testing::Test {
protected:
    void SetUp() override {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder = fs::path(testing::TempDir()) / (std::string("viewing-") + test->name() + std::to_string(::getpid()));
        fs::create_directories(folder);
    }
    void TearDown() override { fs::remove_all(folder); }
    fs::path folder;
};

Image random_image(int width, int height, bool opaque, unsigned seed) {
    std::mt19937 random(seed);
    Image image{width, height, {}};
    image.rgba.resize(image.row_bytes() * static_cast<std::size_t>(height));
    for (std::size_t i = 0; i < image.rgba.size(); ++i)
        image.rgba[i] = opaque && i % 4 == 3 ? 255 : static_cast<std::uint8_t>(random());
    return image;
}

std::string bytes_of(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

void put(const fs::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

struct Kind {
    int bits, color_type, interlace;
};

/// Writes 2 × 2 pixels given as raw rows, with an optional palette and transparent color.
void write_kind(const fs::path& path, const Kind& kind, std::array<std::string, 2> rows,
                std::vector<png_color> palette = {}, std::vector<png_byte> palette_alpha = {},
                const png_color_16* transparent = nullptr) {
    std::FILE* file = std::fopen(path.c_str(), "wb");
    ASSERT_NE(file, nullptr);
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, file);
    png_set_IHDR(png, info, 2, 2, kind.bits, kind.color_type, kind.interlace, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    if (!palette.empty()) png_set_PLTE(png, info, palette.data(), static_cast<int>(palette.size()));
    if (!palette_alpha.empty() || transparent != nullptr)
        png_set_tRNS(png, info, palette_alpha.data(), static_cast<int>(palette_alpha.size()), transparent);
    png_write_info(png, info);
    std::array<png_bytep, 2> pointers{reinterpret_cast<png_bytep>(rows[0].data()),
                                      reinterpret_cast<png_bytep>(rows[1].data())};
    png_write_image(png, pointers.data());
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    std::fclose(file);
}

std::vector<std::uint8_t> pixels(std::initializer_list<int> values) {
    std::vector<std::uint8_t> out;
    for (const int value : values) out.push_back(static_cast<std::uint8_t>(value));
    return out;
}

TEST_F(PngFiles, RoundTripKeepsEveryByte) {
    unsigned seed = 1;
    for (const bool opaque : {true, false}) {
        for (const auto& [width, height] : {std::pair{1, 1}, {1, 7}, {257, 3}, {640, 360}}) {
            SCOPED_TRACE("seed " + std::to_string(seed));
            const Image image = random_image(width, height, opaque, seed++);
            const fs::path path = folder / "a b ü.png";
            const Status status = write_png(path, image);
            ASSERT_TRUE(status) << status.error();
            const Result<Image> back = read_png(path);
            ASSERT_TRUE(back) << back.error();
            EXPECT_EQ(*back, image);
        }
    }
}

TEST_F(PngFiles, OpaqueIsWrittenAsRgbAndEqualPicturesAsEqualBytes) {
    const Image opaque = random_image(16, 16, true, 5);
    const Image glassy = random_image(16, 16, false, 5);
    constexpr std::size_t color_type_at = 25;  // 8 signature, 8 chunk head, 4 + 4 size, 1 depth
    EXPECT_EQ(encode_png(opaque).at(color_type_at), PNG_COLOR_TYPE_RGB);
    EXPECT_EQ(encode_png(glassy).at(color_type_at), PNG_COLOR_TYPE_RGB_ALPHA);
    EXPECT_EQ(encode_png(opaque), encode_png(opaque));
    for (const char* chunk : {"tIME", "tEXt", "iTXt"}) {
        const auto bytes = encode_png(opaque);
        EXPECT_EQ(std::string(bytes.begin(), bytes.end()).find(chunk), std::string::npos) << chunk;
    }
}

TEST_F(PngFiles, EveryKindReadsAsRgba8) {
    const fs::path path = folder / "kind.png";
    struct Case {
        const char* name;
        std::vector<std::uint8_t> expected;
    };
    const auto check = [&](const Case& expected) {
        const Result<Image> image = read_png(path);
        ASSERT_TRUE(image) << expected.name << ": " << image.error();
        EXPECT_EQ(image->width, 2);
        EXPECT_EQ(image->height, 2);
        EXPECT_EQ(image->rgba, expected.expected) << expected.name;
    };

    write_kind(path, {8, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE}, {std::string("\x00\x40", 2), "\x80\xFF"});
    check({"grey 8", pixels({0, 0, 0, 255, 64, 64, 64, 255, 128, 128, 128, 255, 255, 255, 255, 255})});

    write_kind(path, {1, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE}, {"\x40", "\x80"});
    check({"grey 1", pixels({0, 0, 0, 255, 255, 255, 255, 255, 255, 255, 255, 255, 0, 0, 0, 255})});

    write_kind(path, {8, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_INTERLACE_ADAM7},
               {std::string("\x10\x20\x30\x00", 4), "\x50\x60\x70\xFF"});
    check({"grey alpha, interlaced", pixels({16, 16, 16, 32, 48, 48, 48, 0, 80, 80, 80, 96, 112, 112, 112, 255})});

    // In 8 bits, 0x0190 would be 1.56, which must be rounded, not truncated.
    write_kind(path, {16, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE},
               {std::string("\xFF\xFF\x00\x00\x80\x80\x01\x90\x00\x00\x00\x00", 12),
                std::string("\x00\x00\xFE\xFE\x00\x01\x12\x12\x34\x34\x56\x56", 12)});
    check({"rgb 16", pixels({255, 0, 128, 255, 2, 0, 0, 255, 0, 254, 0, 255, 18, 52, 86, 255})});

    write_kind(path, {2, PNG_COLOR_TYPE_PALETTE, PNG_INTERLACE_NONE}, {"\x10", "\xB0"},
               {{1, 2, 3}, {40, 50, 60}, {70, 80, 90}, {255, 0, 255}}, {255, 128});
    check({"palette 2 with alpha", pixels({1, 2, 3, 255, 40, 50, 60, 128, 70, 80, 90, 255, 255, 0, 255, 255})});

    const png_color_16 transparent{0, 9, 8, 7, 0};
    write_kind(path, {8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE},
               {"\x09\x08\x07\x01\x02\x03", "\x09\x08\x06\xFF\xFE\xFD"}, {}, {}, &transparent);
    check({"rgb with a transparent colour", pixels({9, 8, 7, 0, 1, 2, 3, 255, 9, 8, 6, 255, 255, 254, 253, 255})});
}

TEST_F(PngFiles, EveryTruncationGivesASentence) {
    const fs::path path = folder / "cut.png";
    const auto encoded = encode_png(random_image(23, 17, false, 9));
    const std::string whole(encoded.begin(), encoded.end());
    for (std::size_t length = 0; length < whole.size(); length += length < 60 || length + 60 > whole.size() ? 1 : 37) {
        put(path, whole.substr(0, length));
        const Result<Image> image = read_png(path);
        ASSERT_FALSE(image) << "cut to " << length << " bytes";
        EXPECT_EQ(image.error().rfind(path.string() + ": ", 0), 0u) << image.error();
        EXPECT_NE(image.error().find(length < 8 ? "not a PNG" : "cut off"), std::string::npos) << image.error();
    }
}

TEST_F(PngFiles, EveryFlippedByteReadsOrGivesASentence) {
    const fs::path path = folder / "flipped.png";
    const auto encoded = encode_png(random_image(5, 4, false, 11));
    std::string bytes(encoded.begin(), encoded.end());
    int refused = 0;
    for (char& byte : bytes) {
        byte = static_cast<char>(byte ^ 0x55);
        put(path, bytes);
        const Result<Image> image = read_png(path);
        if (!image) {
            ++refused;
            EXPECT_EQ(image.error().rfind(path.string() + ": ", 0), 0u) << image.error();
        }
        byte = static_cast<char>(byte ^ 0x55);
    }
    EXPECT_GT(refused, static_cast<int>(bytes.size()) / 2);
}

/// Returns the signature, an IHDR chunk with the correct checksum, and an empty IDAT.
std::string header_of(std::uint32_t width, std::uint32_t height) {
    const auto big_endian = [](std::uint32_t v) {
        return std::string{static_cast<char>(v >> 24), static_cast<char>(v >> 16), static_cast<char>(v >> 8),
                           static_cast<char>(v)};
    };
    const auto chunk = [&](const std::string& body) {
        std::uint32_t crc = 0xFFFFFFFFU;
        for (const char c : body) {
            crc ^= static_cast<unsigned char>(c);
            for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
        }
        return big_endian(static_cast<std::uint32_t>(body.size() - 4)) + body + big_endian(~crc);
    };
    return "\x89PNG\r\n\x1A\n" +
           chunk("IHDR" + big_endian(width) + big_endian(height) + std::string("\x08\x06\x00\x00\x00", 5)) +
           chunk("IDAT");
}

TEST_F(PngFiles, HugeSizesAreRefusedWithoutAllocatingThem) {
    const fs::path path = folder / "huge.png";
    const auto error_for = [&](std::uint32_t width, std::uint32_t height) {
        put(path, header_of(width, height));
        const Result<Image> image = read_png(path);
        return image ? std::string("read") : image.error();
    };
    EXPECT_EQ(error_for(16385, 4),
              path.string() + ": the picture is 16385 × 4 pixels; at most 16384 per side are allowed");
    EXPECT_NE(error_for(4, 2000000000).find("4 × 2000000000 pixels"), std::string::npos);
    EXPECT_EQ(error_for(16384, 16384),
              path.string() + ": the picture is 16384 × 16384 pixels; at most 64 million are allowed; make it smaller");
    EXPECT_EQ(error_for(8000, 8000), path.string() + ": the PNG file is cut off before its end");
    EXPECT_NE(error_for(0, 4).find("broken"), std::string::npos);
    EXPECT_NE(error_for(0xFFFFFFFFU, 0xFFFFFFFFU).find("broken"), std::string::npos);
}

TEST_F(PngFiles, FilesThatAreNotPngAreReported) {
    const auto error_for = [](const fs::path& path) {
        const Result<Image> image = read_png(path);
        return image ? std::string("read") : image.error();
    };
    EXPECT_NE(error_for(folder / "none.png").find("no such file"), std::string::npos);
    EXPECT_NE(error_for(folder).find("is a directory"), std::string::npos);
    put(folder / "text.png", "P6\n2 2\n255\nabcdefghijkl");
    EXPECT_NE(error_for(folder / "text.png").find("not a PNG file"), std::string::npos);
    EXPECT_NE(error_for("").find("must not be empty"), std::string::npos);
}

TEST_F(PngFiles, AFailedWriteLeavesTheOldFile) {
    const Image image = random_image(8, 8, true, 3);
    const fs::path taken = folder / "folder.png";
    fs::create_directories(taken / "inside");
    const Status onto_folder = write_png(taken, image);
    ASSERT_FALSE(onto_folder);
    EXPECT_EQ(onto_folder.error(), taken.string() + ": cannot be written: it is a directory");

    const Status nowhere = write_png(folder / "no" / "such.png", image);
    ASSERT_FALSE(nowhere);
    EXPECT_NE(nowhere.error().find("No such file or directory"), std::string::npos) << nowhere.error();
    EXPECT_NE(nowhere.error().find("such.png"), std::string::npos);

    EXPECT_FALSE(write_png("", image));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1) << "something was left behind";
}

TEST_F(PngFiles, DevicesAndLinksAreWrittenIntoNotReplaced) {
    const Image image = random_image(8, 8, true, 4);
    ASSERT_TRUE(write_png("/dev/null", image));
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    const Status full = write_png("/dev/full", image);
    ASSERT_FALSE(full);
    EXPECT_EQ(full.error(), "/dev/full: cannot be written: No space left on device");

    const fs::path target = folder / "target.png";
    put(target, "before");
    fs::create_symlink("target.png", folder / "link.png");
    ASSERT_TRUE(write_png(folder / "link.png", image));
    EXPECT_TRUE(fs::is_symlink(folder / "link.png"));
    const auto expected = encode_png(image);
    EXPECT_EQ(bytes_of(target), std::string(expected.begin(), expected.end()));
}

TEST_F(PngFiles, AWriteInterruptedHalfwayLeavesTheOldFile) {
    const fs::path path = folder / "kept.png";
    put(path, "kept");
    struct rlimit before {};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const struct rlimit small { 4096, before.rlim_max };
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    const Status status = write_png(path, random_image(100, 100, true, 6));
    ::setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error(), path.string() + ": cannot be written: File too large");
    EXPECT_EQ(bytes_of(path), "kept");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1) << "something was left behind";
}

/// Returns a PNG of one pixel with a handmade chunk after IHDR.
std::string with_chunk(const std::string& type, const std::string& data) {
    const auto number = [](std::uint32_t value) {
        std::string bytes;
        for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> static_cast<unsigned>(shift));
        return bytes;
    };
    const std::string checked = type + data;
    const auto sum = static_cast<std::uint32_t>(
        ::crc32(0, reinterpret_cast<const Bytef*>(checked.data()), static_cast<uInt>(checked.size())));
    const auto made = encode_png(random_image(1, 1, true, 9));
    constexpr std::size_t header_bytes = 8 + 25;  // the signature and IHDR
    std::string file(made.begin(), made.end());
    return file.insert(header_bytes, number(static_cast<std::uint32_t>(data.size())) + checked + number(sum));
}

std::string packed(const std::string& text) {
    uLongf size = ::compressBound(text.size());
    std::string bytes(size, '\0');
    ::compress(reinterpret_cast<Bytef*>(bytes.data()), &size, reinterpret_cast<const Bytef*>(text.data()), text.size());
    return bytes.substr(0, size);
}

TEST_F(PngFiles, NotesAreReadFromEveryKindOfTextChunk) {
    const std::string key = std::string(png_note_key) + '\0', state = R"({"version": 1})", none(1, '\0');
    const fs::path path = folder / "note.png";
    for (const auto& [type, data] : {std::pair<std::string, std::string>{"tEXt", key + state},
                                     {"zTXt", key + none + packed(state)},
                                     {"iTXt", key + none + none + "en" + none + "state" + none + state},
                                     {"iTXt", key + '\1' + none + none + none + packed(state)}}) {
        put(path, with_chunk(type, data));
        const Result<std::string> note = read_png_note(path);
        ASSERT_TRUE(note) << type << ": " << note.error();
        EXPECT_EQ(*note, state) << type;
        EXPECT_TRUE(read_png(path)) << type;
    }
    put(path, with_chunk("tEXt", "another" + none + state));
    EXPECT_EQ(*read_png_note(path), "");
    for (const std::string& cut :
         {key + '\1' + none, key + '\1' + none + "en", key + '\1' + none + "en" + none + "x"}) {
        put(path, with_chunk("iTXt", cut));
        EXPECT_EQ(*read_png_note(path), "");
    }
}

TEST_F(PngFiles, OversizedOrDamagedNotesAreRefused) {
    const std::string key = std::string(png_note_key) + '\0', none(1, '\0');
    const fs::path path = folder / "note.png";
    put(path, with_chunk("zTXt", key + none + packed(std::string(max_document_bytes, ' '))));
    EXPECT_EQ(read_png_note(path)->size(), max_document_bytes);
    put(path, with_chunk("zTXt", key + none + packed(std::string(max_document_bytes + 1, ' '))));
    EXPECT_EQ(read_png_note(path).error(), path.string() + ": the state in it is longer than 16 MiB");
    EXPECT_TRUE(read_png(path)) << "a picture's pixels need no text";
    std::string damaged = packed(std::string(1000, 'x'));
    damaged.resize(damaged.size() - 4);
    put(path, with_chunk("zTXt", key + none + damaged));
    EXPECT_EQ(read_png_note(path).error(), path.string() + ": the state in it is cut off or damaged");
}

/// Returns the texts of a PNG file written by this program, with their keys, in file order. Each is a compressed iTXt
/// chunk.
std::vector<std::pair<std::string, std::string>> texts_of(const std::vector<std::uint8_t>& file) {
    std::vector<std::pair<std::string, std::string>> texts;
    for (std::size_t at = 8; at + 8 < file.size();) {
        const std::size_t size = (std::size_t{file[at]} << 24U) | (std::size_t{file[at + 1]} << 16U) |
                                 (std::size_t{file[at + 2]} << 8U) | file[at + 3];
        const std::string bytes(file.begin() + static_cast<std::ptrdiff_t>(at) + 4,
                                file.begin() + static_cast<std::ptrdiff_t>(at + 8 + size));
        at += 12 + size;
        if (!bytes.starts_with("iTXt")) continue;
        const std::string key = bytes.substr(4, bytes.find('\0') - 4);
        const std::string data = bytes.substr(4 + key.size() + 5);
        std::string text(max_document_bytes, '\0');
        uLongf length = text.size();
        EXPECT_EQ(::uncompress(reinterpret_cast<Bytef*>(text.data()), &length,
                               reinterpret_cast<const Bytef*>(data.data()), data.size()),
                  Z_OK);
        texts.emplace_back(key, text.substr(0, length));
    }
    return texts;
}

/// Pillow refuses a file with a text chunk of more than 1 MiB (PngImagePlugin.MAX_TEXT_CHUNK), and drops one that is
/// not UTF-8.
TEST_F(PngFiles, ALongNoteIsSplitIntoChunksThatEveryReaderAccepts) {
    constexpr std::size_t most_bytes = 1U << 20U;
    constexpr unsigned seed = 20261126;
    std::mt19937 random(seed);
    const std::vector<std::string> letters = {"a", "é", "그", "𝄞", "\n"};
    const fs::path path = folder / "note.png";
    for (const std::size_t size : {1U, 999'999U, 1'000'000U, 1'000'001U, 3'100'000U, 1U << 24U}) {
        std::string note;
        while (note.size() + 4 <= size) note += letters[random() % letters.size()];
        note += std::string(size - note.size(), '.');
        const std::vector<std::uint8_t> file = encode_png(random_image(1, 1, true, 9), note);
        std::string joined;
        int number = 0;
        for (const auto& [key, text] : texts_of(file)) {
            EXPECT_EQ(key, ++number == 1 ? std::string(png_note_key) : png_note_key + (" " + std::to_string(number)));
            EXPECT_LE(text.size(), most_bytes) << size;
            EXPECT_NE(static_cast<unsigned char>(text.front()) & 0xC0U, 0x80U) << "a character is split";
            joined += text;
        }
        EXPECT_TRUE(joined == note) << "seed " << seed << ", " << size << " bytes: " << joined.size();
        put(path, {file.begin(), file.end()});
        EXPECT_TRUE(*read_png_note(path) == note) << "seed " << seed << ", " << size << " bytes";
    }
}

TEST_F(PngFiles, ANoteTooLongToReadIsNotWritten) {
    const std::vector<std::uint8_t> file =
        encode_png(random_image(1, 1, true, 9), std::string(max_document_bytes + 1, 'x'));
    EXPECT_TRUE(texts_of(file).empty());
    // A note in several parts, each within the limit but together beyond it, is not read either.
    const std::string none(1, '\0'), third = packed(std::string(max_document_bytes / 3 + 1, ' '));
    std::string chunks = with_chunk("zTXt", png_note_key + (" 3" + none + none) + third);
    for (const std::string part : {" 2", ""}) {
        const std::string one = with_chunk("zTXt", png_note_key + part + none + none + third);
        const std::size_t header_bytes = 8 + 25, whole = with_chunk("zTXt", "").size() - 12 - header_bytes;
        chunks.insert(header_bytes, one.substr(header_bytes, one.size() - header_bytes - whole));
    }
    const fs::path path = folder / "note.png";
    put(path, chunks);
    EXPECT_EQ(read_png_note(path).error(), path.string() + ": the state in it is longer than 16 MiB");
}

}  // namespace
}  // namespace viewing
