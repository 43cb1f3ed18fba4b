// state: the whole resolved state, alone, as a link, or with the files it needs.
#include <algorithm>

#include "cli/commands.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/results/bundle.h"
#include "cli/state_arguments.h"
#include "state/file/json.h"
#include "state/file/link.h"

namespace viewing {
namespace {

struct Linking {
    bool is_wanted = false;
    std::optional<std::string> base;
    std::string address() const { return base.value_or(link_base()); }
};

void print_link(const Options& options, const Linking& linking, const LinkedStep& step) {
    const std::optional<std::string> link = link_to(step.lesson, step.step);
    if (!link) options.refuse("--link can only name the lessons that come with the program (lesson --list)");
    print(linking.address() + *link + "\n");
}

void print_link(const Linking& linking, const LoadedState& state, const Scene& scene) {
    print(linking.address() + link_fragment(state.params) + "\n");
    const auto* const described = std::get_if<SceneDescription>(&state.params.scene);
    const bool has_meshes = described && std::any_of(described->objects.begin(), described->objects.end(),
                                                     [](const ObjectDescription& one) { return !one.file.empty(); });
    if (!scene.file.empty() || has_meshes)
        note("state: the link only names the scene's files, it does not carry them; --bundle DIR does");
}

ExitStatus run_state(const Command& self, const Arguments& arguments) {
    Options options(self);
    const StateArguments state_arguments(options);
    std::optional<std::string> bundle, lesson, step_number;
    options.group("Output");
    options.text("--bundle", "DIR", bundle,
                 "Writes a new folder to be given to somebody: state.json, the scene's file, the meshes and their "
                 "material libraries, with names that fit; prints the path of its state.json");
    Linking linking;
    options.flag(
        "--link", linking.is_wanted,
        "Prints a link in place of the JSON: an address, # and what differs from the defaults. Every STATE may "
        "be one. It carries no files");
    options.text("--base", "ADDRESS", linking.base,
                 "What stands before the #; default $VIEWING_SANDBOX_LINK_BASE, else viewing-sandbox.html");
    options.group("Lesson");
    options.text("--lesson", "ID|FILE", lesson,
                 "A step of a lesson in place of STATE; with --link a link that leads through the lesson from there");
    options.text("--step", "N", step_number, "Which one, counted from 1; default 1");
    if (!options.parse(arguments)) return ExitStatus::done;
    if (bundle && linking.is_wanted) options.refuse("--bundle and --link cannot both be");
    if (linking.base && !linking.is_wanted) options.refuse("--base needs --link");
    if (linking.base && linking.base->find_first_of("# \t\r\n") != std::string::npos)
        options.refuse("--base: an address without # and blanks is wanted");

    if (step_number && !lesson) options.refuse("--step needs --lesson");
    if (lesson && state_arguments.are_given())
        options.refuse("--lesson: a step has its own state, so no STATE, --set, --mesh and --at");

    std::optional<LinkedStep> step;
    if (lesson) step = lesson_step(options, *lesson, step_number);
    if (step && linking.is_wanted) {
        print_link(options, linking, *step);
        return ExitStatus::done;
    }
    const LoadedState state = step ? step->lesson.steps[step->step].start : state_arguments.load();
    const Scene scene = scene_of(state);  // a state whose scene cannot be shown is a bad one
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
    "the whole state as JSON, every field with its value",
    "Prints what STATE and --set come to: what the file says about itself (title, about, group), then every field, in "
    "the order of the documentation. Reading it back gives the same state exactly. Scenes and meshes are named as they "
    "were given: those of a file relative to it, those of the command line to the working directory.",
    "state > mine.json\n"
    "state mine.json --set shadow.opacity=0.8\n"
    "state mine.json --bundle to-give-away\n"
    "state --set shadow.opacity=0.8 --link\n"
    "state --lesson depth-fighting --step 2 --link\n"
    "state --set light.position=[12,20,0,0] | viewing-sandbox snapshot - -o picture.png",
    "0289",
    run_state};

}  // namespace viewing
