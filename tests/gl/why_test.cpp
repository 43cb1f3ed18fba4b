// The explanation of a pixel: the color that the chain predicts equals the one that GL draws, over presets and seeded
// states with mistakes; and wherever a fix of a preset changes the picture, the explanation names that fix.
// VIEWING_LONG_TESTS=N checks N times as many states.
#include <array>
#include <map>
#include <random>

#include "gl/gl_test.h"
#include "gl/planes_room.h"
#include "platform/sanitized.h"
#include "render/probe.h"
#include "state/presets.h"
#include "topics/hidden/measured/camera_picture.h"
#include "topics/hidden/numbers/hidden_views.h"
#include "topics/why/numbers/why.h"
#include "unit/state/random_params.h"

namespace viewing {
namespace {

constexpr glm::ivec2 why_px(192, 120);

class WhyThisPixel : public testing::GlTest {
protected:
    struct Seen {
        int equal = 0, unequal = 0, at_edges = 0, by_rounding = 0;
        std::map<std::string, int> kinds;
    };

    static FramePlan plan_of(const Params& params, const Derived& derived, const Scene& scene) {
        return plan(params, derived, solved(params, derived, scene));
    }

    /// Runs a hidden-surface method for a state that needs one.
    static HiddenPictures solved(const Params& params, const Derived& derived, const Scene& scene) {
        const auto question = hidden_question(params, derived, why_px);
        if (!question) return {};
        HiddenSurfaceSolver solver(scene);
        return answer_hidden_question(solver, *question).pictures;
    }

    /// Returns the pass, the object and the outcome of each fragment that touches a pixel. If a neighboring pixel's
    /// text is different, there is an edge between the two pixels.
    static std::string touches_of(const PixelChain& chain) {
        std::string text;
        for (const Touch& touch : chain.touches)
            text += std::to_string(touch.fragment.pass) + ":" + std::to_string(touch.fragment.object_index) +
                    (touch.fragment.passes ? "+ " : "- ");
        return text;
    }

    static void compare(const Params& state, const Scene& scene, std::mt19937& random, int pixels,
                        const std::string& what, Seen& seen) {
        Params params = state;
        params.view.samples = 0;
        const Derived derived = derive(params, scene, renderer().viewport(why_px, params.depth.format));
        const FramePlan frame = plan_of(params, derived, scene);
        const Image picture = draw(frame, scene, why_px);
        const FragmentFinder finder(scene);
        for (int i = 0; i < pixels; ++i) {
            const glm::ivec2 pixel(static_cast<int>(random() % why_px.x), static_cast<int>(random() % why_px.y));
            const testing::Rgb read = testing::rgb_at(picture, pixel);
            const PixelChain exact = pixel_chain(frame, finder, pixel, why_px);
            const PixelChain chain = chain_as_rounded(frame, finder, pixel, why_px, color_at(picture, pixel));
            const std::optional<Color> predicted = predicted_color(frame, chain),
                                       at_first = predicted_color(frame, exact);
            if (!predicted) continue;
            seen.by_rounding += *predicted == *at_first ? 0 : 1;
            const auto blends = std::count_if(chain.touches.begin(), chain.touches.end(), [&](const Touch& touch) {
                return touch.paints && frame.passes[touch.fragment.pass].blend == Blend::alpha;
            });
            // The driver rounds each blend to 8 bits in its own way.
            const int rounding = std::max(1, static_cast<int>(blends) / 3);
            if (testing::worst_channel(read, {predicted->r, predicted->g, predicted->b}) <= rounding) {
                ++seen.equal;
                continue;
            }
            bool at_edge = false;
            for (const glm::ivec2 beside : {glm::ivec2(1, 0), glm::ivec2(-1, 0), glm::ivec2(0, 1), glm::ivec2(0, -1)}) {
                const PixelChain there = pixel_chain(frame, finder, pixel + beside, why_px);
                // The floor's pattern has edges, too.
                const glm::ivec3 step(there.color.r - chain.color.r, there.color.g - chain.color.g,
                                      there.color.b - chain.color.b);
                at_edge = at_edge || touches_of(there) != touches_of(chain) ||
                          glm::any(glm::greaterThan(glm::abs(step), glm::ivec3(3)));
            }
            if (at_edge) {
                ++seen.at_edges;
                continue;
            }
            ++seen.unequal;
            ++seen.kinds[what];
            EXPECT_GE(blends, 1) << what << " (" << pixel.x << ", " << pixel.y << ") is "
                                 << hex_of(color_at(picture, pixel)) << ", but " << hex_of(*predicted)
                                 << " is predicted";
        }
    }

    /// At most one pixel in a thousand may differ, edges aside; compare() tolerates a difference only where something
    /// is blended, since GL rounds to 8 bits at each blend.
    static void check(const Seen& seen) {
        std::string kinds;
        for (const auto& [kind, count] : seen.kinds) kinds += "\n  " + kind + ": " + std::to_string(count);
        RecordProperty("equal", seen.equal);
        RecordProperty("by_rounding", seen.by_rounding);
        RecordProperty("at_edges", seen.at_edges);
        EXPECT_LE(seen.unequal, 0.001 * seen.equal) << seen.equal << " equal, " << seen.unequal << " unequal:" << kinds;
        EXPECT_LE(seen.at_edges, 0.02 * seen.equal);
        EXPECT_LE(seen.by_rounding, 0.02 * seen.equal);
    }

    /// Takes the mistakes and styles of a random state, and keeps the preset's camera and scene so that something is
    /// visible.
    static Params random_room(const Params& base, unsigned seed) {
        const Params wild = testing::RandomParams(seed).make();
        Params room = base;
        room.shadow = wild.shadow;
        room.reflection = wild.reflection;
        room.slips = wild.slips;
        room.slips.degrees_as_radians = false;
        room.depth = wild.depth;
        room.depth.func = seed % 4 == 0 ? wild.depth.func : CompareFunc::less;
        room.depth.buffer = room.depth.write = true;
        room.cull = seed % 3 == 0 ? wild.cull : CullParams{};
        room.visibility = VisibilityParams{};
        room.view.shows = Shows::color;
        std::mt19937 random(seed);
        const auto uniform = [&](double low, double high) {
            return std::uniform_real_distribution<double>(low, high)(random);
        };
        room.lights.resize(1 + random() % 4, LightParams{});
        for (LightParams& light : room.lights)
            light.position = {uniform(-6, 6), uniform(0.5, 9), uniform(-6, 6), random() % 3 == 0 ? 0.0 : 1.0};
        room.planes.resize(1 + random() % 3, PlaneParams{});
        for (std::size_t i = 1; i < room.planes.size(); ++i)
            room.planes[i].equation = {i == 1 ? 1.0 : uniform(-0.3, 0.3), uniform(-0.2, 0.2), i == 1 ? 0.0 : 1.0,
                                       uniform(2, 5)};
        room.overrides = {};
        room.view.plane = room.view.light = 1;
        return room;
    }
};

TEST_F(WhyThisPixel, PredictsTheColorsOfPresets) {
    std::mt19937 random(3801);
    Seen seen;
    for (const NamedFile& preset : presets()) {
        const auto [params, scene] = testing::preset_named(preset.name);
        compare(params, scene, random, testing::trials(is_sanitized ? 10 : 100), preset.name, seen);
    }
    check(seen);
}

/// Presets with random planes, lights, bounces, styles, mistakes and depth formats.
TEST_F(WhyThisPixel, PredictsTheColorsOfRandomRooms) {
    constexpr unsigned first_seed = 3820;
    Seen seen;
    const std::vector<NamedFile> all = presets();
    for (int room = 0; room < testing::trials(is_sanitized ? 6 : 60); ++room) {
        const unsigned seed = first_seed + static_cast<unsigned>(room);
        std::mt19937 random(seed);
        const auto [base, scene] = testing::preset_named(all[random() % all.size()].name);
        const Params params = random_room(base, seed);
        compare(params, scene, random, 100, "seed " + std::to_string(seed), seen);
    }
    check(seen);
}

/// The explanation of surfaces, mirrors, lights, and casters agrees with an oracle that traces rays through rooms of
/// spheres and boxes with closed-form formulas.
TEST_F(WhyThisPixel, AgreesWithARayCaster) {
    int surfaces = 0, images = 0, shadows = 0;
    for (unsigned number = 0; number < testing::rooms(60); ++number) {
        testing::Room room = testing::RoomMaker(number).make();
        const Derived derived = derive(room.params, room.scene, renderer().viewport(why_px, room.params.depth.format));
        const FramePlan frame = plan(room.params, derived);
        room.oracle.bounces = frame.reflection_depth;
        const testing::RayCaster oracle(room.oracle, room.camera);
        const FragmentFinder finder(room.scene);
        std::mt19937 random(3870 + number);
        for (int i = 0; i < 40; ++i) {
            const glm::ivec2 pixel(static_cast<int>(random() % why_px.x), static_cast<int>(random() % why_px.y));
            const auto sight_at = [&](double x, double y) {
                return oracle.at(pixel.x + x, pixel.y + y, why_px.x, why_px.y);
            };
            const testing::Sight sight = sight_at(0.5, 0.5);
            const double out = 1.2;
            if (sight_at(0.5 - out, 0.5) != sight || sight_at(0.5 + out, 0.5) != sight ||
                sight_at(0.5, 0.5 - out) != sight || sight_at(0.5, 0.5 + out) != sight)
                continue;
            const PixelChain chain = pixel_chain(frame, finder, pixel, why_px);
            std::vector<std::size_t> mirrors;
            SCOPED_TRACE("room " + std::to_string(number) + ", pixel " + std::to_string(pixel.x) + ", " +
                         std::to_string(pixel.y));
            for (std::size_t k = 0; k < sight.met.size(); ++k) {
                const testing::Met& met = sight.met[k];
                const Touch* touch = chain.surface(frame, mirrors);
                ASSERT_TRUE(touch) << "behind " << k << " mirrors";
                EXPECT_EQ(touch->fragment.object_index, met.solid >= 0 ? met.solid : -1 - met.patch);
                (k == 0 ? surfaces : images)++;
                if (met.solid >= 0) break;
                const auto patch = static_cast<std::size_t>(met.patch);
                unsigned missing = 0;
                for (std::size_t light = 0; light < room.oracle.lights.size(); ++light) {
                    if (shadow_at(frame, chain, patch, light, mirrors).first) missing |= 1U << light;
                    const std::optional<Blocker> in_way =
                        blocker(finder, touch->fragment.point_scene, room.oracle.lights[light]);
                    const bool is_missing = (met.missing >> light & 1U) != 0;
                    EXPECT_TRUE(in_way || !is_missing) << "light " << light;
                }
                EXPECT_EQ(missing, met.missing);
                shadows += missing != 0 ? 1 : 0;
                mirrors.push_back(patch);
            }
        }
    }
    EXPECT_GT(surfaces, 500);
    EXPECT_GT(images, 100);
    EXPECT_GT(shadows, 50);
}

/// A row about depth fighting names the visible surface, and calls a shadow a shadow; a hidden tie has no row.
TEST_F(WhyThisPixel, TellsOnlyTheFightThatDecidesWhatIsSeen) {
    std::map<std::string, int> fights;
    for (const std::string name : {"opening", "shadow-fights", "depth-fighting"}) {
        auto [params, scene] = testing::preset_named(name);
        params.view.samples = 0;
        const Viewport viewport = renderer().viewport(why_px, params.depth.format);
        const Derived derived = derive(params, scene, viewport);
        const FramePlan frame = plan_of(params, derived, scene);
        const FragmentFinder finder(scene);
        for (int y = 2; y < why_px.y; y += 6)
            for (int x = 2; x < why_px.x; x += 6) {
                const WhyQuestion question{params, derived, frame, finder, viewport, {}, {x, y}};
                const Why explained = why(question);
                const Touch* surface = explained.chain.surface(frame);
                for (const WhyRow& row : explained.rows) {
                    if (row.kind != WhyRow::Kind::fight) continue;
                    ++fights[name];
                    ASSERT_TRUE(surface);
                    const std::string sentence = say(row.sentences.front());
                    EXPECT_NE(sentence.find(say(surface_name(question, surface->fragment.object_index))),
                              std::string::npos)
                        << name << " " << x << ", " << y << ": " << sentence;
                    EXPECT_EQ(sentence.starts_with("the shadow of "), name == "shadow-fights") << sentence;
                }
            }
    }
    EXPECT_EQ(fights["opening"], 0);
    EXPECT_GT(fights["shadow-fights"], 10);
    EXPECT_GT(fights["depth-fighting"], 2);
}

/// A mirror's image at a pixel also lies on that pixel's line of sight, unless the image is drawn with a fovy or a
/// projection of its own. Only in that case does a row name another pixel, where the image belongs.
TEST_F(WhyThisPixel, AMirrorRowSaysWhereAnImageBelongs) {
    std::map<std::string, int> rows, elsewhere;
    for (const char* const name :
         {"opening", "room", "mirrors-facing", "mirror-other-fovy", "mirror-plus-2ab", "mirror-other-projection"}) {
        auto [params, scene] = testing::preset_named(name);
        params.view.samples = 0;
        const Viewport viewport = renderer().viewport(why_px, params.depth.format);
        const Derived derived = derive(params, scene, viewport);
        const FramePlan frame = plan_of(params, derived, scene);
        const FragmentFinder finder(scene);
        for (int y = 2; y < why_px.y; y += 5)
            for (int x = 2; x < why_px.x; x += 5)
                for (const WhyRow& row : why({params, derived, frame, finder, viewport, {}, {x, y}}).rows) {
                    if (row.kind != WhyRow::Kind::mirror) continue;
                    ++rows[name];
                    const bool is_elsewhere = say(row.sentences.front()).find("belongs at pixel") != std::string::npos;
                    elsewhere[name] += is_elsewhere ? 1 : 0;
                }
        EXPECT_GT(rows[name], 20) << name;
        const bool has_other_lens = params.reflection.fovy != 0.0 || !params.reflection.same_projection;
        EXPECT_EQ(elsewhere[name] > 0, has_other_lens) << name;
    }
    EXPECT_GT(elsewhere["mirror-other-fovy"], rows["mirror-other-fovy"] / 2);
}

/// For each preset with a mistake: wherever its fix changes the picture, the explanation names that fix.
TEST_F(WhyThisPixel, NamesTheMistakeWhereItChangesThePicture) {
    std::mt19937 random(3850);
    int tried = 0;
    for (const NamedFile& preset : presets()) {
        if (preset.fixed_by.empty()) continue;
        auto [params, scene] = testing::preset_named(preset.name);
        params.view.samples = 0;
        const Result<Params> fixed = apply_settings(params, std::vector<std::string>{preset.fixed_by});
        ASSERT_TRUE(fixed) << preset.name;
        const Viewport viewport = renderer().viewport(why_px, params.depth.format);
        const Derived derived = derive(params, scene, viewport), right = derive(*fixed, scene, viewport);
        const FramePlan frame = plan_of(params, derived, scene);
        const Image before = draw(frame, scene, why_px), after = draw(plan_of(*fixed, right, scene), scene, why_px);
        const std::vector<Problem> problems = find_problems(params, derived, scene, frame);
        const FragmentFinder finder(scene);
        const auto solve = [&, &scene = scene](const Params& state, const Derived& numbers) {
            return solved(state, numbers, scene);
        };
        std::vector<glm::ivec2> differing;
        for (int y = 0; y < why_px.y; ++y)
            for (int x = 0; x < why_px.x; ++x)
                if (testing::worst_channel(testing::rgb_at(before, {x, y}), testing::rgb_at(after, {x, y})) > 8)
                    differing.emplace_back(x, y);
        ASSERT_FALSE(differing.empty()) << preset.name << " looks the same with " << preset.fixed_by;
        std::shuffle(differing.begin(), differing.end(), random);
        differing.resize(std::min<std::size_t>(differing.size(), is_sanitized ? 5 : 40));
        int named = 0;
        for (const glm::ivec2& pixel : differing) {
            const Why explained =
                why({params, derived, frame, finder, viewport, problems, pixel, color_at(before, pixel), solve});
            named += std::any_of(explained.rows.begin(), explained.rows.end(),
                                 [&](const WhyRow& row) { return row.fix == preset.fixed_by; });
        }
        ++tried;
        EXPECT_GE(named, 0.95 * static_cast<double>(differing.size()))
            << preset.name << ": " << named << " of " << differing.size() << " pixels name " << preset.fixed_by;
    }
    EXPECT_GE(tried, 30);
}

}  // namespace
}  // namespace viewing
