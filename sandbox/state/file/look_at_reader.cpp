// Reads a camera given as eye, center and up.
#include <algorithm>
#include <array>

#include "state/file/reader.h"

namespace viewing {
namespace {

constexpr std::array<std::string_view, 4> replaced{"camera.position", "camera.yaw", "camera.pitch", "camera.roll"};
constexpr const char* look_at_form = "{\"eye\": [x, y, z], \"center\": [x, y, z], \"up\": [x, y, z]}";

}  // namespace

std::span<const std::string_view> fields_of_look_at() {
    return replaced;
}

Json look_at_as_json(const LookAt& look_at) {
    return {{"eye", vector_as_json(look_at.eye)},
            {"center", vector_as_json(look_at.center)},
            {"up", vector_as_json(look_at.up)}};
}

LookAt read_look_at(const Json& value, const Where& where) {
    require_object(value, where, look_at_form);
    require_keys(value, where, {"eye", "center", "up"});
    const Field& position = field("camera.position");
    LookAt look_at;
    const auto read = [&](const char* key, glm::dvec3& vector) {
        if (value.contains(key))
            vector = read_vec3(value[key], where.key(key), {position.min, position.max}, allowed_text(position));
        else if (std::string_view(key) != "up")
            where.key(key).refuse("is missing: look_at is " + std::string(look_at_form));
    };
    read("eye", look_at.eye);
    read("center", look_at.center);
    read("up", look_at.up);
    switch (camera_looking_at(look_at).fault) {
        case LookAtFault::center_is_eye:
            where.key("center").refuse("must differ from eye: the camera looks from eye toward center");
        case LookAtFault::up_along_view:
            where.key("up").refuse(
                "must be neither zero nor parallel to center − eye, which would leave the roll undefined; if the "
                "camera looks straight down, [0, 0, -1] puts −z at the top of the picture");
        case LookAtFault::none:
            break;
    }
    return look_at;
}

void require_one_camera(const Json& camera, const Where& where) {
    if (!camera.contains("look_at")) return;
    for (const std::string_view path : replaced) {
        const std::string name(field(path).name());
        if (camera.contains(name))
            where.key("look_at").refuse("is given together with " + std::string(path) +
                                        ": write the camera either as look_at or as position, yaw, pitch and roll");
    }
}

}  // namespace viewing
