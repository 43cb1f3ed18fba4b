// state: the whole resolved state, alone or with the files it needs.
#include "cli/commands.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/results/bundle.h"
#include "cli/state_arguments.h"
#include "state/json.h"

namespace viewing {
namespace {

ExitStatus run(const Command& self, const Arguments& arguments) {
    Options options(self);
    const StateArguments state_arguments(options);
    std::optional<std::string> bundle;
    options.group("Output");
    options.text("--bundle", "DIR", bundle,
                 "Writes a new folder to be given to somebody: state.json, the scene's file, the meshes and their "
                 "material libraries, with names that fit; prints the path of its state.json");
    if (!options.parse(arguments)) return ExitStatus::done;

    const LoadedState state = state_arguments.load();
    const Scene scene = scene_of(state);  // a state whose scene cannot be shown is a bad one
    if (bundle)
        print(write_bundle(*bundle, state, scene) + "\n");
    else
        print(write_state(state.params, state.titles));
    return ExitStatus::done;
}

}  // namespace

constinit const Command state_command{
    "state",
    "[STATE] [--set PATH=VALUE]… [--bundle DIR]",
    "the whole state as JSON, every field with its value",
    "Prints what STATE and --set come to: what the file says about itself (title, about, group), then every field, in "
    "the order of the documentation. Reading it back gives the same state exactly. Scenes and meshes are named as they "
    "were given: those of a file relative to it, those of the command line to the working directory.",
    "state > mine.json\n"
    "state mine.json --set shadow.opacity=0.8\n"
    "state mine.json --bundle to-give-away\n"
    "state --set light.position=[12,20,0,0] | viewing-sandbox snapshot - -o picture.png",
    "0289",
    run};

}  // namespace viewing
