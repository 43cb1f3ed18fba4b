// Compares the computed fragments of a pixel with GL's buffers: the last drawn fragment equals the values read back.
// VIEWING_LONG_TESTS=N checks N times as many states.
#include <bit>
#include <cmath>
#include <cstdlib>
#include <map>

#include "gl_test.h"
#include "render/probe.h"
#include "topics/depth/numbers/fragments.h"
#include "topics/depth/numbers/reconcile.h"
#include "topics/hidden/numbers/hidden_views.h"
#include "unit/geometry/random.h"

namespace viewing {
namespace {

using testing::object;
using testing::params_with;
using testing::scene_named;
using testing::setting;
using testing::trials;

constexpr glm::ivec2 fragments_px(160, 90);

/// Returns how far GL's depth, before it is stored, may be from the exact one: 4.5 codes of 24 bits, or 12 ulps of a
/// float near 1.
double arithmetic(const DepthPrecision& precision) {
    return (precision.is_float ? 12.0 : 4.5) / 16777216.0;
}

std::int64_t code_of(double depth, const DepthPrecision& precision) {
    const double kept = std::clamp(depth, 0.0, 1.0);
    if (precision.is_float) return std::bit_cast<std::int32_t>(static_cast<float>(kept));
    return std::llround(kept * (std::exp2(precision.bits) - 1.0));
}

/// The range of codes to which a depth may round.
struct Codes {
    std::int64_t least, greatest;
};

bool in_known_order(const Codes& a, const Codes& b) {
    const bool is_one = a.least == a.greatest && b.least == b.greatest && a.least == b.least;
    return is_one || a.greatest < b.least || b.greatest < a.least;
}

/// Returns whether float32 errors cannot change the result of any comparison between two fragments or between a
/// fragment and the cleared value.
bool is_decided(const std::vector<Fragment>& fragments, double cleared, const DepthPrecision& precision) {
    const std::int64_t cleared_code = code_of(cleared, precision);
    std::vector<Codes> codes{{cleared_code, cleared_code}};
    const double off = arithmetic(precision);
    for (const Fragment& fragment : fragments) {
        const double depth = fragment.window_depth;
        const Codes mine{code_of(depth - off, precision), code_of(depth + off, precision)};
        for (const Codes& other : codes)
            if (!in_known_order(mine, other)) return false;
        codes.push_back(mine);
    }
    return true;
}

const Fragment* last_drawn(const std::vector<Fragment>& fragments) {
    const Fragment* last = nullptr;
    for (const Fragment& fragment : fragments)
        if (fragment.drawn) last = &fragment;
    return last;
}

std::string surfaces_of(const std::vector<Fragment>& fragments) {
    std::string names;
    for (const Fragment& fragment : fragments) names += fragment.object + (fragment.front_facing ? "+" : "-");
    return names;
}

std::string told(const std::vector<Fragment>& fragments) {
    std::string text;
    for (const Fragment& f : fragments)
        text += "\n  " + f.object + " " + std::to_string(f.eye_z) + " " + std::to_string(f.stored) +
                (f.front_facing ? " front" : " back") + (f.culled ? " culled" : "") + (f.passes ? " passes" : "") +
                (f.drawn ? " drawn" : "") + (f.tie ? " tie" : "");
    return text;
}

class Fragments : public testing::GlTest {
protected:
    struct Seen {
        int compared = 0, codes_compared = 0, at_edges = 0, undecided = 0;
        std::map<std::string, double> worst;  ///< difference between the computed and read-back depth, in codes
        std::map<std::string, double> used;   ///< the same difference as a fraction of the stated bound
    };

    /// Compares the object and code of the last drawn fragment with those read back, at random pixels of one state.
    static void compare(const Params& params, const Scene& scene, Random& random, int pixels, Seen& seen) {
        const Derived derived = derive_for(params, scene, fragments_px);
        HiddenPictures pictures;
        if (const auto question = hidden_question(params, derived, fragments_px)) {
            HiddenSurfaceSolver solver(scene);
            pictures = answer_hidden_question(solver, *question).pictures;
        }
        const FramePlan frame = plan(params, derived, pictures);
        PixelProbe probe;
        ASSERT_TRUE(probe.prepare(renderer(), frame, scene, derived, fragments_px));
        const FragmentFinder finder(scene);
        const DepthPrecision precision = precision_of(frame.depth_format);
        for (int trial = 0; trial < pixels; ++trial) {
            const glm::ivec2 pixel(random.number(0, fragments_px.x), random.number(0, fragments_px.y));
            const std::vector<Fragment> fragments = finder.at(frame, pixel, fragments_px);
            // GL rounds vertices to 1/256 of a pixel, so near an edge it may find other surfaces.
            const std::vector<std::vector<Fragment>> around = beside(finder, frame, pixel);
            if (std::ranges::any_of(around, [&](const auto& f) { return surfaces_of(f) != surfaces_of(fragments); })) {
                ++seen.at_edges;
                continue;
            }
            if (!is_decided(fragments, frame.clear_depth_value, precision)) {
                ++seen.undecided;
                continue;
            }
            ++seen.compared;
            const PixelReport report = probe.at(pixel, scene);
            const std::string what = "pixel " + std::to_string(pixel.x) + " " + std::to_string(pixel.y) + ", read " +
                                     report.object + " " + std::to_string(report.stored) + told(fragments);
            std::vector<Fragment> told_fragments = fragments;
            reconcile(told_fragments, report, frame.clears_depth());
            for (const Fragment& fragment : told_fragments)
                EXPECT_FALSE(!fragment.is_sent && fragment.decided_by_rounding);
            const Fragment* const last = last_drawn(fragments);
            EXPECT_EQ(report.object, last ? last->object : "") << what;
            if (!last) continue;
            EXPECT_EQ(report.front_facing, last->front_facing) << what;
            const DepthState& depth = frame.passes[last->pass].depth;
            if (!report.has_depth || !depth.test || !depth.write) continue;
            const double off = std::abs(static_cast<double>(report.stored) - last->stored);
            double& worst = seen.worst[std::to_string(precision.bits) + " bits, mapping " +
                                       std::to_string(static_cast<int>(frame.depth_mapping))];
            worst = std::max(worst, off);
            ++seen.codes_compared;
            double& used = seen.used[std::to_string(precision.bits) + " bits, mapping " +
                                     std::to_string(static_cast<int>(frame.depth_mapping)) +
                                     (frame.lens.orthographic ? ", orthographic" : ", perspective")];
            used = std::max(used, off / last->within);
            EXPECT_LE(off, last->within) << what;
        }
    }

    /// Returns the fragments 0.04 pixels from the center, on each of four sides.
    static std::vector<std::vector<Fragment>> beside(const FragmentFinder& finder, const FramePlan& frame,
                                                     glm::ivec2 pixel) {
        const glm::ivec2 center = pixel * finer + finer / 2;
        std::vector<std::vector<Fragment>> all;
        for (const glm::ivec2 step : {glm::ivec2(1, 0), glm::ivec2(-1, 0), glm::ivec2(0, 1), glm::ivec2(0, -1)})
            all.push_back(finder.at(frame, center + step, fragments_px * finer));
        return all;
    }
    static constexpr int finer = 25;

    static void tell(const Seen& seen) {
        for (const auto& [kind, value] : seen.worst) std::printf("%s: worst %g codes\n", kind.c_str(), value);
        for (const auto& [kind, value] : seen.used) std::printf("%s: %g of the stated bound\n", kind.c_str(), value);
        std::printf("%d pixels compared, %d of them by code; %d at edges and %d undecided left out\n", seen.compared,
                    seen.codes_compared, seen.at_edges, seen.undecided);
    }
};

/// Returns the opening scene with a decal in the plane of the patch.
Scene scene_with_decal() {
    Scene scene = scene_named("torus-and-boxes");
    SceneObject decal = object("decal", quad_mesh(), {1.2, 0.0, 1.6}, {1.3, 1.0, 0.9});
    decal.description.decal = true;
    scene.objects.push_back(decal);
    return scene;
}

TEST_F(Fragments, EndWithTheOneReadBack) {
    const Scene scene = scene_with_decal();
    Random random(seed);
    Seen seen;
    for (const char* const format : {"d4", "d8", "d12", "d16", "d24", "d32f"})
        for (const char* const mapping : {"standard", "reversed", "logarithmic"})
            for (int trial = 0; trial < trials(2); ++trial) {
                std::vector<std::string> settings{setting("depth.format", format), setting("depth.mapping", mapping),
                                                  "depth.offset.factor=-1", "depth.offset.units=-8"};
                if (random.number(0, 1) < 0.3) settings.push_back("projection.type=orthographic");
                if (random.number(0, 1) < 0.3) settings.push_back("cull.enabled=true");
                settings.push_back("camera.pitch=-24");
                settings.push_back("camera.yaw=" + std::to_string(random.number(10, 50)));
                settings.push_back("projection.near=" + std::to_string(random.number(0.1, 2.0)));
                std::string what = "seed " + std::to_string(seed);
                for (const std::string& text : settings) what += " " + text;
                SCOPED_TRACE(what);
                compare(params_with(settings), scene, random, 40, seen);
            }
    tell(seen);
    EXPECT_GT(seen.compared, 600);
    EXPECT_GT(seen.codes_compared, 600);
    EXPECT_LT(seen.at_edges, seen.compared / 4);
}

TEST_F(Fragments, EndWithTheOneReadBackThroughAWindowBesideTheAxis) {
    const Scene scene = scene_with_decal();
    Random random(seed + 1);
    Seen seen;
    for (const char* const mapping : {"standard", "reversed", "logarithmic"})
        for (const char* const window :
             {R"({"type": "frustum", "left": -0.3, "right": 0.1, "bottom": -0.2, "top": 0.3})",
              R"({"type": "orthographic_window", "left": -1, "right": 4, "bottom": -3, "top": 1})"}) {
            SCOPED_TRACE("seed " + std::to_string(seed + 1) + " " + mapping + " " + window);
            compare(params_with({setting("depth.mapping", mapping), setting("projection", window)}), scene, random, 40,
                    seen);
        }
    tell(seen);
    EXPECT_GT(seen.compared, 60);
}

TEST_F(Fragments, EndWithTheOneReadBackIfFarIsInfinite) {
    const Scene scene = scene_with_decal();
    Random random(seed + 2);
    Seen seen;
    for (const char* const format : {"d16", "d24", "d32f"})
        for (const char* const mapping : {"standard", "reversed"}) {
            SCOPED_TRACE("seed " + std::to_string(seed + 2) + " " + format + " " + mapping);
            compare(params_with({setting("depth.format", format), setting("depth.mapping", mapping),
                                 "projection.far=infinite"}),
                    scene, random, 40, seen);
        }
    tell(seen);
    EXPECT_GT(seen.compared, 60);
}

TEST_F(Fragments, StayWithinTheBoundsOfEveryFormatMappingAndLens) {
    // Triangles of all sizes and slopes, including slivers and nearly edge-on ones, in all 18 combinations of format,
    // mapping and lens.
    Random random(seed + 7);
    Seen seen;
    for (const char* const format : {"d16", "d24", "d32f"})
        for (const char* const mapping : {"standard", "reversed", "logarithmic"})
            for (const char* const type : {"perspective", "orthographic"})
                for (int trial = 0; trial < trials(4); ++trial) {
                    Scene scene = testing::scene_of({});
                    const double near = std::exp(random.number(std::log(0.01), std::log(2.0)));
                    const double far = near * std::exp(random.number(std::log(1.5), std::log(1e4)));
                    const double extent = std::min(far, 60.0);
                    for (int i = 0; i < 40; ++i) {
                        std::array<glm::dvec3, 3> corners;
                        const double z = -random.number(near, extent);
                        const double reach = 0.4 * extent * std::pow(random.number(0.05, 1.0), 2.0);
                        for (glm::dvec3& corner : corners)
                            corner = {random.number(-reach, reach), random.number(-reach, reach),
                                      z + random.number(-reach, reach)};
                        if (i % 3 == 0) corners[2] = corners[1] + 0.01 * (corners[2] - corners[1]);
                        scene.objects.push_back(object("t" + std::to_string(i), triangle_mesh(corners), {0, 0, 0}));
                    }
                    const Params params = params_with(
                        {setting("depth.format", format), setting("depth.mapping", mapping),
                         setting("projection.type", type), "projection.far=" + std::to_string(far),
                         "projection.near=" + std::to_string(near), "projection.height=" + std::to_string(0.7 * extent),
                         "camera.position=[0,0,0]", "camera.yaw=0", "camera.pitch=0", "shadow.enabled=false",
                         "reflection.enabled=false", "plane.equation=[0,1,0,1000]", "plane.extent=0.01"});
                    SCOPED_TRACE("seed " + std::to_string(seed) + " " + format + " " + mapping + " " + type + " near " +
                                 std::to_string(near) + " far " + std::to_string(far));
                    compare(params, testing::scene_of(scene.objects), random, 60, seen);
                }
    tell(seen);
    EXPECT_EQ(seen.used.size(), 18U);
    EXPECT_GT(seen.codes_compared, 1500);
}

TEST_F(Fragments, FollowEveryTest) {
    const Scene scene = scene_with_decal();
    Random random(seed + 1);
    Seen seen;
    const auto one_of = [&random](std::initializer_list<const char*> choices) {
        return *(choices.begin() + static_cast<std::ptrdiff_t>(random.number(0, static_cast<double>(choices.size()))));
    };
    for (const char* const func : {"never", "less", "equal", "lequal", "greater", "notequal", "gequal", "always"})
        for (int trial = 0; trial < trials(12); ++trial) {
            const std::vector<std::string> settings{
                setting("depth.func", func),
                setting("depth.format", one_of({"d5", "d16", "d24", "d32f"})),
                setting("depth.mapping", one_of({"standard", "reversed", "logarithmic"})),
                setting("depth.test", one_of({"true", "true", "true", "true", "false"})),
                setting("depth.write", one_of({"true", "true", "true", "false"})),
                setting("depth.clear", one_of({"true", "true", "true", "false"})),
                setting("depth.write_while_clearing", one_of({"true", "true", "true", "false"})),
                setting("depth.logarithm_per_vertex", one_of({"true", "false"})),
                setting("depth.decals", one_of({"offset", "equal", "stencil"})),
                setting("cull.enabled", one_of({"true", "false", "false"})),
                setting("cull.face", one_of({"back", "front", "front_and_back"})),
                setting("cull.front_face", one_of({"ccw", "cw"})),
                setting("reflection.enabled", one_of({"true", "false"})),
                setting("shadow.style", one_of({"blend", "missing_light"})),
                setting("visibility.method", one_of({"depth_buffer", "depth_buffer", "depth_buffer", "none"})),
                "camera.pitch=-24",
                "camera.yaw=" + std::to_string(random.number(20, 40))};
            std::string what = "seed " + std::to_string(seed + 1);
            for (const std::string& text : settings) what += " " + text;
            SCOPED_TRACE(what);
            compare(params_with(settings), scene, random, 20, seen);
        }
    tell(seen);
    EXPECT_GT(seen.compared, 600);
    EXPECT_GT(seen.codes_compared, 100);
}

TEST_F(Fragments, InASmallRasterComeFromTheSquaresCenters) {
    const Scene scene = scene_named("few-triangles");
    Random random(seed + 9);
    Seen seen;
    for (const char* const method : {"painter", "newell", "software_depth_buffer", "ray_cast"})
        for (const char* const raster : {"[13,9]", "[5,20]", "[40,7]"})
            compare(params_with({setting("visibility.method", method), setting("visibility.raster", raster),
                                 "depth.format=d24", "camera.position=[0.2,1.7,6]", "camera.yaw=3", "camera.pitch=0",
                                 "projection.near=3"}),
                    scene, random, 40, seen);
    tell(seen);
    EXPECT_GT(seen.compared, 300);
}

TEST_F(Fragments, HaveTheDepthOfAPerVertexLogarithm) {
    const Scene scene = scene_with_decal();
    Random random(seed + 3);
    Seen seen;
    for (const char* const format : {"d8", "d16", "d24", "d32f"})
        for (int trial = 0; trial < trials(6); ++trial) {
            std::vector<std::string> settings{setting("depth.format", format),
                                              "depth.mapping=logarithmic",
                                              "depth.logarithm_per_vertex=true",
                                              "depth.offset.factor=-1",
                                              "depth.offset.units=-8",
                                              "camera.pitch=-24",
                                              "camera.yaw=" + std::to_string(random.number(10, 50)),
                                              "projection.near=" + std::to_string(random.number(0.01, 2.0))};
            if (trial % 3 == 2) settings.push_back("projection.type=orthographic");
            std::string what = "seed " + std::to_string(seed + 3);
            for (const std::string& text : settings) what += " " + text;
            SCOPED_TRACE(what);
            compare(params_with(settings), scene, random, 40, seen);
        }
    tell(seen);
    EXPECT_GT(seen.compared, 500);
    EXPECT_GT(seen.codes_compared, 400);
}

TEST_F(Fragments, StopAtTheDrawCall) {
    const Scene scene = scene_with_decal();
    Random random(seed + 4);
    Seen seen;
    for (int trial = 0; trial < trials(40); ++trial) {
        // With four objects, the mirror mask, mirror image, patch, shadow and objects take up to 14 draw calls.
        const std::vector<std::string> settings{
            "view.call=" + std::to_string(static_cast<int>(random.number(0, 16))),
            "view.triangle=" + std::to_string(static_cast<int>(random.number(-1, 14))),
            trial % 3 == 0 ? "reflection.enabled=true" : "reflection.enabled=false",
            trial % 4 == 0 ? "depth.clear=false" : "depth.clear=true",
            trial % 5 == 0 ? "depth.decals=stencil" : "depth.decals=offset",
            "camera.pitch=-24",
            "camera.yaw=" + std::to_string(random.number(20, 40))};
        std::string what = "seed " + std::to_string(seed + 4);
        for (const std::string& text : settings) what += " " + text;
        SCOPED_TRACE(what);
        compare(params_with(settings), scene, random, 30, seen);
    }
    tell(seen);
    EXPECT_GT(seen.compared, 600);
}

TEST_F(Fragments, FollowTheOrderOfTheMethod) {
    Random random(seed + 2);
    Seen seen;
    for (const char* const method : {"painter", "newell", "bsp", "software_depth_buffer", "ray_cast"})
        for (const char* const name : {"torus-and-boxes", "cyclic-overlap", "interpenetrating"})
            for (const char* const culls : {"false", "true"}) {
                SCOPED_TRACE(std::string(method) + " " + name + ", culled: " + culls);
                const Params params = params_with({setting("visibility.method", method), setting("cull.enabled", culls),
                                                   "camera.pitch=-20", setting("reflection.enabled", culls)});
                compare(params, scene_named(name), random, 40, seen);
            }
    tell(seen);
    EXPECT_GT(seen.compared, 600);
}

}  // namespace
}  // namespace viewing
