// matrices: every matrix of the lecture with its numbers, no GL needed.
#include <array>
#include <utility>

#include "cli/as_json.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/state_arguments.h"
#include "cli/values.h"
#include "frame/matrix_facts.h"
#include "frame/matrix_text.h"

namespace viewing {
namespace {

constexpr std::array format_names{"json", "text", "latex", "glm", "glsl", "numpy", "matlab"};
constexpr std::array formats{MatrixFormat::text, MatrixFormat::latex, MatrixFormat::glm,
                             MatrixFormat::glsl, MatrixFormat::numpy, MatrixFormat::matlab};

/// Of S and R: those of the first plane and light.
Json facts_as_json(const Facts& facts, const glm::dmat4& mirror, const CastShadow& cast) {
    const glm::dmat4& shadow = cast.shadowed_world_from_world;
    return {{"plane_dot_light", cast.plane_dot_light + 0.0},
            {"det_mirror", glm::determinant(mirror)},
            {"rank_shadow", rank_of(shadow)},
            {"depth_step_at_target", facts.depth_step_at_target},
            {"resolvable_step_at_target", facts.resolvable_step_at_target},
            {"target_distance", facts.target_distance},
            {"det_shadow", glm::determinant(shadow) + 0.0},
            {"shadow_residual", shadow_residual(shadow, cast.plane_dot_light)},
            {"mirror_residual", mirror_residual(mirror)},
            {"view_residual", facts.view_residual}};
}

Json followed_as_json(const FollowedPoint& followed) {
    return {{"point", as_json(followed.point_world)},
            {"shadow", followed.shadow_world ? as_json(*followed.shadow_world) : Json()},
            {"plane_distance", followed.plane_distance + 0.0},
            {"foot", as_json(followed.foot_world)},
            {"mirrored", as_json(followed.mirrored_world)}};
}

/// S and R of each plane, each S of one light: the first ones are those above.
Json planes_as_json(const Derived& derived) {
    Json planes = Json::array();
    for (const DerivedPlane& plane : derived.planes) {
        Json shadows = Json::array();
        for (const CastShadow& cast : plane.shadows)
            shadows.push_back({{"light", as_json(cast.light_world)},
                               {"shadow_from_world", as_json(cast.shadowed_world_from_world)},
                               {"shadow_sign", static_cast<int>(cast.sign)}});
        planes.push_back({{"equation", as_json(plane.unit_plane)},
                          {"mirror_from_world", as_json(plane.mirrored_world_from_world)},
                          {"shadows", std::move(shadows)}});
    }
    return planes;
}

Json all_as_json(const Derived& derived, const std::vector<Problem>& problems) {
    const glm::dmat4& mirror = derived.planes.front().mirrored_world_from_world;
    const CastShadow& cast = derived.planes.front().shadows.front();
    Json all{{"world_from_view", as_json(derived.world_from_view)},
             {"view_from_world", as_json(derived.view_from_world)},
             {"clip_from_view", as_json(derived.clip_from_view)},
             {"clip_from_world", as_json(derived.clip_from_world)},
             {"shadow_from_world", as_json(cast.shadowed_world_from_world)},
             {"shadow_sign", static_cast<int>(cast.sign)},
             {"mirror_from_world", as_json(mirror)},
             {"facts", facts_as_json(derived.facts, mirror, cast)},
             {"planes", planes_as_json(derived)},
             {"problems", as_json(problems)}};
    if (derived.followed) all["followed"] = followed_as_json(*derived.followed);
    return all;
}

std::string all_as_text(const Derived& derived, const std::vector<Problem>& problems, MatrixFormat format) {
    const DerivedPlane& plane = derived.planes.front();
    const CastShadow& cast = plane.shadows.front();
    const std::array named{std::pair("world_from_view", &derived.world_from_view),
                           std::pair("view_from_world", &derived.view_from_world),
                           std::pair("clip_from_view", &derived.clip_from_view),
                           std::pair("clip_from_world", &derived.clip_from_world),
                           std::pair("shadow_from_world", &cast.shadowed_world_from_world),
                           std::pair("mirror_from_world", &plane.mirrored_world_from_world)};
    std::string text = format == MatrixFormat::numpy ? "import numpy as np\n\n" : "";
    for (const auto& [name, matrix] : named)
        text += (name == named.front().first ? "" : "\n") + matrix_text(name, *matrix, format);
    if (format != MatrixFormat::text) return text;
    text += "\nshadow_sign = " + std::string(cast.sign < 0.0 ? "-1" : "1") + "\n";
    for (const Problem& problem : problems) text += problem.sentence + "\n";
    return text;
}

ExitStatus run(const Command& self, const Arguments& arguments) {
    Options options(self);
    const StateArguments state_arguments(options);
    std::optional<std::string> size, format;
    options.group("Output");
    options.text("--size", "WxH", size,
                 "Size of the picture in pixels, whose aspect the projection has; default 1280x720");
    options.text(
        "--format", "FORMAT", format,
        "json (default), text, latex, numpy, matlab: rows as on the slides; glm, glsl: columns first, as their "
        "constructors take them");
    if (!options.parse(arguments)) return ExitStatus::done;

    const std::size_t chosen = choice_option(options, "--format", format.value_or("json"), format_names);
    const Viewport viewport{size_option(options, size)};
    const LoadedState state = state_arguments.load();
    const Scene scene = scene_of(state);
    const Derived derived = derive(state.params, scene, viewport);
    const std::vector<Problem> problems = find_problems(state.params, derived, scene, plan(state.params, derived));
    print(chosen == 0 ? print_document(all_as_json(derived, problems)) + "\n"
                      : all_as_text(derived, problems, formats[chosen - 1]));
    return ExitStatus::done;
}

}  // namespace

constinit const Command matrices_command{
    "matrices",
    "[STATE] [--set PATH=VALUE]… [--size WxH] [--format json|text|latex|glm|glsl|numpy|matlab]",
    "V, P, S and R with their facts, in the format of your choice",
    "Prints the matrices of a state in double precision: camera and view, projection as uploaded, shadow S (uploaded "
    "is shadow_sign · S), mirror R. JSON adds measured facts (determinant, rank, residuals of S² = (Π·L) S and R² = I) "
    "and sentences about what is wrong. Needs no GL.",
    "matrices\n"
    "matrices --set light.position=[12,20,0,0] --format latex\n"
    "matrices --format numpy > matrices.py",
    "0289",
    run};

}  // namespace viewing
