// matrices: every matrix of the lecture with its numbers, no GL needed.
#include <array>
#include <utility>

#include "cli/commands.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/state_arguments.h"
#include "cli/values.h"
#include "frame/matrix_facts.h"
#include "frame/matrix_text.h"
#include "report/matrices_report.h"

namespace viewing {
namespace {

constexpr std::array format_names{"json", "text", "latex", "glm", "glsl", "numpy", "matlab"};
constexpr std::array formats{MatrixFormat::text, MatrixFormat::latex, MatrixFormat::glm,
                             MatrixFormat::glsl, MatrixFormat::numpy, MatrixFormat::matlab};

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
    print(chosen == 0 ? print_document(matrices_as_json(derived, problems)) + "\n"
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
    "and sentences about what is wrong; followed has the followed point p: shadow_homogeneous is S p as it comes, "
    "shadow "
    "what it is after the division by w, or null, mirrored R p. Needs no GL.",
    "matrices\n"
    "matrices --set light.position=[12,20,0,0] --format latex\n"
    "matrices --format numpy > matrices.py",
    "0289",
    run};

}  // namespace viewing
