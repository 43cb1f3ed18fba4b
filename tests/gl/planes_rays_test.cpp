// Checks pictures of rooms with several planes and lights, and with mirrors seen in mirrors, against the oracle of
// ray_caster.h: which object or patch each pixel shows, which lights are missing on it, and which stencil values remain
// at the end.
#include "planes_room.h"
#include "render/buffer_read.h"

namespace viewing {
namespace {

using testing::Met;
using testing::OracleScene;
using testing::RayCaster;
using testing::Rgb;
using testing::Room;
using testing::Sight;

constexpr glm::ivec2 rays_px(96, 54);

/// The content of a pixel as one number: a solid (0 and up), the background, or a patch with its set of missing lights.
constexpr int shows_background = -1, undefined = -2, first_patch = 100;

int class_of_patch(int patch, unsigned missing) {
    return first_patch + 16 * patch + static_cast<int>(missing);
}

/// Patches and shadows get distinct flat colors: full blue, which no solid has, marks them; green encodes the missing
/// lights and red the patch.
glm::dvec3 color_of_patch(std::size_t patch, int missing) {
    return {(60.0 * static_cast<double>(patch) + 20.0) / 255.0, (16.0 * missing + 7.0) / 255.0, 1.0};
}

void paint_for_reading(FramePlan& frame) {
    for (Pass& pass : frame.passes) {
        const bool is_patch = pass.subject == Subject::patch && pass.shading != Shading::flat;
        const bool is_shadow = pass.subject == Subject::objects && pass.shading == Shading::flat;
        if (!(is_patch || is_shadow)) continue;
        const int missing = is_patch ? pass.stencil.reference >> 4 : 1 << pass.light;
        pass.color = glm::dvec4(color_of_patch(pass.plane, missing), pass.color.a);
        pass.shading = Shading::flat;
    }
}

int class_of(const Rgb& color, const Rgb& background) {
    if (color == background) return shows_background;
    if (color.b == 255) return class_of_patch(color.r / 60, static_cast<unsigned>(color.g / 16));
    if (color.r > color.g && color.g == color.b) return 0;
    if (color.g > color.r && color.r == color.b) return 1;
    return color.r == color.g && color.g > color.b ? 2 : undefined;
}

/// Returns the class that the oracle expects. Missing light is visible only on patches that are not mirrors. A painted
/// shadow also covers mirrors; if several lights are missing, the shadow of the last one is visible.
int class_of(const Sight& sight, ShadowStyle style) {
    const auto last_light = [](unsigned missing) {
        unsigned last = 0;
        for (unsigned bit = 1; bit <= missing; bit <<= 1)
            if (missing & bit) last = bit;
        return last;
    };
    if (style == ShadowStyle::blend)
        for (const Met& met : sight.met)
            if (met.missing != 0) return class_of_patch(met.patch, last_light(met.missing));
    if (sight.ends_in_background()) return shows_background;
    const Met& end = sight.met.back();
    return end.patch >= 0 ? class_of_patch(end.patch, end.missing) : end.solid;
}

struct Tally {
    int compared = 0, thin = 0, pinholes = 0, shadow = 0, stencils = 0, stencil_shadow = 0;
    int mirrored[5] = {};  ///< pixels by number of mirrors

    void add(const Tally& other) {
        compared += other.compared;
        thin += other.thin;
        pinholes += other.pinholes;
        shadow += other.shadow;
        stencils += other.stencils;
        stencil_shadow += other.stencil_shadow;
        for (int i = 0; i < 5; ++i) mirrored[i] += other.mirrored[i];
    }
    void print() const {
        std::printf(
            "%d pixels and %d stencil values; %d differed beside edges thinner than a pixel, %d were pinholes\n",
            compared, stencils, thin, pinholes);
        std::printf("%d pixels and %d stencil values in shadow; seen in 1, 2, 3, 4 mirrors: %d, %d, %d, %d\n", shadow,
                    stencil_shadow, mirrored[1], mirrored[2], mirrored[3], mirrored[4]);
    }
};

struct Difference {
    bool is_stencil = false;
    int x = 0, y = 0, expected = 0, found = 0;
};

std::string text_of(const std::vector<Difference>& differences) {
    if (differences.empty()) return "";
    const Difference& first = differences.front();
    return std::to_string(differences.size()) + " differ, the first at " + std::to_string(first.x) + "," +
           std::to_string(first.y) + (first.is_stencil ? ": the stencil is " : ": the colour means ") +
           std::to_string(first.found) + " in place of " + std::to_string(first.expected);
}

/// Returns whether the oracle finds a different class within a pixel of the center of (x, y). Samples more finely than
/// one ray per pixel.
template <typename ClassAt>
bool is_beside_edge(const ClassAt& class_at, int x, int y) {
    constexpr int steps = 12;
    const int here = class_at(x + 0.5, y + 0.5);
    for (int j = -steps; j <= steps; ++j)
        for (int i = -steps; i <= steps; ++i)
            if (class_at(x + 0.5 + static_cast<double>(i) / steps, y + 0.5 + static_cast<double>(j) / steps) != here)
                return true;
    return false;
}

/// Calls check(x, y, class) for each pixel that has the same class as all its neighbors.
template <typename ClassAt, typename Check>
void for_each_inner_pixel(const ClassAt& class_at, const Check& check) {
    std::vector<int> classes;
    for (int y = 0; y < rays_px.y; ++y)
        for (int x = 0; x < rays_px.x; ++x) classes.push_back(class_at(x + 0.5, y + 0.5));
    const auto at = [&](int x, int y) { return classes[static_cast<std::size_t>(y * rays_px.x + x)]; };
    for (int y = 1; y + 1 < rays_px.y; ++y) {
        for (int x = 1; x + 1 < rays_px.x; ++x) {
            bool is_edge = false;
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) is_edge = is_edge || at(x + dx, y + dy) != at(x, y);
            if (!is_edge) check(x, y, at(x, y));
        }
    }
}

class PlanesRays : public testing::GlTest {
protected:
    void compare(const Room& room) {
        const Derived derived = derive_for(room.params, room.scene, rays_px);
        OracleScene oracle = room.oracle;
        oracle.bounces = reflection_depth(room.params, derived);
        const RayCaster caster(oracle, room.camera);
        differences_.clear();
        pinholes_ = 0;
        read(room, rays_px);
        compare_colors(room, caster);
        compare_stencil(room, caster);
        if (!differences_.empty()) forget_pinholes(room);
    }

    Tally tally_;
    std::vector<Difference> differences_;  ///< in the most recently compared room
    int pinholes_ = 0;                     ///< in the same room

private:
    /// Draws the room so that its colors can be decoded.
    void read(const Room& room, glm::ivec2 picture_px) {
        FramePlan frame = plan(room.params, derive_for(room.params, room.scene, picture_px));
        background_ = {frame.background.r, frame.background.g, frame.background.b};
        paint_for_reading(frame);
        View view;
        image_ = draw(frame, room.scene, picture_px, renderer(), view);
        Result<BufferReader> reader = BufferReader::make(renderer().capabilities());
        ASSERT_TRUE(reader) << reader.error();
        stored_ = reader->stored(view, room.params.depth.format, {{0, 0}, picture_px});
    }

    int found_at(bool is_stencil, int x, int y) const {
        if (is_stencil) return stored_[static_cast<std::size_t>(y * image_.width + x)].stencil;
        return class_of(testing::rgb_at(image_, {x, y}), background_);
    }

    void compare_colors(const Room& room, const RayCaster& caster) {
        const auto sight_at = [&](double x, double y) { return caster.at(x, y, rays_px.x, rays_px.y); };
        const auto class_at = [&](double x, double y) { return class_of(sight_at(x, y), room.params.shadow.style); };
        for_each_inner_pixel(class_at, [&](int x, int y, int expected) {
            ++tally_.compared;
            tally_.shadow += expected >= first_patch && (expected - first_patch) % 16 != 0;
            ++tally_.mirrored[std::min<std::size_t>(sight_at(x + 0.5, y + 0.5).mirrors, 4)];
            note({false, x, y, expected, found_at(false, x, y)}, class_at);
        });
    }

    /// Compares each stencil value with the one that the nearest patch leaves, even where an object hides the patch.
    /// Painted shadows count lights in the stencil only with stencil_once.
    void compare_stencil(const Room& room, const RayCaster& caster) {
        const ShadowParams& shadow = room.params.shadow;
        const bool counts = shadow.stencil_once || shadow.style == ShadowStyle::missing_light;
        const auto value_at = [&](double x, double y) {
            const Met met = caster.patch_at(x, y, rays_px.x, rays_px.y);
            return met.patch + 1 + (counts ? static_cast<int>(met.missing) << 4 : 0);
        };
        for_each_inner_pixel(value_at, [&](int x, int y, int expected) {
            ++tally_.stencils;
            tally_.stencil_shadow += expected >> 4 != 0;
            note({true, x, y, expected, found_at(true, x, y)}, value_at);
        });
    }

    template <typename ClassAt>
    void note(const Difference& here, const ClassAt& class_at) {
        if (here.found == here.expected) return;
        if (is_beside_edge(class_at, here.x, here.y))
            ++tally_.thin;
        else
            differences_.push_back(here);
    }

    /// Drops the differences that are pinholes. A rasterizer may miss a point where it clips the two triangles of a
    /// square. Such a pinhole has no area and almost vanishes in a picture five times as large, while a real error
    /// covers all 25 pixels.
    void forget_pinholes(const Room& room) {
        constexpr int larger = 5, few = 2;
        read(room, larger * rays_px);
        const auto is_pinhole = [&](const Difference& here) {
            int wrong = 0;
            for (int y = larger * here.y; y < larger * (here.y + 1); ++y)
                for (int x = larger * here.x; x < larger * (here.x + 1); ++x)
                    wrong += found_at(here.is_stencil, x, y) != here.expected;
            return wrong <= few;
        };
        pinholes_ = static_cast<int>(std::erase_if(differences_, is_pinhole));
        tally_.pinholes += pinholes_;
    }

    Rgb background_{0};
    Image image_;
    std::vector<StoredPixel> stored_;
};

constexpr unsigned first_cast_room = 61000;

TEST_F(PlanesRays, AgreeInEveryRoom) {
    const unsigned count = testing::rooms(208);
    for (unsigned number = first_cast_room; number < first_cast_room + count; ++number) {
        SCOPED_TRACE("room " + std::to_string(number));
        compare(testing::room(number));
        EXPECT_EQ(text_of(differences_), "");
        EXPECT_LE(pinholes_, 1);
    }
    tally_.print();
    // Each kind of pixel must have occurred often enough for the comparison to mean something.
    const auto each = static_cast<int>(count);
    EXPECT_GT(tally_.compared, 3000 * each);
    EXPECT_GT(tally_.stencil_shadow, 100 * each);
    EXPECT_GT(tally_.shadow, 60 * each);
    EXPECT_GT(tally_.mirrored[1], 500 * each);
    EXPECT_GT(tally_.mirrored[2], 100 * each);
    EXPECT_GT(tally_.mirrored[3], 15 * each);
    EXPECT_LE(tally_.pinholes, 4 + tally_.compared / 200'000);
}

TEST_F(PlanesRays, RejectEveryBrokenTechnique) {
    for (const char* const broken :
         {"shadow.sign=none", "shadow.clip_casters=false", "shadow.own_stencil=false", "reflection.clip=none",
          "reflection.shadows=false", "reflection.mask_writes_depth=true", "reflection.after_objects=true",
          "reflection.side_of_eye=false", "reflection.printed_by_rows=true", "reflection.stencil=false"}) {
        bool is_noticed = false;
        for (unsigned number = first_cast_room; number < first_cast_room + 60 && !is_noticed; ++number) {
            Room room = testing::room(number);
            room.params = *apply_settings(room.params, std::vector<std::string>{broken});
            compare(room);
            is_noticed = std::ranges::any_of(differences_, [](const Difference& here) { return !here.is_stencil; });
        }
        EXPECT_TRUE(is_noticed) << broken;
    }
}

}  // namespace
}  // namespace viewing
