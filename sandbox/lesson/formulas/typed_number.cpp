#include "lesson/formulas/typed_number.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include "lesson/formulas/expression.h"

namespace viewing {

std::optional<double> typed_number(std::string_view text) {
    struct Sign {
        std::string_view typed, meant;
    };
    const std::string_view degree = text.find('(') == std::string_view::npos ? "" : "*pi/180";
    const Sign signs[] = {{"−", "-"}, {"·", "*"}, {"×", "*"}, {"÷", "/"}, {"π", "pi"}, {"√", "sqrt"}, {"°", degree}};
    std::string formula;
    while (!text.empty()) {
        const Sign* const end = std::end(signs);
        const Sign* const sign =
            std::find_if(std::begin(signs), end, [&](const Sign& one) { return text.starts_with(one.typed); });
        formula += sign == end ? text.substr(0, 1) : sign->meant;
        text.remove_prefix(sign == end ? 1 : sign->typed.size());
    }
    const Surroundings nothing{[](const std::string& name, std::span<const double>) -> Result<Json> {
                                   return Error{name + " has no value here"};
                               },
                               nullptr, nullptr};
    // The parentheses make a comma an error. Without them, it would begin a second value, which Lua would ignore.
    const Result<Json> value = evaluate("(" + formula + ")", nothing, {.instructions = 20'000});
    if (!value || !value->is_number() || !std::isfinite(value->get<double>())) return std::nullopt;
    return value->get<double>();
}

}  // namespace viewing
