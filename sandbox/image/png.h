// PNG files in and out, through libpng. Equal pictures with equal notes give byte-equal files: no time stamps.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "image/image.h"
#include "text/result.h"

namespace viewing {

/// The largest width and height that is read or written.
constexpr int largest_image_side = 16384;
/// The most pixels that are read: 256 MB of memory, whatever a small file promises.
constexpr int most_image_pixels = 64'000'000;

/// Any PNG (1 … 16 bits, grey, palette, with or without alpha, interlaced) as 8-bit RGBA with the values stored in
/// the file: no gamma is applied, 16 bits are rounded to 8, no alpha is 255. One sentence that begins with the path for
/// a file that cannot be read, is no PNG, is broken or cut off, or is larger than largest_image_side or
/// most_image_pixels, which its header tells.
Result<Image> read_png(const std::filesystem::path& path);

/// Pixels per inch on a screen.
inline constexpr double usual_dpi = 96.0;

/// The same from an open file or pipe, up to the picture's end; `name` begins the sentence.
Result<Image> read_png(std::FILE* stream, const std::string& name);

/// The name of the text chunk that a note is: the state that a picture shows, as JSON. A long one goes on in chunks of
/// the names "… 2", "… 3" (note_parts.h).
inline constexpr char png_note_key[] = "viewing-sandbox state";

/// The note of a PNG file, as it stands before the pixels; empty where it has none. The error is that of read_png, or
/// that the note is longer than max_document_bytes or damaged.
Result<std::string> read_png_note(const std::filesystem::path& path);

/// The bytes of a PNG file: RGB when every alpha is 255, else RGBA. Fast rather than small: zlib level 1 and the SUB
/// filter alone take a fifth of libpng's default time and end a third larger. Sides 1 … largest_image_side. `note`:
/// UTF-8, kept with the picture; "", or one longer than max_document_bytes: none.
/// `dpi`: how large it is meant to be on paper; the usual one is left out, since it is taken where nothing is said.
std::vector<std::uint8_t> encode_png(const Image& image, const std::string& note = "", double dpi = usual_dpi);

/// encode_png into a file, whole or not at all (file.h).
Status write_png(const std::filesystem::path& path, const Image& image);

}  // namespace viewing
