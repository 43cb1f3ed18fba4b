// A field reported as having no effect has none: changing its value leaves the frame's plan or the picture identical,
// byte for byte.
#include "frame/effect.h"

#include <algorithm>

#include "gl/gl_test.h"
#include "state/fields.h"
#include "state/presets.h"
#include "topics/hidden/numbers/hidden_views.h"

namespace viewing {
namespace {

constexpr glm::ivec2 effect_px{120, 80};

class Effect : public testing::GlTest {
protected:
    static LoadedState state_of(const std::string& name, const std::vector<std::string>& settings) {
        Result<LoadedState> state = load_state(name);
        EXPECT_TRUE(state) << state.error();
        const Result<Params> params = apply_settings(state->params, settings);
        EXPECT_TRUE(params) << params.error();
        state->params = *params;
        return *std::move(state);
    }
    static Scene scene_for(const Params& params) {
        const Result<Scene> scene = load_scene(params.scene, "", params.coplanar);
        EXPECT_TRUE(scene) << scene.error();
        return *scene;
    }
    static FramePlan plan_of(const Params& params, const Scene& scene) {
        const Derived derived = derive_for(params, scene, effect_px);
        const std::optional<HiddenQuestion> question = hidden_question(params, derived, effect_px);
        if (!question) return plan(params, derived);
        HiddenSurfaceSolver solver(scene);
        return plan(params, derived, answer_hidden_question(solver, *question).pictures);
    }
    static Image picture_of(const Params& params) {
        const Scene scene = scene_for(params);
        return draw(plan_of(params, scene), scene, effect_px);
    }
    /// Returns whether the change is visible in the camera's picture.
    static bool has_effect(const Params& before, const Params& after) {
        const Scene scene = scene_for(before), scene_after = scene_for(after);
        const FramePlan a = plan_of(before, scene), b = plan_of(after, scene_after);
        return a != b && draw(a, scene, effect_px) != draw(b, scene_after, effect_px);
    }
};

/// Returns states with other values of the field: each other value of an enumeration, the opposite of a switch, or
/// three numbers or colors. There are none for fields with their own widget.
std::vector<Params> with_other_values(const Params& params, const Field& field) {
    std::vector<Params> others;
    const auto other = [&](const auto& change) {
        Params changed = params;
        change(changed);
        if (changed != params) others.push_back(changed);
    };
    Params copy = params;
    const FieldRef ref = field.in(copy);
    if (std::holds_alternative<bool*>(ref))
        other([&](Params& p) { *std::get<bool*>(field.in(p)) = !*std::get<bool*>(ref); });
    if (const auto* choice = std::get_if<EnumRef>(&ref))
        for (int index = 0; index < static_cast<int>(choice->names.size()); ++index)
            other([&](Params& p) { std::get<EnumRef>(field.in(p)).set(index); });
    for (const double share : {0.03, 0.4, 0.9}) {
        const bool is_wide = field.max - field.min > 1e3;
        const double value =
            is_wide ? (field.logarithmic ? 20.0 * share : 20.0 * share - 10.0) : std::lerp(field.min, field.max, share);
        if (std::holds_alternative<double*>(ref)) other([&](Params& p) { *std::get<double*>(field.in(p)) = value; });
        if (std::holds_alternative<int*>(ref))
            other([&](Params& p) { *std::get<int*>(field.in(p)) = static_cast<int>(std::lround(value)); });
        if (std::holds_alternative<Color*>(ref))
            other([&](Params& p) {
                *std::get<Color*>(field.in(p)) = {static_cast<std::uint8_t>(255.0 * share), 9, 7};
            });
    }
    return others;
}

struct Case {
    const char* preset;
    std::vector<std::string> settings;
};

TEST_F(Effect, FieldsReportedWithoutEffectHaveNone) {
    const Case cases[] = {{"opening", {}},
                          {"opening", {"projection.type=orthographic", "depth.test=false"}},
                          {"opening", {"shadow.enabled=false", "reflection.enabled=false"}},
                          {"opening", {"plane.receives_shadow=false", "plane.mirrors=false"}},
                          {"opening", {"shadow.style=missing_light", "cull.enabled=true"}},
                          {"opening", {"shadow.offset=lift", "view.shows=depth"}},
                          {"opening", {"shadow.offset=none", "view.shows=facing"}},
                          {"opening", {"depth.clear=false", "view.shows=stencil"}},
                          {"opening", {"reflection.mirrored=camera", "depth.mapping=reversed", "depth.format=d32f"}},
                          {"opening", {"depth.mapping=logarithmic", "view.shows=overdraw"}},
                          {"room", {}},
                          {"mirrors-facing-once", {}},
                          {"tilted-plane", {"reflection.clip=oblique"}},
                          {"fighting-offset", {}},
                          {"fighting-decals-stencil", {}},
                          {"coplanar", {"view.shows=fighting"}},
                          {"painter-cycle", {}},
                          {"newell-cycle", {"depth.test=false"}},
                          {"bsp-walk", {}},
                          {"ray-cast-curved", {"cull.enabled=true"}}};
    int asked = 0;
    for (const auto& [preset, settings] : cases) {
        const Params params = state_of(preset, settings).params;
        const Scene scene = scene_for(params);
        const FramePlan frame = plan_of(params, scene);
        const Image picture = draw(frame, scene, effect_px);
        for (const Field& field : fields()) {
            const std::string_view why = why_without_effect(params, &scene, field.path);
            if (why.empty()) continue;
            for (const Params& changed : with_other_values(params, field)) {
                ++asked;
                const Scene other_scene = changed.coplanar == params.coplanar ? scene : scene_for(changed);
                const FramePlan other = plan_of(changed, other_scene);
                if (other == frame) continue;
                EXPECT_EQ(draw(other, other_scene, effect_px), picture)
                    << preset << " with " << (settings.empty() ? "" : settings.front()) << ": " << field.path
                    << " has an effect, but is reported: " << why;
            }
        }
    }
    EXPECT_GT(asked, 500);
}

TEST_F(Effect, FieldsWithAnEffectAreNotReported) {
    const Params opening = state_of("opening", {}).params;
    const Scene scene = scene_for(opening);
    for (const char* path : {"projection.fovy", "depth.test", "depth.mapping", "cull.enabled", "shadow.opacity",
                             "shadow.enabled", "reflection.reflectance", "reflection.enabled", "view.shows"}) {
        EXPECT_EQ(why_without_effect(opening, &scene, path), "") << path;
        const std::vector<Params> others = with_other_values(opening, field(path));
        EXPECT_TRUE(std::any_of(others.begin(), others.end(), [&](const Params& changed) {
            return has_effect(opening, changed);
        })) << path;
    }
}

TEST_F(Effect, FollowingTheAdviceMakesTheFieldEffective) {
    const Params orbits = testing::params_with({"camera.navigation=orbit"});
    EXPECT_EQ(why_without_effect(orbits, nullptr, "slips.pole_flip"), "");
    EXPECT_NE(why_without_effect(orbits, nullptr, "slips.walk_slows"), "");
    const Params decals = state_of("fighting-offset", {}).params;
    const Scene scene = scene_for(decals), opening = scene_for(Params{});
    EXPECT_EQ(why_without_effect(decals, &scene, "depth.offset.units"), "");
    EXPECT_NE(why_without_effect(decals, &opening, "depth.offset.units"), "");
    EXPECT_EQ(why_without_effect(testing::params_with({"scene=coplanar"}), nullptr, "coplanar.gap"), "");
}

}  // namespace
}  // namespace viewing
