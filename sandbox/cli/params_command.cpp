// params: prints every field of the state from the list in state/fields.cpp, or the JSON Schema of a file format.
#include "cli/commands.h"
#include "cli/option_values.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/results/file_forms.h"
#include "state/file/schema.h"
#include "state/file/state_json.h"

namespace viewing {
namespace {

ExitStatus run_params(const Command& self, const Arguments& arguments) {
    Options options(self);
    std::optional<std::string> format;
    options.text("--format", "FORMAT", format,
                 "json (default) for programs, text for people; schema: the JSON Schema of a state file, which editors "
                 "use to complete and check it; FORM-schema: that of scene, suite, lesson, lecture, exercise, hand-in "
                 "or flight files");
    if (!options.parse(arguments)) return ExitStatus::done;

    std::vector<const char*> formats{"json", "text", "schema"};
    std::vector<std::string (*)()> lists{params_as_json, params_as_text, state_schema};
    for (const FileForm& form : file_forms()) {
        formats.push_back(form.format);
        lists.push_back(form.schema);
    }
    std::string listed = lists[choice_option(options, "--format", format.value_or("json"), formats)]();
    if (!listed.ends_with('\n')) listed += '\n';
    print(listed);
    return ExitStatus::done;
}

}  // namespace

constinit const Command params_command{"params",
                                       "[--format json|text|schema|FORM-schema]",
                                       "lists every parameter: path, type, unit, range, default, what it does",
                                       "Lists every field of the state file, which is everything that --set can "
                                       "change. A state or scene may name its schema in \"$schema\".",
                                       "params --format text\n"
                                       "params --format schema > state.schema.json\n"
                                       "params | jq '.[].path'",
                                       "0289",
                                       run_params};

}  // namespace viewing
