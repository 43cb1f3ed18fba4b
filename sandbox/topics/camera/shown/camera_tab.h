// The camera's pose in the panel, written in two ways: yaw, pitch and roll, or eye, center and up. Params hold the
// angles; the second way is derived from them and converted back on every edit.
#pragma once

#include <optional>

#include "state/params.h"

namespace viewing {

struct CameraTab {
    bool shows_look_at = false;
    /// The typed numbers, while they still describe the state's camera: the angles do not determine the length of up or
    /// the distance of the center.
    std::optional<LookAt> typed;
};

/// Draws the camera's pose as position and angles or as gluLookAt arguments, and the choice between the two. If the
/// state lists the controls to show, or a lesson covers part of the pose, only position and angles appear.
void draw_camera_pose(CameraTab& tab, Params& params);

}  // namespace viewing
