// The texts of the pixel view and the cell view, without drawing them: the outcome of each test in words, the numbers
// in cells, and the steps.
#include "topics/depth/numbers/fragment_text.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>
#include <set>

#include "state/compare_func.h"
#include "topics/depth/shown/cell_text.h"
#include "topics/depth/shown/draw_steps.h"
#include "topics/depth/shown/pixel_numbers.h"

namespace viewing {
namespace {

constexpr DepthPrecision bits_8{8, false}, bits_24{24, false}, float_32{32, true};

std::uint32_t bits_of(float value) {
    return std::bit_cast<std::uint32_t>(value);
}

/// Returns a fragment as FragmentFinder would make it. `with` is the code that it is compared with.
Fragment fragment(std::uint32_t stored, std::uint32_t with, CompareFunc func = CompareFunc::less) {
    Fragment made;
    made.object = "box";
    made.triangle = 2;
    made.stored = stored;
    made.compared_with = with;
    made.depth.func = func;
    made.tie = stored == with;
    made.passes = made.drawn = compare(func, stored, with);
    return made;
}

// ---- codes and comparisons ------------------------------------------------------------------------------

TEST(FragmentText, CodesAreReadable) {
    EXPECT_EQ(code_text(15'955'400, bits_24), "15,955,400");
    EXPECT_EQ(code_text(15, bits_8), "15");
    EXPECT_EQ(code_text(bits_of(0.5F), float_32), "0.500000000");
    EXPECT_EQ(bits_text(0x3f000000U), "0x3f000000");
}

TEST(FragmentText, SpellsOutTheCompare) {
    EXPECT_EQ(compare_text(CompareFunc::less, 15'955'400, 16'777'215, bits_24), "15,955,400 < 16,777,215");
    EXPECT_EQ(compare_text(CompareFunc::lequal, 9, 9, bits_8), "9 ≤ 9");
    EXPECT_EQ(compare_text(CompareFunc::equal, 9, 7, bits_8), "9 = 7");
    EXPECT_EQ(compare_text(CompareFunc::notequal, 9, 7, bits_8), "9 ≠ 7");
    EXPECT_EQ(compare_text(CompareFunc::gequal, 9, 7, bits_8), "9 ≥ 7");
    EXPECT_EQ(compare_text(CompareFunc::greater, bits_of(0.25F), bits_of(0.0F), float_32), "0.250 > 0.000");
    EXPECT_EQ(compare_text(CompareFunc::always, 9, 7, bits_8), "GL_ALWAYS");
    EXPECT_EQ(compare_text(CompareFunc::never, 9, 7, bits_8), "GL_NEVER");
}

TEST(FragmentText, FloatsLookEqualOnlyWhenTheyAreEqual) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> exponent(-40.0F, 0.0F);
    for (int i = 0; i < 2000; ++i) {
        const std::uint32_t a = bits_of(std::exp2(exponent(random))), b = a + static_cast<std::uint32_t>(random() % 3);
        const std::string text = compare_text(CompareFunc::less, a, b, float_32);
        const std::size_t middle = text.find(" < ");
        ASSERT_NE(middle, std::string::npos);
        EXPECT_EQ(text.substr(0, middle) == text.substr(middle + 3), a == b) << text;
    }
}

// ---- how the tests treat a fragment ------------------------------------------------------------------------

TEST(FragmentText, EveryTestHasASentence) {
    EXPECT_EQ(say(test_text(fragment(15'955'400, 16'777'215), bits_24).whole()), "15,955,400 < 16,777,215  passes");
    EXPECT_EQ(say(test_text(fragment(9, 7), bits_8).whole()), "9 < 7  fails");
    EXPECT_EQ(say(test_text(fragment(812, 812), bits_24).whole()), "812 < 812  tie: fails");
    EXPECT_EQ(say(test_text(fragment(812, 812, CompareFunc::lequal), bits_24).whole()), "812 ≤ 812  tie: passes");
    EXPECT_EQ(say(test_text(fragment(812, 812, CompareFunc::always), bits_24).whole()), "GL_ALWAYS  passes");
    EXPECT_EQ(say(test_text(fragment(8, 812, CompareFunc::never), bits_24).whole()), "GL_NEVER  fails");

    Fragment rounded = fragment(813, 812);
    rounded.decided_by_rounding = true;
    EXPECT_EQ(say(test_text(rounded, bits_24).whole()), "rounding decides  fails");
    EXPECT_EQ(say(decision_sentence(rounded, bits_24)),
              "box, triangle 3: GL's rounding decides here, so the pixel is unchanged.");
    rounded.passes = rounded.drawn = true;
    EXPECT_EQ(say(test_text(rounded, bits_24).whole()), "rounding decides  passes");

    Fragment other = fragment(8, 812);
    other.drawn = false;
    EXPECT_EQ(say(test_text(other, bits_24).whole()), "8 < 812  passes, no color");
    other = fragment(8, 812);
    other.stencil_fails = true;
    EXPECT_EQ(say(test_text(other, bits_24).whole()), "stencil fails");
    other.culled = true;
    EXPECT_EQ(say(test_text(other, bits_24).whole()), "culled");
    other = fragment(900, 812);
    other.depth.test = false;
    other.is_sent = false;
    EXPECT_EQ(say(test_text(other, bits_24).whole()), "not sent");
    other.is_sent = true;
    other.passes = other.drawn = true;
    EXPECT_EQ(say(test_text(other, bits_24).whole()), "depth test off  drawn");
}

TEST(FragmentText, TheLastDrawnFragmentIsVisible) {
    EXPECT_EQ(seen_fragment({}), -1);
    EXPECT_EQ(seen_fragment({fragment(9, 7)}), -1);
    EXPECT_EQ(seen_fragment({fragment(9, 15), fragment(5, 9), fragment(7, 5)}), 1);
}

std::string said_of(const std::optional<Fragment>& incoming, const BufferCell& before, const BufferCell& after,
                    const DepthPrecision& precision) {
    return say(cell_sentence(incoming, before, after, precision));
}

TEST(FragmentText, ACellsSentenceDescribesWhatHappensToIt) {
    BufferCell before, after;
    before.stored = 15;
    after.stored = 9;
    EXPECT_EQ(said_of(fragment(9, 15), before, after, bits_8),
              "box, triangle 3: 9 < 15, so color and depth are replaced.");
    EXPECT_EQ(said_of({}, before, before, bits_8), "This triangle does not cover the pixel.");
    EXPECT_EQ(said_of({}, before, after, bits_8), "This triangle changes color and depth.");
    before.stored = 7;
    EXPECT_EQ(said_of(fragment(9, 15), before, before, bits_8),
              "box, triangle 3: 9 < 7 is false, so the pixel is unchanged.")
        << "the code that was read back counts";
    before.stored = 9;
    EXPECT_EQ(said_of(fragment(9, 15), before, before, bits_8),
              "box, triangle 3: 9 < 9 is false (a tie), so the pixel is unchanged.");

    Fragment sent = fragment(9, 15);
    sent.depth.write = false;
    before.stored = 15;
    EXPECT_EQ(said_of(sent, before, before, bits_8),
              "box, triangle 3: 9 < 15, so the color is replaced; the mask keeps the depth.");
    sent = fragment(9, 15);
    sent.drawn = false;
    EXPECT_EQ(said_of(sent, before, after, bits_8),
              "box, triangle 3: 9 < 15, so the depth is replaced but the color is not.");
    sent = fragment(9, 15, CompareFunc::always);
    EXPECT_EQ(said_of(sent, before, after, bits_8), "box, triangle 3: GL_ALWAYS, so color and depth are replaced.");
    sent = fragment(9, 15, CompareFunc::never);
    EXPECT_EQ(said_of(sent, before, before, bits_8), "box, triangle 3: GL_NEVER, so the pixel is unchanged.");
    sent.stencil_fails = true;
    EXPECT_EQ(said_of(sent, before, before, bits_8),
              "box, triangle 3: the stencil test fails, so the pixel is unchanged.");
    sent.culled = true;
    sent.front_facing = false;
    EXPECT_EQ(said_of(sent, before, before, bits_8), "box, triangle 3 is culled: it is back-facing.");
    sent = fragment(20, 15);
    sent.depth.test = false;
    sent.passes = sent.drawn = true;
    EXPECT_EQ(said_of(sent, before, before, bits_8),
              "box, triangle 3: the depth test is off, so the color is replaced but the depth is not.");
}

TEST(FragmentText, ChangesInTheCellDecideTheSentence) {
    BufferCell before, other_code, other_color, other;
    before.stored = other_color.stored = 15;
    other_code.stored = other.stored = 14;
    other_color.color = other.color = {1, 2, 3};
    // According to the computation, the fragment fails, but the cell changes, so the code that is read back must have
    // passed.
    EXPECT_EQ(said_of(fragment(16, 15), before, other, bits_8),
              "box, triangle 3: 14 < 15, so color and depth are replaced.");
    EXPECT_EQ(said_of(fragment(16, 15), before, other_code, bits_8),
              "box, triangle 3: 14 < 15, so color and depth are replaced.");
    // According to the computation, the fragment passes, but nothing changes.
    EXPECT_EQ(said_of(fragment(13, 15), before, before, bits_8),
              "box, triangle 3: GL's rounding decides here, so the pixel is unchanged.");
    // The code stays the same, but the color changes.
    EXPECT_EQ(said_of(fragment(15, 15, CompareFunc::lequal), before, other_color, bits_8),
              "box, triangle 3: 15 ≤ 15, so color and depth are replaced.");
    EXPECT_EQ(said_of(fragment(15, 15), before, other_color, bits_8),
              "box, triangle 3: GL's rounding decides here, so color and depth are replaced.");
    // Without the depth mask there is no new code to read back.
    Fragment masked = fragment(16, 15);
    masked.depth.write = false;
    EXPECT_EQ(said_of(masked, before, other_color, bits_8),
              "box, triangle 3: GL's rounding decides here, so the color is replaced; the mask keeps the depth.");
    // A fragment that cannot have changed the cell is not mentioned.
    EXPECT_EQ(said_of(masked, before, other, bits_8), "This triangle changes color and depth.");
    Fragment culled = fragment(14, 15);
    culled.culled = true;
    EXPECT_EQ(said_of(culled, before, other_color, bits_8), "This triangle changes the color but not the depth.");
    EXPECT_NE(said_of(culled, before, before, bits_8).find("is culled"), std::string::npos);
    Fragment untested = fragment(14, 15);
    untested.depth.test = untested.passes = untested.drawn = false;
    EXPECT_EQ(said_of(untested, before, other_color, bits_8), "This triangle changes the color but not the depth.");
}

// ---- numbers in cells -------------------------------------------------------------------------------------

CellBlock block_of(const std::vector<double>& depths, const DepthPrecision& precision) {
    CellBlock block{{10, 20}, {static_cast<int>(depths.size()), 1}, {}};
    for (const double depth : depths) {
        BufferCell cell;
        const double greatest = std::exp2(precision.bits) - 1.0;
        cell.stored = precision.is_float ? bits_of(static_cast<float>(depth))
                                         : static_cast<std::uint32_t>(std::llround(depth * greatest));
        cell.window_depth = precision.is_float ? static_cast<float>(depth) : cell.stored / greatest;
        block.cells.push_back(cell);
    }
    return block;
}

TEST(CellText, SmallFormatsShowTheirCodes) {
    const CellTexts cells = cell_texts(block_of({0.0, 0.2, 1.0}, {4, false}), {4, false}, 1.0, 4);
    EXPECT_EQ(cells.texts, (std::vector<std::string>{"0", "3", "15"}));
    EXPECT_EQ(cells.note, "stored code, 0 … 15");
    EXPECT_EQ(cell_texts(block_of({0.5}, {16, false}), {16, false}, 1.0, 5).texts[0], "32768");
}

TEST(CellText, WindowDepthsGetAsManyDecimalsAsTheyNeed) {
    EXPECT_EQ(cell_texts(block_of({0.25, 0.5, 1.0}, bits_24), bits_24, 1.0, 5).texts,
              (std::vector<std::string>{"0.25", "0.50", "1.00"}));
    EXPECT_EQ(cell_texts(block_of({0.25, 0.251, 1.0}, bits_24), bits_24, 1.0, 5).texts,
              (std::vector<std::string>{"0.250", "0.251", "1.000"}));
    EXPECT_EQ(cell_texts(block_of({0.25, 0.251}, bits_24), bits_24, 1.0, 5).note, "window depth");
}

TEST(CellText, NeighborsAreCountedFromTheSmallest) {
    const CellBlock block = block_of({0.5, 0.50001, 1.0}, bits_24);
    const CellTexts cells = cell_texts(block, bits_24, 1.0, 5);
    EXPECT_EQ(cells.texts, (std::vector<std::string>{"0", "167", "clear"}));
    EXPECT_EQ(cells.note, "code − 8,388,608");
}

TEST(CellText, EqualTextsMeanEqualCodesUnlessNoted) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    for (const DepthPrecision& precision : {bits_8, DepthPrecision{16, false}, bits_24, float_32})
        for (int i = 0; i < 300; ++i) {
            const double least = share(random), width = std::pow(10.0, -6.0 * share(random)) * (1.0 - least);
            std::vector<double> depths;
            for (int cell = 0; cell < 20; ++cell) depths.push_back(cell % 5 == 0 ? 1.0 : least + width * share(random));
            const CellBlock block = block_of(depths, precision);
            const int room = 4 + i % 6;
            const CellTexts cells = cell_texts(block, precision, 1.0, room);
            ASSERT_EQ(cells.texts.size(), depths.size());
            std::set<std::pair<std::string, std::uint32_t>> pairs;
            std::set<std::string> texts;
            for (std::size_t cell = 0; cell < depths.size(); ++cell) {
                pairs.emplace(cells.texts[cell], block.cells[cell].stored);
                texts.insert(cells.texts[cell]);
                if (cells.texts[cell] == "clear") continue;
                EXPECT_LE(cells.texts[cell].size(), static_cast<std::size_t>(room)) << cells.texts[cell];
            }
            if (cells.note == "window depth, rounded") continue;
            EXPECT_EQ(pairs.size(), texts.size()) << cells.note;
        }
}

TEST(CellText, AnEmptyBlockHasNoTexts) {
    EXPECT_TRUE(cell_texts({}, bits_24, 1.0, 5).texts.empty());
}

// ---- steps --------------------------------------------------------------------------------------------------

TEST(DrawSteps, AreTheTrianglesOneByOne) {
    const std::vector<DrawCall> calls = {{0, 0, 3}, {0, 1, 0}, {1, 0, 2}, {2, -1, 1}};
    ASSERT_EQ(step_count(calls), 6);
    std::vector<DrawLimit> expected = {{0, 0}};
    for (int call = 0; call < 4; ++call)
        for (int triangle = 1; triangle <= calls[static_cast<std::size_t>(call)].triangles; ++triangle)
            expected.push_back({call, triangle});
    for (int step = 0; step <= 6; ++step) {
        EXPECT_EQ(limit_of(step, calls), expected[static_cast<std::size_t>(step)]);
        EXPECT_EQ(step_of(limit_of(step, calls), calls), step);
        EXPECT_EQ(step_of(step_before(limit_of(step, calls), calls), calls), std::max(step - 1, 0));
    }
    EXPECT_EQ(limit_of(-1, calls), DrawLimit());
    EXPECT_EQ(limit_of(100, calls), (DrawLimit{3, 1}));
    EXPECT_EQ(step_of({}, calls), -1);
    EXPECT_EQ(step_of({2, -1}, calls), 5);
    EXPECT_EQ(step_of({2, 99}, calls), 5);
    EXPECT_EQ(step_of({99, 0}, calls), 6);
}

TEST(DrawSteps, SteppingByCallsReachesTheEndAndTheStart) {
    const std::vector<DrawCall> calls = {{0, 0, 3}, {1, 0, 2}};
    EXPECT_EQ(next_call({0, 0}, calls), (DrawLimit{0, -1}));
    EXPECT_EQ(next_call({0, 2}, calls), (DrawLimit{1, -1}));
    EXPECT_EQ(next_call({1, -1}, calls), DrawLimit());
    EXPECT_EQ(previous_call({}, calls), (DrawLimit{1, -1}));
    EXPECT_EQ(previous_call({1, 1}, calls), (DrawLimit{0, -1}));
    EXPECT_EQ(previous_call({0, -1}, calls), (DrawLimit{0, 0}));
    EXPECT_EQ(previous_call({}, {}), DrawLimit());
    EXPECT_EQ(next_call({}, {}), DrawLimit());
    EXPECT_EQ(limit_of(3, {}), DrawLimit());
}

// ---- the numbers of a pixel -----------------------------------------------------------------------------------

const PixelNumber& named(const std::vector<PixelNumber>& numbers, const std::string& name) {
    for (const PixelNumber& number : numbers)
        if (number.name == name) return number;
    throw std::runtime_error("no number " + name);
}

TEST(DrawSteps, NextAndPreviousFindTheNearestOnEitherSide) {
    const std::vector<DrawCall> calls = {{0, 0, 3}, {0, 1, 0}, {1, 0, 2}, {2, -1, 1}};
    const std::vector<DrawLimit> some = {{0, 2}, {2, 1}, {3, 1}};
    const std::vector<int> steps = {2, 4, 6};
    for (int step = 0; step <= 6; ++step) {
        std::optional<int> before, after;
        for (const int other : steps) {
            if (other < step) before = other;
            if (other > step && !after) after = other;
        }
        const auto step_or_none = [&](const std::optional<DrawLimit>& limit) {
            return limit ? std::optional(step_of(*limit, calls)) : std::nullopt;
        };
        EXPECT_EQ(step_or_none(previous_of(some, limit_of(step, calls), calls)), before) << step;
        EXPECT_EQ(step_or_none(next_of(some, limit_of(step, calls), calls)), after) << step;
    }
    EXPECT_EQ(previous_of(some, {}, calls), (DrawLimit{3, 1})) << "from the whole frame to its last step";
    EXPECT_FALSE(next_of(some, {}, calls));
    EXPECT_FALSE(next_of({}, {0, 0}, calls));
}

TEST(PixelNumbers, KeepTheirPlacesWithAndWithoutASign) {
    PixelReport pixel;
    pixel.written = pixel.has_depth = true;
    pixel.stored = 15'955'400;
    pixel.window_depth = 15'955'400 / 16'777'215.0;
    pixel.ndc_z = 2.0 * pixel.window_depth - 1.0;
    pixel.eye_z = -5.5;
    pixel.step = 1.511e-3;
    pixel.world = {1.0, -2.0, 0.25};
    const std::vector<PixelNumber> numbers = pixel_numbers(pixel, {}, {});
    EXPECT_EQ(named(numbers, "stored").value, " 15,955,400");
    EXPECT_EQ(named(numbers, "stored").unit, "of 2²⁴ − 1");
    EXPECT_EQ(named(numbers, "z_{window}").value, " 0.951016006");
    EXPECT_EQ(named(numbers, "z_{ndc}").value, " 0.902032012");
    EXPECT_EQ(named(numbers, "eye z").value, "−5.5000");
    EXPECT_EQ(named(numbers, "width Δz").value, " 0.00151");
    EXPECT_EQ(named(numbers, "stencil").value, " 0");
    EXPECT_EQ(named(numbers, "world").value, " 1.000  −2.000   0.250");
}

TEST(PixelNumbers, OmitUnknownNumbers) {
    PixelReport pixel;
    pixel.precision = float_32;
    pixel.stored = bits_of(1.0F);
    const std::vector<PixelNumber> numbers = pixel_numbers(pixel, {}, {});
    EXPECT_EQ(named(numbers, "stored").value, " 0x3f800000");
    for (const char* name : {"eye z", "width Δz", "world"}) EXPECT_EQ(named(numbers, name).value, " —");
    const auto complains = [&] {
        const std::string explanation = named(pixel_numbers(pixel, {}, {}), "eye z").explanation;
        return explanation.starts_with("The pixel's depth is the clear value.");
    };
    EXPECT_FALSE(complains());
    pixel.written = true;
    EXPECT_TRUE(complains());
    pixel.has_depth = true;
    EXPECT_FALSE(complains());
}

TEST(PixelNumbers, StepsHaveThreeDigits) {
    EXPECT_EQ(step_text(152.6), "153");
    EXPECT_EQ(step_text(1.524), "1.52");
    EXPECT_EQ(step_text(0.001511), "0.00151");
    EXPECT_EQ(step_text(8.583e-6), "8.58·10⁻⁶");
    EXPECT_EQ(step_text(0.0), "0.00");
}

}  // namespace
}  // namespace viewing
