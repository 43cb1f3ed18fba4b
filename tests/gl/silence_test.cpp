// No sentence is missing, and none is a false alarm: if a switch changes the picture, a sentence names it, and the fix
// that a sentence offers changes a picture. The tests run over presets and over seeded states with several mistakes.
// With VIEWING_LONG_TESTS=N, they cover all presets and N times as many seeds, which differ from the usual ones and
// begin at VIEWING_FIRST_SEED. A value of 250 makes 20,000 pairs of a state and a change.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <set>
#include <span>

#include "gl/gl_test.h"
#include "platform/sanitized.h"
#include "state/fields.h"
#include "state/presets.h"

namespace viewing {
namespace {

/// A field (PATH), or one of its values (PATH=VALUE), that is a choice and cannot be a mistake; with the reason.
struct Choice {
    std::string_view setting, reason;
};
constexpr Choice choices[] = {
    {"projection.type", "a parallel projection is as right as perspective"},
    {"cull.enabled", "the back of an open surface vanishes, as it should"},
    {"shadow.enabled", "a picture without shadows"},
    {"shadow.style", "both styles are right"},
    {"shadow.offset", "all but none are right, up to fighting at the edge"},
    {"reflection.enabled", "a picture without mirrors"},
    {"reflection.mirrored", "two ways to draw a mirror; the camera is mirrored without the mistakes of R"},
    {"reflection.clip=clip_distance", "one of two right ways to clip an image"},
    {"reflection.clip=oblique", "the other one; what it does to depth is said"},
    {"plane.receives_shadow", "a plane without shadows"},
    {"plane.mirrors", "a plane that is no mirror"},
    {"plane.gloss", "a highlight"},
    {"depth.func=less", "which of two equal depths wins"},
    {"depth.func=lequal", "which of two equal depths wins"},
    {"depth.format", "how much precision there is"},
    {"depth.mapping", "how precision is spread"},
    {"depth.decals", "three ways to draw decals"},
};

/// Fits the edges of the projection's window to its other settings, to keep one object from filling the picture.
void fit_window(ProjectionParams& projection) {
    const bool is_parallel = projection.type == ProjectionType::orthographic_window;
    const double top =
        is_parallel ? 0.5 * projection.height : projection.near * std::tan(glm::radians(0.5 * projection.fovy));
    projection.right = 1.6 * top;
    projection.left = -projection.right;
    projection.top = top;
    projection.bottom = -top;
}

/// A switch of the technique, set to another value.
struct Change {
    std::string path, setting;
    Params params;
};

/// Beginnings of sentences about the drawing order and about rounding. A picture may happen not to depend on these.
constexpr std::string_view by_chance[] = {
    "GL_ALWAYS",
    "GL_NOTEQUAL",
    "depth mask off",
    "the shadow writes its depth",
    "the mask writes the mirror's own depth",
    "nothing lifts the shadow off its plane: the two depths differ only by rounding",
    "the mirror is the image's near plane, which makes depth",
    "without the stencil, depth decides where the mirror covers its image"};

bool is_by_chance(const Problem& problem) {
    return problem.id == "depth.offset_too_small" ||
           std::any_of(std::begin(by_chance), std::end(by_chance),
                       [&](std::string_view start) { return say(problem.sentence).starts_with(start); });
}

/// GL_GREATER and GL_GEQUAL differ only where two depths are equal, like GL_LESS and GL_LEQUAL.
bool decides_ties(const Params& before, const Change& change) {
    const auto wants_farther = [](const Params& params) {
        return params.depth.func == CompareFunc::greater || params.depth.func == CompareFunc::gequal;
    };
    return change.path == "depth.func" && wants_farther(before) && wants_farther(change.params);
}

bool is_choice(const Change& change) {
    return std::any_of(std::begin(choices), std::end(choices), [&](const Choice& choice) {
        return choice.setting == change.path || choice.setting == change.setting;
    });
}

std::vector<Change> changes_of(const Params& params) {
    std::vector<Change> all;
    for (const Field& field : fields()) {
        const std::string_view group = group_of(field.path);
        static constexpr std::string_view groups[] = {"projection", "cull",  "depth", "shadow",
                                                      "reflection", "slips", "plane"};
        if (std::find(std::begin(groups), std::end(groups), group) == std::end(groups)) continue;
        Params copy = params;
        const FieldRef ref = field.in(copy);
        if (bool* const* on = std::get_if<bool*>(&ref)) {
            **on = !**on;
            all.push_back({std::string(field.path), std::string(field.path) + (**on ? "=true" : "=false"), copy});
        } else if (const auto* choice = std::get_if<EnumRef>(&ref)) {
            const int now = choice->index();
            for (int index = 0; index < static_cast<int>(choice->names.size()); ++index) {
                if (index == now) continue;
                EnumRef(*choice).set(index);
                if (field.path == "projection.type") fit_window(copy.projection);
                all.push_back(
                    {std::string(field.path), std::string(field.path) + "=" + std::string(choice->names[index]), copy});
            }
        }
    }
    return all;
}

/// Returns whether the program accepts the state, as a file or in the window.
bool is_accepted(const Params& before, const Change& change) {
    return static_cast<bool>(apply_settings(before, std::vector<std::string>{change.setting}));
}

/// Returns the state without the mistakes whose sentences say that codes or the drawing order decide which surface
/// wins.
Params without_chance(Params params) {
    params.depth.format = DepthFormat::d24;
    params.depth.func = CompareFunc::less;
    params.depth.logarithm_per_vertex = false;
    params.depth.buffer = params.depth.test = params.depth.write = true;
    params.shadow.write_depth = false;
    return params;
}

bool is_left_to_chance(const std::vector<Problem>& problems) {
    static constexpr std::string_view ids[] = {"depth.too_coarse",
                                               "depth.code_of_cleared",
                                               "depth.equal",
                                               "depth.only_farther",
                                               "shadow.writes_depth",
                                               "depth.no_buffer",
                                               "depth.test_off",
                                               "depth.mask_off",
                                               "depth.always",
                                               "depth.notequal",
                                               "depth.logarithm_per_vertex",
                                               "cull.front"};
    return std::any_of(problems.begin(), problems.end(), [](const Problem& problem) {
        return std::find(std::begin(ids), std::end(ids), problem.id) != std::end(ids);
    });
}

unsigned first_seed() {
    if (testing::trials(1) == 1) return 3700;
    const char* const seed = std::getenv("VIEWING_FIRST_SEED");
    return seed ? static_cast<unsigned>(std::strtoul(seed, nullptr, 10)) : 510'000;
}

class Silence : public testing::GlTest {
protected:
    static constexpr glm::ivec2 size_px{160, 100};
    inline static int pairs = 0;

    void TearDown() override {
        std::printf("%d pairs of a state and a change so far\n", pairs);
        GlTest::TearDown();
    }

    struct Shown {
        Image picture;
        std::set<std::string> sentences;
        std::vector<Problem> problems;
    };
    static Shown shown(const Params& params, const Scene& scene) {
        Shown shown{draw(params, scene, size_px), {}, problems_of(params, scene, size_px)};
        for (const Problem& problem : shown.problems) shown.sentences.insert(say(problem.sentence));
        return shown;
    }

    /// Returns whether the fix changes the camera's picture, its depth, its stencil or its facing.
    static bool fix_shows(const Params& params, const Scene& scene, const std::string& fix) {
        const Result<Params> fixed = apply_settings(params, std::vector<std::string>{fix});
        EXPECT_TRUE(fixed) << "refused: " << fix << ": " << (fixed ? "" : fixed.error());
        if (!fixed) return true;
        for (const Shows shows : {Shows::color, Shows::depth, Shows::stencil, Shows::facing})
            for (const glm::ivec2 size : {size_px, glm::ivec2(400, 240)}) {
                Params before = params, after = *fixed;
                before.view.shows = after.view.shows = shows;
                if (draw(before, scene, size) != draw(after, scene, size)) return true;
            }
        return false;
    }

    static constexpr int few_pixels = 24;

    static int changed_pixels(const Shown& before, const Shown& after) {
        return testing::pixels_beyond(before.picture, after.picture, 8);
    }

    static bool is_named(const Shown& before, const Shown& after) {
        return changed_pixels(before, after) <= few_pixels || before.sentences != after.sentences;
    }

    /// Removes from both states the mistakes that leave the picture to chance, and returns whether the change is then
    /// named; returns false if there are no such mistakes. Culled fronts count as one: they expose the bottoms of
    /// objects, which fight with the floor.
    static bool is_named_without_chance(const Params& state, const Shown& after, const Change& change,
                                        const Scene& scene) {
        const bool shows_insides = std::any_of(after.problems.begin(), after.problems.end(),
                                               [](const Problem& problem) { return problem.id == "cull.front"; });
        if (!shows_insides && !is_left_to_chance(after.problems)) return false;
        Params before = without_chance(state), now = without_chance(change.params);
        if (shows_insides) before.cull.face = now.cull.face = CullFace::back;
        return is_named(shown(before, scene), shown(now, scene));
    }

    /// Checks one change of a state, and returns whether the picture changed. `before` is shown(state, scene).
    static bool check(const Params& state, const Shown& before, const Change& change, const Scene& scene,
                      const std::string& what) {
        ++pairs;
        const Shown after = shown(change.params, scene);
        const int changed = changed_pixels(before, after);
        EXPECT_TRUE(is_named(before, after) || is_choice(change) || decides_ties(state, change) ||
                    is_named_without_chance(state, after, change, scene))
            << "silent: " << what << " changes " << changed << " pixels";
        for (const Problem& problem : after.problems) {
            if (problem.kind != ProblemKind::wrong || problem.fixed_by.empty() ||
                before.sentences.contains(say(problem.sentence)) || is_by_chance(problem))
                continue;
            EXPECT_TRUE(fix_shows(change.params, scene, problem.fixed_by) ||
                        (is_left_to_chance(after.problems) &&
                         fix_shows(without_chance(change.params), scene, problem.fixed_by)))
                << "alarm: " << what << ": " << say(problem.sentence) << " | " << problem.fixed_by;
        }
        return changed > few_pixels;
    }
};

/// Returns the presets that GL draws with its depth buffer, in color and without jiggling.
std::vector<NamedFile> drawn_presets() {
    std::vector<NamedFile> drawn;
    for (const NamedFile& preset : presets()) {
        const Params params = testing::preset_named(preset.name).params;
        if (params.visibility.method == VisibilityMethod::depth_buffer && params.view.shows == Shows::color &&
            !params.animation.jiggle)
            drawn.push_back(preset);
    }
    return drawn;
}

Params one_sample(Params params) {
    params.view.samples = 0;
    params.view.pass = params.view.call = -1;
    return params;
}

TEST_F(Silence, SwitchesOfPresetsAreNamed) {
    const std::vector<NamedFile> all = drawn_presets();
    ASSERT_GE(all.size(), 40U);
    const std::size_t step = testing::trials(1) > 1 ? 1 : is_sanitized ? 24 : 8;
    int changed = 0;
    for (std::size_t i = 0; i < all.size(); i += step) {
        const auto [params, scene] = testing::preset_named(all[i].name);
        const Params base = one_sample(params);
        const Shown before = shown(base, scene);
        for (const Change& change : changes_of(base))
            if (is_accepted(base, change))
                changed += check(base, before, change, scene, all[i].name + ": " + change.setting) ? 1 : 0;
    }
    EXPECT_GT(changed, is_sanitized ? 15 : 50) << "most switches change the picture somewhere";
}

/// A preset and its settings. The test judges the last setting.
struct JudgedState {
    std::string preset;
    std::vector<std::string> settings;
};

/// False alarms and silences that long runs found in earlier versions.
const std::vector<JudgedState>& found_in_long_runs() {
    static const std::vector<JudgedState> found = {
        {"shadow-black-paint", {"depth.write_while_clearing=false", "depth.func=notequal"}},
        {"opening", {"shadow.write_depth=true", "depth.format=d12", "reflection.stencil=false"}},
        {"mirror-from-behind", {"depth.func=never", "shadow.style=missing_light", "reflection.after_objects=true"}},
        {"world-minus-ten",
         {"slips.degrees_as_radians=true", "reflection.same_projection=false", "shadow.offset=lift"}},
        {"fighting-reversed-clip-range", {"depth.format=d10", "depth.decals=stencil", "depth.func=equal"}},
        {"room", {"projection.type=orthographic_window", "shadow.clip_to_receiver=false"}},
        {"walk-slows", {"slips.shadow_by_rows=true", "shadow.offset=none"}},
        {"lecture-code-as-printed", {"depth.clear=false", "shadow.clip_to_receiver=false"}},
        {"wall-mirror", {"depth.format=d4", "reflection.reflect_light=false"}},
        {"fighting-divider", {"reflection.printed_by_rows=true", "reflection.enabled=true"}},
        {"far-infinite", {"depth.format=d6", "projection.type=frustum", "reflection.stencil=false"}},
        {"mirror-ways", {"shadow.stencil_once=false", "projection.type=orthographic_window", "plane.gloss=true"}},
        {"mirror-unclipped", {"projection.type=orthographic_window", "slips.shadow_by_rows=true"}},
        {"back-faces-culled", {"depth.format=d5", "reflection.stencil=false"}},
        {"passes", {"projection.type=orthographic_window", "plane.gloss=true"}},
        {"front-faces-culled", {"reflection.mask_writes_depth=true", "reflection.flip_winding=false"}},
        {"walk-slows", {"depth.func=notequal", "depth.mapping=reversed", "depth.reversed_offset=false"}},
        {"walk-slows",
         {"reflection.after_objects=true", "shadow.clip_to_receiver=false", "depth.write_while_clearing=false"}},
        {"room", {"depth.func=notequal", "projection.type=orthographic_window", "shadow.clip_to_receiver=false"}},
        {"mirror-over-objects", {"shadow.enabled=true", "depth.func=gequal", "reflection.reflect_light=false"}},
        {"mirror-unclipped", {"depth.buffer=false", "depth.clear=false", "reflection.stencil=false"}},
        {"mirror-light", {"slips.oblique_in_world=true", "reflection.clip=oblique"}},
        {"frustum-off-center", {"reflection.clip=oblique", "slips.pole_flip=true", "reflection.stencil=false"}},
        {"walk-slows", {"depth.logarithm_per_vertex=true", "slips.swapped_order=true", "slips.shadow_by_rows=true"}},
        {"passes", {"shadow.write_depth=true", "slips.oblique_in_world=true", "reflection.clip=oblique"}},
        {"mirror-other-fovy", {"depth.reversed_offset=false", "depth.format=d8", "reflection.stencil=false"}},
        {"fighting-divider", {"cull.enabled=true", "depth.format=d4", "depth.write_while_clearing=false"}},
        {"mirror-unclipped", {"reflection.after_objects=true", "depth.write_while_clearing=false"}},
        {"depth-fighting", {"depth.format=d9", "slips.degrees_as_radians=true"}},
        {"mirrors-facing-once", {"shadow.own_stencil=false", "reflection.shadows=false"}},
        {"mirrors-facing", {"shadow.own_stencil=false", "reflection.side_of_eye=false"}},
        {"fighting-offset", {"projection.type=orthographic_window", "depth.format=d11"}},
        {"mirror-other-projection",
         {"depth.test=false", "reflection.mask_writes_depth=true", "reflection.stencil=false"}},
        {"front-faces-culled", {"slips.camera_as_view=true", "shadow.own_stencil=false", "cull.face=front_and_back"}},
        {"fighting-reversed", {"depth.format=d5", "slips.degrees_as_radians=true"}},
        {"fighting-decals-equal", {"depth.func=equal", "depth.func=lequal", "depth.clear=false"}},
        {"fighting-divider", {"depth.format=d9", "depth.reversed_clear=false", "depth.write_while_clearing=false"}},
        {"fighting-reversed-clip-range", {"depth.format=d9", "depth.write_while_clearing=false"}},
        {"mirror-hides-itself", {"depth.func=notequal", "shadow.offset=none", "reflection.reflect_light=false"}},
        {"mirror-without-shadow", {"reflection.printed_by_rows=true", "reflection.clip=oblique"}},
        {"fighting-reversed-clip-range",
         {"shadow.offset=lift", "depth.func=lequal", "depth.write_while_clearing=false"}},
        {"from-light", {"depth.decals=stencil", "reflection.stencil=false"}},
        {"mirror-other-projection", {"reflection.stencil=false"}},
        {"room", {"reflection.clip=none"}},
        {"mirrors-facing", {"reflection.side_of_eye=false"}},
        {"front-faces-culled", {"reflection.stencil=false"}},
        {"mirror-plus-2ab", {"reflection.stencil=false"}},
        {"fighting-reversed-clip-range", {"depth.write_while_clearing=false", "depth.format=d5", "depth.func=gequal"}},
        {"fighting-reversed", {"shadow.enabled=true", "slips.shadow_by_rows=true", "plane.gloss=true"}},
        {"shadow-to-infinity", {"depth.func=equal", "slips.shadow_by_rows=true", "depth.func=lequal"}},
        {"mirror-inside-out", {"cull.face=front", "reflection.stencil=false"}},
        {"mirror-from-behind", {"shadow.stencil_once=false", "depth.format=d5", "reflection.mask_writes_depth=true"}},
        {"mirror-oblique-depth",
         {"depth.format=d8", "reflection.mask_writes_depth=true", "reflection.reflect_light=false"}},
        {"interpenetrating", {"reflection.after_objects=true", "depth.func=gequal", "slips.degrees_as_radians=true"}},
        {"mirrors-facing", {"depth.format=d5", "shadow.style=missing_light", "reflection.clip=none"}},
        {"front-faces-culled", {"depth.write=false", "shadow.offset=none"}},
        {"mirror-ways", {"depth.format=d8", "reflection.stencil=false", "shadow.clip_to_receiver=false"}},
        {"mirror-inside-out",
         {"depth.write_while_clearing=false", "depth.logarithm_per_vertex=true", "depth.func=lequal"}},
        {"from-light", {"depth.write=false", "depth.format=d12", "reflection.stencil=false"}},
        {"mirror-other-fovy", {"slips.degrees_as_radians=true", "reflection.reflect_light=false"}},
        {"camera-sent-as-view",
         {"depth.func=notequal", "reflection.printed_by_rows=true", "reflection.reflect_light=false"}},
        {"tilted-plane", {"slips.swapped_order=true", "depth.func=always", "reflection.reflect_light=false"}},
        {"fighting-logarithmic",
         {"reflection.enabled=true", "slips.shadow_by_rows=true", "reflection.reflect_light=false"}},
        {"mirrors-facing-once", {"slips.camera_as_view=true", "shadow.offset=lift"}},
        {"room", {"slips.camera_as_view=true", "reflection.side_of_eye=false", "shadow.offset=lift"}},
        {"mirrors-facing", {"projection.type=orthographic", "reflection.clip=none"}},
        {"observer-rays", {"depth.write=false", "reflection.stencil=false"}},
        {"depth-not-cleared",
         {"reflection.after_objects=true", "slips.camera_as_view=true", "projection.type=orthographic"}},
        {"mirrors-facing", {"depth.decals=stencil", "shadow.clip_at_light=false", "shadow.sign=forced"}},
        {"lecture-code-as-printed", {"reflection.mask_writes_depth=true", "reflection.reflect_light=false"}},
        {"opening", {"shadow.write_depth=true", "cull.enabled=true", "reflection.stencil=false"}},
        {"view-is-inverse", {"depth.format=d32f", "slips.shadow_by_rows=true", "shadow.clip_to_receiver=false"}},
        {"fighting-reversed", {"shadow.offset=none", "reflection.shadows=false", "shadow.enabled=true"}},
        {"mirrors-facing-once", {"depth.decals=equal", "depth.clear=false", "shadow.own_stencil=false"}},
        {"front-faces-culled",
         {"shadow.stencil_once=false", "reflection.mask_writes_depth=true", "reflection.printed_by_rows=true"}},
        {"walk", {"shadow.write_depth=true", "reflection.stencil=false"}},
        {"mirrors-facing", {"shadow.sign=none", "depth.func=lequal", "slips.shadow_by_rows=true"}},
        {"fighting-logarithmic", {"depth.func=greater", "depth.func=equal", "depth.logarithm_per_vertex=true"}},
        {"mirror-from-behind",
         {"shadow.clip_at_light=false", "slips.oblique_in_world=true", "reflection.clip=oblique"}},
        {"shadow-leaks", {"depth.write_while_clearing=false", "shadow.clip_to_receiver=false"}},
        {"camera-plus-ten", {"depth.format=d4", "cull.face=front", "cull.enabled=true"}},
        {"walkthrough", {"shadow.write_depth=true", "depth.format=d4", "reflection.stencil=false"}},
        {"fighting-reversed-clip-range", {"shadow.enabled=true", "depth.format=d11", "depth.reversed_offset=false"}},
        {"far-infinite", {"slips.degrees_as_radians=true", "depth.format=d4", "reflection.after_objects=true"}},
        {"shadow-normal-flipped", {"slips.shadow_by_rows=true"}},
        {"mirror-ways", {"shadow.offset=none", "depth.format=d12", "shadow.clip_casters=false"}},
        {"walk-slows", {"reflection.printed_by_rows=true", "depth.format=d4", "reflection.after_objects=true"}},
        {"orthographic", {"reflection.clip=oblique", "slips.oblique_in_world=true"}},
        {"occlusion-cue", {"depth.func=notequal", "depth.write_while_clearing=false"}},
        {"mirror-unclipped", {"reflection.stencil=false", "shadow.enabled=false", "reflection.after_objects=true"}},
        {"world-minus-ten", {"cull.face=front_and_back", "depth.format=d4", "reflection.stencil=false"}},
        {"mirror-off-the-edge", {"depth.buffer=false", "reflection.after_objects=true"}},
        {"cells-small", {"depth.format=d16", "reflection.enabled=true", "reflection.stencil=false"}},
        {"camera-sent-as-view", {"depth.format=d16", "reflection.after_objects=true"}},
        {"mirror-without-shadow", {"depth.format=d4", "depth.func=equal", "reflection.printed_by_rows=true"}},
        {"mirror-xz", {"depth.mapping=logarithmic", "depth.logarithm_per_vertex=true", "reflection.clip=oblique"}},
        {"fighting-offset-too-much", {"depth.reversed_offset=false", "depth.mapping=reversed"}},
        {"world-minus-ten", {"slips.shadow_by_rows=true", "shadow.stencil_once=false"}},
        {"inside-out", {"plane.receives_shadow=false", "slips.swapped_order=true", "reflection.flip_winding=false"}},
        {"mirror-inside-out",
         {"cull.face=front_and_back", "reflection.same_projection=false", "reflection.after_objects=true"}},
        {"camera-plus-ten", {"projection.type=orthographic", "depth.reversed_offset=false", "shadow.offset=lift"}},
        {"shadow-writes-depth", {"shadow.clip_to_receiver=false", "slips.shadow_by_rows=true"}},
        {"mirrors-facing", {"reflection.printed_by_rows=true", "cull.front_face=cw", "reflection.shadows=false"}},
        {"mirror-over-objects", {"depth.func=lequal", "shadow.stencil_once=false", "depth.clear=false"}},
        {"shadow-lift", {"plane.mirrors=false", "projection.type=orthographic", "shadow.clip_to_receiver=false"}},
        {"mirror-hides-itself", {"depth.format=d11", "reflection.same_projection=false", "reflection.mirrored=camera"}},
        {"fighting-reversed-clip-range", {"depth.format=d11", "depth.func=gequal", "depth.func=greater"}},
        {"depth-far-does-nothing", {"shadow.offset=none", "reflection.stencil=false", "shadow.enabled=true"}},
        {"camera-sent-as-view", {"depth.reversed_offset=false", "shadow.stencil_once=false", "depth.mapping=reversed"}},
        {"degrees-as-radians", {"plane.mirrors=false", "depth.func=gequal", "reflection.after_objects=true"}},
        {"mirror-from-behind", {"depth.format=d16", "depth.write=false", "reflection.mask_writes_depth=true"}},
        {"fighting-reversed-clip-range",
         {"cull.face=front_and_back", "cull.enabled=true", "slips.camera_as_view=true"}},
        {"walk-slows", {"shadow.write_depth=true"}},
        {"mirrors-facing", {"reflection.mask_writes_depth=true", "reflection.shadows=false"}},
        {"walk-slows", {"shadow.stencil_once=false"}},
        {"depth-far-does-nothing", {"depth.func=gequal", "depth.format=d4", "slips.degrees_as_radians=true"}},
        {"fighting-near-raised", {"depth.decals=equal", "shadow.enabled=true", "shadow.offset=none"}},
        {"mirrors-facing", {"reflection.mask_writes_depth=true", "reflection.reflect_light=false"}},
        {"fighting-reversed-clip-range",
         {"slips.camera_as_view=true", "reflection.enabled=true", "reflection.printed_by_rows=true"}},
        {"camera-sent-as-view", {"reflection.side_of_eye=false", "depth.format=d7", "reflection.clip=none"}},
        {"shadow-leaks", {"depth.write_while_clearing=false", "depth.func=never", "shadow.clip_to_receiver=false"}},
        {"mirrors-facing-once", {"shadow.offset=none", "depth.format=d12", "reflection.shadows=false"}},
        {"world-minus-ten",
         {"projection.type=orthographic", "slips.walk_slows=true", "reflection.printed_by_rows=true"}},
        {"mirror-plus-2ab", {"reflection.after_objects=true", "depth.func=greater", "slips.shadow_by_rows=true"}},
        {"shadow-highlight", {"slips.swapped_order=true", "cull.enabled=true"}},
        {"inside-out", {"cull.face=front_and_back", "shadow.write_depth=true", "reflection.printed_by_rows=true"}},
        {"mirrors-facing-once",
         {"slips.camera_as_view=true", "reflection.stencil=false", "reflection.printed_by_rows=true"}},
        {"mirrors-facing", {"reflection.printed_by_rows=true", "reflection.side_of_eye=false"}},
        {"fighting-offset-too-little", {"depth.func=lequal", "depth.mapping=logarithmic"}},
        {"mirrors-facing-once", {"shadow.sign=forced", "slips.shadow_by_rows=true", "reflection.shadows=false"}},
        {"mirror-normal-not-unit",
         {"depth.reversed_offset=false", "shadow.style=missing_light", "depth.mapping=reversed"}},
    };
    return found;
}

TEST_F(Silence, WhatLongRunsHaveFoundStaysRight) {
    for (const JudgedState& found : found_in_long_runs()) {
        const auto [params, scene] = testing::preset_named(found.preset);
        const std::span<const std::string> settings = found.settings;
        const Result<Params> before = apply_settings(one_sample(params), settings.first(settings.size() - 1));
        ASSERT_TRUE(before) << before.error();
        const Result<Params> after = apply_settings(*before, settings.last(1));
        ASSERT_TRUE(after) << after.error();
        const std::string& last = settings.back();
        check(*before, shown(*before, scene), {last.substr(0, last.find('=')), last, *after}, scene,
              found.preset + ": " + last);
    }
}

/// When a state already has mistakes, a sentence names each further one, too.
TEST_F(Silence, MistakesAreNamedBesideOthers) {
    const std::vector<NamedFile> all = drawn_presets();
    for (int run = 0; run < testing::trials(is_sanitized ? 6 : 25); ++run) {
        const unsigned seed = first_seed() + static_cast<unsigned>(run);
        std::mt19937 random(seed);
        const NamedFile& preset = all[random() % all.size()];
        const auto [params, scene] = testing::preset_named(preset.name);
        Params state = one_sample(params);
        std::string what = "seed " + std::to_string(seed) + ", " + preset.name;
        for (int mistakes = 0; mistakes < 3; ++mistakes) {
            const std::vector<Change> changes = changes_of(state);
            const Change& change = changes[random() % changes.size()];
            if (!is_accepted(state, change)) continue;
            what += " " + change.setting;
            check(state, shown(state, scene), change, scene, what);
            state = change.params;
        }
    }
}

}  // namespace
}  // namespace viewing
