#include "cli/results/bundle.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string_view>
#include <vector>

#include "cli/exit_status.h"
#include "platform/file.h"
#include "platform/text_file.h"
#include "platform/whole_folder.h"
#include "report/as_json.h"
#include "state/file/state_json.h"
#include "text/words.h"

namespace viewing {
namespace {

namespace fs = std::filesystem;

constexpr const char* state_name = "state.json";

[[noreturn]] void refuse(const std::string& what) {
    throw Failure(ExitStatus::bad_input, "--bundle: " + what);
}

/// Returns a file name that is valid on every system. It contains no characters that are special to a system or a
/// shell, and no unprintable ones.
std::string safe_name(const fs::path& file) {
    std::string name = printable(file.filename().string());
    const auto is_unsafe = [](char sign) {
        return std::string_view("\\/:*?\"<>|$`'!&;").find(sign) != std::string_view::npos;
    };
    std::replace_if(name.begin(), name.end(), is_unsafe, '_');
    if (name.starts_with('-') || name.starts_with('.')) name.front() = '_';
    constexpr std::size_t longest_stem = 150;  // bytes; file systems allow 255, and a number may follow
    const std::string ending = fs::path(name).extension().string();
    std::string stem = name.substr(0, name.size() - ending.size());
    while (stem.size() > longest_stem) remove_last_character(stem);
    return stem + ending.substr(0, longest_stem / 2);
}

/// Copies files into the prepared folder and returns their names there.
class Packer {
public:
    explicit Packer(fs::path folder) : folder_(std::move(folder)) { taken_.insert(state_name); }

    /// Returns the new name of a mesh file, which is copied on first use together with its material libraries.
    std::string mesh(const fs::path& file) {
        const std::string place = place_of(file);
        if (const auto known = names_.find(file); known != names_.end()) return known->second;
        const std::string name = free_name(place, safe_name(file));
        copy(file, name);
        names_[file] = name;
        for (const std::string& library : material_libraries(file)) {
            const fs::path beside = file.parent_path() / library;
            const bool is_there = check_readable(beside) && resolved(beside).parent_path() == file.parent_path();
            if (is_there && taken_.insert(in_lower_case(place + library)).second) copy(beside, place + library);
        }
        return name;
    }

    void text(const std::string& name, const std::string& text) {
        value_or_end(write_file(folder_ / name, std::string_view(text)));
    }

    /// Returns a name that no other file in the bundle has, such as "name-2.obj" if necessary.
    std::string free_name(const std::string& place, const std::string& wanted) {
        const fs::path path(wanted);
        std::string name = wanted;
        for (int number = 2; !taken_.insert(in_lower_case(place + name)).second; ++number)
            name = path.stem().string() + "-" + std::to_string(number) + path.extension().string();
        return place + name;
    }

private:
    /// Returns the subfolder for files that come from the given file's folder: "" for the first such folder, then "2/",
    /// "3/", …, so that files that belong together stay together.
    std::string place_of(const fs::path& file) {
        const auto [found, is_new] = places_.try_emplace(file.parent_path(), places_.size() + 1);
        if (found->second == 1) return "";
        const std::string place = std::to_string(found->second);
        if (is_new) {
            std::error_code error;
            fs::create_directory(folder_ / place, error);
            taken_.insert(place);
        }
        return place + "/";
    }

    void copy(const fs::path& from, const std::string& name) {
        std::error_code error;
        fs::copy_file(from, folder_ / name, error);
        if (error) refuse(from.string() + ": cannot be copied: " + error.message());
    }

    /// Returns the file names after "mtllib", except unsafe ones: the mesh is copied unchanged, so its libraries cannot
    /// be renamed. The program itself does not read these files.
    static std::vector<std::string> material_libraries(const fs::path& mesh) {
        std::vector<std::string> names;
        std::ifstream lines(mesh, std::ios::binary);
        for (std::string line; std::getline(lines, line);) {
            std::istringstream words(line);
            std::string word;
            if (!(words >> word) || word != "mtllib") continue;
            while (words >> word)
                if (safe_name(word) == word) names.push_back(word);
        }
        return names;
    }

    fs::path folder_;
    std::map<fs::path, std::size_t> places_;
    std::map<fs::path, std::string> names_;
    std::set<std::string> taken_;  ///< in lower case: on some systems, names that differ only in case are the same file
};

/// Packs the files of the scene's objects, and updates their names in the scene.
void pack_objects(Packer& packer, SceneDescription& scene, const fs::path& base) {
    for (ObjectDescription& object : scene.objects)
        if (!object.file.empty()) object.file = packer.mesh(resolved(base / object.file));
}

/// Packs the files of a scene file's objects. Returns the scene file's text with their new names, and with everything
/// else unchanged.
std::string packed_scene_file(Packer& packer, const fs::path& file) {
    const std::string text = value_or_end(read_text_file(file));
    return value_or_end(guarded([&] {
        Json scene = parse_document(text, file.string() + ": ");
        if (!scene.contains("objects")) return print_document(scene) + "\n";
        for (Json& object : scene["objects"])
            if (object.contains("file"))
                object["file"] = packer.mesh(resolved(file.parent_path() / object["file"].get<std::string>()));
        return print_document(scene) + "\n";
    }));
}

/// Packs the state's scene, and updates the names in the state.
void pack_scene(Packer& packer, LoadedState& state, const Scene& scene) {
    SceneSource& source = state.params.scene;
    if (auto* inline_scene = std::get_if<SceneDescription>(&source)) {
        pack_objects(packer, *inline_scene, state.base);
    } else if (is_obj_file(scene.file)) {
        const std::string name = packer.mesh(resolved(scene.file));
        // The object's name is derived from its file's name.
        const std::string before = scene.file.stem().string(), after = fs::path(name).stem().string();
        if (state.params.follow && state.params.follow->object == before) state.params.follow->object = after;
        if (state.params.view.pin && state.params.view.pin->object == before) state.params.view.pin->object = after;
        source = name;
    } else if (!scene.file.empty()) {
        std::string name = safe_name(scene.file);
        if (!name.ends_with(".json")) name += ".json";
        name = packer.free_name("", name);
        packer.text(name, packed_scene_file(packer, scene.file));
        source = name;
    }
}

}  // namespace

std::string write_bundle(const std::string& folder, const LoadedState& state, const Scene& scene) {
    if (folder.empty()) refuse("must be the name of a new folder, got an empty string");
    WholeFolder whole = value_or_end(WholeFolder::begin(folder));
    Packer packer(whole.beside());
    LoadedState packed = state;
    pack_scene(packer, packed, scene);
    packer.text(state_name, write_state(packed.params, packed.titles));
    value_or_end(whole.take_name());
    return (fs::path(folder) / state_name).lexically_normal().string();
}

}  // namespace viewing
