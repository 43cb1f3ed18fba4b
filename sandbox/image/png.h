// Reads and writes PNG files with libpng. Equal pictures with equal notes give byte-identical files, which contain no
// time stamps.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "image/image.h"
#include "text/result.h"

namespace viewing {

/// The largest width and height that can be read or written.
constexpr int largest_image_side = 16384;
/// The maximum number of pixels to read. It limits the memory to 256 MB, whatever the header of a small file promises.
constexpr int most_image_pixels = 64'000'000;

/// Reads any PNG (1 … 16 bits, gray, palette, with or without alpha, interlaced) as 8-bit RGBA with the values stored
/// in the file: no gamma is applied, 16 bits are rounded to 8, missing alpha is 255. The error is one sentence that
/// begins with the path and says that the file cannot be read, is not a PNG, is damaged or truncated, or, according to
/// its header, exceeds largest_image_side or most_image_pixels.
Result<Image> read_png(const std::filesystem::path& path);
/// Returns whether a PNG file has 16 bits per channel; false for anything that cannot be read.
bool has_16_bits(const std::filesystem::path& path);

/// Pixels per inch on a typical screen.
inline constexpr double usual_dpi = 96.0;

/// Reads a PNG from an open file or pipe, up to the end of the picture. An error begins with `name`.
Result<Image> read_png(std::FILE* stream, const std::string& name);

/// The key of the text chunk that holds the note: the state that a picture shows, as JSON. A long note continues in
/// chunks with the keys "… 2", "… 3" (note_parts.h).
inline constexpr char png_note_key[] = "viewing-sandbox state";

/// Returns the note that precedes the pixels in a PNG file; empty if there is none. The error is that of read_png, or
/// says that the note is longer than max_document_bytes or damaged.
Result<std::string> read_png_note(const std::filesystem::path& path);

/// Returns the bytes of a PNG file: RGB if every alpha is 255, otherwise RGBA. Favors speed over size: zlib level 1
/// with only the SUB filter takes a fifth of libpng's default time, and the files are a third larger. Each side must be
/// 1 … largest_image_side. `note` is UTF-8 stored with the picture; nothing is stored for "" or a note longer than
/// max_document_bytes. `dpi` is the intended resolution on paper; usual_dpi is not stored, since readers assume it by
/// default.
std::vector<std::uint8_t> encode_png(const Image& image, const std::string& note = "", double dpi = usual_dpi);

/// Returns the bytes of a PNG file of 16-bit gray values, rows from the top; gray.size() = width · height.
std::vector<std::uint8_t> encode_gray_png(int width, int height, const std::vector<std::uint16_t>& gray);

/// Writes the bytes from encode_png to a file, completely or not at all (file.h).
Status write_png(const std::filesystem::path& path, const Image& image);

}  // namespace viewing
