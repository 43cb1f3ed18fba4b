// params: every field of the state, from the one list of fields.
#include <array>

#include "cli/commands.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/values.h"
#include "state/json.h"

namespace viewing {
namespace {

ExitStatus run(const Command& self, const Arguments& arguments) {
    Options options(self);
    std::optional<std::string> format;
    options.text("--format", "json|text", format, "json (default) for programs, text to read");
    if (!options.parse(arguments)) return ExitStatus::done;

    constexpr std::array formats{"json", "text"};
    const bool as_text = choice_option(options, "--format", format.value_or("json"), formats) == 1;
    std::string listed = as_text ? params_as_text() : params_as_json();
    if (!listed.ends_with('\n')) listed += '\n';
    print(listed);
    return ExitStatus::done;
}

}  // namespace

constinit const Command params_command{"params",
                                       "[--format json|text]",
                                       "every parameter: path, type, unit, range, default, what it does",
                                       "Lists every field of the state file, and so everything that --set can change.",
                                       "params --format text\n"
                                       "params | jq '.[].path'",
                                       "0289",
                                       run};

}  // namespace viewing
