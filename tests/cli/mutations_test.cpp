// Compares pictures with hundreds of deliberately changed pictures, all of which the comparison must find different,
// and with the same pictures in other kinds of PNG files, all of which it must find equal.
#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <random>

#include "cli/mutations.h"
#include "cli/program.h"
#include "image/compare.h"
#include "image/png.h"

namespace cli_tests {
namespace {

using viewing::compare_images;
using viewing::Image;
using viewing::portable_options;
using Json = nlohmann::json;
using Words = std::vector<std::string>;

constexpr std::array presets{
    "opening",      "teapot",      "letters",           "curved", "cyclic-overlap", "parallel-light",
    "tilted-plane", "wall-mirror", "shadow-derivation", "room"};

struct Mutation {
    std::string kind;
    Image image;
};

/// Returns the average difference between two areas of the same size, in levels.
double distance(const Image& a, const Area& from, const Image& b, const Area& to) {
    double sum = 0.0;
    for (int y = 0; y < from.height; ++y)
        for (int i = 0; i < 4 * from.width; ++i)
            sum += std::abs(a.row(from.y + y)[4 * from.x + i] - b.row(to.y + y)[4 * to.x + i]);
    return sum / (4.0 * from.width * from.height);
}

/// Returns the number of levels by which the whole area can be darkened or brightened, whichever is larger, and whether
/// it can be brightened by more levels than it can be darkened.
std::pair<int, bool> room_in(const Image& image, const Area& area) {
    int low = 255, high = 0;
    for (int y = area.y; y < area.y + area.height; ++y)
        for (int x = area.x; x < area.x + area.width; ++x)
            for (int c = 0; c < 3; ++c) {
                low = std::min<int>(low, image.row(y)[4 * x + c]);
                high = std::max<int>(high, image.row(y)[4 * x + c]);
            }
    return {std::max(low, 255 - high), 255 - high > low};
}

/// Makes changes in memory. A seed determines their positions and amounts.
class Mutator {
public:
    Mutator(const Image& image, unsigned seed) : image_(image), random_(seed) {}

    std::vector<Mutation> of_each_kind() {
        return {{"a hole", hole()}, {"an edge moved", edge()},      {"a channel's offset", offset()},
                {"gamma", gamma()}, {"regions swapped", swapped()}, {"blended twice", blended()}};
    }

private:
    int from(int low, int high) { return low + static_cast<int>(random_() % static_cast<unsigned>(high - low + 1)); }
    Area area(int smallest, int largest) {
        const int width = from(smallest, largest), height = from(smallest, largest);
        return {from(0, image_.width - width), from(0, image_.height - height), width, height};
    }

    /// Changes at least 36 pixels by at least 8 levels.
    Image hole() {
        const Area where = area(6, 20);
        const double levels = (room_in(image_, where).second ? 1 : -1) * from(8, 60);
        return changed(image_, where, [levels](int, double level) { return level + levels; });
    }
    /// Moves an edge by at least two pixels. The edge is at least 40 levels high in at least half of the rows, if the
    /// picture has such an edge.
    Image edge() {
        for (;;) {
            const Area where = area(24, 40);
            int rows = 0;
            for (int y = where.y; y < where.y + where.height; ++y) {
                int most = 0;
                for (int x = where.x + 6; x + 8 < where.x + where.width; ++x)
                    most = std::max(most, std::abs(image_.row(y)[4 * (x + 1)] - image_.row(y)[4 * x]));
                rows += most >= 40;
            }
            if (2 * rows < where.height && ++misses_ < 20000) continue;
            Image moved = image_;
            for (int i = from(2, 4); i > 0; --i) moved = shifted(std::move(moved), where);
            return moved;
        }
    }
    Image offset() {
        const Area where = area(40, 160);
        const double levels = (room_in(image_, where).second ? 1 : -1) * from(3, 12);
        const int channel = from(0, 2);
        return changed(image_, where, [=](int c, double level) { return level + (c == channel ? levels : 0.0); });
    }
    Image gamma() { return with_gamma(image_, (from(0, 1) == 0 ? 1.0 : -1.0) * 0.01 * from(5, 30) + 1.0); }
    Image swapped() {
        for (;;) {
            const Area one = area(12, 30);
            const Area other{from(0, image_.width - one.width), from(0, image_.height - one.height), one.width,
                             one.height};
            if (distance(image_, one, image_, other) < 8.0) continue;
            Image result = image_;
            for (int y = 0; y < one.height; ++y)
                for (int i = 0; i < 4 * one.width; ++i) {
                    result.row(one.y + y)[4 * one.x + i] = image_.row(other.y + y)[4 * other.x + i];
                    result.row(other.y + y)[4 * other.x + i] = image_.row(one.y + y)[4 * one.x + i];
                }
            return result;
        }
    }
    /// Adds a shadow that removes half of the light, in a place that is bright enough.
    Image blended() {
        for (;;) {
            const Area where = area(8, 30);
            const Image dark = changed(image_, where, [](int, double level) { return level / 2.0; });
            if (distance(image_, where, dark, where) >= 6.0) return dark;
        }
    }

    const Image& image_;
    std::mt19937 random_;
    int misses_ = 0;
};

class MutationsSlowTest : public Program {
protected:
    Image drawn(const std::string& preset, const std::string& setting = "") const {
        Words words{"snapshot", preset, "--view", "camera", "--size", "320x180", "-o", "drawn.png"};
        if (!setting.empty()) words.insert(words.end(), {"--set", setting});
        expect(0, words);
        return *viewing::read_png(folder() / "drawn.png");
    }

    /// Returns pictures of other states: another yaw, no shadow, a missing object.
    std::vector<Mutation> drawn_otherwise(const std::string& preset) const {
        const Json state = expect(0, {"state", preset}).json();
        const auto yaw = [&](double more) {
            return "camera.yaw=" + std::to_string(state["camera"]["yaw"].get<double>() + more);
        };
        std::vector<Mutation> all{{"yaw", drawn(preset, yaw(0.5))},
                                  {"no shadow", drawn(preset, "shadow.enabled=false")}};
        Json scene = state["scene"];
        if (scene.is_string()) {
            std::ifstream file(std::string(std::getenv("VIEWING_SANDBOX_ASSETS")) + "/scenes/" +
                               scene.get<std::string>() + ".json");
            scene = Json::parse(file);
        }
        scene["objects"].erase(0);
        all.push_back({"a missing object", drawn(preset, "scene={\"objects\":" + scene["objects"].dump() + "}")});
        return all;
    }
};

TEST_F(MutationsSlowTest, AreAllFound) {
    constexpr unsigned seeds = 6;
    std::map<std::string, int> count;
    for (unsigned p = 0; p < presets.size(); ++p) {
        const Image image = drawn(presets[p]);
        std::vector<Mutation> mutations = drawn_otherwise(presets[p]);
        for (unsigned i = 0; i < seeds; ++i)
            for (Mutation& mutation : Mutator(image, 1000 * p + i).of_each_kind()) {
                mutation.kind += ", seed " + std::to_string(1000 * p + i);
                mutations.push_back(std::move(mutation));
            }
        for (const Mutation& mutation : mutations) {
            SCOPED_TRACE(std::string(presets[p]) + ": " + mutation.kind);
            if (mutation.image == image) continue;  // identical: this preset does not show the changed shadow
            ++count[mutation.kind.substr(0, mutation.kind.find(','))];
            const auto strict = compare_images(mutation.image, image);
            const auto portable = compare_images(mutation.image, image, portable_options);
            EXPECT_FALSE(strict.equal) << "strict: " << sentence(strict);
            EXPECT_FALSE(portable.equal) << "portable: " << sentence(portable);
        }
    }
    int all = 0;
    for (const auto& [kind, number] : count) {
        std::cout << number << " times " << kind << "\n";
        all += number;
    }
    std::cout << all << " mutations, seeds 1000 p + 0 ... " << seeds - 1 << " of preset p\n";
    EXPECT_GE(all, 300);
}

// ---- other kinds of PNG files --------------------------------------------------------------------------------------

struct Kind {
    int bits, color_type, interlace = PNG_INTERLACE_NONE, filter = PNG_ALL_FILTERS, compression = 6;
};

int channels_of(int color_type) {
    return color_type == PNG_COLOR_TYPE_RGB_ALPHA    ? 4
           : color_type == PNG_COLOR_TYPE_RGB        ? 3
           : color_type == PNG_COLOR_TYPE_GRAY_ALPHA ? 2
                                                     : 1;
}

/// Returns the pixels as stored in a file of this kind. With a palette these are indices, and `palette` receives the
/// colors.
std::vector<png_byte> raw_of(const Image& image, const Kind& kind, std::vector<png_color>& palette) {
    std::map<std::array<std::uint8_t, 3>, png_byte> index;
    std::vector<png_byte> raw;
    const int channels = channels_of(kind.color_type);
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        const std::uint8_t* const pixel = image.rgba.data() + i;
        if (kind.color_type == PNG_COLOR_TYPE_PALETTE) {
            const auto [found, is_new] =
                index.emplace(std::array{pixel[0], pixel[1], pixel[2]}, static_cast<png_byte>(palette.size()));
            if (is_new) palette.push_back({pixel[0], pixel[1], pixel[2]});
            raw.push_back(found->second);
            continue;
        }
        for (int c = 0; c < channels; ++c) {
            const bool is_alpha = channels % 2 == 0 && c == channels - 1;
            raw.insert(raw.end(), static_cast<std::size_t>(kind.bits / 8), is_alpha ? pixel[3] : pixel[c]);
        }
    }
    return raw;
}

void write_kind(const std::filesystem::path& path, const Image& image, const Kind& kind) {
    std::vector<png_color> palette;
    std::vector<png_byte> raw = raw_of(image, kind, palette);
    ASSERT_LE(palette.size(), 256U);
    std::vector<png_bytep> rows;
    const std::size_t row_bytes = raw.size() / static_cast<std::size_t>(image.height);
    for (int y = 0; y < image.height; ++y) rows.push_back(raw.data() + row_bytes * static_cast<std::size_t>(y));
    std::FILE* file = std::fopen(path.c_str(), "wb");
    ASSERT_NE(file, nullptr);
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, file);
    png_set_IHDR(png, info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height), kind.bits,
                 kind.color_type, kind.interlace, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, kind.filter);
    png_set_compression_level(png, kind.compression);
    if (!palette.empty()) png_set_PLTE(png, info, palette.data(), static_cast<int>(palette.size()));
    png_write_info(png, info);
    png_write_image(png, rows.data());
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    std::fclose(file);
}

/// Reduces the picture to gray, so that a gray file can store it. The next function reduces the picture to 5 levels per
/// channel, so that its colors fit in a palette.
Image grey(const Image& image) {
    Image result = image;
    for (std::size_t i = 0; i < result.rgba.size(); i += 4) result.rgba[i + 1] = result.rgba[i + 2] = result.rgba[i];
    return result;
}
Image of_few_colours(const Image& image) {
    return changed(image, all_of(image), [](int, double level) { return 63.0 * std::floor(level / 63.0); });
}

TEST_F(MutationsSlowTest, NoneIsFoundInAnotherKindOfFile) {
    const std::vector<Kind> coloured{{8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_FILTER_NONE, 0},
                                     {8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_FILTER_SUB, 1},
                                     {8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_FILTER_UP, 3},
                                     {8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_FILTER_AVG, 5},
                                     {8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_FILTER_PAETH, 9},
                                     {8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_ADAM7},
                                     {8, PNG_COLOR_TYPE_RGB_ALPHA},
                                     {16, PNG_COLOR_TYPE_RGB},
                                     {16, PNG_COLOR_TYPE_RGB_ALPHA, PNG_INTERLACE_ADAM7}};
    const std::vector<Kind> greys{
        {8, PNG_COLOR_TYPE_GRAY}, {16, PNG_COLOR_TYPE_GRAY}, {8, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_INTERLACE_ADAM7}};
    const std::vector<Kind> palettes{{8, PNG_COLOR_TYPE_PALETTE}, {8, PNG_COLOR_TYPE_PALETTE, PNG_INTERLACE_ADAM7}};
    int count = 0;
    for (const char* const preset : presets) {
        const Image image = drawn(preset);
        for (const auto& [picture, kinds] :
             {std::pair(image, coloured), {grey(image), greys}, {of_few_colours(image), palettes}})
            for (const Kind& kind : kinds) {
                SCOPED_TRACE(std::string(preset) + ", " + std::to_string(kind.bits) + " bits, color type " +
                             std::to_string(kind.color_type) + ", interlace " + std::to_string(kind.interlace));
                write_kind(folder() / "kind.png", picture, kind);
                const auto back = viewing::read_png(folder() / "kind.png");
                ASSERT_TRUE(back) << back.error();
                for (const auto& options : {viewing::CompareOptions{}, portable_options}) {
                    const auto report = compare_images(*back, picture, options);
                    EXPECT_TRUE(report.equal && report.different == 0) << sentence(report);
                }
                ++count;
            }
    }
    std::cout << count << " files of other kinds\n";
    EXPECT_GE(count, 100);
}

}  // namespace
}  // namespace cli_tests
