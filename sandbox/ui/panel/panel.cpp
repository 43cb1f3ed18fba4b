// Each section has its own drawing function. Each section's header reports the problems that arise from the section's
// settings.
#include "ui/panel/panel.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "text/catalogue.h"
#include "topics/camera/shown/projection_section.h"
#include "topics/depth/shown/depth_panel.h"
#include "topics/hidden/numbers/hidden_method.h"
#include "topics/planes/shown/shadow_panel.h"
#include "ui/panel/beside_panel.h"
#include "ui/parts/field_controls.h"
#include "ui/parts/look.h"
#include "ui/parts/panel_parts.h"

namespace viewing {
namespace {

using widgets::Lamp;
using widgets::Role;

void camera_lamps(const Session& session) {
    const Navigation mode = session.params.camera.navigation;
    const MovingFreedoms can = available_freedoms(mode);
    const MovingFreedoms& now = session.moving_freedoms();
    const MovingFreedoms& asked = session.asked_freedoms();
    const Lamp lamps[] = {{marked("forward"), can.forward, now.forward, "W S", asked.forward},
                          {marked("strafe"), can.strafe, now.strafe, "A D", asked.strafe},
                          {marked("up/down"), can.lift, now.lift, "R F", asked.lift},
                          {marked("yaw"), can.yaw, now.yaw, "← →", asked.yaw},
                          {marked("pitch"), can.pitch, now.pitch, "↑ ↓", asked.pitch},
                          {marked("roll"), can.roll, now.roll, "Q E", asked.roll}};
    if (!widgets::IsListed(target_of("camera.navigation")) && !widgets::IsHighlighted("lamps")) return;
    if (widgets::IsCovered("lamps")) {
        widgets::Plate("degrees of freedom", {ImGui::GetContentRegionAvail().x, ImGui::GetFrameHeight()});
        return widgets::MarkTarget("lamps");
    }
    const ImVec2 from = ImGui::GetCursorScreenPos();
    widgets::Lamps("degrees of freedom", lamps, Role::camera);
    widgets::MarkTarget("lamps", from, ImGui::GetItemRectMax());
    widgets::Tooltip("Degrees of freedom",
                     "Ring: the degree of freedom is available in this mode. Filled: it is moving now. Red: its key "
                     "is pressed, but this mode does not have it. Fly-through has "
                     "six; walk-through has two: panning about y and walking forward or back.");
}

/// Draws buttons for standard views; each also has a key.
void known_views(Session& session, const Derived& derived) {
    if (widgets::IsListing()) return;
    const float gap = px(4.0F);
    const auto next = [gap](const char* label) {
        const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
        if (ImGui::GetItemRectMax().x + gap + widgets::SmallButtonWidth(label) <= right) ImGui::SameLine(0.0F, gap);
    };
    if (widgets::SmallButton("Home")) session.go_home();
    widgets::Tooltip("Home", "Returns the camera to the pose that it had when this state was opened. Key: Home");
    next("Frame all");
    if (widgets::SmallButton("Frame all")) session.frame_all(derived.aspect);
    widgets::Tooltip("Frame all",
                     "Moves back or forward until the whole scene and its point lights are in view; the viewing "
                     "direction stays the same. Key: G");
    next("Level");
    if (widgets::SmallButton("Level", session.params.camera.roll != 0.0, "The roll is 0.")) session.level();
    widgets::Tooltip("Level", "Removes the roll. Key: L");
    static constexpr const char* axes[] = {"x", "y", "z"};
    for (int axis = 0; axis < 3; ++axis) {
        next(axes[axis]);
        if (widgets::SmallButton(axes[axis])) session.look_along(axis);
        widgets::Tooltip("Look along an axis",
                         "Looks at the target from the positive side of the axis; pressed again, from the negative "
                         "side. Keys: X, Y, Z");
    }
}

/// Draws the speed of flying and walking, which belongs to the user, not to the state.
void speed_control(Session& session) {
    if (widgets::IsListing()) return;
    double speed = session.speed();
    const widgets::NumberStyle style{.min = Session::least_speed,
                                     .max = Session::greatest_speed,
                                     .decimals = 2,
                                     .logarithmic = true,
                                     .default_value = MotionTuning{}.speed};
    ImGui::BeginDisabled(session.params.camera.navigation == Navigation::orbit);
    if (widgets::Slider("speed", speed, style)) session.set_speed(speed);
    ImGui::EndDisabled();
    widgets::Tooltip("Speed",
                     "Speed in world units per second for fly and walk, not for orbit. Hold Shift for a quarter of "
                     "this speed. Ctrl+wheel in the camera view also changes it.");
}

void slips(Params& params) {
    control(params, "slips.walk_slows", {.label = marked("walking slows (walk)")});
    control(params, "slips.creeping_roll", {.label = marked("creeping roll (walk, orbit)")});
    control(params, "slips.pole_flip", {.label = marked("flip at the pole (orbit)")});
    control(params, "slips.swapped_order", {.label = marked("R·T instead of T·R")});
    control(params, "slips.camera_as_view", {.label = marked("C sent as V")});
}

void camera_section(Session& session, const Derived& derived, const std::vector<Problem>& problems, CameraTab& tab) {
    if (!section("Camera", problems, {"camera", "follow"})) return;
    const widgets::Group group("camera");
    Params& params = session.params;
    static constexpr const char* modes[] = {marked("Fly (6 DOF)"), marked("Walk (2 DOF)"), marked("Orbit")};
    control(params, "camera.navigation", {.segments = true, .names = modes, .label = "##navigation"});
    draw_camera_pose(tab, params);
    camera_lamps(session);
    known_views(session, derived);
    control(params, "camera.target", {.label = marked("target")});
    speed_control(session);

    named_section("slips", {}, [&params] {
        static constexpr const char* targets[] = {"control:slips", "section:slips"};
        if (details("Common mistakes", targets)) slips(params);
    });
}

void hidden_surfaces_section(Session& session, const std::vector<Problem>& problems, HiddenPanelState& hidden_state,
                             const HiddenStatus& hidden) {
    const std::string of_method = hidden.answer ? say(hidden.answer->problem()) : "";
    if (!section("Hidden surfaces", problems, {"depth", "visibility"}, of_method)) return;
    const widgets::Group group("depth");
    Params& params = session.params;
    static constexpr const char* funcs[] = {"GL_NEVER",   "GL_LESS",     "GL_EQUAL",  "GL_LEQUAL",
                                            "GL_GREATER", "GL_NOTEQUAL", "GL_GEQUAL", "GL_ALWAYS"};
    static constexpr const char* faces[] = {"GL_FRONT", "GL_BACK", "GL_FRONT_AND_BACK"};
    static constexpr const char* fronts[] = {"GL_CCW", "GL_CW"};
    static constexpr float second = 118.0F, choice = 150.0F;
    control(params, "depth.test", {.label = marked("Depth test")});
    beside(second, px(choice));
    control(params, "depth.func", {.width = choice, .names = funcs, .label = "##func"});
    control(params, "depth.write", {.label = marked("Depth mask")});
    beside(second, widgets::ToggleWidth("Clear depth"));
    control(params, "depth.clear", {.label = marked("Clear depth")});
    control(params, "cull.enabled", {.label = marked("Cull face")});
    beside(second, px(choice));
    control(params, "cull.face", {.width = choice, .names = faces, .label = "##face"});
    if (!widgets::IsListing()) {
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(tr("Front face"));
        beside(second, px(choice));
    }
    const char* const front_label = widgets::IsListing() ? marked("Front face") : "##front_face";
    control(params, "cull.front_face", {.width = choice, .names = fronts, .label = front_label});
    if (control(params, "visibility.method", {.width = choice, .names = method_names(), .label = marked("method")}))
        params.view.lower_right = Topic::automatic;  // the topic that suits the method
    draw_hidden_panel(hidden_state, session, hidden);
}

void observer_section(Session& session) {
    if (!widgets::Section("Observer", false)) return;
    const widgets::Group group("observer");
    control(session.params, "observer.target", {.label = marked("target")});
    control(session.params, "observer.yaw", {.decimals = 1, .label = marked("yaw")});
    control(session.params, "observer.pitch", {.decimals = 1, .label = marked("pitch")});
    control(session.params, "observer.distance", {.label = marked("distance")});
    control(session.params, "observer.light_rays", {.label = marked("Light rays")});
    beside(118.0F, widgets::ToggleWidth("Mirrored eye"));
    control(session.params, "observer.mirrored_eye", {.label = marked("Mirrored eye")});
    control(session.params, "observer.image_space", {.label = marked("Image space")});
}

/// Returns the width of a control, which leaves space for the longest label. A wider panel has longer sliders.
float item_width() {
    const float usual = px(189.0F), room = ImGui::GetContentRegionAvail().x - px(93.0F);
    return room > usual + px(8.0F) ? std::floor(room) : usual;
}

}  // namespace

void draw_panel(Session& session, const Derived& derived, const std::vector<Problem>& problems,
                HiddenPanelState& hidden_state, const HiddenStatus& hidden, CameraTab& tab) {
    ImGui::PushItemWidth(item_width());
    named_section("camera",
                  {"control:camera", "lamps", "button:home", "button:frame all", "button:level", "control:slips",
                   "section:slips"},
                  [&] { camera_section(session, derived, problems, tab); });
    named_section("projection", {"control:projection", "control:slips.degrees_as_radians", "note:depth_step"},
                  [&] { draw_projection_section(session, derived, problems); });
    named_section("visibility",
                  {"control:depth.test", "control:depth.func", "control:depth.write", "control:depth.clear",
                   "control:cull", "control:visibility", "button:find a view where this key fails"},
                  [&] { hidden_surfaces_section(session, problems, hidden_state, hidden); });
    named_section("depth",
                  {"control:depth", "control:coplanar", "control:view.depth_scale", "control:view.depth_colors",
                   "control:animation.jiggle", "note:offset_unit"},
                  [&] { draw_depth_section(session, derived); });
    named_section("light", {"control:light", "control:animation"}, [&] { draw_light_section(session, problems); });
    named_section("plane", {"control:plane", "text:unit normal", "button:normalize"},
                  [&] { draw_plane_section(session, derived, problems); });
    named_section("shadow", {"control:shadow", "control:reflection"},
                  [&] { draw_shadow_and_reflection_section(session, problems); });
    named_section("beside", {"control:view.beside"}, [&] { beside_section(session, problems); });
    named_section("observer", {"control:observer"}, [&] { observer_section(session); });
    ImGui::PopItemWidth();
}

void draw_listed_controls(Session& session, const Derived& derived, const std::vector<Problem>& problems,
                          HiddenPanelState& hidden_state, const HiddenStatus& hidden, CameraTab& tab, bool has_title) {
    std::vector<std::string>& listed = widgets::CurrentContext().targets.listed;
    for (const std::string& path : session.params.view.layout.controls) listed.push_back(target_of(path));
    if (has_title) {
        ImGui::PushFont(widgets::CurrentContext().fonts.heading);
        ImGui::TextUnformatted(tr("Controls"));
        ImGui::PopFont();
    }
    draw_panel(session, derived, problems, hidden_state, hidden, tab);
    listed.clear();
}

}  // namespace viewing
