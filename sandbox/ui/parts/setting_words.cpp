#include "ui/parts/setting_words.h"

#include <algorithm>
#include <optional>
#include <string_view>

#include "state/fields.h"
#include "text/catalogue.h"
#include "text/numbers.h"

namespace viewing {
namespace {

/// Returns a JSON value in readable form: on or off for a switch, rounded numbers, a list in parentheses.
std::string value_in_words(std::string_view value, int digits) {
    if (value == "true") return tr("on");
    if (value == "false") return tr("off");
    std::string words;
    while (!value.empty()) {
        const std::size_t end = std::min(value.find_first_of("[],\""), value.size());
        const std::optional<double> number = parse_double(value.substr(0, end));
        if (number)
            words += digits == all_digits ? shortest_number(*number) : figures(*number, digits);
        else
            words += value.substr(0, end);
        if (end == value.size()) break;
        if (value[end] != '"') words += value[end] == '[' ? "(" : value[end] == ']' ? ")" : ", ";
        value.remove_prefix(end + 1);
    }
    return words;
}

}  // namespace

std::string setting_in_words(const std::string& setting, int digits) {
    const std::string path = path_of(setting);
    const Field* const known = find_field(path);
    const std::string label = known ? tr(std::string(known->label).c_str()) : path;
    return label + " " + value_in_words(std::string_view(setting).substr(path.size() + 1), digits);
}

}  // namespace viewing
