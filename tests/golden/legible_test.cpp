// Measures the stage in pixels: each letter of a lesson's steps is large enough, is really drawn, and contrasts with
// its background, and no large part of the picture is empty. Letters come from Dear ImGui's vertices
// (ui/letters.h), colors from the picture; neither depends on the layout code. VIEWING_LONG_TESTS=1 measures every
// step, asked and revealed, in every room, and prints the distributions.
#include <array>
#include <cctype>
#include <iostream>
#include <map>

#include "app/resting_window.h"
#include "gl/gl_test.h"
#include "lesson/lesson.h"
#include "state/presets.h"
#include "trials.h"
#include "ui/letters.h"
#include "ui/main_view.h"

namespace viewing {
namespace {

using test::Letter;

/// Relative luminance, as defined by WCAG 2.1, of an sRGB color with channels from 0 to 255.
double luminance(const glm::dvec3& color) {
    const auto linear = [](double value) {
        value /= 255.0;
        return value <= 0.03928 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(color.r) + 0.7152 * linear(color.g) + 0.0722 * linear(color.b);
}

/// The contrast ratio of WCAG 2.1: 1 for equal colors, 21 for black on white.
double contrast(const glm::dvec3& a, const glm::dvec3& b) {
    const double first = luminance(a), second = luminance(b);
    return (std::max(first, second) + 0.05) / (std::min(first, second) + 0.05);
}

struct Box {
    int left, top, right, bottom;  ///< pixels; right and bottom are outside
};

/// The part of a letter's ink that is on the screen.
Box box_of(const Letter& letter, const Image& image) {
    const auto inside = [](float value, int end) { return std::clamp(static_cast<int>(value), 0, end); };
    return {inside(std::max(letter.min.x, letter.clip.x), image.width),
            inside(std::max(letter.min.y, letter.clip.y), image.height),
            inside(std::ceil(std::min(letter.max.x, letter.clip.z)), image.width),
            inside(std::ceil(std::min(letter.max.y, letter.clip.w)), image.height)};
}

/// The color behind a letter: the most frequent one in the one-pixel frame around its ink.
glm::dvec3 ground_of(const Box& box, const Image& image) {
    std::map<std::array<int, 3>, int> counts;
    for (int y = std::max(box.top - 1, 0); y < std::min(box.bottom + 1, image.height); ++y)
        for (int x = std::max(box.left - 1, 0); x < std::min(box.right + 1, image.width); ++x) {
            if (x >= box.left && x < box.right && y >= box.top && y < box.bottom) continue;
            const testing::Rgb color = testing::rgb_at(image, {x, y});
            ++counts[{color.r, color.g, color.b}];
        }
    const auto most = std::max_element(counts.begin(), counts.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    return most == counts.end() ? glm::dvec3(0.0) : glm::dvec3(most->first[0], most->first[1], most->first[2]);
}

struct Legible {
    double contrast;  ///< of the letter's color, blended with its background by its opacity
    double drawn;     ///< how close the most inked pixel comes to that color: 0 (background) to 1
    double size;      ///< of the font, in window heights
};

std::optional<Legible> measured(const Letter& letter, const Image& image) {
    const Box box = box_of(letter, image);
    if (box.right - box.left < 2 || box.bottom - box.top < 3) return std::nullopt;
    const glm::dvec3 ground = ground_of(box, image);
    const ImU32 packed = letter.color;
    const glm::dvec3 color((packed >> IM_COL32_R_SHIFT) & 0xFFU, (packed >> IM_COL32_G_SHIFT) & 0xFFU,
                           (packed >> IM_COL32_B_SHIFT) & 0xFFU);
    const glm::dvec3 ink = glm::mix(ground, color, static_cast<double>(packed >> IM_COL32_A_SHIFT) / 255.0);
    const glm::dvec3 way = ink - ground;
    double drawn = 0.0;
    for (int y = box.top; y < box.bottom; ++y)
        for (int x = box.left; x < box.right; ++x)
            drawn = std::max(drawn, glm::dot(glm::dvec3(testing::rgb_at(image, {x, y})) - ground, way) /
                                        std::max(glm::dot(way, way), 1.0));
    return Legible{contrast(ink, ground), drawn, letter.line_height / static_cast<float>(image.height)};
}

/// The area of the largest rectangle without any mark, outside the given rectangles, relative to the area above
/// `bottom`.
double largest_empty_share(const Image& image, const std::vector<Rect>& outside, int bottom) {
    constexpr int cell = 8;
    const auto is_plain = [&](int left, int top) {
        const testing::Rgb first = testing::rgb_at(image, {left, top});
        for (int y = top; y < top + cell; ++y)
            for (int x = left; x < left + cell; ++x)
                if (testing::rgb_at(image, {x, y}) != first) return false;
        const ImVec2 middle(static_cast<float>(left + cell / 2), static_cast<float>(top + cell / 2));
        return std::none_of(outside.begin(), outside.end(), [&](const Rect& rect) { return rect.contains(middle); });
    };
    const int columns = image.width / cell, rows = bottom / cell;
    std::vector<int> heights(static_cast<std::size_t>(columns));  // plain cells upward from the current row
    int largest = 0;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            int& height = heights[static_cast<std::size_t>(column)];
            height = is_plain(column * cell, row * cell) ? height + 1 : 0;
        }
        for (int left = 0; left < columns; ++left) {
            int height = rows;
            for (int right = left; right < columns && height > 0; ++right) {
                height = std::min(height, heights[static_cast<std::size_t>(right)]);
                largest = std::max(largest, height * (right - left + 1));
            }
        }
    }
    return static_cast<double>(largest) / std::max(columns * rows, 1);
}

/// A hall: its projector, its theme and its language.
struct Hall {
    glm::ivec2 size_px;
    Theme theme;
    Language language;
};
const std::array<Hall, 4> halls = {{{{1920, 1080}, Theme::dark, Language::en},
                                    {{1024, 768}, Theme::dark, Language::ko},
                                    {{1280, 720}, Theme::projector, Language::ko},
                                    {{1024, 768}, Theme::projector, Language::en}}};

/// Measurements from one or more pictures.
struct Measured {
    std::vector<double> contrasts, sizes;         ///< one per letter; sizes in window heights
    std::vector<double> empty_parts, main_views;  ///< one per picture, relative to the area above the text
    std::vector<std::string> pale, missing;       ///< letters with too little contrast; letters that left no ink
    double least_size = 1.0;                      ///< of all letters
    std::string smallest;                         ///< the letter of that size
    std::string empty;                            ///< pictures with an empty part of more than a tenth, a line each
    std::string narrow;                           ///< pictures whose main view has less than its share, a line each

    void add(const Letter& letter, const std::string& where, const Image& image) {
        const bool is_word = letter.character >= 0x80 || std::isalnum(static_cast<int>(letter.character)) != 0;
        const bool is_disabled = (letter.color >> IM_COL32_A_SHIFT) <= 153U;  // disabled text may be pale, as in WCAG
        const bool is_scrolled_to = letter.pen.y + letter.line_height > letter.clip.w + 0.5F;  // fades at a list's edge
        if (is_scrolled_to) return;
        const std::optional<Legible> legible = measured(letter, image);
        if (!is_word || is_disabled || !legible) return;
        contrasts.push_back(legible->contrast);
        sizes.push_back(legible->size);
        const std::string what = where + ", \"" + test::utf8(letter.character) + "\" at " +
                                 std::to_string(static_cast<int>(letter.min.x)) + ", " +
                                 std::to_string(static_cast<int>(letter.min.y)) + ": ";
        if (legible->size < least_size) {
            least_size = legible->size;
            smallest = what + "1/" + std::to_string(1.0 / legible->size);
        }
        // A glyph thinner than a pixel never reaches its color.
        constexpr double least_contrast = 4.5, least_drawn = 0.3;
        if (legible->contrast < least_contrast) pale.push_back(what + std::to_string(legible->contrast));
        if (legible->drawn < least_drawn) missing.push_back(what + std::to_string(legible->drawn));
    }
};

/// Returns the value below which the fraction `share` of the values lies.
double quantile(std::vector<double> values, double share) {
    if (values.empty()) return 0.0;
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

class LegibleSlowTest : public testing::GlTest {
protected:
    /// Draws a step in a hall and adds its letters and areas to `all`.
    static void measure(Measured& all, const Lesson& lesson, std::size_t step, bool is_revealed, const Hall& hall) {
        LoadedState start = lesson.steps[step].start;
        start.params.ui.theme = hall.theme;
        start.params.ui.language = hall.language;
        const Result<Scene> scene = load_scene(start.params.scene, start.base, start.params.coplanar);
        ASSERT_TRUE(scene) << scene.error();
        PictureRequest request{.view = PictureView::window, .size_px = hall.size_px};
        request.lesson = std::make_shared<LessonPicture>(LessonPicture{lesson, step, is_revealed, true});
        RestingWindow window(renderer(), start, *scene);
        const Status rested = window.rest(request);
        ASSERT_TRUE(rested) << rested.error();
        const Image image = window.read();
        const std::string where = lesson.id + ", step " + std::to_string(step + 1) + (is_revealed ? ", revealed" : "") +
                                  ", " + std::to_string(hall.size_px.x) + "×" + std::to_string(hall.size_px.y);
        const test::Page page(ImGui::GetIO().Fonts->Fonts);
        const ImDrawData& data = *ImGui::GetDrawData();
        for (int i = 0; i < data.CmdListsCount; ++i)
            for (const Letter& letter : page.letters(*data.CmdLists[i])) all.add(letter, where, image);
        const Layout layout = window.layout();
        // A plate with "?" covers what the question is about, so its area does not count as empty.
        std::vector<Rect> full = test::main_view(layout);
        window.texts();
        for (const widgets::RecordedItem& item : widgets::CurrentContext().recorded)
            if (item.text == "?") full.push_back({item.min, item.max});
        const double empty = largest_empty_share(image, full, static_cast<int>(layout.strip.min.y));
        all.empty_parts.push_back(empty);
        constexpr double most_empty = 0.1;
        if (empty > most_empty) all.empty += "\n  " + where + ": " + std::to_string(empty);
        const double share = static_cast<double>(test::main_share(layout));
        const double least_share = hall.size_px.x * 3 > hall.size_px.y * 4 ? 0.5 : 0.4;
        if (share < least_share) all.narrow += "\n  " + where + ": " + std::to_string(share);
        all.main_views.push_back(share);
    }

    static void expect_legible(const Measured& all) {
        // Text fades where a list can scroll further, and a drawn frame may cross a letter.
        EXPECT_LE(all.pale.size(), all.contrasts.size() / 500) << all.pale.front();
        EXPECT_LE(all.missing.size(), all.contrasts.size() / 200) << all.missing.front();
        constexpr double least_size = 1.0 / 42.0, least_index = 0.77 / 41.0;
        EXPECT_GE(all.least_size, least_index) << "a letter is smaller than an index: " << all.smallest;
        EXPECT_GE(quantile(all.sizes, 0.01), least_size) << "letters other than indices are small";
    }
};

/// Measures every eleventh picture in each hall, so that every lesson is covered.
TEST_F(LegibleSlowTest, TypeOnStage) {
    const bool is_long = testing::is_long();
    const std::size_t stride = is_long ? 1 : 11 * halls.size();
    for (std::size_t h = 0; h < halls.size(); ++h) {
        Measured all;
        std::size_t picture = is_long ? 0 : 11 * h;
        for (const LessonFile& file : lessons()) {
            const Result<Lesson> lesson = load_lesson(file.path.string());
            ASSERT_TRUE(lesson) << lesson.error();
            for (std::size_t step = 0; step < lesson->steps.size(); ++step)
                for (const bool is_revealed : {false, true})
                    if (picture++ % stride == 0) measure(all, *lesson, step, is_revealed, halls[h]);
        }
        expect_legible(all);
        EXPECT_GE(all.empty_parts.size(), is_long ? 200U : 4U);
        if (is_long) {
            EXPECT_LE(quantile(all.empty_parts, 0.97), 0.1) << "much of the stage is empty:" << all.empty;
            EXPECT_LE(quantile(all.empty_parts, 1.0), 0.12) << "much of the stage is empty:" << all.empty;
            EXPECT_EQ(all.narrow, "") << "the main view is small";
        }
        for (const double share : {0.0, 0.01, 0.05, 0.5, 1.0})
            std::cout << halls[h].size_px.x << "×" << halls[h].size_px.y << ", quantile " << share << ": contrast "
                      << quantile(all.contrasts, share) << ", type 1/" << 1.0 / quantile(all.sizes, share)
                      << ", largest empty part " << quantile(all.empty_parts, share) << ", main view "
                      << quantile(all.main_views, share) << "\n";
        std::cout << "smallest letter: " << all.smallest << "\nmore than a tenth empty:" << all.empty
                  << "\nmain view too small:" << all.narrow << "\npale letters:";
        for (const std::string& letter : all.pale) std::cout << "\n  " << letter;
        std::cout << "\n";
    }
}

/// All text in the free window, subscripts included, uses one scale of five sizes, and no digit is below 9 pixels.
/// Measures every eighth preset, or all with VIEWING_LONG_TESTS.
TEST_F(LegibleSlowTest, TypeInTheWindow) {
    std::map<long, std::string> examples;  // by size in pixels
    const std::size_t stride = testing::is_long() ? 1 : 8;
    const std::vector<NamedFile> all_presets = presets();
    for (std::size_t i = 0; i < all_presets.size(); i += stride) {
        const NamedFile& preset = all_presets[i];
        if (preset.sets_looks) continue;
        const Result<LoadedState> state = load_state(preset.path.string());
        ASSERT_TRUE(state) << state.error();
        const Result<Scene> scene = load_scene(state->params.scene, state->base, state->params.coplanar);
        ASSERT_TRUE(scene) << scene.error();
        RestingWindow window(renderer(), *state, *scene);
        const Status rested = window.rest({.view = PictureView::window, .size_px = {1280, 720}});
        ASSERT_TRUE(rested) << rested.error();
        const test::Page page(ImGui::GetIO().Fonts->Fonts);
        const ImDrawData& data = *ImGui::GetDrawData();
        for (int list = 0; list < data.CmdListsCount; ++list)
            for (const Letter& letter : page.letters(*data.CmdLists[list]))
                examples.try_emplace(
                    std::lround(letter.line_height),
                    preset.name + ", \"" + test::utf8(letter.character) + "\" in " + data.CmdLists[list]->_OwnerName);
    }
    std::string all;
    for (const auto& [size_px, example] : examples) all += std::to_string(size_px) + " px: " + example + "\n";
    EXPECT_LE(examples.size(), 5U) << all;
    EXPECT_GE(examples.begin()->first, 9) << all;
}

}  // namespace
}  // namespace viewing
