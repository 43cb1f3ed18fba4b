#include "frame/say.h"

#include "state/file/json.h"

namespace viewing {

void Sayer::add(bool is_so, Sentence said, ProblemKind kind, std::string_view fixed_by) {
    if (!is_so) return;
    const bool is_field = !fixed_by.empty() && fixed_by.find('=') == std::string_view::npos;
    problems_.push_back({std::move(said.text), group_, kind,
                         is_field ? default_setting(fixed_by) : std::string(fixed_by), said.id,
                         std::move(said.values)});
}

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

}  // namespace viewing
