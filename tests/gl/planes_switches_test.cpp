// The fix of every broken preset visibly changes the picture, and a sentence reports what was broken. A busy state
// draws without a GL error, whichever switch is changed. The reported reasons come from
// topics/planes/numbers/shadow_problems.cpp and topics/planes/numbers/mirror_problems.cpp; planes_edges_test.cpp has
// the degenerate states.
#include "gl_test.h"
#include "state/presets.h"

namespace viewing {
namespace {

using testing::object;
using testing::params_with;
using testing::pixels_beyond;
using testing::says;
using testing::scene_of;

constexpr glm::ivec2 switches_px(160, 90);

/// A broken preset and the same preset after its own fix.
struct Artefact {
    std::string name;
    Params broken, fixed;
    Scene scene;
};

/// Settings that break a preset's picture in another way.
struct Variant {
    const char* preset;
    std::vector<std::string> settings;
    const char* fixed_by = "";  ///< the fix, if it differs from the preset's own; "" otherwise
};

const Variant variants[] = {
    {"shadow-fights",
     {"shadow.offset=polygon_offset", "shadow.offset_factor=0", "shadow.offset_units=4"},
     "shadow.offset_units=-4"},
    {"shadow-shared-stencil", {"shadow.style=missing_light"}},
    {"mirror-light", {"reflection.mirrored=camera"}},
};

Artefact artefact(const NamedFile& preset, const Variant& variant) {
    const auto [params, scene] = testing::preset_named(preset.name);
    std::vector<std::string> settings{"view.samples=0"};
    settings.insert(settings.end(), variant.settings.begin(), variant.settings.end());
    const Result<Params> broken = apply_settings(params, settings);
    EXPECT_TRUE(broken) << broken.error();
    const std::string fixed_by = *variant.fixed_by == '\0' ? preset.fixed_by : variant.fixed_by;
    const Result<Params> fixed = apply_settings(*broken, std::vector<std::string>{fixed_by});
    EXPECT_TRUE(fixed) << fixed.error();
    std::string name = preset.name;
    for (const std::string& setting : variant.settings) name += " " + setting;
    return {std::move(name), *broken, *fixed, scene};
}

std::vector<Artefact> artefacts() {
    std::vector<Artefact> all;
    for (const NamedFile& preset : presets()) {
        if (preset.fixed_by.empty()) continue;
        all.push_back(artefact(preset, {}));
        for (const Variant& variant : variants)
            if (preset.name == variant.preset) all.push_back(artefact(preset, variant));
    }
    EXPECT_GE(all.size(), 30U);
    return all;
}

/// Each switch, set to the opposite of its default or to another of its values.
constexpr const char* switches[] = {"shadow.enabled=false",
                                    "shadow.stencil_once=false",
                                    "shadow.clip_to_receiver=false",
                                    "shadow.clip_casters=false",
                                    "shadow.clip_at_light=false",
                                    "shadow.sign=none",
                                    "shadow.sign=forced",
                                    "shadow.offset=none",
                                    "shadow.offset=lift",
                                    "shadow.offset=no_depth_test",
                                    "shadow.style=missing_light",
                                    "shadow.write_depth=true",
                                    "shadow.own_stencil=false",
                                    "reflection.enabled=false",
                                    "reflection.stencil=false",
                                    "reflection.clip=none",
                                    "reflection.clip=oblique",
                                    "reflection.flip_winding=false",
                                    "reflection.reflect_light=false",
                                    "reflection.mirrored=camera",
                                    "reflection.same_projection=false",
                                    "reflection.fovy=25",
                                    "reflection.printed_by_rows=true",
                                    "reflection.mask_writes_depth=true",
                                    "reflection.after_objects=true",
                                    "reflection.side_of_eye=false",
                                    "reflection.shadows=false",
                                    "reflection.reflectance=0",
                                    "reflection.reflectance=1",
                                    "slips.plus_2ab=true",
                                    "slips.normal_not_unit=true",
                                    "slips.degrees_as_radians=true",
                                    "projection.aspect=0.5",
                                    "depth.buffer=false"};

class Switches : public testing::GlTest {};

TEST_F(Switches, ChangeThePictureThatTheyBreak) {
    for (const Artefact& artefact : artefacts()) {
        const Image fixed = draw(artefact.fixed, artefact.scene, switches_px);
        const Image broken = draw(artefact.broken, artefact.scene, switches_px);
        EXPECT_GT(pixels_beyond(broken, fixed, 8), 40) << artefact.name;
    }
}

TEST_F(Switches, AreReportedWhenTheyBreakThePicture) {
    for (const Artefact& artefact : artefacts()) {
        const std::vector<Problem> without = problems_of(artefact.fixed, artefact.scene, switches_px);
        const std::vector<Problem> with = problems_of(artefact.broken, artefact.scene, switches_px);
        EXPECT_TRUE(std::any_of(with.begin(), with.end(), [&](const Problem& told) {
            return told.kind == ProblemKind::wrong && !says(without, told.group, say(told.sentence));
        })) << artefact.name;
    }
}

TEST_F(Switches, AnOffsetThatHidesEveryShadowIsReported) {
    const auto check = [&](const char* preset, const char* mapping, double factor) {
        SCOPED_TRACE(std::string(preset) + " " + mapping + " " + std::to_string(factor));
        const auto [usual, scene] = testing::preset_named(preset);
        const Params params =
            *apply_settings(usual, std::vector<std::string>{mapping, "view.samples=0", "shadow.offset=polygon_offset",
                                                            "shadow.offset_factor=" + std::to_string(factor)});
        const Params without = *apply_settings(params, std::vector<std::string>{"shadow.enabled=false"});
        const int shadow_px = pixels_beyond(draw(params, scene, switches_px), draw(without, scene, switches_px), 8);
        const std::vector<Problem> problems = problems_of(params, scene, switches_px);
        const auto found = std::find_if(problems.begin(), problems.end(),
                                        [](const Problem& problem) { return problem.id == "shadow.pushed_away"; });
        EXPECT_EQ(shadow_px == 0, factor > 0.0) << shadow_px;
        EXPECT_EQ(found != problems.end(), factor > 0.0);
        EXPECT_EQ(found == problems.end() ? "" : found->fixed_by, factor > 0.0 ? "shadow.offset_factor=-1.0" : "");
    };
    for (const char* const preset : {"opening", "tilted-plane", "shadow-derivation"})
        for (const char* const mapping : {"depth.mapping=standard", "depth.mapping=reversed"})
            for (const double factor : {-1.0, -0.05, 0.05, 0.5, 2.0}) check(preset, mapping, factor);
}

TEST_F(Switches, AnOffsetNoGreaterThanRoundingIsReported) {
    const auto check = [&](const char* preset, const std::vector<std::string>& camera, double factor, double units,
                           const char* fixed_by) {
        SCOPED_TRACE(std::string(preset) + " " + std::to_string(factor) + " " + std::to_string(units));
        const auto [usual, scene] = testing::preset_named(preset);
        const Params placed = *apply_settings(*apply_settings(usual, camera),
                                              std::vector<std::string>{"view.samples=0", "shadow.offset=polygon_offset",
                                                                       "shadow.offset_factor=" + std::to_string(factor),
                                                                       "shadow.offset_units=" + std::to_string(units)});
        const Params right = *apply_settings(placed, std::vector<std::string>{"shadow.offset_units=-64"});
        const int missing_px = pixels_beyond(draw(placed, scene, switches_px), draw(right, scene, switches_px), 8);
        const std::vector<Problem> problems = problems_of(placed, scene, switches_px);
        const auto found = std::find_if(problems.begin(), problems.end(),
                                        [](const Problem& problem) { return problem.id == "shadow.weak_offset"; });
        EXPECT_EQ(found == problems.end() ? "" : found->fixed_by, fixed_by);
        EXPECT_EQ(missing_px > 0, *fixed_by != '\0') << missing_px;
        if (found == problems.end()) return;
        const Params fixed = *apply_settings(placed, {&found->fixed_by, 1});
        EXPECT_EQ(pixels_beyond(draw(fixed, scene, switches_px), draw(right, scene, switches_px), 8), 0);
    };
    const std::vector<std::string> from_above = {"camera.position=[0.3,9,0.2]", "camera.pitch=-90"};
    for (const char* const preset : {"opening", "room", "walkthrough", "shadow-any-plane"}) {
        check(preset, {}, 0.0, -1.0, "shadow.offset_factor=-1.0");
        check(preset, {}, 0.0, -8.0, "");
        check(preset, {}, -1.0, 0.0, "");
        check(preset, {}, -1.0, -1.0, "");
    }
    for (const char* const preset : {"opening", "room"}) {
        check(preset, from_above, -1.0, 0.0, "shadow.offset_units=-1.0");
        check(preset, from_above, -1.0, -1.0, "");
    }
}

TEST_F(Switches, AnOffsetThatKeepsItsSignIsReportedOnlyIfItPushesAway) {
    const auto [usual, scene] = testing::preset_named("opening");
    struct Case {
        double factor, units;
        const char* reported;
    };
    for (const auto& [factor, units, reported] :
         {Case{-1.0, -1.0, "it pushes surfaces away instead of pulling"}, Case{1.0, 1.0, ""},
          Case{0.5, -1.0, "its negative number pushes surfaces away"}}) {
        SCOPED_TRACE(std::to_string(factor) + " " + std::to_string(units));
        const Params kept = *apply_settings(
            usual, std::vector<std::string>{"depth.mapping=reversed", "depth.reversed_offset=false", "view.samples=0",
                                            "shadow.offset=polygon_offset", "depth.offset.factor=0",
                                            "depth.offset.units=0", "shadow.offset_factor=" + std::to_string(factor),
                                            "shadow.offset_units=" + std::to_string(units)});
        const Params without = *apply_settings(kept, std::vector<std::string>{"shadow.enabled=false"});
        const int shadow_px = pixels_beyond(draw(kept, scene, switches_px), draw(without, scene, switches_px), 8);
        EXPECT_EQ(shadow_px > 0, factor > 0.0) << shadow_px;
        const std::vector<Problem> problems = problems_of(kept, scene, switches_px);
        EXPECT_EQ(says(problems, "depth", "the offset keeps its sign"), *reported != '\0');
        EXPECT_TRUE(says(problems, "depth", reported) || *reported == '\0');
        EXPECT_FALSE(says(problems, "shadow", "pushes the shadow away"));
    }
}

TEST_F(Switches, DrawABusyStateWithoutErrors) {
    const Scene scene = scene_of({object("one", box_mesh(), {-1.0, 0.5, 0.5}), object("two", box_mesh(), {1, 1, -1})});
    for (const char* const buffers : {"view.samples=0", "depth.format=d16"}) {
        for (const char* const changed : switches) {
            const Params params = params_with(
                {buffers, changed, "reflection.bounces=2", "cull.enabled=true", R"(lights=[{"position":[1,2,1,0.4]}])",
                 R"(planes=[{"equation":[0,0,1,2.5],"extent":3},{"equation":[1,0,0.2,3],"extent":3,"gloss":true}])"});
            draw(params, scene, {48, 27});
        }
    }
}

}  // namespace
}  // namespace viewing
