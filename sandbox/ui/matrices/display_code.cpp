#include "ui/matrices/display_code.h"

#include <string>

#include "text/numbers.h"
#include "ui/parts/look.h"

namespace viewing {

using widgets::Role;

void draw_display_code(const Params& params, const Derived& derived) {
    const CameraParams& camera = params.camera;
    const ProjectionParams& projection = params.projection;
    const widgets::Context& context = widgets::CurrentContext();
    const auto line = [&](Role role, const std::string& code) {
        ImGui::PushFont(context.fonts.small_number);
        ImGui::PushStyleColor(ImGuiCol_Text, role == Role::none ? context.palette.text : context.palette.of(role));
        ImGui::TextUnformatted(code.c_str());
        ImGui::PopStyleColor();
        ImGui::PopFont();
    };
    // 0 − x, since −x would print a zero as −0.
    const auto opposite = [](double value, int decimals) { return plain_decimals(0.0 - value, decimals); };
    const std::string range = plain_decimals(projection.near, 3) + ", " + plain_decimals(projection.far, 1) + ");";
    const double half_width = projection.height * derived.aspect * 0.5, half_height = projection.height * 0.5;

    line(Role::none, "void display() {");
    if (projection.type == ProjectionType::perspective)
        line(Role::none, "  P = perspective(radians(" + plain_decimals(projection.fovy, 1) + "),\n      " +
                             plain_decimals(derived.aspect, 3) + ", " + range);
    else
        line(Role::none, "  P = ortho(" + plain_decimals(-half_width, 2) + ", " + plain_decimals(half_width, 2) +
                             ",\n      " + plain_decimals(-half_height, 2) + ", " + plain_decimals(half_height, 2) +
                             ", " + range);
    line(Role::none, "  V = mat4(1);  // move the world instead:");
    line(Role::camera, "  W = rotate(radians(" + opposite(camera.roll, 1) + "), z)  // −roll");
    line(Role::camera, "    * rotate(radians(" + opposite(camera.pitch, 1) + "), x)  // −pitch");
    line(Role::camera, "    * rotate(radians(" + opposite(camera.yaw, 1) + "), y)  // −heading");
    line(Role::camera, "    * translate(" + opposite(camera.position.x, 2) + ", " + opposite(camera.position.y, 2) +
                           ", " + opposite(camera.position.z, 2) + ");");
    line(Role::none, "  drawObjects();  // with P V W\n}");
}

}  // namespace viewing
