// How the user moves the camera with the mouse: remembered for the window like the theme, and never part of a state.
#pragma once

namespace viewing {

struct MouseHabits {
    bool keeps_horizon = true;  ///< fly: dragging yaws about the world's up axis, so that it never tilts the horizon
    bool right_pans = false;    ///< the right button pans instead of looking around; in orbit, it always pans
    bool middle_pans = false;   ///< the middle button shifts the picture instead of orbiting; with Shift, vice versa
    bool inverts_y = false;     ///< dragging upward looks down
    double sensitivity = 1.0;   ///< multiplies the angle per pixel; least_sensitivity … greatest_sensitivity
    bool operator==(const MouseHabits&) const = default;
};

inline constexpr double least_sensitivity = 0.1, greatest_sensitivity = 5.0;

}  // namespace viewing
