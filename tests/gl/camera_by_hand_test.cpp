// Pictures that GL draws with V and P entered by hand: the explanation of a pixel predicts its color, and P V maps the
// inspected point to the pixel. If an entered matrix spoils the picture, a sentence says so, and its fix restores the
// correct picture.
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "gl/gl_test.h"
#include "platform/sanitized.h"
#include "render/probe.h"
#include "topics/why/numbers/why.h"

namespace viewing {
namespace {

using glm::dmat4;
using glm::dvec3;

constexpr glm::ivec2 entered_px(192, 120);

/// V and P entered by hand; either may be missing.
struct Entered {
    std::string what;
    CameraOverrides matrices;
    bool is_right = false;
};

std::vector<Entered> entered_in(const Derived& own) {
    const dmat4 &v = own.view_from_world, &p = own.clip_from_view, c = own.world_from_view;
    const dmat4 mirrored_z = glm::scale(dmat4(1.0), dvec3(1, 1, -1));
    dmat4 sheared = v, w_by_x = v, in_row = v, tilted = p;
    for (int column = 0; column < 4; ++column) sheared[column][0] += 0.3 * v[column][1];
    w_by_x[0][3] = 0.02;
    w_by_x[1][3] = 0.03;
    for (int axis = 0; axis < 3; ++axis) std::swap(in_row[axis][3], in_row[3][axis]);
    tilted[0][2] = 0.1;
    tilted[1][3] = 0.1;
    const dmat4 other = glm::lookAtRH(dvec3(4, 3, 7), dvec3(0, 0.5, 0), dvec3(0.2, 1, 0));
    const dmat4 zero_to_one = glm::perspectiveRH_ZO(0.9, own.aspect, 0.5, 40.0);
    const std::nullopt_t none = std::nullopt;
    return {{"another camera", {other, none}, true},
            {"V transposed", {glm::transpose(v), none}},
            {"C as V", {c, none}},
            {"V with its translation in the last row", {in_row, none}},
            {"V scaled", {glm::scale(dmat4(1.0), dvec3(1.5)) * v, none}},
            {"V left-handed", {mirrored_z * v, none}},
            {"V sheared", {sheared, none}},
            {"V changes w", {w_by_x, none}},
            {"another lens", {none, glm::perspectiveRH_NO(0.9, own.aspect, 0.3, 60.0)}, p[2][2] < 0.0},  // not reversed
            {"P up to a factor", {none, 0.5 * p}, true},
            {"P for 0 ... 1", {none, zero_to_one}},
            {"P transposed", {none, glm::transpose(p)}},
            {"P left-handed", {none, p * mirrored_z}},
            {"P tilted", {none, tilted}},
            {"P V as P", {none, p * v}},
            {"V scaled and P transposed", {glm::scale(dmat4(1.0), dvec3(0.7)) * v, glm::transpose(p)}}};
}

class EnteredCamera : public testing::GlTest {
protected:
    static Params state(const char* preset) {
        Params params = testing::preset_named(preset).params;
        params.view.samples = 0;
        params.view.shows = Shows::color;
        return params;
    }
    static constexpr const char* rooms[] = {"opening", "room", "fighting-reversed", "orthographic", "teapot"};

    /// Calls visit(what, params, derived, scene) for each entered matrix in each room.
    template <typename Visit>
    static void visit_all(const Visit& visit) {
        for (const char* const room : rooms) {
            const Scene scene = testing::preset_named(room).scene;
            Params params = state(room);
            const Derived own = derive_for(params, scene, entered_px);
            for (const Entered& entered : entered_in(own)) {
                params.camera_overrides = entered.matrices;
                const Viewport viewport = renderer().viewport(entered_px, params.depth.format);
                visit(room + (", " + entered.what), params, derive(params, scene, viewport), scene);
            }
        }
    }
};

TEST_F(EnteredCamera, ThePredictedColorsAreGLs) {
    std::mt19937 random(3905);
    int equal = 0, drawn = 0;
    visit_all([&](const std::string& what, const Params& params, const Derived& derived, const Scene& scene) {
        const FramePlan frame = plan(params, derived);
        const Image picture = draw(frame, scene, entered_px);
        const FragmentFinder finder(scene);
        for (int i = 0; i < (is_sanitized ? 6 : 40); ++i) {
            const glm::ivec2 pixel(static_cast<int>(random() % 190) + 1, static_cast<int>(random() % 118) + 1);
            const testing::Rgb read = testing::rgb_at(picture, pixel);
            bool is_edge = false;
            for (const glm::ivec2 beside : {glm::ivec2(1, 0), glm::ivec2(-1, 0), glm::ivec2(0, 1), glm::ivec2(0, -1)})
                is_edge = is_edge || testing::worst_channel(read, testing::rgb_at(picture, pixel + beside)) > 6;
            if (is_edge) continue;
            const Color color{static_cast<std::uint8_t>(read.r), static_cast<std::uint8_t>(read.g),
                              static_cast<std::uint8_t>(read.b)};
            const PixelChain chain = chain_as_rounded(frame, finder, pixel, entered_px, color);
            const std::optional<Color> predicted = predicted_color(frame, chain);
            if (!predicted) continue;
            ++equal;
            drawn += chain.touches.empty() ? 0 : 1;
            EXPECT_LE(testing::worst_channel(read, {predicted->r, predicted->g, predicted->b}), 2)
                << what << " (" << pixel.x << ", " << pixel.y << ")";
        }
    });
    EXPECT_GT(equal, is_sanitized ? 200 : 1500);
    EXPECT_GT(drawn, equal / 4);
}

TEST_F(EnteredCamera, AnInspectedPointIsTheOneThatPVSendsToThePixel) {
    std::mt19937 random(3906);
    int points = 0, without_distances = 0;
    visit_all([&](const std::string& what, const Params& params, const Derived& derived, const Scene& scene) {
        PixelProbe probe;
        ASSERT_TRUE(probe.prepare(renderer(), plan(params, derived), scene, derived, entered_px));
        for (int i = 0; i < 20; ++i) {
            const glm::ivec2 pixel(static_cast<int>(random() % 192), static_cast<int>(random() % 120));
            const PixelReport report = probe.at(pixel, scene);
            if (!report.has_depth || report.step > 1e-3) continue;
            ++points;
            without_distances += derived.has_distances ? 0 : 1;
            const glm::dvec4 view = derived.view_from_world * glm::dvec4(report.world, 1.0);
            const glm::dvec4 clip = derived.clip_from_view * view;
            const glm::dvec2 place = (glm::dvec2(clip) / clip.w * glm::dvec2(0.5, -0.5) + 0.5) * glm::dvec2(entered_px);
            EXPECT_NEAR(place.x, pixel.x + 0.5, 0.01) << what;
            EXPECT_NEAR(place.y, pixel.y + 0.5, 0.01) << what;
            EXPECT_NEAR(report.eye_z, view.z / view.w, 1e-6 + 1e-6 * std::abs(report.eye_z)) << what;
        }
    });
    EXPECT_GT(points, 300);
    EXPECT_GT(without_distances, 40);
}

TEST_F(EnteredCamera, AWrongMatrixThatChangesThePictureIsSaidAndItsFixGivesThePictureBack) {
    for (const char* const room : rooms) {
        const Scene scene = testing::preset_named(room).scene;
        const Params base = state(room);
        const Image right = draw(base, scene, entered_px);
        for (const Entered& entered : entered_in(derive_for(base, scene, entered_px))) {
            SCOPED_TRACE(std::string(room) + ", " + entered.what);
            Params params = base;
            params.camera_overrides = entered.matrices;
            const bool is_changed = testing::pixels_beyond(draw(params, scene, entered_px), right, 8) > 24;
            std::vector<std::string> fixes;
            for (const Problem& problem : problems_of(params, scene, entered_px))
                if (problem.kind == ProblemKind::wrong && problem.id.starts_with("by_hand"))
                    fixes.push_back(problem.fixed_by);
            if (is_changed || entered.is_right) {
                EXPECT_EQ(fixes.empty(), entered.is_right);
            }
            if (entered.is_right || entered.what == "P for 0 ... 1") continue;  // this P belongs to another lens
            Params fixed = *apply_settings(params, fixes);
            EXPECT_LE(testing::pixels_beyond(draw(fixed, scene, entered_px), right, 8), 4);
        }
    }
}

}  // namespace
}  // namespace viewing
