// measure: numbers measured in a frame. The quantities come with the topics that they belong to.
#include <array>

#include "cli/commands.h"
#include "cli/options.h"
#include "cli/state_arguments.h"
#include "cli/values.h"

namespace viewing {
namespace {

constexpr std::array<const char*, 2> quantities{"fighting", "visibility"};

ExitStatus run(const Command& self, const Arguments& arguments) {
    Options options(self);
    const StateArguments state_arguments(options);
    std::optional<std::string> what, size;
    options.group("Measurement");
    options.text("--what", "QUANTITY", what,
                 "fighting: depth fighting; visibility: what the hidden-surface methods do");
    options.text("--size", "WxH", size, size_help);
    if (!options.parse(arguments)) return ExitStatus::done;

    if (!what) options.refuse("--what is missing: one of fighting, visibility");
    choice_option(options, "--what", *what, quantities);
    size_option(options, size);
    scene_of(state_arguments.load());
    options.refuse("--what " + *what + " cannot be measured yet: it comes with a later version");
}

}  // namespace

constinit const Command measure_command{
    "measure",
    "[STATE] [--set PATH=VALUE]… --what fighting|visibility [--size WxH]",
    "numbers measured in a frame (comes with a later version)",
    "Will print measurements of a frame as JSON. This version refuses every quantity.",
    "measure --what fighting",
    "29",
    run};

}  // namespace viewing
