// matrices: prints the lecture's matrices as numbers or symbols, or explains a pasted matrix. Needs no GL.
#include <array>
#include <iostream>
#include <utility>

#include "cli/commands.h"
#include "cli/option_values.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/results/chosen_matrices.h"
#include "cli/results/explained_text.h"
#include "cli/state_arguments.h"
#include "report/as_json.h"
#include "report/matrices_report.h"
#include "topics/camera/numbers/look_at_text.h"
#include "topics/matrices/numbers/matrix_text.h"

namespace viewing {
namespace {

constexpr std::array matrix_formats{"json", "text", "latex", "glm", "glsl", "numpy", "matlab"};
constexpr std::array formats{MatrixFormat::text, MatrixFormat::latex, MatrixFormat::glm,
                             MatrixFormat::glsl, MatrixFormat::numpy, MatrixFormat::matlab};

constexpr int most_digits = 17;

/// The matrices to print, and their format.
struct TypedMatrices {
    std::vector<ChosenMatrix> matrices;
    int digits = 0;  ///< significant digits; 0: all
    bool is_symbolic = false;
};

LookAt rounded(LookAt look_at, int digits) {
    for (glm::dvec3* const part : {&look_at.eye, &look_at.center, &look_at.up})
        for (int axis = 0; digits > 0 && axis < 3; ++axis) (*part)[axis] = rounded_to((*part)[axis], digits);
    return look_at;
}

/// `look_at` is the camera to add to plain text, or null.
std::string listed_as_text(const TypedMatrices& wish, const LookAt* look_at, const std::vector<Problem>& problems,
                           MatrixFormat format) {
    // Math between $ and $ must not contain empty lines.
    const std::string between = format == MatrixFormat::latex ? "\\quad\n" : "\n";
    std::string text = format == MatrixFormat::numpy ? "import numpy as np\n\n" : "";
    for (const ChosenMatrix& chosen : wish.matrices) {
        if (&chosen != &wish.matrices.front()) text += between;
        text += wish.is_symbolic && chosen.symbols ? matrix_text(chosen.name, *chosen.symbols, format)
                                                   : matrix_text(chosen.name, chosen.matrix, format, wish.digits);
        if (!chosen.sign) continue;
        if (format == MatrixFormat::latex) text += between;
        text += number_text(chosen.sign_name, *chosen.sign, format,
                            "uploaded is " + chosen.sign_name + " * " + chosen.name);
    }
    if (format == MatrixFormat::text && look_at)
        text += "\nlook_at: " + look_at_call(rounded(*look_at, wish.digits), LookAtCall::glu) + "\n";
    if (format == MatrixFormat::text && !problems.empty()) text += "\n";
    for (const Problem& problem : problems)
        if (format == MatrixFormat::text) text += say(problem.sentence) + "\n";
    return text;
}

Json rounded(Json json, int digits) {
    if (json.is_number_float()) return rounded_to(json.get<double>(), digits);
    if (json.is_structured())
        for (Json& part : json) part = rounded(std::move(part), digits);
    return json;
}

Json symbols_as_json(const MatrixSymbols& symbols) {
    Json rows = Json::array();
    for (std::size_t row = 0; row < 4; ++row)
        rows.push_back({symbols[4 * row], symbols[4 * row + 1], symbols[4 * row + 2], symbols[4 * row + 3]});
    return rows;
}

/// Returns the chosen matrices, or `all` if none is chosen.
Json listed_as_json(const TypedMatrices& wish, const Json& all, bool is_chosen) {
    Json json = is_chosen ? Json::object() : all;
    for (const ChosenMatrix& chosen : wish.matrices) {
        json[chosen.key] =
            wish.is_symbolic && chosen.symbols ? symbols_as_json(*chosen.symbols) : as_json(chosen.matrix);
        if (chosen.sign) json[chosen.sign_key] = static_cast<int>(*chosen.sign);
    }
    if (is_chosen)
        for (const char* const key : {"problems", "problem_details"}) json[key] = all[key];
    return rounded(std::move(json), wish.digits);
}

/// Prints what a pasted matrix is; `format` 0 selects JSON, any other value text.
ExitStatus explain(const std::string& file, const Params& params, double aspect, std::size_t format) {
    const std::string source = file == "-" ? "standard input" : file;
    const std::string text = value_or_end(file == "-" ? read_text(std::cin, source) : read_text_file(file));
    const Result<PastedMatrix> pasted = read_pasted_matrix(text);
    if (!pasted) throw Failure(ExitStatus::bad_input, source + ": " + pasted.error());
    const ExplainedMatrix found = explain_matrix(pasted->matrix, pasted->letter, params, aspect, pasted->tolerance);
    const ExplainedMatrix own =
        found.right ? explain_matrix(*found.right, found.letter, params, aspect) : ExplainedMatrix{};
    print(format == 0 ? print_document(explained_json(*pasted, found)) + "\n" : explained_text(*pasted, found, own));
    return ExitStatus::done;
}

ExitStatus run_matrices(const Command& self, const Arguments& arguments) {
    Options options(self);
    const StateArguments state_arguments(options);
    std::optional<std::string> size, format, only, digits, pasted;
    TypedMatrices wish;
    options.group("Output");
    options.text("--size", "WxH", size,
                 "Size of the picture in pixels, which sets the aspect ratio of the projection; default 1280x720");
    options.text("--format", "FORMAT", format,
                 "json (default), text, latex, numpy, matlab: rows as on the slides; glm, glsl: columns first, as "
                 "their constructors expect. LaTeX output goes between $ and $");
    options.text("--only", "LIST", only,
                 "Only these matrices, in this order: C, V, P, PV, and S, R of the first plane and light, S[2,1] of "
                 "the second plane and the first light, R[2] of the second plane: --only V,S[2,1],R");
    options.text("--digits", "N", digits, "Number of significant digits, 1 to 17; default: all");
    options.flag("--symbolic", wish.is_symbolic,
                 "Prints symbols instead of numbers, as in the window; numbers where there is no symbolic form: PV, "
                 "and matrices entered by hand");
    options.text("--explain", "FILE", pasted,
                 "Says what the matrix in FILE is (- is standard input), and what is wrong with it: a V, C, P, S or R "
                 "as GLM, NumPy, MATLAB, C or JSON write it, compared with the state's. Text, or JSON with --format "
                 "json");
    if (!options.parse(arguments)) return ExitStatus::done;
    if (pasted && (only || digits || wish.is_symbolic))
        options.refuse("--explain cannot be combined with --only, --digits or --symbolic");
    if (pasted && *pasted == "-" && state_arguments.as_typed() == "-")
        options.refuse("STATE and --explain cannot both be standard input");

    const std::size_t chosen = choice_option(options, "--format", format.value_or("json"), matrix_formats);
    if (digits) wish.digits = whole_option(options, "--digits", *digits, 1, most_digits);
    const Viewport viewport{size_option(options, size)};
    const LoadedState state = state_arguments.load();
    if (pasted) {
        if (chosen > 1) options.refuse("--explain prints text or json");
        return explain(*pasted, state.params, viewport.aspect(), format ? chosen : 1);
    }
    const Scene scene = scene_of(state);
    const Derived derived = derive(state.params, scene, viewport);
    const std::vector<Problem> problems = find_problems(state.params, derived, scene, plan(state.params, derived));
    wish.matrices = chosen_matrices(options, only, state.params, derived);
    print(chosen == 0
              ? print_document(listed_as_json(wish, matrices_as_json(derived, problems), only.has_value())) + "\n"
              : listed_as_text(wish, only ? nullptr : &derived.look_at, problems, formats[chosen - 1]));
    return ExitStatus::done;
}

}  // namespace

constinit const Command matrices_command{
    "matrices",
    "[STATE] [--set PATH=VALUE]… [--only LIST] [--explain FILE] [--format FORMAT] [OPTIONS]",
    "prints V, P, S and R with their facts, in the format of your choice",
    "Prints the matrices of a state in double precision: camera and view, projection as uploaded, shadow S "
    "(shadow_sign · S is uploaded), mirror R. look_at is the camera as gluLookAt takes it: eye, "
    "center and up. JSON adds measured facts (determinant, rank, residuals of S² = (Π·L) S "
    "and R² = I) and sentences about problems; problem_details has an id for each, its kind (wrong, note or window), "
    "the values in its sentence and the setting that fixes it; followed has the followed point p: "
    "shadow_homogeneous is S p, shadow is S p after the division by w, or null, and mirrored is R p. Needs no GL.",
    "matrices\n"
    "matrices --set light.position=[12,20,0,0] --format latex\n"
    "matrices --only S,R --digits 4 --format latex\n"
    "matrices mirrors-facing-once --only S[1,1],R[2] --symbolic --format text\n"
    "matrices --format numpy > matrices.py\n"
    "matrices --explain mine.txt",
    "0289",
    run_matrices};

}  // namespace viewing
