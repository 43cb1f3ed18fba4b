#include "topics/camera/numbers/look_at_text.h"

#include "text/numbers.h"

namespace viewing {
namespace {

std::string listed(const glm::dvec3& v) {
    return shortest_number(v.x + 0.0) + ", " + shortest_number(v.y + 0.0) + ", " + shortest_number(v.z + 0.0);
}

}  // namespace

std::string look_at_call(const LookAt& look_at, LookAtCall call) {
    const std::string eye = listed(look_at.eye), center = listed(look_at.center), up = listed(look_at.up);
    switch (call) {
        case LookAtCall::glm:
            return "glm::lookAt(glm::dvec3(" + eye + "), glm::dvec3(" + center + "), glm::dvec3(" + up + "))";
        case LookAtCall::glu:
            return "gluLookAt(" + eye + ", " + center + ", " + up + ");";
        case LookAtCall::three:
            break;
    }
    return "camera.position.set(" + eye + ");\ncamera.up.set(" + up + ");\ncamera.lookAt(" + center + ");";
}

}  // namespace viewing
