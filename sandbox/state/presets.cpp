// Finds the presets and scenes of the assets directory, and loads a STATE argument.
#include "state/presets.h"

#include <algorithm>

#include "image/figure_note.h"
#include "platform/file.h"
#include "platform/text_file.h"
#include "state/file/document.h"
#include "state/file/form.h"
#include "state/file/link.h"
#include "state/file/state_json.h"
#include "state/scene.h"
#include "text/words.h"

namespace viewing {

namespace {

namespace fs = std::filesystem;

constexpr const char* opening = "opening";

/// Reads the titles as far as possible; errors are reported when the file is loaded.
NamedFile named_file(const fs::path& path) {
    NamedFile named;
    named.name = path.stem().string();
    named.path = path;
    const Result<std::string> text = read_text_file(path);
    const Result<Json> document =
        text ? guarded([&] { return parse_document(*text, ""); }) : Result<Json>(Error{text.error()});
    if (document && document->is_object()) {
        std::vector<std::string> mistakes;
        titles_form().read_members(named, *document, Where{"", "", &mistakes});
        named.sets_looks = document->contains("ui");
    }
    if (named.title.empty()) named.title = named.name;
    return named;
}

std::vector<NamedFile> named_files(const char* folder) {
    std::vector<NamedFile> files;
    const fs::path assets = assets_directory();
    if (assets.empty()) return files;
    for (const fs::path& file : files_in(assets / folder, ".json")) files.push_back(named_file(file));
    std::sort(files.begin(), files.end(), [](const NamedFile& a, const NamedFile& b) { return a.name < b.name; });
    return files;
}

/// Returns the names of the presets in the order of the lecture; empty if the list cannot be read.
std::vector<std::string> lecture_order() {
    const Result<std::string> text = read_text_file(assets_directory() / "lecture.json");
    const Result<Json> document =
        text ? guarded([&] { return parse_document(*text, ""); }) : Result<Json>(Error{text.error()});
    std::vector<std::string> names;
    if (!document || !document->is_object() || !document->contains("presets")) return names;
    for (const Json& name : (*document)["presets"])
        if (name.is_string()) names.push_back(name.get<std::string>());
    return names;
}

LoadedState preset_state(const std::string& name, const Params& params, const fs::path& base) {
    LoadedState state{params, base, name + ".json: scene"};
    state.preset = std::make_shared<const OpenPreset>(OpenPreset{name, params});
    state.reach = {false, {}};
    return state;
}

Result<LoadedState> parsed(const Result<std::string>& text, const std::string& source, const fs::path& base) {
    if (!text) {
        return Error{text.error()};
    }
    Result<StateDocument> state = parse_state_document(*text, source);
    if (!state) {
        return Error{state.error()};
    }
    return LoadedState{
        std::move(state->params), base, source + ": scene", nullptr, std::move(state->titles), std::move(state->flight),
        reach_of_folder(base)};
}

Result<std::string> state_in_figure(const fs::path& path) {
    Result<std::string> note = read_figure_note(path);
    if (note && note->empty())
        return Error{one_line(path.string()) +
                     ": this picture contains no state; only pictures of one state that this program has written do"};
    return note;
}

/// Loads the state or preset that a link names. A link has no folder, so its state may read no files outside the assets
/// without permission.
Result<LoadedState> state_in_link(const std::string& text) {
    const Result<Link> link = read_link(text);
    if (!link) return Error{link.error()};
    if (link->kind == Link::Kind::lesson)
        return Error{"this link opens a lesson: use viewing-sandbox lesson " + link->text + " --step " +
                     std::to_string(link->step)};
    if (link->kind == Link::Kind::preset) {
        const std::vector<NamedFile> known = presets();
        if (std::none_of(known.begin(), known.end(), [&](const NamedFile& file) { return file.name == link->text; }))
            return Error{"link: " + one_line(link->text) + ": no such preset" + names_hint(link->text, known)};
        return load_state(link->text);
    }
    Result<LoadedState> state = parsed(link->text, "link", "");
    if (state) state->reach = {false, {}};
    return state;
}

Error unknown_state(const std::string& argument) {
    for (const NamedFile& scene : scenes())
        if (scene.name == argument)
            return Error{argument + ": is a scene, not a preset: to see it, use --set scene=" + argument};
    return Error{one_line(argument) + ": neither a file nor a preset" + names_hint(argument, presets())};
}

}  // namespace

std::string names_hint(std::string_view word, std::span<const NamedFile> files) {
    if (files.empty()) {
        return "; there are none: " + assets_problem();
    }
    std::vector<std::string> names;
    for (const NamedFile& file : files) {
        names.push_back(file.name);
    }
    return " (viewing-sandbox presets lists them)" + suggestion(word, names);
}

std::vector<NamedFile> presets() {
    std::vector<NamedFile> files = named_files("presets");
    const std::vector<std::string> order = lecture_order();
    const auto place = [&order](const NamedFile& file) {
        return std::find(order.begin(), order.end(), file.name) - order.begin();
    };
    std::stable_sort(files.begin(), files.end(),
                     [&](const NamedFile& a, const NamedFile& b) { return place(a) < place(b); });
    return files;
}

std::vector<NamedFile> scenes() {
    return named_files("scenes");
}

Result<LoadedState> load_state(const std::string& argument) {
    if (argument.empty()) {
        return preset_state(opening, Params{}, assets_directory() / "presets");
    }
    if (is_link(argument)) return state_in_link(argument);
    const fs::path path(argument);
    const bool is_name = !path.has_parent_path() && path.extension() != ".json";
    if (const fs::path assets = assets_directory(); is_name && !assets.empty()) {
        const fs::path preset = assets / "presets" / (argument + ".json");
        if (std::error_code error; fs::exists(preset, error)) {
            Result<LoadedState> state = parsed(read_text_file(preset), argument + ".json", preset.parent_path());
            if (!state) return Error{state.error()};
            LoadedState named = preset_state(argument, state->params, state->base);
            named.titles = std::move(state->titles);
            return named;
        }
    }
    if (std::error_code error; is_name && !fs::exists(path, error)) {
        return unknown_state(argument);
    }
    if (is_figure_name(path)) return parsed(state_in_figure(path), argument, path.parent_path());
    return parsed(read_text_file(path), argument, path.parent_path());
}

Result<LoadedState> state_in_text(const std::string& text, const std::string& source) {
    return is_link(text) ? state_in_link(text) : parsed(text, source, "");
}

}  // namespace viewing
