#include "suite/picture_script.h"

#include "state/file/document.h"
#include "text/html.h"

namespace viewing {

std::string picture_script(const std::string& name, std::string_view expected, std::string_view actual,
                           std::string_view difference) {
    const auto data = [](std::string_view png) {
        return "\"data:image/png;base64," + base64({reinterpret_cast<const std::uint8_t*>(png.data()), png.size()}) +
               "\"";
    };
    return "pictures(" + Json(name).dump() + ", {\"expected\": " + data(expected) + ",\n \"actual\": " + data(actual) +
           ",\n \"difference\": " + data(difference) + "});\n";
}

}  // namespace viewing
