#include "state/file/beside.h"

#include <algorithm>

#include "state/file/reader.h"
#include "state/file/state_json.h"

namespace viewing {

bool may_differ_beside(std::string_view path) {
    constexpr std::string_view common[] = {"version",          "scene",      "ui", "view.beside", "view.lower_left",
                                           "view.lower_right", "view.layout"};
    return (find_field(path) || path == look_at_path) &&
           std::none_of(std::begin(common), std::end(common),
                        [path](std::string_view group) { return is_in(path, group); });
}

Params beside_params(const Params& params) {
    const BesideParams& beside = params.view.beside;
    Params other = params;
    switch (beside.shows) {
        case Beside::nothing:
            break;
        case Beside::depth:
            other.view.shows = Shows::depth;
            break;
        case Beside::other_depth:
            other.depth.format = beside.format;
            other.depth.mapping = beside.mapping;
            break;
        case Beside::settings:
            other = applied(std::move(other), beside.set.all, "view.beside.set: ");
            clamp_to_ranges(other);
            break;
    }
    return other;
}

bool show_beside(Params& params, Params other) {
    std::vector<std::string> set = settings_to(params, std::move(other));
    std::erase_if(set, [](const std::string& setting) {
        return !may_differ_beside(std::string_view(setting).substr(0, setting.find('=')));
    });
    if (set.empty()) return false;
    params.view.beside.shows = Beside::settings;
    // Store the settings as if they were read from a file, so that writing and reading a state changes nothing.
    const Json written = parse_document(print_document(settings_as_json(set)), "");
    params.view.beside.set.all = read_settings(written, {});
    return true;
}

}  // namespace viewing
