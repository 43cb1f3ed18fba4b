// state: the whole resolved state.
#include "cli/commands.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/state_arguments.h"
#include "state/json.h"

namespace viewing {
namespace {

ExitStatus run(const Command& self, const Arguments& arguments) {
    Options options(self);
    const StateArguments state_arguments(options);
    if (!options.parse(arguments)) return ExitStatus::done;

    const LoadedState state = state_arguments.load();
    scene_of(state);  // a state whose scene cannot be shown is a bad one
    print(write_state(state.params));
    return ExitStatus::done;
}

}  // namespace

constinit const Command state_command{
    "state",
    "[STATE] [--set PATH=VALUE]…",
    "the whole state as JSON, every field with its value",
    "Prints what STATE and --set come to: every field, in the order of the documentation. Reading it back gives the "
    "same state exactly.",
    "state > mine.json\n"
    "state mine.json --set shadow.opacity=0.8\n"
    "state --set light.position=[12,20,0,0] | viewing-sandbox snapshot - -o picture.png",
    "0289",
    run};

}  // namespace viewing
