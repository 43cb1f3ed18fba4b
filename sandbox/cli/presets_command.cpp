// presets: the presets and scenes that come with the program, a line each.
#include "cli/commands.h"
#include "cli/options.h"
#include "cli/output.h"
#include "state/presets.h"
#include "state/scene.h"

namespace viewing {
namespace {

std::string line(const NamedFile& file, const char* kind) {
    return file.name + kind + " — " + file.title + (file.about.empty() ? "" : ": " + file.about) + "\n";
}

ExitStatus run(const Command& self, const Arguments& arguments) {
    Options options(self);
    if (!options.parse(arguments)) return ExitStatus::done;

    if (assets_directory().empty()) throw Failure(ExitStatus::bad_input, "presets: " + assets_problem());
    std::string lines;
    for (const NamedFile& preset : presets()) lines += line(preset, "");
    for (const NamedFile& scene : scenes()) lines += line(scene, " (scene)");
    print(lines);
    return ExitStatus::done;
}

}  // namespace

constinit const Command presets_command{
    "presets",
    "",
    "the presets and scenes that come with the program, a line each",
    "A preset is a whole state and can stand wherever STATE does. A scene is only the objects: --set scene=NAME.",
    "presets\n"
    "open --set scene=teapot",
    "0289",
    run};

}  // namespace viewing
