// No sentence is missing, and none is a false alarm: if a switch changes the picture, a sentence names it, and the fix
// that a sentence offers changes a picture. The tests run over presets and over seeded states with several mistakes.
// With VIEWING_LONG_TESTS, they cover all presets and more seeds.
#include <algorithm>
#include <random>
#include <set>

#include "gl/gl_test.h"
#include "platform/sanitized.h"
#include "state/fields.h"
#include "state/presets.h"

namespace viewing {
namespace {

/// A change that is a choice and not a mistake: a field or one of its values, with the reason.
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
    {"plane.receives_shadow", "a plane without shadows"},
    {"plane.mirrors", "a plane that is no mirror"},
    {"plane.gloss", "a highlight"},
    {"depth.func=less", "which of two equal depths wins"},
    {"depth.func=lequal", "which of two equal depths wins"},
    {"depth.format", "how much precision there is"},
    {"depth.mapping", "how precision is spread"},
    {"depth.decals", "three ways to draw decals"},
};

/// A switch of the technique, set to another value.
struct Change {
    std::string_view path;
    std::string setting;
    Params params;
};

/// A change that no sentence names yet, with the reason.
struct Unsaid {
    std::string_view preset, setting, reason;
};
constexpr Unsaid unsaid[] = {
    {"room", "reflection.clip=none", "only images of images show what is behind a mirror"},
    {"mirrors-facing", "reflection.side_of_eye=false", "only images of images are seen from behind"},
    {"front-faces-culled", "reflection.stencil=false",
     "with few bits, depth rounds alike where image and mirror touch"},
    {"mirror-plus-2ab", "reflection.stencil=false", "the image leaves the mirror inside a triangle"},
};

/// Beginnings of sentences about the drawing order. A picture may happen not to depend on that order.
constexpr std::string_view by_chance[] = {"GL_ALWAYS", "GL_NOTEQUAL", "the shadow writes its depth",
                                          "the mask writes the mirror's own depth"};

bool is_by_chance(const std::string& sentence) {
    return std::any_of(std::begin(by_chance), std::end(by_chance),
                       [&](std::string_view start) { return sentence.starts_with(start); });
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
            all.push_back({field.path, std::string(field.path) + (**on ? "=true" : "=false"), copy});
        } else if (const auto* choice = std::get_if<EnumRef>(&ref)) {
            const int now = choice->index();
            for (int index = 0; index < static_cast<int>(choice->names.size()); ++index) {
                if (index == now) continue;
                EnumRef(*choice).set(index);
                all.push_back({field.path, std::string(field.path) + "=" + std::string(choice->names[index]), copy});
            }
        }
    }
    return all;
}

class Silence : public testing::GlTest {
protected:
    static constexpr glm::ivec2 size_px{160, 100};

    struct Shown {
        Image picture;
        std::set<std::string> sentences;
        std::vector<Problem> problems;
    };
    static Shown shown(const Params& params, const Scene& scene) {
        Shown shown{draw(params, scene, size_px), {}, problems_of(params, scene, size_px)};
        for (const Problem& problem : shown.problems) shown.sentences.insert(problem.sentence);
        return shown;
    }

    /// Returns whether the fix changes the camera's picture, its depth, its stencil or its facing.
    static bool fix_shows(const Params& params, const Scene& scene, const std::string& fix) {
        const Result<Params> fixed = apply_settings(params, std::vector<std::string>{fix});
        EXPECT_TRUE(fixed) << fix;
        for (const Shows shows : {Shows::color, Shows::depth, Shows::stencil, Shows::facing})
            for (const glm::ivec2 size : {size_px, glm::ivec2(400, 240)}) {
                Params before = params, after = *fixed;
                before.view.shows = after.view.shows = shows;
                if (draw(before, scene, size) != draw(after, scene, size)) return true;
            }
        return false;
    }

    /// Checks one change of a state, and returns whether the picture changed.
    static bool check(const Shown& before, const Change& change, const Scene& scene, const std::string& what) {
        const Shown after = shown(change.params, scene);
        constexpr int few_pixels = 24;
        const int changed = testing::pixels_beyond(before.picture, after.picture, 8);
        const bool is_said =
            std::any_of(after.sentences.begin(), after.sentences.end(),
                        [&](const std::string& sentence) { return !before.sentences.contains(sentence); });
        const bool was_said =
            std::any_of(before.sentences.begin(), before.sentences.end(),
                        [&](const std::string& sentence) { return !after.sentences.contains(sentence); });
        const bool is_unsaid = std::any_of(std::begin(unsaid), std::end(unsaid), [&](const Unsaid& one) {
            return what.find(one.preset) != std::string::npos && one.setting == change.setting;
        });
        EXPECT_TRUE(is_unsaid || changed <= few_pixels || is_said || was_said || is_choice(change))
            << "silent: " << what << " changes " << changed << " pixels";
        for (const Problem& problem : after.problems) {
            if (problem.kind != ProblemKind::wrong || problem.fixed_by.empty() ||
                before.sentences.contains(problem.sentence) || is_by_chance(problem.sentence))
                continue;
            EXPECT_TRUE(fix_shows(change.params, scene, problem.fixed_by))
                << "alarm: " << what << ": " << problem.sentence << " | " << problem.fixed_by;
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
            changed += check(before, change, scene, all[i].name + ": " + change.setting) ? 1 : 0;
    }
    EXPECT_GT(changed, is_sanitized ? 15 : 50) << "most switches change the picture somewhere";
}

/// When a state already has mistakes, a sentence names each further one, too.
TEST_F(Silence, MistakesAreNamedBesideOthers) {
    constexpr unsigned first_seed = 3700;
    const std::vector<NamedFile> all = drawn_presets();
    for (int run = 0; run < testing::trials(is_sanitized ? 6 : 25); ++run) {
        const unsigned seed = first_seed + static_cast<unsigned>(run);
        std::mt19937 random(seed);
        const NamedFile& preset = all[random() % all.size()];
        const auto [params, scene] = testing::preset_named(preset.name);
        Params state = one_sample(params);
        std::string what = "seed " + std::to_string(seed) + ", " + preset.name;
        for (int mistakes = 0; mistakes < 3; ++mistakes) {
            const std::vector<Change> changes = changes_of(state);
            const Change& change = changes[random() % changes.size()];
            what += " " + change.setting;
            check(shown(state, scene), change, scene, what);
            state = change.params;
        }
    }
}

}  // namespace
}  // namespace viewing
