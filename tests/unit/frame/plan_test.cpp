// The technique as data: the passes, the one field of one pass that each switch changes, and the invariants of every
// state.
#include "frame/plan/plan.h"

#include <algorithm>
#include <map>
#include <set>

#include "state/person/language.h"
#include "text/catalogue.h"
#include "unit/frame/frame_test.h"
#include "unit/geometry/random.h"
#include "unit/state/random_params.h"

namespace viewing {
namespace {

using testing::box_scene;
using testing::differences;
using testing::Names;
using testing::names_of_passes;
using testing::params_with;

FramePlan plan_of(const Params& params, bool clip_control = true) {
    return plan(params, derive(params, box_scene(), Viewport{{160, 90}, clip_control}));
}
FramePlan plan_with(const std::vector<std::string>& settings) {
    return plan_of(params_with(settings));
}

const Pass& pass_named(const FramePlan& frame, const std::string& name) {
    static const Pass missing;
    const auto found = std::find_if(frame.passes.begin(), frame.passes.end(),
                                    [&](const Pass& pass) { return say(pass.name) == name; });
    EXPECT_NE(found, frame.passes.end()) << name;
    return found == frame.passes.end() ? missing : *found;
}

/// Returns the names and reasons of the passes in the current language.
Names said_of(const FramePlan& frame) {
    Names said;
    for (const Pass& pass : frame.passes) said.insert(said.end(), {say(pass.name), say(pass.reason)});
    return said;
}

TEST(PlanPasses, DoNotDependOnTheLanguage) {
    const std::vector<std::string> several = {"lights=[{}]", "planes=[{\"mirrors\":true}]", "reflection.bounces=2",
                                              "shadow.style=missing_light", "depth.decals=stencil"};
    for (const std::vector<std::string>& settings : {std::vector<std::string>{}, several}) {
        const FramePlan english = plan_with(settings);
        const Names said = said_of(english);
        ASSERT_TRUE(speak(Language::ko));
        const FramePlan korean = plan_with(settings);
        const Names said_in_korean = said_of(english);
        speak_pseudo(std::vector<PoEntry>{{.english = "Objects", .translation = ""}});
        const FramePlan pseudo = plan_with(settings);
        EXPECT_NE(said_of(pseudo), said);
        ASSERT_TRUE(speak(Language::en));
        EXPECT_EQ(english, korean);
        EXPECT_EQ(english, pseudo);
        EXPECT_EQ(said, said_of(korean));
        for (std::size_t i = 0; i < said.size(); ++i) EXPECT_NE(said[i], said_in_korean[i]);
    }
}

TEST(PlanPasses, OfTheOpeningState) {
    const FramePlan frame = plan_of(Params{});
    EXPECT_EQ(names_of_passes(frame), (Names{"Mirror mask", "Mirror image", "Patch", "Shadow", "Objects"}));

    const Pass& mask = pass_named(frame, "Mirror mask");
    EXPECT_EQ(mask.subject, Subject::patch);
    EXPECT_FALSE(mask.color_write);
    EXPECT_FALSE(mask.depth.write);
    EXPECT_EQ(mask.stencil, (StencilState{true, CompareFunc::always, 1, StencilOp::replace}));

    const Pass& image = pass_named(frame, "Mirror image");
    EXPECT_TRUE(image.is_mirror_image);
    EXPECT_EQ(image.stencil, (StencilState{true, CompareFunc::equal, 1, StencilOp::keep, 0x0F}));
    EXPECT_EQ(image.cull.front_face, FrontFace::cw);
    EXPECT_EQ(image.lights_world, (std::vector<glm::dvec4>{{2.6, -5.2, 2.2, 1.0}}));
    EXPECT_EQ(image.sky_world, glm::dvec3(0, -1, 0));
    ASSERT_EQ(image.clip_planes.size(), 1U);
    EXPECT_EQ(image.clip_planes[0], glm::dvec4(0, 1, 0, 0));
    EXPECT_EQ(image.world_from_scene * glm::dvec4(1, 2, 3, 1), glm::dvec4(1, -2, 3, 1));

    const Pass& patch = pass_named(frame, "Patch");
    EXPECT_EQ(patch.subject, Subject::patch);
    EXPECT_EQ(patch.shading, Shading::lit);
    EXPECT_EQ(patch.blend, Blend::alpha);
    EXPECT_DOUBLE_EQ(patch.color.a, 0.7);  // 1 − reflectance
    EXPECT_EQ(patch.depth, (DepthState{true, CompareFunc::always, true}));
    EXPECT_FALSE(patch.cull.enabled);

    const Pass& shadow = pass_named(frame, "Shadow");
    EXPECT_EQ(shadow.shading, Shading::flat);
    EXPECT_EQ(shadow.color, glm::dvec4(0, 0, 0, 0.5));
    EXPECT_EQ(shadow.blend, Blend::alpha);
    EXPECT_FALSE(shadow.depth.write);
    EXPECT_EQ(shadow.stencil, (StencilState{true, CompareFunc::equal, 1, StencilOp::invert, 0x1F, 0x10}));
    ASSERT_TRUE(shadow.offset);
    EXPECT_EQ(*shadow.offset, (DepthOffset{-1, -1}));
    ASSERT_EQ(shadow.clip_planes.size(), 2U);
    EXPECT_EQ(shadow.clip_planes[0], glm::dvec4(0, 1, 0, 0));
    const glm::dvec4 below_light = shadow.clip_planes[1];  // the light is 5.2 above the plane
    EXPECT_GT(glm::dot(below_light, glm::dvec4(9, 5.19, -7, 1)), 0.0);
    EXPECT_LT(glm::dot(below_light, glm::dvec4(9, 5.2, -7, 1)), 0.0);

    const Pass& objects = pass_named(frame, "Objects");
    EXPECT_EQ(objects.world_from_scene, glm::dmat4(1.0));
    EXPECT_EQ(objects.depth, DepthState{});
    EXPECT_FALSE(objects.stencil.test);
    EXPECT_EQ(objects.blend, Blend::none);
    EXPECT_TRUE(objects.clip_planes.empty());
    EXPECT_FALSE(objects.offset);
}

TEST(PlanPasses, FollowTheSwitches) {
    struct Case {
        std::vector<std::string> settings;
        Names passes;
    };
    const Case cases[] = {
        {{"shadow.enabled=false"}, {"Mirror mask", "Mirror image", "Patch", "Objects"}},
        {{"reflection.enabled=false"}, {"Patch", "Shadow", "Objects"}},
        {{"reflection.bounces=0"}, {"Patch", "Shadow", "Objects"}},
        {{"plane.mirrors=false"}, {"Patch", "Shadow", "Objects"}},
        {{"plane.receives_shadow=false"}, {"Mirror mask", "Mirror image", "Patch", "Objects"}},
        {{"reflection.after_objects=true"},
         {"Objects", "Mirror mask", "Clear mirror", "Mirror image", "Patch", "Shadow"}},
        {{"lights=[{\"position\":[1,4,1,1]}]", "reflection.enabled=false"},
         {"Patch", "Shadow of light 1", "Shadow of light 2", "Objects"}},
        {{"lights=[{\"position\":[1,-4,1,1]}]", "reflection.enabled=false"}, {"Patch", "Shadow of light 1", "Objects"}},
        {{"lights=[{\"position\":[1,4,1,1]}]", "reflection.enabled=false", "shadow.style=missing_light"},
         {"Receiver mask", "Shadow mask of light 1", "Shadow mask of light 2", "Patch in the light",
          "Patch without light 1", "Patch without light 2", "Patch without light 1, 2", "Objects"}},
        {{"planes=[{\"equation\":[0,0,1,3]}]", "shadow.enabled=false"},
         {"Mirror mask 1", "Patch 2 in mirror 1", "Mirror image in mirror 1", "Patch 1", "Mirror mask 2",
          "Clear mirror", "Patch 1 in mirror 2", "Mirror image in mirror 2", "Patch 2", "Objects"}},
        {{"planes=[{\"equation\":[0,0,1,3],\"receives_shadow\":false,\"mirrors\":false}]"},
         {"Mirror mask 1", "Patch 2 in mirror 1", "Mirror image in mirror 1", "Patch 1", "Shadow", "Patch 2",
          "Objects"}},
        {{"reflection.enabled=false", "shadow.enabled=false"}, {"Patch", "Objects"}},
        {{"reflection.stencil=false"}, {"Mirror image", "Patch", "Shadow", "Objects"}},
        {{"shadow.style=missing_light"},
         {"Mirror mask", "Mirror image", "Shadow mask", "Patch in the light", "Patch in shadow", "Objects"}},
        {{"shadow.style=missing_light", "reflection.enabled=false"},
         {"Receiver mask", "Shadow mask", "Patch in the light", "Patch in shadow", "Objects"}},
        {{"shadow.style=missing_light", "reflection.stencil=false"},
         {"Mirror image", "Receiver mask", "Shadow mask", "Patch in the light", "Patch in shadow", "Objects"}},
        {{"light.position=[1,-4,1,1]"}, {"Mirror mask", "Mirror image", "Patch", "Objects"}},
        {{"light.position=[1,0,1,1]"}, {"Mirror mask", "Mirror image", "Patch", "Objects"}},
        {{"light.position=[1,0,1,0]"}, {"Mirror mask", "Mirror image", "Patch", "Objects"}},
        {{"camera.position=[3.9,-3,6.6]"}, {"Mirror mask", "Mirror image", "Patch", "Objects"}},
        {{"camera.position=[3.9,0,6.6]"}, {"Patch", "Objects"}},
    };
    for (const Case& each : cases) {
        std::string what;
        for (const std::string& setting : each.settings) what += setting + " ";
        EXPECT_EQ(names_of_passes(plan_with(each.settings)), each.passes) << what;
    }
}

TEST(PlanPasses, PatchFacingAwayFromTheLightIsUnlit) {
    EXPECT_EQ(pass_named(plan_with({"light.position=[1,-4,1,1]"}), "Patch").shading, Shading::unlit);
    EXPECT_EQ(pass_named(plan_with({"light.position=[1,0,1,1]"}), "Patch").shading, Shading::unlit);
    EXPECT_EQ(pass_named(plan_with({"camera.position=[3.9,-3,6.6]", "light.position=[1,-4,1,1]"}), "Patch").shading,
              Shading::lit);
}

/// Returns the field's name once for every pass, after the name of the pass, such as "Shadow.depth".
std::set<std::string> in_every_pass(const FramePlan& frame, const std::string& field) {
    std::set<std::string> keys;
    for (const Pass& pass : frame.passes) keys.insert(say(pass.name) + "." + field);
    return keys;
}

TEST(PlanSwitches, ChangeOnlyTheirOwnFields) {
    struct Case {
        std::vector<std::string> settings;
        std::set<std::string> changed;
    };
    const FramePlan opening = plan_of(Params{});
    const std::set<std::string> depth_everywhere = in_every_pass(opening, "depth");
    const std::set<std::string> depth_but_patch = {"Mirror mask.depth", "Mirror image.depth", "Shadow.depth",
                                                   "Objects.depth"};
    std::set<std::string> reversed = in_every_pass(opening, "clip_from_world");
    reversed.insert({"frame.clear_depth", "frame.depth_mapping", "frame.clip_zero_to_one", "Shadow.offset"});
    reversed.insert(depth_but_patch.begin(), depth_but_patch.end());
    const Case cases[] = {
        {{"depth.test=false"}, depth_everywhere},
        {{"depth.func=lequal"}, depth_but_patch},
        {{"depth.func=always"}, depth_but_patch},
        {{"depth.write=false"}, {"Mirror image.depth", "Patch.depth", "Objects.depth"}},
        {{"depth.clear=false"}, {"frame.clear_depth"}},
        {{"depth.format=d16"},
         {"frame.depth_format", "frame.stored_depth", "frame.samples"}},  // the stencil's substitute has no samples
        {{"depth.format=d32f"}, {"frame.depth_format", "frame.stored_depth"}},
        {{"depth.write_while_clearing=false"}, {"frame.mask_on_while_clearing"}},
        {{"depth.logarithm_per_vertex=true"}, {"frame.logarithm_per_vertex"}},
        {{"depth.reversed_clear=false", "depth.reversed_offset=false", "depth.reversed_zero_to_one=false"}, {}},
        {{"view.depth_colors=bands"}, {"frame.depth_colors"}},
        {{"view.depth_range=[1,9]"}, {"frame.shown_range"}},
        {{"view.call=2"}, {"frame.limit"}},
        {{"view.call=2", "view.triangle=5"}, {"frame.limit"}},
        {{"view.pixel=[3,4]"}, {}},
        {{"view.beside.shows=depth"}, {}},
        {{"coplanar.gap=1"}, {}},
        {{"animation.jiggle=true"}, {}},
        {{"depth.mapping=logarithmic"}, {"frame.depth_mapping", "frame.stored_depth"}},  // the shader adds the offset
        {{"depth.mapping=reversed"}, reversed},
        {{"depth.offset.factor=-2"}, {"frame.decal_offset"}},
        {{"cull.enabled=true"}, {"Mirror image.cull", "Objects.cull"}},
        {{"cull.face=front"}, {"Mirror image.cull", "Objects.cull"}},
        {{"cull.front_face=cw"}, {"Mirror image.cull", "Objects.cull"}},
        {{"shadow.color=#112233"}, {"Shadow.color"}},
        {{"shadow.opacity=0.75"}, {"Shadow.color"}},
        {{"shadow.stencil_once=false"}, {"Shadow.stencil"}},
        {{"shadow.clip_to_receiver=false"}, {"Shadow.stencil"}},
        {{"shadow.clip_to_receiver=false", "shadow.stencil_once=false"}, {"Shadow.stencil"}},
        {{"shadow.clip_casters=false"}, {"Shadow.clip_planes"}},
        {{"shadow.offset=none"}, {"Shadow.offset"}},
        {{"shadow.offset=lift"}, {"Shadow.offset", "Shadow.world_from_scene"}},
        {{"shadow.offset=no_depth_test"}, {"Shadow.offset", "Shadow.depth"}},
        {{"shadow.offset_factor=-3"}, {"Shadow.offset"}},
        {{"shadow.offset_units=-3"}, {"Shadow.offset"}},
        {{"shadow.lift=3"}, {}},
        {{"shadow.clip_at_light=false"}, {"Shadow.clip_planes"}},
        {{"shadow.sign=none"}, {}},
        {{"shadow.sign=none", "plane.equation=[0,-1,0,0]"}, {"Shadow.world_from_scene", "frame.caster_w"}},
        {{"shadow.sign=forced"}, {}},
        {{"shadow.sign=forced", "shadow.clip_at_light=false"}, {"Shadow.forces_sign", "Shadow.clip_planes"}},
        {{"shadow.write_depth=true"}, {"Shadow.depth"}},
        {{"shadow.own_stencil=false"}, {}},
        {{"plane.gloss=true"}, {"Mirror mask.has_gloss", "Patch.has_gloss"}},
        {{"reflection.bounces=5"}, {"frame.reflection_depth"}},
        {{"reflection.shadows=false", "reflection.same_projection=false"}, {}},
        {{"reflection.mirrored=camera"},
         {"Mirror image.clip_from_world", "Mirror image.view_from_world", "Mirror image.world_from_scene",
          "Mirror image.eye_world", "Mirror image.lights_world", "Mirror image.sky_world", "Mirror image.matrices"}},
        {{"reflection.fovy=20"}, {"Mirror image.clip_from_world", "Mirror image.matrices"}},
        {{"reflection.fovy=40"}, {}},
        {{"reflection.mask_writes_depth=true"}, {"Mirror mask.depth"}},
        {{"reflection.side_of_eye=false"}, {}},
        {{"reflection.side_of_eye=false", "plane.equation=[0,-1,0,0]"},
         {"Mirror image.clip_planes", "Shadow.matrices"}},
        {{"animation.light_orbit=true"}, {}},
        {{"view.pass=2"}, {"frame.limit"}},
        {{"view.shows=shadow_w"}, {"frame.shows", "Objects.shading"}},
        {{"reflection.reflectance=0.6"}, {"Patch.color"}},
        {{"reflection.clip=none"}, {"Mirror image.clip_planes"}},
        {{"reflection.clip=oblique"}, {"Mirror image.clip_planes", "Mirror image.clip_from_world"}},
        {{"reflection.flip_winding=false"}, {"Mirror image.cull"}},
        {{"reflection.reflect_light=false"}, {"Mirror image.lights_world", "Mirror image.sky_world"}},
        {{"view.shows=depth"}, {"frame.shows", "frame.samples"}},
        {{"view.shows=stencil"}, {"frame.shows", "frame.samples"}},
        {{"view.shows=facing"}, {"frame.shows", "Mirror image.shading", "Objects.shading"}},
        {{"view.depth_scale=window"}, {"frame.depth_scale"}},
        {{"view.samples=0"}, {"frame.samples"}},
        {{"ui.theme=light"}, {"frame.background", "frame.patch_colors", "frame.unwritten"}},
        {{"ui.theme=projector"}, {"frame.background", "frame.patch_colors", "frame.unwritten"}},
        {{"plane.extent=2"}, {"frame.patches"}},
        {{"camera.target=[1,1,1]"}, {}},
        {{"camera.navigation=walk"}, {}},
        {{"slips.walk_slows=true"}, {}},
        {{"observer.yaw=10"}, {}},
        {{"ui.scale=2"}, {}},
        {{"visibility.method=none"}, depth_everywhere},
    };
    for (const Case& each : cases) {
        std::string what;
        for (const std::string& setting : each.settings) what += setting + " ";
        EXPECT_EQ(differences(opening, plan_with(each.settings)), each.changed) << what;
    }
}

/// Returns a pass in which no member has its default value.
Pass other_pass() {
    return {.name = "Other",
            .reason = "is other",
            .subject = Subject::patch,
            .plane = 1,
            .light = 1,
            .chosen = Chosen::decals,
            .marks_objects = true,
            .shading = Shading::heat,
            .matrices = "I",
            .world_from_scene = glm::dmat4(2.0),
            .clip_from_world = glm::dmat4(2.0),
            .view_from_world = glm::dmat4(2.0),
            .is_mirror_image = true,
            .mirrors_met = {1},
            .clip_planes = {glm::dvec4(1.0)},
            .depth = {.test = false},
            .stencil = {.write_bits = 1},
            .cull = {.enabled = true},
            .blend = Blend::add,
            .color_write = false,
            .offset = DepthOffset{},
            .forces_sign = true,
            .has_gloss = true,
            .lights_world = {},
            .lights = {},
            .light_strength = 0.5,
            .eye_world = glm::dvec4(1.0),
            .sky_world = glm::dvec3(1.0),
            .color = glm::dvec4(1.0)};
}

/// Returns a plan in which no member except the passes has its default value.
FramePlan other_plan() {
    FramePlan other;
    other.background = other.unwritten = other.patch_light = other.patch_dark = other.patch_line = Color{1, 2, 3};
    other.clear_depth = other.mask_on_while_clearing = false;
    other.clear_depth_value = 0.0;
    other.depth_format = DepthFormat::d16;
    other.stored_depth.unit_codes = 4.0;
    other.depth_mapping = DepthMapping::reversed;
    other.logarithm_per_vertex = other.clip_zero_to_one = true;
    other.lens.far = 41.0;
    other.shows = Shows::depth;
    other.depth_scale = DepthScale::window;
    other.depth_colors = DepthColors::bands;
    other.shown_range = {1.0, 2.0};
    other.samples = 4;
    other.patches.resize(1);
    other.hidden.bounds_world.add(glm::dvec3(0.0));
    other.decal_offset = {1.0, 1.0};
    other.object_marks = {3};
    other.limit.pass = 0;
    other.reflection_depth = 1;
    other.heat = HeatMap{};
    other.caster_w = other.caster_side = glm::dvec4(1.0);
    return other;
}

TEST(PlanSwitches, CompareEveryMemberOfPassAndPlan) {
    FramePlan made, other = other_plan();
    made.passes.resize(1);
    made.passes.front().name = "Other";
    other.passes = made.passes;
    for (const testing::Member<FramePlan>& member : testing::plan_members()) {
        FramePlan changed = made;
        member.take(changed, other);
        EXPECT_FALSE(changed == made) << member.name;
        EXPECT_EQ(differences(made, changed), std::set<std::string>{"frame." + member.name});
    }
    other.passes = {other_pass()};
    for (const testing::Member<Pass>& member : testing::pass_members()) {
        FramePlan changed = made;
        member.take(changed.passes.front(), other.passes.front());
        EXPECT_FALSE(changed == made) << member.name;
        EXPECT_EQ(differences(made, changed), std::set<std::string>{"Other." + member.name});
    }
    EXPECT_EQ(differences(made, other).size(), testing::plan_members().size() + testing::pass_members().size())
        << "every member differs";
}

TEST(PlanSwitches, StencilOfTheShadow) {
    const auto stencil = [](const std::vector<std::string>& settings) {
        return pass_named(plan_with(settings), "Shadow").stencil;
    };
    EXPECT_EQ(stencil({"shadow.stencil_once=false"}),
              (StencilState{true, CompareFunc::equal, 1, StencilOp::keep, 0x0F}));
    EXPECT_EQ(stencil({"shadow.clip_to_receiver=false"}),
              (StencilState{true, CompareFunc::equal, 0, StencilOp::invert, 0x10, 0x10}));
    EXPECT_FALSE(stencil({"shadow.clip_to_receiver=false", "shadow.stencil_once=false"}).test);
}

TEST(PlanSwitches, LiftGoesTowardTheEye) {
    for (const char* const plane : {"plane.equation=[0,1,0,0]", "plane.equation=[0,-3,0,0]"}) {
        const FramePlan frame = plan_with({"shadow.offset=lift", "shadow.lift=0.25", plane});
        const glm::dvec4 lifted = pass_named(frame, "Shadow").world_from_scene * glm::dvec4(0.5, 1.0, 0.5, 1.0);
        EXPECT_GT(lifted.w, 0.0);
        EXPECT_NEAR(lifted.y / lifted.w, 0.25, 1e-12) << plane;
    }
}

TEST(PlanDepth, ReversedInvertsComparisonsOffsetsAndClear) {
    struct Case {
        const char *func, *standard, *reversed;
    };
    for (const Case& each : {Case{"never", "GL_NEVER", "GL_NEVER"},
                             {"less", "GL_LESS", "GL_GREATER"},
                             {"equal", "GL_EQUAL", "GL_EQUAL"},
                             {"lequal", "GL_LEQUAL", "GL_GEQUAL"},
                             {"greater", "GL_GREATER", "GL_LESS"},
                             {"notequal", "GL_NOTEQUAL", "GL_NOTEQUAL"},
                             {"gequal", "GL_GEQUAL", "GL_LEQUAL"},
                             {"always", "GL_ALWAYS", "GL_ALWAYS"}}) {
        const std::string func = std::string("depth.func=") + each.func;
        EXPECT_EQ(gl_name(pass_named(plan_with({func}), "Objects").depth.func), each.standard);
        EXPECT_EQ(gl_name(pass_named(plan_with({func, "depth.mapping=logarithmic"}), "Objects").depth.func),
                  each.standard);
        EXPECT_EQ(gl_name(pass_named(plan_with({func, "depth.mapping=reversed"}), "Objects").depth.func),
                  each.reversed);
    }
    const FramePlan standard = plan_with({"depth.offset.factor=-2", "depth.offset.units=3"});
    const FramePlan reversed = plan_with({"depth.offset.factor=-2", "depth.offset.units=3", "depth.mapping=reversed"});
    EXPECT_EQ(standard.clear_depth_value, 1.0);
    EXPECT_EQ(reversed.clear_depth_value, 0.0);
    EXPECT_EQ(standard.decal_offset, (DepthOffset{-2, 3}));
    EXPECT_EQ(reversed.decal_offset, (DepthOffset{2, -3}));
    EXPECT_EQ(*pass_named(reversed, "Shadow").offset, (DepthOffset{1, 1}));
}

TEST(PlanDepth, ReversedHasThreeSwitches) {
    const std::string reversed = "depth.mapping=reversed";
    const FramePlan right = plan_with({reversed});
    EXPECT_TRUE(right.clip_zero_to_one);
    EXPECT_EQ(differences(right, plan_with({reversed, "depth.reversed_clear=false"})),
              (std::set<std::string>{"frame.clear_depth"}));
    const FramePlan unturned = plan_with({reversed, "depth.reversed_offset=false", "depth.offset.units=3"});
    EXPECT_EQ(unturned.decal_offset, (DepthOffset{0, 3}));
    EXPECT_EQ(*pass_named(unturned, "Shadow").offset, (DepthOffset{-1, -1}));
    const FramePlan plain = plan_with({reversed, "depth.reversed_zero_to_one=false"});
    EXPECT_FALSE(plain.clip_zero_to_one);
    EXPECT_EQ(plain.passes.front().clip_from_world,
              plan_of(params_with({reversed}), false).passes.front().clip_from_world);
}

/// Returns a wall with two posters, one of them closer to the eye, and a box.
Scene scene_with_decals() {
    const Result<Scene> scene = load_scene(SceneSource(std::string("decals")), {});
    EXPECT_TRUE(scene);
    return *scene;
}

TEST(PlanDecals, HaveTheirOwnPassUnlessAnOffsetMovesThem) {
    const Scene scene = scene_with_decals();
    const auto frame_with = [&](const char* setting) {
        const Params params = params_with({setting, "depth.offset.units=-1"});
        return plan(params, derive(params, scene, Viewport{{160, 90}}));
    };
    EXPECT_EQ(names_of_passes(frame_with("depth.decals=offset")).back(), "Objects");
    const FramePlan equal = frame_with("depth.decals=equal");
    EXPECT_EQ(pass_named(equal, "Objects").chosen, Chosen::bases);
    const Pass& by_depth = pass_named(equal, "Decals");
    EXPECT_EQ(by_depth.chosen, Chosen::decals);
    EXPECT_EQ(by_depth.depth, (DepthState{true, CompareFunc::equal, false}));
    EXPECT_EQ(*by_depth.offset, DepthOffset{});

    const FramePlan stencil = frame_with("depth.decals=stencil");
    EXPECT_FALSE(pass_named(stencil, "Decals").depth.test);
    EXPECT_TRUE(pass_named(stencil, "Objects").marks_objects);
    // Walls, posters and posts alternate. A poster has only the mark of its own wall, and a post has none.
    ASSERT_EQ(stencil.object_marks.size(), 12U);
    std::set<int> marks;
    for (std::size_t wall = 0; wall < 12; wall += 3) {
        EXPECT_GT(stencil.object_marks[wall], 2);
        EXPECT_EQ(stencil.object_marks[wall + 1], stencil.object_marks[wall]);
        EXPECT_EQ(stencil.object_marks[wall + 2], 0);
        marks.insert(stencil.object_marks[wall]);
    }
    EXPECT_EQ(marks.size(), 4U);
}

TEST(PlanMirror, ObliqueNearPlaneIsTheMirror) {
    struct Case {
        std::vector<std::string> settings;
        bool clip_control;
        double near_end, far_end;
    };
    for (const Case& each :
         {Case{{}, true, -1.0, 1.0}, Case{{"depth.mapping=reversed"}, true, 1.0, 0.0},
          Case{{"depth.mapping=reversed"}, false, 1.0, -1.0}, Case{{"reflection.mirrored=camera"}, true, -1.0, 1.0}}) {
        std::vector<std::string> settings = each.settings;
        settings.emplace_back("reflection.clip=oblique");
        const FramePlan frame = plan_of(params_with(settings), each.clip_control);
        const Pass& image = pass_named(frame, "Mirror image");
        EXPECT_TRUE(image.clip_planes.empty());
        const auto ndc_z = [&](const glm::dvec3& point_scene) {
            const glm::dvec4 clip = image.clip_from_world * image.world_from_scene * glm::dvec4(point_scene, 1.0);
            return clip.z / clip.w;
        };
        EXPECT_NEAR(ndc_z({0.5, 0.0, 0.5}), each.near_end, 1e-12);
        EXPECT_NEAR(ndc_z({-2.0, 0.0, 1.0}), each.near_end, 1e-12);
        const double towards_far = each.far_end - each.near_end;
        EXPECT_GT((ndc_z({0.5, 0.5, 0.5}) - each.near_end) / towards_far, 0.0) << "kept above the mirror";
        EXPECT_LT((ndc_z({0.5, -0.5, 0.5}) - each.near_end) / towards_far, 0.0) << "clipped behind the mirror";
    }
}

TEST(PlanMirror, MirroredCameraSeesTheSameImage) {
    const Pass by_scene = pass_named(plan_with({"plane.equation=[0.3,1,0.2,0.5]"}), "Mirror image");
    const Pass by_camera =
        pass_named(plan_with({"plane.equation=[0.3,1,0.2,0.5]", "reflection.mirrored=camera"}), "Mirror image");
    const glm::dmat4 one = by_scene.clip_from_world * by_scene.world_from_scene;
    const glm::dmat4 other = by_camera.clip_from_world * by_camera.world_from_scene;
    EXPECT_EQ(by_camera.world_from_scene, glm::dmat4(1.0));
    EXPECT_NEAR(glm::determinant(by_camera.view_from_world), 1.0, 1e-9) << "a camera, not a mirror image of one";
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) EXPECT_NEAR(one[column][row], other[column][row], 1e-9);
}

TEST(PlanMirror, DepthIsLimitedByStencilAndImageCount) {
    const auto depth = [](const std::vector<std::string>& settings) {
        const Params params = params_with(settings);
        return reflection_depth(params, derive(params, box_scene(), Viewport{}));
    };
    const std::string two = "planes=[{\"equation\":[0,0,1,3]}]";
    const std::string three = "planes=[{\"equation\":[0,0,1,3]},{\"equation\":[1,0,0,3]}]";
    EXPECT_EQ(depth({}), 1);
    EXPECT_EQ(depth({"reflection.enabled=false"}), 0);
    EXPECT_EQ(depth({two, "reflection.bounces=16"}), 13);   // 4 bits: 15 values for 2 planes and 13 mirrors in a row
    EXPECT_EQ(depth({three, "reflection.bounces=16"}), 4);  // 3 (1 + 2 + 4 + 8) = 45 images; 93 at the next depth
    EXPECT_EQ(depth({two, "reflection.bounces=5", "visibility.method=painter"}), 1);
}

/// Replaces (−S) with S in the names of the products, because the same upload is (−S) for one sign of the plane and S
/// for the other.
FramePlan without_told_sign(FramePlan frame) {
    const std::string told = "(−S)";
    for (Pass& pass : frame.passes)
        if (const std::size_t at = pass.matrices.find(told); at != std::string::npos)
            pass.matrices.replace(at, told.size(), "S");
    return frame;
}

TEST(PlanPlane, SignAndLengthOfTheEquationDoNotMatter) {
    Random random(seed);
    for (int trial = 0; trial < 60; ++trial) {
        SCOPED_TRACE("seed " + std::to_string(seed) + " trial " + std::to_string(trial));
        Params params;
        params.camera.position = random.vec3(6);
        params.camera.yaw = random.number(-180, 180);
        params.projection.type = trial % 3 == 0 ? ProjectionType::orthographic : ProjectionType::perspective;
        params.lights.front().position = {random.vec3(6), trial % 2};
        params.planes.front().equation = {random.direction(), random.number(-2, 2)};
        params.shadow.offset = static_cast<ShadowOffset>(trial % 4);
        params.shadow.style = trial % 5 == 0 ? ShadowStyle::missing_light : ShadowStyle::blend;
        params.reflection.clip = static_cast<MirrorClip>(trial % 3);
        const FramePlan frame = without_told_sign(plan_of(params));
        for (const double factor : {-1.0, 2.0, -0.5}) {
            Params same = params;
            same.planes.front().equation *= factor;
            EXPECT_EQ(differences(frame, without_told_sign(plan_of(same))), std::set<std::string>{})
                << "times " << factor;
        }
    }
}

TEST(PlanObserver, IsPlainForAnyCamera) {
    const Params params = params_with({"depth.test=false", "cull.enabled=true", "depth.mapping=reversed",
                                       "view.shows=depth", "visibility.method=none", "reflection.clip=oblique"});
    const Derived derived = derive(params, box_scene(), Viewport{});
    const ObserverView observer = derive_observer(params.observer, Viewport{});
    const FramePlan frame = plan_observer(params, derived, observer);
    EXPECT_EQ(frame.shows, Shows::color);
    EXPECT_EQ(frame.depth_mapping, DepthMapping::standard);
    EXPECT_EQ(frame.clear_depth_value, 1.0);
    EXPECT_FALSE(frame.clip_zero_to_one);
    const Pass& objects = pass_named(frame, "Objects");
    EXPECT_EQ(objects.depth, DepthState{});
    EXPECT_FALSE(objects.cull.enabled);
    EXPECT_EQ(objects.eye_world, observer.eye_world);
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            EXPECT_NEAR(objects.clip_from_world[column][row], observer.clip_from_world[column][row], 1e-9);
    EXPECT_EQ(pass_named(frame, "Mirror image").clip_planes.size(), 1U);
}

TEST(PlanObserver, SeesTheSideOfTheObserver) {
    Params params;
    params.observer.pitch = 30.0;  // from below
    const Derived derived = derive(params, box_scene(), Viewport{});
    const FramePlan frame = plan_observer(params, derived, derive_observer(params.observer, Viewport{}));
    EXPECT_EQ(names_of_passes(frame), (Names{"Mirror mask", "Mirror image", "Patch", "Objects"}));
    EXPECT_EQ(pass_named(frame, "Patch").shading, Shading::unlit);
    EXPECT_EQ(pass_named(frame, "Mirror image").clip_planes.at(0), glm::dvec4(0, -1, 0, 0));
}

TEST(PlanEverything, StencilIsNeverTestedBeforeItIsMarked) {
    constexpr unsigned first_seed = 7400;
    for (unsigned run = 0; run < 300; ++run) {
        SCOPED_TRACE("seed " + std::to_string(first_seed + run));
        Params params = testing::RandomParams(first_seed + run).make();
        clamp_to_ranges(params);
        const FramePlan frame = plan_of(params, run % 2 == 0);
        // With a small raster, the frame shows only the results of the method.
        ASSERT_FALSE(frame.passes.empty() && !has_raster(params.visibility));
        // Methods that GL alone cannot draw have no results here and draw no objects; the heat map needs no results.
        const bool draws_objects =
            is_drawn_by_gl_alone(params.visibility.method) || params.view.shows == Shows::fighting;
        const bool has_objects = std::ranges::any_of(
            frame.passes, [](const Pass& pass) { return pass.name == "Objects" || pass.name == "Decals"; });
        EXPECT_EQ(has_objects, draws_objects);
        bool marked = false;
        int patches = 0;
        for (const Pass& pass : frame.passes) {
            EXPECT_FALSE(pass.reason.empty());
            EXPECT_LE(pass.clip_planes.size(), 2U);
            if (pass.stencil.test && pass.stencil.func == CompareFunc::equal && pass.stencil.reference != 0) {
                EXPECT_TRUE(marked) << say(pass.name);
            }
            marked |= pass.marks_objects;
            marked |= pass.subject == Subject::patch && pass.stencil.test && pass.stencil.func == CompareFunc::always &&
                      pass.stencil.on_pass == StencilOp::replace;
            if (pass.subject == Subject::patch && pass.color_write) ++patches;
            if (pass.subject == Subject::patch) {
                EXPECT_FALSE(pass.cull.enabled) << say(pass.name);
            }
            if (pass.is_mirror_image) {
                EXPECT_EQ(pass.cull.enabled, params.cull.enabled);
            }
            EXPECT_TRUE(!pass.depth.test || params.depth.test) << say(pass.name);
            EXPECT_TRUE(!pass.depth.write || params.depth.write) << say(pass.name);
        }
        if (params.view.shows != Shows::overdraw) {
            EXPECT_GE(patches, has_raster(params.visibility) ? 0 : 1) << "the patch is always drawn";
        }
    }
}

TEST(PlanCalls, ListTheChangesOfEachPass) {
    using Calls = std::vector<std::string>;
    const FramePlan frame =
        plan_with({"shadow.offset_factor=-1.5", "cull.enabled=true", "cull.face=front", "depth.func=lequal"});
    const auto calls_of = [&](std::size_t number) {
        return testing::said(
            gl_calls(frame, frame.passes.at(number), number == 0 ? first_gl_state() : frame.passes.at(number - 1)));
    };
    EXPECT_EQ(testing::said(clear_calls(frame)),
              (Calls{"glDisable(GL_DEPTH_TEST)", "glDisable(GL_CULL_FACE)", "glStencilMask(0xFF)", "glClearDepth(1.0)",
                     "glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT)"}));
    EXPECT_EQ(calls_of(0),  // the mask
              (Calls{"glEnable(GL_DEPTH_TEST)", "glDepthFunc(GL_LEQUAL)", "glDepthMask(GL_FALSE)",
                     "glEnable(GL_STENCIL_TEST)", "glStencilFunc(GL_ALWAYS, 1, 0xFF)",
                     "glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE)", "glStencilMask(0xFF)",
                     "glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE)", "glUniformMatrix4fv(clip_from_world, P V)",
                     "drawPatch()"}));
    EXPECT_EQ(calls_of(1),  // the image
              (Calls{"glDepthMask(GL_TRUE)", "glEnable(GL_CULL_FACE)", "glCullFace(GL_FRONT)", "glFrontFace(GL_CW)",
                     "glStencilFunc(GL_EQUAL, 1, 0x0F)", "glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP)",
                     "glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE)", "glEnable(GL_CLIP_DISTANCE0)",
                     "glUniform4f(clip_plane0, 0.0, 1.0, 0.0, 0.0)", "glUniformMatrix4fv(clip_from_world, P V R)",
                     "glUniform4f(light1, 2.6, -5.2, 2.2, 1.0)", "drawObjects()"}));
    EXPECT_EQ(calls_of(4),  // the objects, after the shadow
              (Calls{"glDepthMask(GL_TRUE)", "glEnable(GL_CULL_FACE)", "glCullFace(GL_FRONT)", "glFrontFace(GL_CCW)",
                     "glDisable(GL_STENCIL_TEST)", "glDisable(GL_BLEND)", "glDisable(GL_POLYGON_OFFSET_FILL)",
                     "glDisable(GL_CLIP_DISTANCE0)", "glDisable(GL_CLIP_DISTANCE1)",
                     "glUniformMatrix4fv(clip_from_world, P V)", "glUniform4f(light1, 2.6, 5.2, 2.2, 1.0)",
                     "drawObjects()"}));
}

/// The name of a product says which S or R is uploaded, for which plane and light, and with which sign.
TEST(PlanCalls, NameTheUploadedMatrices) {
    const auto products_of = [](const std::vector<std::string>& settings) {
        std::set<std::string> products;
        for (const Pass& pass : plan_with(settings).passes) products.insert(pass.matrices);
        return products;
    };
    using Products = std::set<std::string>;
    EXPECT_EQ(products_of({}), (Products{"P V", "P V R", "P V S"}));
    EXPECT_EQ(products_of({"plane.equation=[0,-1,0,0]"}), (Products{"P V", "P V R", "P V (−S)"}));
    EXPECT_EQ(products_of({"reflection.printed_by_rows=true"}), (Products{"P V", "P V Rᵀ", "P V S"}));
    EXPECT_EQ(products_of({"lights=[{\"position\":[-2,5,1,1]}]", "reflection.enabled=false"}),
              (Products{"P V", "P V S₁₁", "P V S₁₂"}));
    EXPECT_EQ(products_of({"planes=[{\"equation\":[0,0,1,3],\"receives_shadow\":false}]", "reflection.bounces=2",
                           "reflection.shadows=false"}),
              (Products{"I", "P V", "P V R₁", "P V R₂", "P V R₁ R₂", "P V R₂ R₁", "P V S₁₁"}));
}

TEST(PlanCalls, SetTheColors) {
    const FramePlan frame = plan_with({"shadow.opacity=0.25", "reflection.reflectance=0.3"});
    std::vector<std::string> all;
    for (std::size_t number = 0; number < frame.passes.size(); ++number)
        for (const std::string& call : testing::said(
                 gl_calls(frame, frame.passes[number], number == 0 ? first_gl_state() : frame.passes[number - 1])))
            all.push_back(call);
    const auto has = [&all](const char* call) { return std::ranges::find(all, call) != all.end(); };
    EXPECT_TRUE(has("glUniform4f(light1, 2.6, -5.2, 2.2, 1.0)")) << "R mirrors the light";
    EXPECT_TRUE(has("glUniform1f(alpha, 0.7)")) << "the mirror's own share";
    EXPECT_TRUE(has("glUniform4f(color, 0.0, 0.0, 0.0, 0.25)"));
}

/// Simulates a machine that executes the calls one by one.
TEST(PlanCalls, LeadFromEachPassToTheNext) {
    constexpr unsigned first_seed = 8100;
    for (unsigned run = 0; run < 100; ++run) {
        SCOPED_TRACE("seed " + std::to_string(first_seed + run));
        Params params = testing::RandomParams(first_seed + run).make();
        clamp_to_ranges(params);
        const FramePlan frame = plan_of(params);
        std::map<std::string, std::string> state;  // by the name of a call or a capability
        const auto obey = [&state](const std::string& call) {
            const std::size_t open = call.find('(');
            const std::string name = call.substr(0, open), value = call.substr(open + 1);
            if (name == "glEnable" || name == "glDisable")
                state[value] = name;
            else
                state[name] = value;
        };
        std::vector<Pass> passes = frame.passes;  // two frames: the second starts with the state left by the first
        passes.insert(passes.end(), frame.passes.begin(), frame.passes.end());
        Pass before;
        for (std::size_t number = 0; number < passes.size(); ++number) {
            if (number % frame.passes.size() == 0) {
                for (const std::string& call : testing::said(clear_calls(frame))) {
                    obey(call);
                    if (call.find("glClear(") != 0) continue;
                    EXPECT_TRUE(!state.contains("glStencilMask") || state["glStencilMask"] == "0xFF)");
                    EXPECT_TRUE(!state.contains("glColorMask") || state["glColorMask"].find("GL_FALSE") != 0);
                    EXPECT_EQ(state.contains("glDepthMask") && state["glDepthMask"] == "GL_FALSE)",
                              !frame.mask_on_while_clearing);
                }
                before = first_gl_state();
            }
            const Pass& pass = passes[number];
            for (const std::string& call : testing::said(gl_calls(frame, pass, before))) obey(call);
            const auto is_on = [&](const char* capability) {
                return state[std::string(capability) + ")"] == "glEnable";
            };
            EXPECT_EQ(is_on("GL_DEPTH_TEST"), pass.depth.test);
            EXPECT_EQ(is_on("GL_STENCIL_TEST"), pass.stencil.test);
            EXPECT_EQ(is_on("GL_BLEND"), pass.blend != Blend::none);
            EXPECT_EQ(is_on("GL_CULL_FACE"), pass.cull.enabled);
            EXPECT_EQ(is_on("GL_CLIP_DISTANCE0"), !pass.clip_planes.empty());
            EXPECT_EQ(state.contains("glColorMask") ? state["glColorMask"].find("GL_TRUE") == 0 : true,
                      pass.color_write);
            if (pass.depth.test) {
                EXPECT_EQ(state.contains("glDepthMask") ? state["glDepthMask"] == "GL_TRUE)" : true, pass.depth.write);
                EXPECT_EQ(state["glDepthFunc"], gl_name(pass.depth.func) + ")");
            }
            before = pass;
        }
    }
}

/// After casters are clipped at the light, w has one sign at all remaining points, so forcing the sign gives the right
/// frame.
TEST(Plan, ForcesTheSignOfTheWholeShadowWhereCastersAreClippedAtTheLight) {
    for (const char* const plane : {"plane.equation=[0,1,0,0]", "plane.equation=[0,-1,0,0]"})
        for (const char* const light : {"light.position=[2,5,2,1]", "light.position=[2,5,2,0]"})
            EXPECT_EQ(plan_with({plane, light, "shadow.sign=forced"}), plan_with({plane, light})) << plane << light;
}

/// A mirror's image with a fovy of its own is the image that a camera with that fovy would draw.
TEST(Plan, AMirrorsOwnFovyIsThatOfACameraWithThatFovy) {
    const auto image_of = [](const std::vector<std::string>& settings) {
        const Params params = testing::params_with(settings);
        const FramePlan frame = plan(params, derive(params, testing::box_scene(), {}));
        for (const Pass& pass : frame.passes)
            if (pass.is_mirror_image && pass.subject == Subject::objects) return pass;
        throw std::runtime_error("no image");
    };
    for (const std::string fovy : {"20", "75"})
        for (const std::string mirrored : {"scene", "camera"}) {
            const Pass own = image_of({"reflection.fovy=" + fovy, "reflection.mirrored=" + mirrored});
            const Pass camera = image_of({"projection.fovy=" + fovy, "reflection.mirrored=" + mirrored});
            for (int column = 0; column < 4; ++column)
                EXPECT_LT(glm::length(own.clip_from_world[column] - camera.clip_from_world[column]), 1e-12);
            EXPECT_EQ(own.matrices, mirrored == "scene" ? "P′ V R" : "F P′ F V R");
        }
}

}  // namespace
}  // namespace viewing
