#include "frame/say.h"

#include <cmath>

#include "text/numbers.h"

namespace viewing {

std::string light_name(std::size_t light, std::size_t count) {
    return count == 1 ? tr("the light") : say("light {light}", "light"_a = light + 1);
}

std::string planes_name(std::span<const std::size_t> planes, std::size_t count) {
    if (count == 1) return tr("the plane");
    return say_count(static_cast<std::int64_t>(planes.size()), "plane {planes}", "planes {planes}",
                     "planes"_a = numbers_name(planes));
}

std::string numbers_name(std::span<const std::size_t> indices) {
    std::string numbers;
    for (const std::size_t index : indices) numbers += (numbers.empty() ? "" : ", ") + std::to_string(index + 1);
    return numbers;
}

std::string name_of(const char* thing, const std::vector<std::size_t>& which, std::size_t count) {
    if (count == 1) return std::string("the ") + thing;
    std::string name = std::string(thing) + (which.size() > 1 ? "s" : "");
    for (std::size_t i = 0; i < which.size(); ++i) name += (i > 0 ? ", " : " ") + std::to_string(which[i] + 1);
    return name;
}

std::string signed_figures(double value) {
    if (value == 0.0) return "0";
    return (value < 0.0 ? "−" : "") + figures(std::abs(value), 3);
}

}  // namespace viewing
