// The text of a matrix: the order of its entries, its full precision, and entries that are NaN or infinite.
#include "topics/matrices/numbers/matrix_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <sstream>

namespace viewing {
namespace {

/// Returns a matrix whose entry in row r and column c (from 1) is 10 r + c + 1 / 2, so that a transposition is noticed.
glm::dmat4 numbered() {
    glm::dmat4 matrix;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) matrix[column][row] = 10.0 * (row + 1) + (column + 1) + 0.5;
    return matrix;
}

TEST(MatrixText, PlainTextShowsRowsOnLines) {
    EXPECT_EQ(matrix_text("m", numbered(), MatrixFormat::text),
              "m =\n"
              "  11.5  12.5  13.5  14.5\n"
              "  21.5  22.5  23.5  24.5\n"
              "  31.5  32.5  33.5  34.5\n"
              "  41.5  42.5  43.5  44.5\n");
}

TEST(MatrixText, PlainTextAlignsColumns) {
    glm::dmat4 matrix(1.0);
    matrix[0][1] = -120.25;
    EXPECT_EQ(matrix_text("m", matrix, MatrixFormat::text),
              "m =\n"
              "        1  0  0  0\n"
              "  -120.25  1  0  0\n"
              "        0  0  1  0\n"
              "        0  0  0  1\n");
}

TEST(MatrixText, LatexIsABmatrixOfRows) {
    EXPECT_EQ(matrix_text("shadow_from_world", numbered(), MatrixFormat::latex),
              "\\mathrm{shadow\\_from\\_world} =\n"
              "\\begin{bmatrix}\n"
              "    11.5 & 12.5 & 13.5 & 14.5 \\\\\n"
              "    21.5 & 22.5 & 23.5 & 24.5 \\\\\n"
              "    31.5 & 32.5 & 33.5 & 34.5 \\\\\n"
              "    41.5 & 42.5 & 43.5 & 44.5\n"
              "\\end{bmatrix}\n");
}

TEST(MatrixText, GlmAndGlslListColumnsFirstAndSaySo) {
    const std::string columns =
        "(\n"
        "    11.5, 21.5, 31.5, 41.5,\n"
        "    12.5, 22.5, 32.5, 42.5,\n"
        "    13.5, 23.5, 33.5, 43.5,\n"
        "    14.5, 24.5, 34.5, 44.5);\n";
    EXPECT_EQ(matrix_text("m", numbered(), MatrixFormat::glm), "// columns first\nconst glm::dmat4 m" + columns);
    EXPECT_EQ(matrix_text("m", numbered(), MatrixFormat::glsl), "// columns first\nconst mat4 m = mat4" + columns);
}

TEST(MatrixText, NumpyAndMatlabListRows) {
    EXPECT_EQ(matrix_text("m", numbered(), MatrixFormat::numpy),
              "m = np.array([[11.5, 12.5, 13.5, 14.5],\n"
              "              [21.5, 22.5, 23.5, 24.5],\n"
              "              [31.5, 32.5, 33.5, 34.5],\n"
              "              [41.5, 42.5, 43.5, 44.5]])\n");
    EXPECT_EQ(matrix_text("m", numbered(), MatrixFormat::matlab),
              "m = [11.5, 12.5, 13.5, 14.5;\n"
              "     21.5, 22.5, 23.5, 24.5;\n"
              "     31.5, 32.5, 33.5, 34.5;\n"
              "     41.5, 42.5, 43.5, 44.5];\n");
}

TEST(MatrixText, WholeNumbersHaveADecimalPointWhereNeeded) {
    const glm::dmat4 matrix(1.0);
    EXPECT_NE(matrix_text("m", matrix, MatrixFormat::glsl).find("1.0, 0.0, 0.0, 0.0"), std::string::npos);
    EXPECT_NE(matrix_text("m", matrix, MatrixFormat::matlab).find("1, 0, 0, 0"), std::string::npos);
}

TEST(MatrixText, NegativeZeroIsZero) {
    glm::dmat4 matrix(1.0);
    matrix[2][3] = -0.0;
    for (const auto format : {MatrixFormat::text, MatrixFormat::latex, MatrixFormat::glm, MatrixFormat::glsl,
                              MatrixFormat::numpy, MatrixFormat::matlab})
        EXPECT_EQ(matrix_text("m", matrix, format).find('-'), std::string::npos) << matrix_text("m", matrix, format);
}

TEST(MatrixText, LatexHasPowersOfTen) {
    glm::dmat4 matrix(1.0);
    matrix[0][0] = 2.5e-07;
    matrix[1][0] = -3e+21;
    const std::string text = matrix_text("m", matrix, MatrixFormat::latex);
    EXPECT_NE(text.find("2.5 \\cdot 10^{-7} & -3 \\cdot 10^{21} &"), std::string::npos) << text;
}

TEST(MatrixText, NanAndInfinityFollowTheLanguage) {
    glm::dmat4 matrix(1.0);
    matrix[0][0] = std::numeric_limits<double>::quiet_NaN();
    matrix[1][0] = std::numeric_limits<double>::infinity();
    matrix[2][0] = -std::numeric_limits<double>::infinity();
    const auto has = [&](MatrixFormat format, const char* what) {
        const std::string text = matrix_text("m", matrix, format);
        EXPECT_NE(text.find(what), std::string::npos) << text;
    };
    has(MatrixFormat::text, "nan  inf  -inf");
    has(MatrixFormat::latex, "\\mathrm{NaN} & \\infty & -\\infty");
    has(MatrixFormat::glm, "quiet_NaN()");
    has(MatrixFormat::glsl, "uintBitsToFloat(0x7f800000u)");
    has(MatrixFormat::numpy, "np.nan, np.inf, -np.inf");
    has(MatrixFormat::matlab, "NaN, Inf, -Inf");
}

TEST(MatrixText, EveryNumberReadsBackExactly) {
    constexpr unsigned seed = 7;
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> mantissa(-1.0, 1.0);
    std::uniform_int_distribution<int> exponent(-60, 60);
    for (int round = 0; round < 200; ++round) {
        glm::dmat4 matrix;
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row) matrix[column][row] = std::ldexp(mantissa(random), exponent(random));
        std::istringstream text(matrix_text("m", matrix, MatrixFormat::text));
        std::string name, equals;
        text >> name >> equals;
        for (int row = 0; row < 4; ++row)
            for (int column = 0; column < 4; ++column) {
                std::string number;
                text >> number;
                EXPECT_EQ(std::stod(number), matrix[column][row]) << "seed " << seed << ", round " << round;
            }
    }
}

}  // namespace
}  // namespace viewing
