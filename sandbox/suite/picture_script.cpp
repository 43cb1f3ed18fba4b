#include "suite/picture_script.h"

#include "state/document.h"
#include "text/html.h"

namespace viewing {

std::string picture_script(const std::string& name, std::span<const std::uint8_t> expected,
                           std::span<const std::uint8_t> actual, std::span<const std::uint8_t> difference) {
    const auto data = [](std::span<const std::uint8_t> png) { return "\"data:image/png;base64," + base64(png) + "\""; };
    return "pictures(" + Json(name).dump() + ", {\"expected\": " + data(expected) + ",\n \"actual\": " + data(actual) +
           ",\n \"difference\": " + data(difference) + "});\n";
}

}  // namespace viewing
