// Numbers written as text and read from text. Each expected text is written out by hand.
#include "text/numbers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace viewing {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Numbers, FixedDecimalsHaveARealMinusAndNoNegativeZero) {
    EXPECT_EQ(number_text(-2.5, 2), "−2.50");
    EXPECT_EQ(number_text(-0.0, 3), "0.000");
    EXPECT_EQ(number_text(-1e-10, 3), "0.000");
    EXPECT_EQ(number_text(7.5e-6, 1), "7.5·10⁻⁶");
    EXPECT_EQ(number_text(-1234567.0, 3), "−1.235·10⁶");
    EXPECT_EQ(number_text(nan, 2), "—");
    EXPECT_EQ(number_text(-infinity, 2), "−∞");
}

TEST(Numbers, FiguresAreSignificantDigitsWithoutTrailingZeros) {
    for (const double value : {0.25, -3500.0, 1.2e-7, -2e7, 0.0, 1e300, -2e-300})
        EXPECT_EQ(read_figures(figures(value)), std::optional(value)) << value;
    for (const char* const text : {"", "∞", "—", "box", "2, 3", "1.2·10", "1·10x", "12%"})
        EXPECT_FALSE(read_figures(text)) << text;
    EXPECT_EQ(figures(0.25), "0.25");
    EXPECT_EQ(figures(3456.0), "3500");
    EXPECT_EQ(figures(-0.5), "−0.5");
    EXPECT_EQ(figures(1.23e-7), "1.2·10⁻⁷");
    EXPECT_EQ(figures(9.99e5, 2), "1·10⁶");
    EXPECT_EQ(figures(-2e7, 3), "−2·10⁷");
    EXPECT_EQ(figures(0.0), "0");
    EXPECT_EQ(figures(-infinity), "−∞");
}

TEST(Numbers, OnlyZeroIsZeroPercentAndOnlyAllIsAHundred) {
    EXPECT_EQ(percent(0.125), "12.5%");
    EXPECT_EQ(percent(0.0), "0.0%");
    EXPECT_EQ(percent(1.0), "100.0%");
    EXPECT_EQ(percent(1e-7), "< 0.1%");
    EXPECT_EQ(percent(1.0 - 1e-7), "> 99.9%");
    EXPECT_EQ(percent(0.4951, 0), "50%");
    EXPECT_EQ(percent(0.996, 0), "> 99%");
    EXPECT_EQ(percent(0.00052, 2), "0.05%");
}

TEST(Numbers, CountsAreGroupedByThree) {
    EXPECT_EQ(grouped_number(0), "0");
    EXPECT_EQ(grouped_number(999), "999");
    EXPECT_EQ(grouped_number(1000), "1,000");
    EXPECT_EQ(grouped_number(-123456), "-123,456");
    EXPECT_EQ(grouped_number(1234567), "1,234,567");
}

TEST(Numbers, SuperscriptDigits) {
    EXPECT_EQ(raised_text(24), "²⁴");
    EXPECT_EQ(raised_text(-5), "⁻⁵");
    EXPECT_EQ(raised_text(0), "⁰");
}

TEST(Numbers, CodeHasAsciiMinusAndAllDecimals) {
    EXPECT_EQ(plain_decimals(-0.5, 3), "-0.500");
    EXPECT_EQ(plain_decimals(2.0, 0), "2");
    EXPECT_EQ(plain_decimals(1e20, 1), "100000000000000000000.0");
}

TEST(Numbers, ExactTextReadsBackExactly) {
    std::mt19937_64 random(7);
    for (int i = 0; i < 10'000; ++i) {
        const double value = std::ldexp(std::uniform_real_distribution(-1.0, 1.0)(random),
                                        std::uniform_int_distribution(-60, 60)(random));
        EXPECT_EQ(parse_double(format_number(value)), value);
        EXPECT_EQ(parse_double(plain_number(value)), value);
    }
}

TEST(Numbers, OnlyAWholeFiniteNumberIsAccepted) {
    EXPECT_EQ(parse_double("-.5"), -0.5);
    EXPECT_EQ(parse_double("1e-3"), 0.001);
    for (const char* text : {"", " 1", "1 ", "+1", "1,5", "1.5x", "0x10", "inf", "nan", "1e999", "--1"}) {
        EXPECT_EQ(parse_double(text), std::nullopt) << text;
    }
}

// ---- numbers in pasted text -----------------------------------------------------------------------------------------

using Doubles = std::vector<double>;

TEST(NumbersIn, ReadsAMatrixPastedFromAnyLanguage) {
    EXPECT_EQ(numbers_in("array([[ 1., -2e-3,  0. ],\n       [3.5, 4., -0.25]], dtype=float64)"),
              (Doubles{1, -0.002, 0, 3.5, 4, -0.25}));
    EXPECT_EQ(numbers_in("np.array([[1, 2], [3, 4]], dtype=np.float32)"), (Doubles{1, 2, 3, 4}));
    EXPECT_EQ(numbers_in("[1 2 -3; 4 5.5 6]"), (Doubles{1, 2, -3, 4, 5.5, 6}));
    EXPECT_EQ(numbers_in("1.0e+00  -2.5E-01\r\n\t3"), (Doubles{1, -0.25, 3}));
    EXPECT_EQ(numbers_in("\\begin{pmatrix} 1 & -2 \\\\ 1/3 & .5 \\end{pmatrix}"), (Doubles{1, -2, 1.0 / 3.0, 0.5}));
    EXPECT_EQ(numbers_in("GLfloat m[] = {1.0f, -0.5f, 3.f, .25F, 7u};"), (Doubles{1, -0.5, 3, 0.25, 7}));
    EXPECT_EQ(numbers_in("{{1, 0}, {0, -1}}"), (Doubles{1, 0, 0, -1}));
    EXPECT_EQ(numbers_in("(1,2,3)"), (Doubles{1, 2, 3}));
    EXPECT_EQ(numbers_in("1\t2\n3\n"), (Doubles{1, 2, 3}));
}

TEST(NumbersIn, AcceptsBothMinusSigns) {
    EXPECT_EQ(numbers_in("−3.5, −1/4, 1e−2"), (Doubles{-3.5, -0.25, 0.01})) << "U+2212 wherever a minus may be";
    EXPECT_EQ(numbers_in("-3.5 -1/4 1e-2 2E+1"), (Doubles{-3.5, -0.25, 0.01, 20}));
    EXPECT_EQ(numbers_in("+4"), Doubles{4});
}

TEST(NumbersIn, MinusBelongsToTheNextNumber) {
    EXPECT_EQ(numbers_in("- 2"), Doubles{-2});
    EXPECT_EQ(numbers_in("3 - 4"), (Doubles{3, -4}));
    EXPECT_EQ(numbers_in("3-4"), (Doubles{3, -4}));
    EXPECT_EQ(numbers_in("-, 5"), Doubles{5}) << "a lone dash";
    EXPECT_EQ(numbers_in("−\n5"), Doubles{5});
}

TEST(NumbersIn, IgnoresDigitsInWords) {
    EXPECT_EQ(numbers_in("float64"), Doubles{});
    EXPECT_EQ(numbers_in("x1 = 2"), Doubles{2});
    EXPECT_EQ(numbers_in("m_00: 3, v2.x: 4"), (Doubles{3, 4}));
    EXPECT_EQ(numbers_in("vec3(1, 2, 3)"), (Doubles{1, 2, 3}));
    EXPECT_EQ(numbers_in("그림자3 4"), (Doubles{3, 4})) << "only Latin words absorb digits";
    EXPECT_EQ(numbers_in("30° 5px"), (Doubles{30, 5}));
}

TEST(NumbersIn, IncompleteNumberReadsUpToTheBreak) {
    EXPECT_EQ(numbers_in("1e"), Doubles{1});
    EXPECT_EQ(numbers_in("1e+"), Doubles{1});
    EXPECT_EQ(numbers_in("1."), Doubles{1});
    EXPECT_EQ(numbers_in("1.2.3"), (Doubles{1.2, 0.3})) << "two numbers";
    EXPECT_EQ(numbers_in("."), Doubles{});
    EXPECT_EQ(numbers_in("-"), Doubles{});
    EXPECT_EQ(numbers_in("1/"), Doubles{1});
    EXPECT_EQ(numbers_in(""), Doubles{});
    EXPECT_EQ(numbers_in("nothing at all"), Doubles{});
    EXPECT_EQ(numbers_in(std::string_view("1\0002", 4)), (Doubles{1, 2}));
}

TEST(NumbersIn, AreAllFinite) {
    for (const char* const text :
         {"1e999", "-1e999", "1/0", "0/0", "-5/0", "1e-999", "1e308/1e-308", "inf nan Infinity"})
        for (const double number : numbers_in(text)) EXPECT_TRUE(std::isfinite(number)) << text;
}

TEST(NumbersIn, StopsAtItsLimit) {
    std::string text;
    for (int i = 0; i < 10'000; ++i) text += std::to_string(i) + " ";
    const Doubles numbers = numbers_in(text);
    ASSERT_EQ(numbers.size(), 1000U);
    for (std::size_t i = 0; i < numbers.size(); ++i) EXPECT_EQ(numbers[i], static_cast<double>(i));
    EXPECT_EQ(numbers_in(std::string(1'000'000, '-') + "1"), Doubles{-1});
    EXPECT_EQ(numbers_in(std::string(1'000'000, 'x')).size(), 0U);
}

TEST(NumbersIn, ProgramOutputReadsBack) {
    std::mt19937_64 random(11);
    std::string plain, code;
    Doubles values;
    for (int i = 0; i < 1000; ++i) {
        values.push_back(std::ldexp(std::uniform_real_distribution(-1.0, 1.0)(random),
                                    std::uniform_int_distribution(-60, 60)(random)));
        plain += format_number(values.back()) + ", ";
        code += shortest_number(values.back()) + " ";
    }
    EXPECT_EQ(numbers_in(plain), values);
    EXPECT_EQ(numbers_in(code), values);
}

}  // namespace
}  // namespace viewing
