#include "lesson/allowed.h"

#include <algorithm>

#include "state/file/reader.h"
#include "state/file/state_json.h"

namespace viewing {
namespace {

void add_differences(const Json& a, const Json& b, const std::string& path, std::vector<std::string>& paths) {
    if (a == b) return;
    if (!a.is_object() || !b.is_object() || (!path.empty() && !is_group(path))) return paths.push_back(path);
    for (const auto& [key, value] : a.items())
        add_differences(value, b.contains(key) ? b[key] : Json(), path.empty() ? key : path + "." + key, paths);
}

/// Whether a field affects only how the scene is viewed.
bool is_looking(const std::string& path) {
    constexpr const char* groups[] = {"view", "observer", "ui", "animation"};
    return std::any_of(std::begin(groups), std::end(groups), [&](const char* group) { return is_in(path, group); });
}

}  // namespace

std::vector<std::string> changed_fields(const Params& before, const Params& after) {
    std::vector<std::string> paths;
    add_differences(params_as_document(before), params_as_document(after), "", paths);
    return paths;
}

std::vector<std::string> changed_without_leave(const Params& before, const Params& after,
                                               const std::vector<std::string>& allow) {
    if (allow.empty()) return {};
    std::vector<std::string> paths = changed_fields(before, after);
    std::erase_if(paths, [&](const std::string& path) {
        const auto has = [&](const std::string& group) { return is_in(path, group); };
        return std::any_of(allow.begin(), allow.end(), has) || is_looking(path);
    });
    return paths;
}

Result<Params> changed_start(const LessonStep& step, const std::vector<std::string>& settings) {
    Result<Params> changed = apply_settings(step.start.params, settings, "set ");
    if (!changed) return changed;
    const std::vector<std::string> others = changed_without_leave(step.start.params, *changed, step.ask.allow);
    if (!others.empty()) return Error{"the file changes " + others.front() + ", which the exercise does not allow"};
    return changed;
}

std::vector<std::string> settings_between(const Params& before, const Params& after) {
    std::vector<std::string> settings = settings_to(before, after);
    std::erase_if(settings,
                  [](const std::string& setting) { return is_looking(setting.substr(0, setting.find('='))); });
    return settings;
}

}  // namespace viewing
