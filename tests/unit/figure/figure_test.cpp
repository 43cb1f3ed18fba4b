// Drawings written as SVG and PDF, font subsets, and the removal of backgrounds.
#include <cstring>
#include <random>

#include "embedded/fonts.h"
#include "figure/faces.h"
#include "figure/write.h"
#include "image/figure_note.h"
#include "image/matte.h"
#include "platform/sanitized.h"

#include <gtest/gtest.h>
#include <unistd.h>

namespace viewing {
namespace {

constexpr DrawingBox page{{0.0F, 0.0F}, {200.0F, 100.0F}};

Line line(const std::u32string& characters, const char* face = "Inter-Regular.otf") {
    Line made{face, 12.0F, 50.0F, {}, characters, {200, 100, 50, 255}};
    for (std::size_t i = 0; i < characters.size(); ++i) made.lefts_px.push_back(10.0F + 7.0F * static_cast<float>(i));
    return made;
}

Drawing some_drawing() {
    Drawing drawing{page.max, {}};
    const Ring square{{10.0F, 10.0F}, {30.0F, 10.0F}, {30.0F, 30.0F}, {10.0F, 30.0F}};
    drawing.marks.push_back({page, Shape{{square}, {255, 0, 0, 128}}});
    drawing.marks.push_back({{{0.0F, 0.0F}, {20.0F, 20.0F}}, Shape{{square}, {0, 255, 0, 255}}});
    drawing.marks.push_back({page, Shade{{{40.0F, 10.0F}, {60.0F, 30.0F}}, true, {0, 0, 0, 255}, {255, 255, 255, 0}}});
    drawing.marks.push_back({page, line(U"S = <Π·L> & \"그림자\"")});
    const auto image = std::make_shared<const Image>(Image{2, 1, {255, 0, 0, 255, 0, 0, 255, 128}});
    drawing.marks.push_back(
        {page,
         Inset{image, {{0.0F, 0.0F}, {2.0F, 1.0F}}, {{100.0F, 10.0F}, {140.0F, 30.0F}}, {}, {255, 255, 255, 255}}});
    return drawing;
}

std::string text_of(const std::vector<std::uint8_t>& bytes) {
    return {bytes.begin(), bytes.end()};
}

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

TEST(Svg, ContainsEachMarkOnceInOrder) {
    const std::string svg = as_svg(some_drawing(), {96.0, "A <title>", ""});
    EXPECT_NE(svg.find("width=\"2.0833in\" height=\"1.0417in\" viewBox=\"0 0 200 100\""), std::string::npos) << svg;
    EXPECT_NE(svg.find("<title>A &lt;title&gt;</title>"), std::string::npos);
    EXPECT_EQ(count_of(svg, "<text"), 1U);
    EXPECT_NE(svg.find(">S = &lt;Π·L&gt; &amp; &quot;그림자&quot;</text>"), std::string::npos);
    EXPECT_EQ(count_of(svg, "<image"), 1U);
    EXPECT_EQ(count_of(svg, "<linearGradient"), 1U);
    const std::size_t red = svg.find("fill=\"#ff0000\" fill-opacity=\"0.5\""), green = svg.find("fill=\"#00ff00\"");
    ASSERT_NE(red, std::string::npos);
    ASSERT_NE(green, std::string::npos);
    EXPECT_LT(red, green);
    EXPECT_LT(green, svg.find("<text"));
    // Only the second square goes beyond its clip.
    EXPECT_EQ(count_of(svg, "clip-path=\"url(#clip"), 1U);
    EXPECT_EQ(svg.find("metadata"), std::string::npos);
}

TEST(Svg, AnInchHasTheGivenPixels) {
    EXPECT_NE(as_svg(some_drawing(), {100.0, "", ""}).find("width=\"2in\" height=\"1in\""), std::string::npos);
}

/// A large picture that is scaled down must end exactly at the edge of its box.
TEST(Svg, PicturesFillTheirBox) {
    const int width = 3000;
    const auto image = std::make_shared<const Image>(Image{width, 1, std::vector<std::uint8_t>(4 * width, 255)});
    Drawing drawing{page.max, {}};
    const DrawingBox box{{10.0F, 10.0F}, {110.0F, 11.0F}};
    drawing.marks.push_back({page, Inset{image, {{0.0F, 0.0F}, {width, 1.0F}}, box, {}, {255, 255, 255, 255}}});
    const std::string svg = as_svg(drawing, {});
    const std::size_t at = svg.find("matrix(");
    ASSERT_NE(at, std::string::npos);
    EXPECT_NEAR(10.0 + width * std::stod(svg.substr(at + 7)), 110.0, 0.01);
}

TEST(Pdf, IsOnePageOfTheDrawingsSizeWithoutADate) {
    const std::string pdf = text_of(as_pdf(some_drawing(), {72.0, "A title", ""}));
    EXPECT_EQ(pdf.substr(0, 5), "%PDF-");
    EXPECT_NE(pdf.find("/MediaBox [ 0 0 200 100 ]"), std::string::npos);
    EXPECT_EQ(pdf.find("CreationDate"), std::string::npos);
    EXPECT_NE(pdf.find("Inter-Regular"), std::string::npos);
}

TEST(Vectors, TheSameDrawingGivesTheSameBytes) {
    const VectorOptions options{96.0, "title", "{}"};
    EXPECT_EQ(as_svg(some_drawing(), options), as_svg(some_drawing(), options));
    EXPECT_EQ(as_pdf(some_drawing(), options), as_pdf(some_drawing(), options));
    EXPECT_FALSE(as_svg({{10.0F, 10.0F}, {}}, {}).empty());
    EXPECT_FALSE(as_pdf({{10.0F, 10.0F}, {}}, {}).empty());
}

class Notes : public ::testing::Test {
protected:
    std::string read(const char* name, const std::string& document) const {
        const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) /
                                           (std::to_string(getpid()) + name);  // tests may run side by side
        std::FILE* out = std::fopen(file.c_str(), "wb");
        std::fwrite(document.data(), 1, document.size(), out);
        std::fclose(out);
        const Result<std::string> note = read_figure_note(file);
        EXPECT_TRUE(note) << note.error();
        std::filesystem::remove(file);
        return note ? *note : "";
    }
};

TEST_F(Notes, AreReadBackUnchanged) {
    std::mt19937 random(20261123);
    const std::vector<std::string> pieces = {"<", "&amp;", "]]>",         "\"",  "\\\"", "그림자",
                                             "(", ")",     "</metadata>", "a b", "7",    "é"};
    for (int round = 0; round < 50; ++round) {
        std::string note = "{\n  \"x\": \"";
        for (int i = 0; i < 40; ++i) note += pieces[random() % pieces.size()];
        note += "\"}";
        EXPECT_EQ(read("note.svg", as_svg(some_drawing(), {96.0, "t", note})), note);
        // The PDF omits line breaks between JSON tokens.
        std::string one_line = note;
        one_line.erase(1, 3);
        EXPECT_EQ(read("note.pdf", text_of(as_pdf(some_drawing(), {96.0, "t", note}))), one_line);
    }
}

/// libxml2 refuses an element with more than 10 million bytes of text.
TEST_F(Notes, LongOnesAreSplitIntoSeveralSvgElements) {
    for (const std::size_t size : {1'500'000U, is_sanitized ? 1U << 22U : 1U << 24U}) {
        std::string note;
        for (int i = 0; note.size() + 12 < size; ++i) note += "\"그<" + std::to_string(i) + "&";
        note += std::string(size - note.size(), '.');
        const std::string svg = as_svg(some_drawing(), {96.0, "t", note});
        EXPECT_TRUE(read("note.svg", svg) == note) << size;
        EXPECT_EQ(count_of(svg, "<metadata id=\"viewing-sandbox-state"), (size + 999'999U) / 1'000'000U);
        EXPECT_EQ(count_of(svg, "id=\"viewing-sandbox-state\""), 1U) << "an id names one element";
        EXPECT_TRUE(read("note.pdf", text_of(as_pdf(some_drawing(), {96.0, "t", note}))) == note) << size;
    }
    const std::string too_long((1U << 24U) + 1U, 'x');
    EXPECT_EQ(read("long.svg", as_svg(some_drawing(), {96.0, "t", too_long})), "");
    EXPECT_EQ(read("long.pdf", text_of(as_pdf(some_drawing(), {96.0, "t", too_long}))), "");
}

TEST_F(Notes, AreEmptyIfMissingOrBroken) {
    EXPECT_EQ(read("none.svg", as_svg(some_drawing(), {})), "");
    EXPECT_EQ(read("none.pdf", text_of(as_pdf(some_drawing(), {}))), "");
    EXPECT_EQ(read("cut.svg", "<svg><metadata id=\"viewing-sandbox-state\">{}"), "");
    EXPECT_EQ(read("cut.pdf", "viewing-sandbox-state-7"), "");
    EXPECT_EQ(read("empty.svg", ""), "");
    EXPECT_FALSE(read_figure_note("/nowhere/at/all.svg"));
    EXPECT_FALSE(read_figure_note("/dev/stdin/x.pdf"));
}

TEST(Faces, HaveOnlyTheDrawnCharactersAndAreSmall) {
    for (const char* name :
         {"Inter-Regular.otf", "JetBrainsMono-Regular.ttf", "DejaVuSans.ttf", "NanumBarunGothic.ttf"}) {
        const std::vector<std::uint8_t> whole = subset(embedded_font(name), {});
        const std::vector<std::uint8_t> few = subset(embedded_font(name), {U'S', U'7'});
        const std::vector<std::uint8_t> more = subset(embedded_font(name), {U'S', U'7', U'a', U'b', U'c', U'd'});
        EXPECT_LT(few.size(), 20'000U) << name;
        EXPECT_GT(few.size(), whole.size()) << name;
        EXPECT_GT(more.size(), few.size()) << name;
        // The font file's table directory lists no table that substitutes glyphs.
        const std::string tables(few.begin(), few.begin() + 400);
        EXPECT_EQ(tables.find("GSUB"), std::string::npos) << name;
        EXPECT_NE(tables.find("cmap"), std::string::npos) << name;
    }
    EXPECT_EQ(utf8(U'S') + utf8(U'é') + utf8(U'Π') + utf8(U'그') + utf8(U'𝄞'), "SéΠ그𝄞");
}

TEST(Backgrounds, AreRemovedUsingTwoPictures) {
    std::mt19937 random(7);
    for (int round = 0; round < 2000; ++round) {
        std::uint8_t ink[4], on_black[3], on_white[3], cut[4];
        for (std::uint8_t& channel : ink) channel = static_cast<std::uint8_t>(random() % 256);
        const double alpha = ink[3] / 255.0;
        for (int i = 0; i < 3; ++i) {
            on_black[i] = static_cast<std::uint8_t>(std::lround(ink[i] * alpha));
            on_white[i] = static_cast<std::uint8_t>(std::lround(ink[i] * alpha + 255.0 * (1.0 - alpha)));
        }
        remove_ground(on_black, on_white, cut);
        EXPECT_NEAR(cut[3], ink[3], 1);
        // On any background, the cut-out pixel looks like the original ink.
        for (int i = 0; i < 3; ++i) {
            const double ground = 90.0 * i, found = cut[3] / 255.0;
            EXPECT_NEAR(cut[i] * found + ground * (1.0 - found), ink[i] * alpha + ground * (1.0 - alpha), 2.0);
        }
    }
}

TEST(Backgrounds, AreRemovedFromDrawings) {
    const auto on = [](std::uint8_t ground) {
        Drawing drawing = some_drawing();
        const Ring whole{{0.0F, 0.0F}, {200.0F, 0.0F}, {200.0F, 100.0F}, {0.0F, 100.0F}};
        drawing.marks.insert(drawing.marks.begin(), {page, Shape{{whole}, {ground, ground, ground, 255}}});
        return drawing;
    };
    const Result<Drawing> cut = without_ground(on(0), on(255));
    ASSERT_TRUE(cut);
    EXPECT_EQ(as_svg(*cut, {}), as_svg(some_drawing(), {}));
    EXPECT_FALSE(without_ground(on(0), some_drawing()));
}

}  // namespace
}  // namespace viewing
