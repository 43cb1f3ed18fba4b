// Shared by the tests of derive() and plan(): scenes without files, presets with their scenes, states from settings,
// and the complete list of members in which two frame plans can differ.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "frame/problems.h"
#include "geometry/shapes.h"
#include "state/file/state_json.h"
#include "state/presets.h"
#include "state/scene.h"

namespace viewing::testing {

/// Makes an object without reading a file.
inline SceneObject object(const std::string& name, Mesh mesh, const glm::dvec3& position,
                          const glm::dvec3& scale = glm::dvec3(1.0)) {
    ObjectDescription description;
    description.name = name;
    description.position = position;
    description.scale = scale;
    return {description, std::make_shared<const Mesh>(std::move(mesh)), world_from_model(position, {}, scale)};
}

inline Scene scene_of(std::vector<SceneObject> objects) {
    Scene scene;
    scene.objects = std::move(objects);
    for (const SceneObject& placed : scene.objects)
        for (const glm::vec3& vertex : placed.mesh->positions)
            scene.bounds_world.add(glm::dvec3(placed.world_from_model * glm::dvec4(vertex, 1.0)));
    return scene;
}

/// Returns a box of side 2 that reaches from y = 0 to y = 2.
inline Scene box_scene() {
    return scene_of({object("box", box_mesh(), {0.0, 1.0, 0.0})});
}

/// Applies command-line settings to the opening state.
inline Params params_with(const std::vector<std::string>& settings) {
    const Result<Params> params = apply_settings(Params{}, settings);
    EXPECT_TRUE(params) << params.error();
    return *params;
}

/// Returns the messages in the current language.
inline std::vector<std::string> said(const std::vector<Message>& messages) {
    std::vector<std::string> all;
    for (const Message& message : messages) all.push_back(say(message));
    return all;
}

/// A preset with its scene.
struct LoadedPreset {
    Params params;
    Scene scene;
};
inline LoadedPreset preset_named(const std::string& name) {
    const Result<LoadedState> state = load_state(name);
    EXPECT_TRUE(state) << state.error();
    const Result<Scene> scene = load_scene(state->params.scene, state->base, state->params.coplanar);
    EXPECT_TRUE(scene) << scene.error();
    return {state->params, *scene};
}

inline std::vector<Problem> problems_of(const Params& params, const Scene& scene, const Viewport& viewport = {}) {
    const Derived derived = derive(params, scene, viewport);
    return find_problems(params, derived, scene, plan(params, derived));
}

using Names = std::vector<std::string>;
inline Names names_of_passes(const FramePlan& frame) {
    Names names;
    for (const Pass& pass : frame.passes) names.push_back(say(pass.name));
    return names;
}

inline bool says(const std::vector<Problem>& problems, std::string_view group, const std::string& words) {
    return std::any_of(problems.begin(), problems.end(), [&](const Problem& problem) {
        return problem.group == group && say(problem.sentence).find(words) != std::string::npos;
    });
}

/// A named group of members of a pass or a plan.
template <typename Whole>
struct Member {
    std::string name;
    std::function<bool(const Whole&, const Whole&)> is_same;
    std::function<void(Whole&, const Whole&)> take;  ///< copies these members from the second to the first
};

template <typename Whole, typename... Type>
Member<Whole> member(std::string name, Type Whole::*... members) {
    return {std::move(name), [=](const Whole& a, const Whole& b) { return ((a.*members == b.*members) && ...); },
            [=](Whole& to, const Whole& from) { ((to.*members = from.*members), ...); }};
}

/// Lists all members of a pass except its name.
inline const std::vector<Member<Pass>>& pass_members() {
    static const std::vector<Member<Pass>> members = {
        member("reason", &Pass::reason),
        member("subject", &Pass::subject),
        member("plane", &Pass::plane),
        member("light", &Pass::light),
        member("chosen", &Pass::chosen),
        member("marks_objects", &Pass::marks_objects),
        member("shading", &Pass::shading),
        member("matrices", &Pass::matrices),
        member("world_from_scene", &Pass::world_from_scene),
        member("clip_from_world", &Pass::clip_from_world),
        member("view_from_world", &Pass::view_from_world),
        member("is_mirror_image", &Pass::is_mirror_image),
        member("mirrors_met", &Pass::mirrors_met),
        member("clip_planes", &Pass::clip_planes),
        member("depth", &Pass::depth),
        member("stencil", &Pass::stencil),
        member("cull", &Pass::cull),
        member("blend", &Pass::blend),
        member("color_write", &Pass::color_write),
        member("offset", &Pass::offset),
        member("forces_sign", &Pass::forces_sign),
        member("has_gloss", &Pass::has_gloss),
        member("lights_world", &Pass::lights_world),
        member("lights", &Pass::lights),
        member("light_strength", &Pass::light_strength),
        member("eye_world", &Pass::eye_world),
        member("sky_world", &Pass::sky_world),
        member("color", &Pass::color),
    };
    return members;
}

/// Lists all members of a plan except its passes.
inline const std::vector<Member<FramePlan>>& plan_members() {
    static const std::vector<Member<FramePlan>> members = {
        member("background", &FramePlan::background),
        member("unwritten", &FramePlan::unwritten),
        member("patch_colors", &FramePlan::patch_light, &FramePlan::patch_dark, &FramePlan::patch_line),
        member("clear_depth", &FramePlan::clear_depth, &FramePlan::clear_depth_value),
        member("mask_on_while_clearing", &FramePlan::mask_on_while_clearing),
        member("depth_format", &FramePlan::depth_format),
        member("stored_depth", &FramePlan::stored_depth),
        member("depth_mapping", &FramePlan::depth_mapping),
        member("logarithm_per_vertex", &FramePlan::logarithm_per_vertex),
        member("lens", &FramePlan::lens),
        member("clip_zero_to_one", &FramePlan::clip_zero_to_one),
        member("shows", &FramePlan::shows),
        member("depth_scale", &FramePlan::depth_scale),
        member("depth_colors", &FramePlan::depth_colors),
        member("shown_range", &FramePlan::shown_range),
        member("samples", &FramePlan::samples),
        member("patches", &FramePlan::patches),
        member("hidden", &FramePlan::hidden),
        member("decal_offset", &FramePlan::decal_offset),
        member("object_marks", &FramePlan::object_marks),
        member("limit", &FramePlan::limit),
        member("heat", &FramePlan::heat),
        member("caster_w", &FramePlan::caster_w),
        member("caster_side", &FramePlan::caster_side),
        member("reflection_depth", &FramePlan::reflection_depth),
    };
    return members;
}

/// Returns the members that must be copied from `b` to `a` to make both equal, such as "frame.samples" and
/// "Shadow.stencil". If the names of the passes differ, the result includes "frame.passes".
inline std::set<std::string> differences(const FramePlan& a, const FramePlan& b) {
    std::set<std::string> differing;
    FramePlan changed = a;
    for (const Member<FramePlan>& each : plan_members()) {
        if (each.is_same(a, b)) continue;
        differing.insert("frame." + each.name);
        each.take(changed, b);
    }
    const auto has_same_name = [](const Pass& x, const Pass& y) { return x.name == y.name; };
    if (!std::equal(a.passes.begin(), a.passes.end(), b.passes.begin(), b.passes.end(), has_same_name)) {
        differing.insert("frame.passes");
        changed.passes = b.passes;
    }
    for (std::size_t index = 0; index < changed.passes.size(); ++index) {
        Pass& pass = changed.passes[index];
        for (const Member<Pass>& each : pass_members()) {
            if (each.is_same(pass, b.passes[index])) continue;
            differing.insert(say(pass.name) + "." + each.name);
            each.take(pass, b.passes[index]);
        }
    }
    EXPECT_TRUE(changed == b) << "the lists of frame_test.h lack a member of Pass or FramePlan";
    return differing;
}

}  // namespace viewing::testing
