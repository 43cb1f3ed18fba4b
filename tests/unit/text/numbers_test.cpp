// Numbers as characters, each expected text written out by hand.
#include "text/numbers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

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

TEST(Numbers, FiguresAreSignificantDigitsWithoutZerosAtTheEnd) {
    EXPECT_EQ(figures(0.25), "0.25");
    EXPECT_EQ(figures(3456.0), "3500");
    EXPECT_EQ(figures(-0.5), "−0.5");
    EXPECT_EQ(figures(1.23e-7), "1.2·10⁻⁷");
    EXPECT_EQ(figures(9.99e5, 2), "1·10⁶");
    EXPECT_EQ(figures(-2e7, 3), "−2·10⁷");
    EXPECT_EQ(figures(0.0), "0");
    EXPECT_EQ(figures(-infinity), "−∞");
}

TEST(Numbers, OnlyNothingIsNoPercentAndOnlyAllAreAHundred) {
    EXPECT_EQ(percent(0.125), "12.5 %");
    EXPECT_EQ(percent(0.0), "0.0 %");
    EXPECT_EQ(percent(1.0), "100.0 %");
    EXPECT_EQ(percent(1e-7), "< 0.1 %");
    EXPECT_EQ(percent(1.0 - 1e-7), "> 99.9 %");
    EXPECT_EQ(percent(0.4951, 0), "50 %");
    EXPECT_EQ(percent(0.996, 0), "> 99 %");
    EXPECT_EQ(percent(0.00052, 2), "0.05 %");
}

TEST(Numbers, CountsAreInGroupsOfThree) {
    EXPECT_EQ(grouped_number(0), "0");
    EXPECT_EQ(grouped_number(999), "999");
    EXPECT_EQ(grouped_number(1000), "1,000");
    EXPECT_EQ(grouped_number(-123456), "-123,456");
    EXPECT_EQ(grouped_number(1234567), "1,234,567");
}

TEST(Numbers, RaisedDigits) {
    EXPECT_EQ(raised_text(24), "²⁴");
    EXPECT_EQ(raised_text(-5), "⁻⁵");
    EXPECT_EQ(raised_text(0), "⁰");
}

TEST(Numbers, CodeHasTheKeyboardsMinusAndAllItsDecimals) {
    EXPECT_EQ(plain_decimals(-0.5, 3), "-0.500");
    EXPECT_EQ(plain_decimals(2.0, 0), "2");
    EXPECT_EQ(plain_decimals(1e20, 1), "100000000000000000000.0");
}

TEST(Numbers, WhatIsWrittenExactlyReadsBackExactly) {
    std::mt19937_64 random(7);
    for (int i = 0; i < 10'000; ++i) {
        const double value = std::ldexp(std::uniform_real_distribution(-1.0, 1.0)(random),
                                        std::uniform_int_distribution(-60, 60)(random));
        EXPECT_EQ(parse_double(format_number(value)), value);
        EXPECT_EQ(parse_double(plain_number(value)), value);
    }
}

TEST(Numbers, OnlyAWholeFiniteNumberIsOne) {
    EXPECT_EQ(parse_double("-.5"), -0.5);
    EXPECT_EQ(parse_double("1e-3"), 0.001);
    for (const char* text : {"", " 1", "1 ", "+1", "1,5", "1.5x", "0x10", "inf", "nan", "1e999", "--1"}) {
        EXPECT_EQ(parse_double(text), std::nullopt) << text;
    }
}

}  // namespace
}  // namespace viewing
