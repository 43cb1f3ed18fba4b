// presets: the presets and scenes that come with the program, a line each.
#include "cli/commands.h"
#include "cli/options.h"
#include "cli/output.h"
#include "state/file/document.h"
#include "state/presets.h"
#include "state/scene.h"

namespace viewing {
namespace {

std::string line(const NamedFile& file, const char* mark) {
    return file.name + mark + " — " + file.title + (file.about.empty() ? "" : ": " + file.about) + "\n";
}

Json preset_as_json(const NamedFile& file, const char* kind) {
    return {{"name", file.name}, {"title", file.title}, {"about", file.about}, {"group", file.group}, {"kind", kind}};
}

ExitStatus run_presets(const Command& self, const Arguments& arguments) {
    Options options(self);
    bool json = false;
    options.flag("--json", json, "The same as JSON: name, title, about, group and kind (preset or scene) of each");
    if (!options.parse(arguments)) return ExitStatus::done;

    if (assets_directory().empty()) throw Failure(ExitStatus::bad_input, "presets: " + assets_problem());
    std::string lines;
    Json list = Json::array();
    const auto add = [&](const std::vector<NamedFile>& files, const char* kind, const char* mark) {
        for (const NamedFile& file : files) {
            lines += line(file, mark);
            list.push_back(preset_as_json(file, kind));
        }
    };
    add(presets(), "preset", "");
    add(scenes(), "scene", " (scene)");
    print(json ? print_document(list) + "\n" : lines);
    return ExitStatus::done;
}

}  // namespace

constinit const Command presets_command{
    "presets",
    "[--json]",
    "the presets and scenes that come with the program, a line each",
    "A preset is a whole state and can stand wherever STATE does. A scene is only the objects: --set scene=NAME. Some "
    "names are both: as STATE such a name is the preset, behind scene= the scene.",
    "presets\n"
    "presets --json\n"
    "open --set scene=teapot",
    "0289",
    run_presets};

}  // namespace viewing
