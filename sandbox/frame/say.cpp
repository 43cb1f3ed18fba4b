#include "frame/say.h"

#include "state/file/state_json.h"
#include "text/numbers.h"

namespace viewing {

void Sayer::add(bool is_so, Sentence said, ProblemKind kind, std::string_view fixed_by) {
    if (!is_so) return;
    const bool is_field = !fixed_by.empty() && fixed_by.find('=') == std::string_view::npos;
    problems_.push_back(
        {std::move(said.message), group_, kind, is_field ? default_setting(fixed_by) : std::string(fixed_by), said.id});
}

std::string near_setting(ProjectionParams projection, double near) {
    if (projection.type != ProjectionType::frustum) return "projection.near=" + plain_number(near);
    projection.move_near(near);
    return fmt::format(R"(projection={{"near": {}, "left": {:.6g}, "right": {:.6g}, "bottom": {:.6g}, "top": {:.6g}}})",
                       plain_number(near), projection.left, projection.right, projection.bottom, projection.top);
}

Message light_name(std::size_t light, std::size_t count) {
    return count == 1 ? message("the light") : message("light {light}", "light"_a = light + 1);
}

Message planes_name(std::span<const std::size_t> planes, std::size_t count) {
    if (count == 1) return message("the plane");
    const std::string numbers = numbers_name(planes);
    return planes.size() == 1 ? message("plane {planes}", "planes"_a = numbers)
                              : message("planes {planes}", "planes"_a = numbers);
}

std::string numbers_name(std::span<const std::size_t> indices) {
    std::string numbers;
    for (const std::size_t index : indices) numbers += (numbers.empty() ? "" : ", ") + std::to_string(index + 1);
    return numbers;
}

}  // namespace viewing
