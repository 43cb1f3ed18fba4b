// What the tests of derive and plan share: scenes without files, states from settings, and a frame plan written out as
// text, field by field, so that two plans can be compared by what is in them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "frame/problems.h"
#include "geometry/shapes.h"
#include "state/json.h"

namespace viewing::testing {

/// An object without files.
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

/// A unit box from y = 0 to y = 2, its vertices known from shapes.cpp only by their position.
inline Scene box_scene() {
    return scene_of({object("box", box_mesh(), {0.0, 1.0, 0.0})});
}

/// The opening state with settings as on the command line.
inline Params params_with(const std::vector<std::string>& settings) {
    const Result<Params> params = apply_settings(Params{}, settings);
    EXPECT_TRUE(params) << params.error();
    return *params;
}

inline std::vector<Problem> problems_of(const Params& params, const Scene& scene, const Viewport& viewport = {}) {
    const Derived derived = derive(params, scene, viewport);
    return find_problems(params, derived, scene, plan(params, derived));
}

inline bool says(const std::vector<Problem>& problems, std::string_view group, const std::string& words) {
    return std::any_of(problems.begin(), problems.end(), [&](const Problem& problem) {
        return problem.group == group && problem.sentence.find(words) != std::string::npos;
    });
}

inline std::string text_of(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", value + 0.0);  // + 0: a negative zero is a zero
    return text;
}

template <typename Vector>
std::string text_of_vector(const Vector& vector) {
    std::string text;
    for (int i = 0; i < Vector::length(); ++i) text += text_of(vector[i]) + " ";
    return text;
}

inline std::string text_of_matrix(const glm::dmat4& matrix) {
    std::string text;
    for (int column = 0; column < 4; ++column) text += text_of_vector(matrix[column]) + "| ";
    return text;
}

/// "Shadow.stencil" → its value, for every field of every pass, and "frame.…" for what the frame itself holds.
inline std::map<std::string, std::string> fields_of(const FramePlan& plan) {
    std::map<std::string, std::string> fields;
    const auto color = [](const Color& c) {
        return std::to_string(c.r) + " " + std::to_string(c.g) + " " + std::to_string(c.b);
    };
    const auto offset = [](const DepthOffset& o) { return text_of(o.factor) + " " + text_of(o.units); };
    std::string names;
    for (const Pass& pass : plan.passes) names += (names.empty() ? "" : ", ") + pass.name;
    fields["frame.passes"] = names;
    fields["frame.background"] = color(plan.background);
    fields["frame.patch_colors"] =
        color(plan.patch_light) + " " + color(plan.patch_dark) + " " + color(plan.patch_line);
    fields["frame.clear_depth"] = std::to_string(plan.clear_depth) + " " + text_of(plan.clear_depth_value);
    fields["frame.depth_format"] = std::to_string(static_cast<int>(plan.depth_format));
    fields["frame.depth_mapping"] = std::to_string(static_cast<int>(plan.depth_mapping));
    fields["frame.lens"] = std::to_string(plan.lens.orthographic) + " " + text_of(plan.lens.fovy_deg) + " " +
                           text_of(plan.lens.height) + " " + text_of(plan.lens.near) + " " + text_of(plan.lens.far);
    fields["frame.clip_zero_to_one"] = std::to_string(plan.clip_zero_to_one);
    fields["frame.shows"] = std::to_string(static_cast<int>(plan.shows));
    fields["frame.mask_on_while_clearing"] = std::to_string(plan.mask_on_while_clearing);
    fields["frame.logarithm_per_vertex"] = std::to_string(plan.logarithm_per_vertex);
    fields["frame.depth_colors"] = std::to_string(static_cast<int>(plan.depth_colors));
    fields["frame.limit"] = std::to_string(plan.limit.call) + " " + std::to_string(plan.limit.triangles) + " " +
                            std::to_string(plan.limit.pass);
    fields["frame.shown_range"] = text_of(plan.shown_range.x) + " " + text_of(plan.shown_range.y);
    fields["frame.depth_scale"] = std::to_string(static_cast<int>(plan.depth_scale));
    fields["frame.samples"] = std::to_string(plan.samples);
    for (const PlanePatch& patch : plan.patches)
        fields["frame.patches"] += text_of_matrix(patch.world_from_patch()) + text_of(patch.extent);
    fields["frame.decal_offset"] = offset(plan.decal_offset);
    for (const Pass& pass : plan.passes) {
        const std::string of = pass.name + ".";
        fields[of + "subject"] = std::to_string(static_cast<int>(pass.subject));
        fields[of + "shading"] = std::to_string(static_cast<int>(pass.shading));
        fields[of + "world_from_scene"] = text_of_matrix(pass.world_from_scene);
        fields[of + "clip_from_world"] = text_of_matrix(pass.clip_from_world);
        fields[of + "view_from_world"] = text_of_matrix(pass.view_from_world);
        fields[of + "is_mirror_image"] = std::to_string(pass.is_mirror_image);
        std::string planes;
        for (const ClipPlane& plane : pass.clip_planes) planes += text_of_vector(plane) + "| ";
        fields[of + "clip_planes"] = planes;
        fields[of + "depth"] =
            std::to_string(pass.depth.test) + " " + gl_name(pass.depth.func) + " " + std::to_string(pass.depth.write);
        fields[of + "stencil"] = std::to_string(pass.stencil.test) + " " + gl_name(pass.stencil.func) + " " +
                                 std::to_string(pass.stencil.reference) + " " +
                                 std::to_string(static_cast<int>(pass.stencil.on_pass)) + " " +
                                 std::to_string(pass.stencil.read_bits) + " " + std::to_string(pass.stencil.write_bits);
        fields[of + "cull"] =
            std::to_string(pass.cull.enabled) + " " + gl_name(pass.cull.face) + " " + gl_name(pass.cull.front_face);
        fields[of + "blend"] = std::to_string(static_cast<int>(pass.blend));
        fields[of + "color_write"] = std::to_string(pass.color_write);
        fields[of + "offset"] = pass.offset ? offset(*pass.offset) : "none";
        for (const glm::dvec4& light : pass.lights_world) fields[of + "lights_world"] += text_of_vector(light);
        fields[of + "light_strength"] = text_of(pass.light_strength);
        fields[of + "forces_sign"] = std::to_string(pass.forces_sign);
        fields[of + "has_gloss"] = std::to_string(pass.has_gloss);
        fields[of + "eye_world"] = text_of_vector(pass.eye_world);
        fields[of + "sky_world"] = text_of_vector(pass.sky_world);
        fields[of + "color"] = text_of_vector(pass.color);
    }
    return fields;
}

/// The keys of fields_of() whose values are not the same in both, or that only one of them has.
inline std::set<std::string> differences(const FramePlan& a, const FramePlan& b) {
    const std::map<std::string, std::string> in_a = fields_of(a), in_b = fields_of(b);
    std::set<std::string> differing;
    for (const auto& [key, value] : in_a)
        if (const auto found = in_b.find(key); found == in_b.end() || found->second != value) differing.insert(key);
    for (const auto& [key, value] : in_b)
        if (!in_a.contains(key)) differing.insert(key);
    return differing;
}

}  // namespace viewing::testing
