#include "lesson/allowed.h"

#include <algorithm>

#include "state/reader.h"

namespace viewing {
namespace {

void add_differences(const Json& a, const Json& b, const std::string& path, std::vector<std::string>& paths) {
    if (a == b) return;
    if (!a.is_object() || !b.is_object() || (!path.empty() && !is_group(path))) return paths.push_back(path);
    for (const auto& [key, value] : a.items())
        add_differences(value, b.contains(key) ? b[key] : Json(), path.empty() ? key : path + "." + key, paths);
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
        const std::string always[] = {"view", "observer", "ui", "animation"};
        return std::any_of(allow.begin(), allow.end(), has) || std::any_of(std::begin(always), std::end(always), has);
    });
    return paths;
}

}  // namespace viewing
