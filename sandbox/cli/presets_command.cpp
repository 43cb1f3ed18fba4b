// presets: lists the presets and scenes that come with the program, one per line.
#include "cli/commands.h"
#include "cli/option_values.h"
#include "cli/options.h"
#include "cli/output.h"
#include "state/file/document.h"
#include "state/presets.h"
#include "state/scene.h"
#include "text/catalogue.h"

namespace viewing {
namespace {

std::string line(const NamedFile& file, const char* mark) {
    return file.name + mark + " — " + tr(file.title.c_str()) +
           (file.about.empty() ? "" : ": " + std::string(tr(file.about.c_str()))) + "\n";
}

Json preset_as_json(const NamedFile& file, const char* kind) {
    return {{"name", file.name},   {"title", tr(file.title.c_str())}, {"about", tr(file.about.c_str())},
            {"group", file.group}, {"slides", file.slides},           {"kind", kind}};
}

ExitStatus run_presets(const Command& self, const Arguments& arguments) {
    Options options(self);
    bool json = false;
    std::optional<std::string> typed_language;
    options.flag("--json", json,
                 "Prints JSON instead: name, title, about, group, slides and kind (preset or scene) of each");
    options.text("--language", "en|ko", typed_language, "Language of titles and sentences; default en");
    if (!options.parse(arguments)) return ExitStatus::done;

    if (assets_directory().empty()) throw Failure(ExitStatus::bad_input, "presets: " + assets_problem());
    speak_option(options, typed_language);
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
    "[--json] [--language en|ko]",
    "lists the presets and scenes that come with the program",
    "A preset is a complete state and can be used wherever STATE can. A scene has only objects: --set scene=NAME. Some "
    "names are both: as STATE such a name is the preset, after scene= the scene.",
    "presets\n"
    "presets --json\n"
    "open --set scene=teapot",
    "0289",
    run_presets};

}  // namespace viewing
