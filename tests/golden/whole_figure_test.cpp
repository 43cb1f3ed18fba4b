// Checks every view as a figure against a frame's own vertices and pixels: each letter of the frame is in the drawing,
// in its SVG document and on its PDF page, and when Poppler draws the page, it has the picture's colors everywhere.
#include <cstdlib>
#include <map>
#include <sstream>

#include "app/resting_window.h"
#include "app/vector_figure.h"
#include "figure/faces.h"
#include "figure/write.h"
#include "golden/states.h"
#include "image/png.h"
#include "platform/file.h"
#include "ui/recorded_letters.h"

namespace viewing {
namespace {

namespace fs = std::filesystem;

struct Shown {
    PictureView view;
    const char* preset = "";
    std::vector<std::string> settings = {};
};

/// Lists every view once, and tables and the whole window also in other themes and in Korean.
const std::vector<Shown>& shown_views() {
    static const std::vector<Shown> all = {
        {PictureView::window},
        {PictureView::camera},
        {PictureView::depth},
        {PictureView::stencil},
        {PictureView::observer},
        {PictureView::matrices},
        {PictureView::derivation},
        {PictureView::shadow_derivation},
        {PictureView::mirror_derivation, "mirror-derivation"},
        {PictureView::tree, "bsp-walk"},
        {PictureView::order, "newell-two-cuts"},
        {PictureView::precision},
        {PictureView::codes},
        {PictureView::histogram},
        {PictureView::cells, "depth-cells"},
        {PictureView::pixel, "depth-cells"},
        {PictureView::fighting, "fighting-16-bit"},
        {PictureView::passes, "passes"},
        {PictureView::moving_world},
        {PictureView::clip},
        {PictureView::way},
        {PictureView::from_light, "from-light"},
        {PictureView::mirror_ways, "mirror-ways"},
        {PictureView::lecture_code, "lecture-code"},
        {PictureView::display_code},
        {PictureView::why, "", {"view.pin={\"at\":[0.5,0.6]}"}},
        {PictureView::window, "depth-cells", {"ui.theme=light"}},
        {PictureView::window, "newell-cycle", {"ui.language=ko"}},
        {PictureView::window, "fighting-16-bit", {"ui.theme=projector"}},
        {PictureView::order, "z-buffer-small", {"ui.theme=light"}},
        {PictureView::pixel, "depth-cells", {"ui.theme=light", "ui.language=ko"}},
        {PictureView::fighting, "fighting-16-bit", {"ui.theme=projector"}},
        {PictureView::matrices, "", {"ui.language=ko"}},
    };
    return all;
}

std::map<char32_t, int> letters_in(const std::string& text) {
    std::map<char32_t, int> counts;
    for (std::size_t at = 0; at < text.size();) {
        const auto first = static_cast<unsigned char>(text[at]);
        const std::size_t size = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
        char32_t character = size == 1 ? first : first & (0xFFU >> (size + 1));
        for (std::size_t i = 1; i < size && at + i < text.size(); ++i)
            character = character << 6U | (static_cast<unsigned char>(text[at + i]) & 0x3FU);
        at += size;
        if (character > U' ') ++counts[character];
    }
    return counts;
}

/// The side of the squares whose mean colors are compared, about the size of a digit. Single pixels differ because each
/// program antialiases in its own way.
constexpr int side_px = 8;

struct Place {
    int x = 0, y = 0;
    double difference = 0.0;  ///< in the channel that differs most, in levels from 0 to 255
};

Place worst_place(const Image& a, const Image& b) {
    Place worst;
    for (int y = 0; y + side_px <= a.height; y += side_px)
        for (int x = 0; x + side_px <= a.width; x += side_px)
            for (int channel = 0; channel < 3; ++channel) {
                int sum = 0;
                for (int row = y; row < y + side_px; ++row)
                    for (int column = x; column < x + side_px; ++column) {
                        const std::ptrdiff_t at = 4 * column + channel;
                        sum += a.row(row)[at] - b.row(row)[at];
                    }
                const double difference = std::abs(sum) / static_cast<double>(side_px * side_px);
                if (difference > worst.difference) worst = {x, y, difference};
            }
    return worst;
}

class WholeFigureSlowTest : public testing::PictureTest, public ::testing::WithParamInterface<std::size_t> {
protected:
    WholeFigureSlowTest() { fs::create_directories(folder_); }
    ~WholeFigureSlowTest() override { fs::remove_all(folder_); }

    std::string file(const char* ending) const { return (folder_ / "figure").string() + ending; }

    static bool runs(const std::string& command) { return std::system((command + " 2>/dev/null").c_str()) == 0; }

    void expect_same_page(const Drawing& drawing, const Image& picture) const {
        if (!runs("command -v pdftoppm >/dev/null"))
            GTEST_SKIP() << "no Poppler; it is in Debian's package poppler-utils";
        ASSERT_TRUE(write_file(file(".pdf"), as_pdf(drawing, {})));
        ASSERT_TRUE(runs("pdftoppm -r 96 -png -singlefile " + file(".pdf") + " " + file("")));
        ASSERT_TRUE(runs("pdftotext -raw " + file(".pdf") + " " + file(".txt")));
        std::string written;
        for (const std::string& line : test::lines_in(drawing)) written += line;
        std::map<char32_t, int> lacking = letters_in(written);
        for (const auto& [character, count] : letters_in(all_bytes(file(".txt")))) lacking[character] -= count;
        for (const auto& [character, count] : lacking)
            EXPECT_LE(count, 0) << "the page lacks " << count << " of " << utf8(character);
        const Result<Image> page = read_png(file(".png"));
        ASSERT_TRUE(page) << page.error();
        ASSERT_EQ(page->width, picture.width);
        ASSERT_EQ(page->height, picture.height);
        const Place worst = worst_place(*page, picture);
        RecordProperty("worst", std::to_string(worst.difference));
        EXPECT_LT(worst.difference, 40.0) << "at (" << worst.x << ", " << worst.y << ")";
    }

private:
    fs::path folder_ = fs::path(::testing::TempDir()) / ("viewing-figure-" + std::to_string(std::rand()));
};

TEST_P(WholeFigureSlowTest, ContainsAllOfItsFrame) {
    const Shown& shown = shown_views()[GetParam()];
    const std::string name = picture_view_names[static_cast<std::size_t>(shown.view)];
    SCOPED_TRACE(name + " " + shown.preset);
    const PictureRequest request{shown.view, {1000, 640}, std::nullopt};
    LoadedState state = state_with(shown.settings, shown.preset);
    state.params = drawn_params(state.params, request);
    const Scene scene = scene_of(state);
    if (is_drawn_by_gl(request)) {
        const Result<Image> image = draw_picture(renderer(), state, scene, request);
        const Result<Drawing> drawing = draw_figure(renderer(), state, scene, request);
        ASSERT_TRUE(image && drawing);
        return expect_same_page(*drawing, *image);
    }
    RestingWindow window(renderer(), state, scene);
    const Status rests = window.rest(request);
    ASSERT_TRUE(rests) << rests.error();
    const Drawing drawing = window.record();
    test::expect_all_letters(drawing, name);
    expect_same_page(drawing, window.read());
}

TEST(WholeFigures, CoverEveryView) {
    for (std::size_t view = 0; view < picture_view_names.size(); ++view)
        EXPECT_TRUE(std::any_of(shown_views().begin(), shown_views().end(), [view](const Shown& shown) {
            return static_cast<std::size_t>(shown.view) == view;
        })) << picture_view_names[view];
}

INSTANTIATE_TEST_SUITE_P(Views, WholeFigureSlowTest, ::testing::Range(std::size_t{0}, shown_views().size()));

}  // namespace
}  // namespace viewing
