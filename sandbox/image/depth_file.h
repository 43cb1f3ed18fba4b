// Depths as numbers in a file: NumPy's .npy, .pfm, or a PNG of 16-bit gray.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace viewing {

/// Window depths as stored: 0 … 1, rows from the top; size = width · height.
struct DepthImage {
    int width = 0, height = 0;  ///< pixels
    std::vector<double> depths;
};

/// Whether a file's name requests depths as numbers: it ends in .npy, .pfm or z16.png, in upper or lower case.
bool is_depth_file_name(const std::string& name);

/// Returns the bytes of the file in the format that the name requests. .npy: shape (height, width), float64, rows from
/// the top. .pfm: float32, rows from the bottom, as the format requires. z16.png: depth · 65535, rounded; rows from the
/// top.
std::vector<std::uint8_t> encode_depths(const DepthImage& image, const std::string& name);

}  // namespace viewing
