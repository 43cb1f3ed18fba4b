// Moves the camera by held keys and mouse drags. It flies with six degrees of freedom, walks with two, or orbits about
// a target, and can also reproduce three well-known mistakes in such code. Pure: the same start, input and time give
// the same pose on any machine. Source: lecture, Camera Movement: Navigation. Read state/params.h next.
#pragma once

#include <glm/glm.hpp>

#include "geometry/camera.h"

namespace viewing {

/// The camera flies with six degrees of freedom, walks with two, or orbits about a target.
enum class Navigation { fly, walk, orbit };

/// The keys that are held, and the mouse motion since the last step.
struct MotionInput {
    glm::dvec3 move{0.0};                       ///< held keys: right, up, forward, each −1 … 1
    double yaw = 0.0, pitch = 0.0, roll = 0.0;  ///< held keys: −1 … 1, positive turns left, looks up, leans left
    glm::dvec2 look_deg{0.0};                   ///< mouse: yaw (left positive), pitch (up positive); not smoothed
    bool keeps_horizon =
        false;                  ///< fly: look_deg turns yaw about world y and pitch about the camera's level right axis
    glm::dvec2 orbit_deg{0.0};  ///< mouse, like look_deg: in fly, carries the camera about orbit_center, with a level
                                ///< horizon; in orbit and walk, the same as look_deg
    glm::dvec3 orbit_center{0.0};  ///< world
    glm::dvec2 pan{0.0};  ///< fly, orbit: shift of the eye (in orbit, also of the target) to the right and up, in
                          ///< world units; not smoothed
    double dolly = 0.0;   ///< fly, walk: distance forward, world units; not smoothed
    double zoom = 1.0;    ///< orbit: multiplies the distance to the target, above 0
    bool slow = false;    ///< held keys act at a quarter of the speed

    /// Returns whether no key is held and the mouse has not moved.
    bool idle() const;
};

/// The mistakes to demonstrate (creeping roll, walking that slows down, the flip at the pole).
struct MotionSlips {
    bool walk_slows = false;     ///< walks along the view direction, then restores the height
    bool creeping_roll = false;  ///< in walk and orbit, yaw and pitch both turn about the camera's own axes
    bool pole_flip = false;      ///< orbits without a pitch limit, using a look-at whose up is always world y
};

struct Pose {
    glm::dvec3 position{0.0};
    Angles angles;
    glm::dvec3 target{0.0};  ///< the center of the orbit
};

/// The motion that continues from one step to the next. In fly it is along the camera's own axes, in walk along the
/// camera's heading on the ground; in orbit, velocity.z moves toward the target.
struct Motion {
    glm::dvec3 velocity{0.0};       ///< right, up, forward, world units per second
    glm::dvec3 turn_rate_deg{0.0};  ///< pitch, yaw, roll (about x, y, z), degrees per second
    bool past_pole = false;         ///< with pole_flip: the orbit has passed the pole

    /// Returns whether all motion has stopped, so that without input no further step changes anything.
    bool at_rest() const;
};

struct MotionTuning {
    double speed = 2.5;         ///< world units per second; in orbit, 2.5 divides the distance by e = 2.718 each second
    double turn_deg = 60.0;     ///< degrees per second
    double smoothing_s = 0.12;  ///< time constant of starting and stopping; 0 starts and stops immediately
};

/// Returns the pose after dt_s seconds, and leaves in `motion` the motion that continues; motion that has stopped is
/// exactly 0. The length of the steps hardly affects the path, because each is divided into short substeps. A dt_s
/// above a quarter of a second counts as a quarter of a second, and a negative or NaN dt_s counts as 0. Walk keeps
/// height, pitch and roll to the last bit. Orbit keeps the roll, keeps the eye's distance unless it zooms, and does not
/// turn the pitch beyond ±89.9°; the camera moves as if bolted to the target, whether or not it looks at the target.
Pose step(const Pose& pose, Motion& motion, const MotionInput& input, Navigation mode, const MotionSlips& slips,
          const MotionTuning& tuning, double dt_s);

/// One flag per degree of freedom.
struct MovingFreedoms {
    bool forward = false, strafe = false, lift = false, yaw = false, pitch = false, roll = false;
    bool operator==(const MovingFreedoms&) const = default;
};

/// Returns the freedoms of a mode: all six for fly, forward and yaw for walk, all but roll for orbit.
MovingFreedoms available_freedoms(Navigation mode);

/// Returns the freedoms that held keys request, available or not.
MovingFreedoms asked_freedoms(const MotionInput& input);

/// Returns the available freedoms in which the camera moves, due to continuing motion or this step's mouse motion.
MovingFreedoms moving_freedoms(const Motion& motion, const MotionInput& input, Navigation mode);

}  // namespace viewing
