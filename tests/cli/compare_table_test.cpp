// Redraws the pictures behind the table of comparisons in tests/README.md and compares them again. With
// VIEWING_COMPARE_TABLE=FOLDER, also keeps the pairs of pictures in that folder for other programs
// (tests/compare_table).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>

#include "cli/mutations.h"
#include "cli/program.h"
#include "image/compare.h"
#include "image/png.h"

namespace cli_tests {
namespace {

using viewing::CompareOptions;
using viewing::CompareReport;
using viewing::Image;
using Words = std::vector<std::string>;

struct Pair {
    std::string name;
    Image a, b;
};

class CompareTableSlowTest : public Program {
protected:
    /// Draws a camera view at 640 x 360 with 4 samples, unless `more` says otherwise.
    Image drawn(const Words& more) const {
        const auto says = [&more](const char* name) { return std::find(more.begin(), more.end(), name) != more.end(); };
        Words words{"snapshot", "--view", "camera", "-o", "drawn.png"};
        if (!says("--size")) words.insert(words.end(), {"--size", "640x360"});
        if (!says("--samples")) words.insert(words.end(), {"--samples", "4"});
        words.insert(words.end(), more.begin(), more.end());
        expect(0, words);
        return *viewing::read_png(folder() / "drawn.png");
    }

    std::vector<Pair> pairs() const {
        const Image opening = drawn({}), single = drawn({"--samples", "0"});
        const Image fine = resolved(drawn({"--size", "2560x1440", "--samples", "0"}), 4);
        const auto with = [this](const std::string& setting) { return drawn({"--set", setting}); };
        std::vector<Pair> all{{"noise ±2", noisy(opening, 2, 1), opening},
                              {"4 samples against none", opening, single},
                              {"16 samples against 4", fine, opening},
                              {"yaw +0.001°", with("camera.yaw=30.601"), opening}};
        // An area of 5 x 4 pixels in the middle of the shadow.
        const Area hole = inside_of_difference(opening, with("shadow.enabled=false"), 20, 5, 4, 6);
        EXPECT_NE(hole, Area());
        for (const int levels : {28, 6})
            all.push_back({"a hole of 20 pixels in the shadow, " + std::to_string(levels) + " levels",
                           changed(opening, hole, [levels](int, double level) { return level + levels; }), opening});
        all.push_back({"a shadow blended twice", drawn({"shadow-double-blend"}),
                       drawn({"shadow-double-blend", "--set", "shadow.stencil_once=true"})});
        const Image box =
            drawn({"--set", R"(scene={"objects":[{"name":"box","shape":"box","position":[0,1,0]}]})", "--set",
                   "camera.position=[0,1,5]", "--set", "camera.yaw=0", "--set", "camera.pitch=0"});
        const int edge = strongest_edge(box, 180);
        for (const int rows : {5, 20, 60})
            all.push_back({"an edge moved by a pixel over " + std::to_string(rows) + " rows",
                           shifted(box, {edge - 8, 180 - rows / 2, 16, rows}), box});
        all.push_back({"+2 in one channel of half the picture",
                       changed(opening, {0, 0, 320, 360}, [](int c, double level) { return level + (c == 0 ? 2 : 0); }),
                       opening});
        all.push_back({"gamma 1.02", with_gamma(opening, 1.02), opening});
        all.push_back({"reflectance .30 → .31", with("reflection.reflectance=0.31"), opening});
        all.push_back({"opacity .50 → .51", with("shadow.opacity=0.51"), opening});
        return all;
    }

    /// Returns the column after which red changes most in this row.
    static int strongest_edge(const Image& image, int y) {
        int best = 8, most = 0;
        for (int x = 8; x + 9 < image.width; ++x) {
            const int step = std::abs(image.row(y)[4 * (x + 1)] - image.row(y)[4 * x]);
            if (step > most) {
                most = step;
                best = x;
            }
        }
        return best;
    }
};

/// Returns "equal, 12" or "different, 12", where 12 is the number of counted pixels, or "different, shift 0.75" if only
/// the mean shifts.
std::string cell(const CompareReport& report) {
    const bool counts =
        report.beyond_share() > report.options.share ||
        (report.options.profile == viewing::CompareProfile::portable && report.largest_block > report.options.block_px);
    if (report.equal || counts) return (report.equal ? "equal, " : "different, ") + std::to_string(report.beyond);
    double largest = 0.0;
    for (const double shift : report.local_shift) largest = std::max(largest, std::abs(shift));
    std::ostringstream text;
    text << "different, shift " << std::round(100.0 * largest) / 100.0;
    return text.str();
}

/// Returns whether two verdicts agree and have the same reason. Their numbers may differ between processors.
bool agree(const std::string& published, const std::string& found) {
    const std::size_t number = published.find_last_of(' ') + 1;
    if (published.substr(0, number) != found.substr(0, found.find_last_of(' ') + 1)) return false;
    const double expected = std::strtod(published.c_str() + number, nullptr);
    const double actual = std::strtod(found.c_str() + found.find_last_of(' ') + 1, nullptr);
    return std::abs(actual - expected) <= 0.05 * expected + (published.find("shift") == std::string::npos ? 5.0 : 0.05);
}

TEST_F(CompareTableSlowTest, OfTheTestsReadmeHolds) {
    std::ifstream stream(std::string(std::getenv("TEST_SOURCE_DIR")) + "/README.md");
    const std::string readme{std::istreambuf_iterator<char>(stream), {}};
    const char* const kept = std::getenv("VIEWING_COMPARE_TABLE");
    std::ofstream rows;
    if (kept != nullptr) rows.open(std::string(kept) + "/rows.txt");
    int number = 0;
    for (const Pair& pair : pairs()) {
        const std::string strict = cell(viewing::compare_images(pair.a, pair.b));
        const std::string portable = cell(viewing::compare_images(pair.a, pair.b, viewing::portable_options));
        const std::string row = "| " + pair.name + " | " + strict + " | " + portable + " |";
        if (kept != nullptr) {
            const std::string name = std::string(kept) + "/" + std::to_string(number++);
            ASSERT_TRUE(viewing::write_png(name + "-a.png", pair.a));
            ASSERT_TRUE(viewing::write_png(name + "-b.png", pair.b));
            rows << row << "\n";
        }
        const std::size_t at = readme.find("| " + pair.name + " | ");
        if (at == std::string::npos) {
            ADD_FAILURE() << "the README has no such row: " << row;
            continue;
        }
        std::istringstream line(readme.substr(at, readme.find('\n', at) - at));
        Words cells;
        for (std::string each; std::getline(line, each, '|');)
            cells.push_back(each.size() > 2 ? each.substr(1, each.size() - 2) : "");
        ASSERT_GE(cells.size(), 4U);
        EXPECT_TRUE(agree(cells[2], strict)) << "strict: " << row;
        EXPECT_TRUE(agree(cells[3], portable)) << "portable: " << row;
    }
}

}  // namespace
}  // namespace cli_tests
