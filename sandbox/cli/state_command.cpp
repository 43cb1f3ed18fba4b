// state: prints the complete state, as JSON or as a link, or writes it together with the files it needs.
#include <algorithm>

#include "cli/commands.h"
#include "cli/option_values.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/results/bundle.h"
#include "cli/state_arguments.h"
#include "state/file/link.h"
#include "state/file/state_json.h"

namespace viewing {
namespace {

struct Linking {
    bool is_wanted = false;
    std::string address;
};

void print_link(const Options& options, const Linking& linking, const LinkedStep& step) {
    const std::optional<std::string> link = link_to(step.lesson, step.step);
    if (!link) options.refuse("--link can only name the lessons that come with the program (lesson --list)");
    print(linking.address + *link + "\n");
}

void print_link(const Linking& linking, const LoadedState& state, const Scene& scene) {
    print(linking.address + link_fragment(state.params) + "\n");
    const auto* const described = std::get_if<SceneDescription>(&state.params.scene);
    const bool has_meshes = described && std::any_of(described->objects.begin(), described->objects.end(),
                                                     [](const ObjectDescription& one) { return !one.file.empty(); });
    if (!scene.file.empty() || has_meshes)
        note("state: the link names the scene's files but does not contain them; use --bundle DIR to pack them");
}

ExitStatus run_state(const Command& self, const Arguments& arguments) {
    Options options(self);
    const StateArguments state_arguments(options);
    std::optional<std::string> bundle, base, lesson, step_number;
    options.group("Output");
    options.text("--bundle", "DIR", bundle,
                 "Writes a new folder to share: state.json, the scene's file, the meshes and their material libraries, "
                 "under matching names; prints the path of its state.json");
    Linking linking;
    options.flag("--link", linking.is_wanted,
                 "Prints a link instead of the JSON: an address, # and the differences from the defaults. Any STATE "
                 "may be a link. It contains no files");
    options.text("--base", "ADDRESS", base, base_help);
    options.group("Lesson");
    options.text("--lesson", "ID|FILE", lesson,
                 "A step of this lesson instead of STATE; with --link, a link that starts the lesson at this step");
    options.text("--step", "N", step_number, "Number of the step, counted from 1; default 1");
    if (!options.parse(arguments)) return ExitStatus::done;
    if (bundle && linking.is_wanted) options.refuse("--bundle and --link cannot be combined");
    if (base && !linking.is_wanted) options.refuse("--base needs --link");
    linking.address = address_option(options, "--base", base);

    if (step_number && !lesson) options.refuse("--step needs --lesson");
    if (lesson && state_arguments.are_given())
        options.refuse("--lesson: a step has its own state, so STATE, --set, --mesh and --at are not allowed");

    std::optional<LinkedStep> step;
    if (lesson) step = lesson_step(options, *lesson, step_number);
    if (step && linking.is_wanted) {
        print_link(options, linking, *step);
        return ExitStatus::done;
    }
    const LoadedState state = step ? step->lesson.steps[step->step].start : state_arguments.load();
    const Scene scene = scene_of(state);  // refuses a state whose scene cannot be loaded
    if (bundle)
        print(write_bundle(*bundle, state, scene) + "\n");
    else if (linking.is_wanted)
        print_link(linking, state, scene);
    else
        print(write_state(state.params, state.titles));
    return ExitStatus::done;
}

}  // namespace

constinit const Command state_command{
    "state",
    "[STATE | --lesson ID --step N] [--set PATH=VALUE]… [--bundle DIR | --link]",
    "prints the whole state as JSON, every field with its value",
    "Prints the state that STATE and --set result in: title, about and group of the file, then every field, in the "
    "order of the documentation. Reading it back gives exactly the same state. Scenes and meshes keep the names given: "
    "relative to the file that names them, or to the working directory on the command line.",
    "state > mine.json\n"
    "state mine.json --set shadow.opacity=0.8\n"
    "state mine.json --bundle to-give-away\n"
    "state --set shadow.opacity=0.8 --link\n"
    "state --lesson depth-fighting --step 2 --link\n"
    "state --set light.position=[12,20,0,0] | viewing-sandbox snapshot - -o picture.png",
    "0289",
    run_state};

}  // namespace viewing
