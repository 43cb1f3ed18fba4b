#include "cli/state_arguments.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <string_view>
#include <utility>

#include "cli/option_values.h"
#include "cli/output.h"
#include "platform/text_file.h"
#include "state/fields.h"
#include "state/file/state_json.h"
#include "text/words.h"

namespace viewing {
namespace {

namespace fs = std::filesystem;

constexpr const char* scene_file = "a file of the scene";
constexpr const char* piped_name = "standard input";

/// Returns the files that an inline scene names; for any other scene, its own file or name.
std::set<std::string> files_named_by(const SceneSource& source) {
    if (const auto* name = std::get_if<std::string>(&source)) return {*name};
    std::set<std::string> files;
    for (const ObjectDescription& object : std::get<SceneDescription>(source).objects)
        if (!object.file.empty()) files.insert(object.file);
    return files;
}

bool sets_scene(const std::string& setting) {
    constexpr std::string_view path = "scene";
    return setting.starts_with(path) && setting.size() > path.size() &&
           std::string_view("=.[").find(setting[path.size()]) != std::string_view::npos;
}

/// Rewrites the scene's file names, which are relative to the state's folder, to be relative to the working directory.
void rebase_to_working_directory(LoadedState& loaded) {
    if (auto* scene = std::get_if<SceneDescription>(&loaded.params.scene)) {
        for (ObjectDescription& object : scene->objects)
            if (!object.file.empty()) object.file = (loaded.base / object.file).string();
    }
    loaded.base.clear();
}

}  // namespace

StateArguments::StateArguments(Options& options) : options_(options) {
    options.group("State");
    options.positional("STATE", state_,
                       "A .json file, the name of a preset (viewing-sandbox presets), an .obj file to view, a link "
                       "printed by state --link, or - for a state or link on standard input; default: the opening "
                       "preset. A recorded flight shows its start");
    options.text("--at", "SECONDS", at_, "For a flight as STATE: the picture at this time");
    options.texts("--set", "PATH=VALUE", settings_,
                  "Sets one field, a group or an element of STATE; repeatable, applied in order: projection.near=0.01, "
                  "light.position=[2,5,1,0], depth.func=always (viewing-sandbox params)");
    options.text("--mesh", "FILE.obj", mesh_, "Shows this Wavefront mesh instead of the state's scene");
    options.flag("--allow-outside", allows_outside_,
                 "Lets STATE name scenes and meshes outside its own folder and the program's; files named on the "
                 "command line need no permission");
}

const std::string& StateArguments::text() const {
    if (state_ != "-") return state_;
    if (!piped_) piped_ = value_or_end(read_text(std::cin, piped_name));
    return *piped_;
}

std::optional<LinkedStep> StateArguments::linked_step() const {
    const std::optional<Link> link = lesson_link(text());
    if (!link) return std::nullopt;
    return value_or_end(load_linked_step(*link));
}

LoadedState StateArguments::loaded() const {
    if (const std::optional<LinkedStep> linked = linked_step()) return linked->lesson.steps[linked->step].start;
    if (state_ == "-") return value_or_end(state_in_text(text(), piped_name));
    return value_or_end(load_state(is_obj_file(state_) ? "" : state_));
}

LoadedState StateArguments::load() const {
    const bool state_is_mesh = is_obj_file(state_);
    if (mesh_ && state_is_mesh) options_.refuse("--mesh: STATE is already a mesh");
    if (mesh_ && !is_obj_file(*mesh_))
        options_.refuse("--mesh: " + one_line(*mesh_) + " must be a Wavefront .obj file");

    LoadedState loaded = this->loaded();
    if (at_) take_picture_at(loaded);
    if (mesh_ || state_is_mesh) {
        loaded.params.scene = mesh_.value_or(state_);
        loaded.base.clear();
        loaded.scene_origin = mesh_ ? "--mesh" : "STATE";
        loaded.reach.add(mesh_.value_or(state_));
        loaded.preset.reset();  // its description no longer fits the objects
    }
    if (std::any_of(settings_.begin(), settings_.end(), sets_scene)) {
        rebase_to_working_directory(loaded);
        loaded.scene_origin = "--set scene";
    }
    const std::set<std::string> named_by_state = files_named_by(loaded.params.scene);
    loaded.params = value_or_end(apply_settings(std::move(loaded.params), settings_));
    loaded.reach.is_everywhere = allows_outside_;
    for (const std::string& file : files_named_by(loaded.params.scene))
        if (!named_by_state.contains(file)) loaded.reach.add(loaded.base / file);
    if (loaded.flight && loaded.flight->start != loaded.params) {
        Flight flight = *loaded.flight;
        flight.start = loaded.params;
        loaded.flight = std::make_shared<const Flight>(std::move(flight));
    }
    return loaded;
}

std::vector<FileArgument> StateArguments::files() const {
    std::vector<FileArgument> files;
    add_file_if_there(files, "STATE", state_);
    if (mesh_) files.push_back({"--mesh", *mesh_});
    return files;
}

void StateArguments::take_picture_at(LoadedState& loaded) const {
    const std::shared_ptr<const Flight> flight = std::exchange(loaded.flight, nullptr);
    if (!flight) options_.refuse("--at needs a flight as STATE: a file recorded in the window");
    const double at_s = number_option(options_, "--at", *at_, 0.0, flight->seconds);
    loaded.params = value_or_end(FlightWalk(flight).at(flight->picture_at(at_s)));
}

bool StateArguments::set_only_looks() const {
    return !mesh_ && std::all_of(settings_.begin(), settings_.end(), [](const std::string& setting) {
        return is_in(setting.substr(0, setting.find('=')), "ui");
    });
}

bool StateArguments::say_only_looks() const {
    return (state_.empty() || lesson_link(text())) && set_only_looks();
}

UiParams StateArguments::looks() const {
    if (!set_only_looks())
        options_.refuse("an exercise has its own state, so --mesh is not allowed and --set takes only ui.… fields");
    return value_or_end(apply_settings(Params{}, settings_)).ui;
}

std::vector<FileArgument> files_of(const LoadedState& state) {
    std::vector<FileArgument> files;
    for (const std::string& name : files_named_by(state.params.scene))
        add_file_if_there(files, scene_file, (state.base / name).string());
    return files;
}

std::vector<FileArgument> files_of(const Scene& scene) {
    std::vector<FileArgument> files;
    for (const fs::path& file : scene.read) files.push_back({scene_file, file.string()});
    return files;
}

LinkedStep lesson_step(const Options& options, const std::string& lesson, const std::optional<std::string>& number) {
    LinkedStep step{value_or_end(load_lesson(lesson)), 0};
    const int count = static_cast<int>(step.lesson.steps.size());
    if (number) step.step = static_cast<std::size_t>(whole_option(options, "--step", *number, 1, count) - 1);
    return step;
}

Scene scene_of(const LoadedState& state) {
    Scene scene = value_or_end(load_scene(state.params.scene, state.base, state.params.coplanar,
                                          {.origin = state.scene_origin, .reach = state.reach}));
    for (const std::string& line : scene.notes) note(line);
    return scene;
}

}  // namespace viewing
