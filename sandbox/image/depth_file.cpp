#include "image/depth_file.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "image/png.h"
#include "text/words.h"

namespace viewing {
namespace {

/// Appends the bytes of a number, least significant first.
template <typename Bits>
void append(std::vector<std::uint8_t>& out, Bits bits) {
    for (std::size_t byte = 0; byte < sizeof bits; ++byte)
        out.push_back(static_cast<std::uint8_t>(bits >> (8U * byte)));
}

void append(std::vector<std::uint8_t>& out, const std::string& text) {
    out.insert(out.end(), text.begin(), text.end());
}

/// Source: NumPy's format description, version 1.0: the header's end is aligned to 64 bytes.
std::vector<std::uint8_t> as_npy(const DepthImage& image) {
    std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': (" + std::to_string(image.height) + ", " +
                         std::to_string(image.width) + "), }";
    constexpr std::size_t before = 10;  // the magic, the version and the header's length
    header.append(63 - (before + header.size()) % 64, ' ');
    header += '\n';
    std::vector<std::uint8_t> out;
    append(out, std::string("\x93NUMPY\x01") + '\0');
    append(out, static_cast<std::uint16_t>(header.size()));
    append(out, header);
    for (const double depth : image.depths) append(out, std::bit_cast<std::uint64_t>(depth));
    return out;
}

std::vector<std::uint8_t> as_pfm(const DepthImage& image) {
    std::vector<std::uint8_t> out;
    // A negative scale says that the bytes are in little-endian order.
    append(out, "Pf\n" + std::to_string(image.width) + " " + std::to_string(image.height) + "\n-1.0\n");
    const auto width = static_cast<std::size_t>(image.width);
    for (std::size_t row = static_cast<std::size_t>(image.height); row-- > 0;)
        for (std::size_t x = 0; x < width; ++x)
            append(out, std::bit_cast<std::uint32_t>(static_cast<float>(image.depths[row * width + x])));
    return out;
}

}  // namespace

bool is_depth_file_name(const std::string& name) {
    const std::string lower = in_lower_case(name);
    return lower.ends_with(".npy") || lower.ends_with(".pfm") || lower.ends_with("z16.png");
}

std::vector<std::uint8_t> encode_depths(const DepthImage& image, const std::string& name) {
    const std::string lower = in_lower_case(name);
    if (lower.ends_with(".npy")) return as_npy(image);
    if (lower.ends_with(".pfm")) return as_pfm(image);
    std::vector<std::uint16_t> gray;
    gray.reserve(image.depths.size());
    for (const double depth : image.depths)
        gray.push_back(static_cast<std::uint16_t>(std::lround(65535.0 * std::clamp(depth, 0.0, 1.0))));
    return encode_gray_png(image.width, image.height, gray);
}

}  // namespace viewing
