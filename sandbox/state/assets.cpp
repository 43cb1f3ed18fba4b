// Finds the assets directory and reports any problem with it.
#include <cstdlib>
#include <vector>

#include "platform/child_process.h"
#include "platform/file.h"
#include "state/scene.h"
#include "text/words.h"

namespace viewing {

namespace fs = std::filesystem;

namespace {

constexpr const char* variable = "VIEWING_SANDBOX_ASSETS";

/// Returns the variable's value; "" if it is not set.
std::string chosen_by_variable() {
    const char* chosen = std::getenv(variable);
    return chosen != nullptr ? chosen : "";
}

}  // namespace

std::string assets_problem() {
    const std::string chosen = chosen_by_variable();
    const std::string blamed =
        std::string("the environment variable ") + variable + " says that the assets are in " + one_line(chosen) + ", ";
    const fs::path assets = assets_directory();
    if (assets.empty() && !chosen.empty()) return blamed + "which is not a folder";
    if (assets.empty())
        return std::string(
                   "there is neither an assets folder beside the program nor ../share/viewing-sandbox; name one "
                   "with the environment variable ") +
               variable;
    std::vector<std::string> missing;
    for (const char* kind : {"presets", "scenes", "lessons", "exercises"})
        if (files_in(assets / kind, ".json").empty()) missing.emplace_back(kind);
    if (missing.empty()) return "";
    return (chosen.empty() ? "the folder " + one_line(assets.string()) : blamed + "which") + " contains no " +
           joined(missing);
}

fs::path assets_directory() {
    std::error_code error;
    if (const std::string chosen = chosen_by_variable(); !chosen.empty()) {
        return fs::is_directory(chosen, error) ? fs::path(chosen) : fs::path();
    }
    const fs::path program = own_program();
    if (program.empty()) {
        return {};
    }
    const fs::path beside = program.parent_path();
    for (const fs::path& candidate : {beside / "assets", beside.parent_path() / "share" / "viewing-sandbox"}) {
        if (fs::is_directory(candidate, error)) {
            return candidate;
        }
    }
    return {};
}

}  // namespace viewing
