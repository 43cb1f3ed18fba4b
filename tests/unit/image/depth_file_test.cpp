// Depths as numbers: the bytes of each format, read back as their specifications say.
#include "image/depth_file.h"

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>

#include "image/png.h"

namespace viewing {
namespace {

const DepthImage small{3, 2, {0.0, 0.25, 1.0, 0.5, 0.1, 0.75}};

template <typename Number>
Number number_at(const std::vector<std::uint8_t>& bytes, std::size_t at) {
    Number number{};
    std::memcpy(&number, bytes.data() + at, sizeof number);
    return number;
}

TEST(DepthFile, NumPyHoldsFloat64FromTheTop) {
    const std::vector<std::uint8_t> bytes = encode_depths(small, "Z.NPY");
    EXPECT_EQ(std::string(bytes.begin() + 1, bytes.begin() + 6), "NUMPY");
    const std::size_t data = 10U + number_at<std::uint16_t>(bytes, 8);
    EXPECT_EQ(data % 64, 0U);
    const std::string header(bytes.begin() + 10, bytes.begin() + static_cast<std::ptrdiff_t>(data));
    EXPECT_NE(header.find("'descr': '<f8', 'fortran_order': False, 'shape': (2, 3), }"), std::string::npos);
    EXPECT_EQ(header.back(), '\n');
    ASSERT_EQ(bytes.size(), data + 6 * 8);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(number_at<double>(bytes, data + 8 * i), small.depths[i]);
}

TEST(DepthFile, PfmHoldsFloat32FromTheBottom) {
    const std::vector<std::uint8_t> bytes = encode_depths(small, "z.pfm");
    const std::string header = "Pf\n3 2\n-1.0\n";
    EXPECT_EQ(std::string(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(header.size())), header);
    ASSERT_EQ(bytes.size(), header.size() + 6 * 4);
    const float expected[] = {0.5F, 0.1F, 0.75F, 0.0F, 0.25F, 1.0F};
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(number_at<float>(bytes, header.size() + 4 * i), expected[i]);
}

TEST(DepthFile, GrayPngHolds16Bits) {
    const std::vector<std::uint8_t> bytes = encode_depths(small, "z16.png");
    EXPECT_EQ(bytes[24], 16) << "bits per sample";
    EXPECT_EQ(bytes[25], 0) << "gray";
    const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "depth_file_test_z16.png";
    std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(bytes.data()), std::ssize(bytes));
    const Result<Image> read = read_png(path);
    std::filesystem::remove(path);
    ASSERT_TRUE(read) << read.error();
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(read->rgba[4 * i], 255.0 * small.depths[i], 0.51);
}

TEST(DepthFile, KnowsItsNames) {
    for (const char* name : {"z.npy", "a/b.PFM", "z16.png", "far-z16.png"}) EXPECT_TRUE(is_depth_file_name(name));
    for (const char* name : {"z.png", "d16.png", "npy", "z.pfm.png", "-"}) EXPECT_FALSE(is_depth_file_name(name));
}

}  // namespace
}  // namespace viewing
