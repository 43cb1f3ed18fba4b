#include "topics/camera/shown/camera_tab.h"

#include <algorithm>
#include <iterator>

#include "text/catalogue.h"
#include "topics/camera/numbers/look_at_text.h"
#include "ui/parts/field_controls.h"
#include "ui/parts/links.h"
#include "ui/parts/look.h"
#include "ui/parts/panel_parts.h"

namespace viewing {
namespace {

constexpr const char* pose_targets[] = {"control:camera.position", "control:camera.yaw", "control:camera.pitch",
                                        "control:camera.roll"};

/// Draws the three angles in one row or, if the state lists its controls, each angle in its own row.
void camera_angles(Params& params) {
    if (widgets::IsListing()) {
        static constexpr widgets::Links yaw[] = {link::yaw}, pitch[] = {link::pitch}, roll[] = {link::roll};
        control(params, "camera.yaw", {.decimals = 1, .links = yaw});
        control(params, "camera.pitch", {.decimals = 1, .links = pitch});
        control(params, "camera.roll", {.decimals = 1, .links = roll});
        return;
    }
    double angles[] = {params.camera.yaw, params.camera.pitch, params.camera.roll};
    static constexpr widgets::Links links[] = {link::yaw, link::pitch, link::roll};
    static constexpr double defaults[] = {30.6, -16.4, 0.0};
    const Field& turn = field("camera.yaw");
    const widgets::NumberStyle style{.min = turn.min,
                                     .max = turn.max,
                                     .drag_min = -360.0,
                                     .drag_max = 360.0,
                                     .step = 0.2,
                                     .decimals = 1,
                                     .unit = "°"};
    static constexpr const char* targets[] = {"control:camera.yaw", "control:camera.pitch", "control:camera.roll"};
    {
        const widgets::TargetScope scope(targets);
        if (widgets::Numbers("yaw pitch roll", angles, style, defaults, links)) {
            params.camera.yaw = angles[0];
            params.camera.pitch = angles[1];
            params.camera.roll = angles[2];
        }
    }
    if (std::any_of(std::begin(targets), std::end(targets), widgets::IsCovered)) return;
    widgets::Tooltip("Yaw, pitch, roll",
                     "Yaws about y, then pitches about the camera's x axis, then rolls about its z axis.",
                     "C = T R_y R_x R_z");
}

/// Returns the numbers to show: the typed ones while they still describe the camera, otherwise those derived from it.
LookAt shown_look_at(const CameraTab& tab, const CameraParams& camera) {
    if (!tab.typed) return camera.look_at();
    CameraParams typed_camera = camera;
    typed_camera.look(*tab.typed);
    return typed_camera == camera ? *tab.typed : camera.look_at();
}

void copy_buttons(const LookAt& look_at) {
    struct Copy {
        const char* label;
        LookAtCall call;
    };
    static constexpr Copy copies[] = {
        {"glm::lookAt", LookAtCall::glm}, {"gluLookAt", LookAtCall::glu}, {"three.js", LookAtCall::three}};
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(tr("Copy"));
    for (const Copy& copy : copies) {
        behind(widgets::SmallButtonWidth(copy.label));
        if (widgets::SmallButton(copy.label)) ImGui::SetClipboardText(look_at_call(look_at, copy.call).c_str());
        widgets::Tooltip(copy.label, "Copies this camera as a call for another program, with all its digits.");
    }
}

void look_at_fields(CameraTab& tab, CameraParams& camera) {
    const Field& position = field("camera.position");
    const widgets::NumberStyle style{.min = position.min, .max = position.max, .step = position.step};
    const LookAt start = default_params().camera.look_at();
    LookAt look_at = shown_look_at(tab, camera);
    const auto vector = [&](const char* label, glm::dvec3& value, const glm::dvec3& usual, const char* explained,
                            std::span<const widgets::Links> links) {
        const bool changed = widgets::Vec3(label, value, style, usual, links);
        widgets::Tooltip(label, explained, "V = lookAt(eye, center, up)");
        return changed;
    };
    bool changed =
        vector(marked("eye"), look_at.eye, start.eye,
               marked("The camera's position. The center stays where it is, so the camera turns."), link::position);
    changed |= vector(marked("center"), look_at.center, start.center,
                      marked("The point that appears in the middle of the picture. Only its direction from the eye "
                             "counts, not its distance."),
                      {});
    changed |= vector(marked("up"), look_at.up, start.up,
                      marked("The direction that appears vertical in the picture. It need not be perpendicular to the "
                             "view, and its length does not matter."),
                      {});
    if (changed) {
        camera.look(look_at);
        tab.typed = look_at;
    }
    const LookAtFault fault = camera_looking_at(look_at).fault;
    if (fault == LookAtFault::center_is_eye)
        widgets::Trouble("center = eye: there is no view direction, so the camera looks along −z");
    if (fault == LookAtFault::up_along_view)
        widgets::Trouble("up is zero or parallel to the view, so the roll is undefined and set to 0");
    copy_buttons(look_at);
}

}  // namespace

void draw_camera_pose(CameraTab& tab, Params& params) {
    const bool has_choice =
        !widgets::IsListing() && std::none_of(std::begin(pose_targets), std::end(pose_targets), widgets::IsCovered);
    if (has_choice) {
        static constexpr const char* ways[] = {marked("Angles"), marked("Look at")};
        static constexpr const char* tips[] = {marked("The camera as position, yaw, pitch and roll."),
                                               marked("The camera as gluLookAt arguments: eye, center and up.")};
        int way = tab.shows_look_at ? 1 : 0;
        if (widgets::Segments("##pose", way, ways, 0, tips)) tab.shows_look_at = way == 1;
        if (widgets::IsSought(pose_targets)) tab.shows_look_at = false;
        if (tab.shows_look_at) return look_at_fields(tab, params.camera);
    }
    control(params, "camera.position",
            {.links = link::position, .label = label_of(marked("position"), marked("camera position###position"))});
    camera_angles(params);
}

}  // namespace viewing
