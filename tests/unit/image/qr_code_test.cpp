// QR codes: their size, their limits and the three marks in their corners. cli/lesson_test.cpp decodes the
// code in a picture of the stage.
#include "image/qr_code.h"

#include <gtest/gtest.h>

namespace viewing::test {
namespace {

TEST(QrCode, GrowsWithItsTextUpToVersion40) {
    // Bytes that versions 1, 2 and 40 hold at the lowest level of error correction (ISO/IEC 18004, table 7).
    for (const auto& [bytes, modules] : {std::pair(17, 21), {18, 25}, {32, 25}, {33, 29}, {2953, 177}}) {
        const Result<QrCode> code = qr_code(std::string(static_cast<std::size_t>(bytes), '#'));
        ASSERT_TRUE(code) << bytes;
        EXPECT_EQ(code->modules, modules) << bytes;
    }
    const Result<QrCode> too_long = qr_code(std::string(2954, '#'));
    ASSERT_FALSE(too_long);
    EXPECT_EQ(too_long.error(), "The link has 2,954 characters; a QR code holds at most 2,953.");
    EXPECT_FALSE(qr_code(""));
}

TEST(QrCode, HasItsMarksInThreeCorners) {
    const Result<QrCode> code = qr_code("https://cg.example.edu/viewing/");
    ASSERT_TRUE(code);
    const int far = code->modules - 7;
    for (const auto& [top, left] : {std::pair(0, 0), {0, far}, {far, 0}})
        for (int row = 0; row < 7; ++row)
            for (int column = 0; column < 7; ++column) {
                const int ring = std::max(std::abs(row - 3), std::abs(column - 3));
                EXPECT_EQ(code->is_dark(top + row, left + column), ring != 2) << row << " " << column;
            }
}

}  // namespace
}  // namespace viewing::test
