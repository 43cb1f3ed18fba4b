// Moves the camera by held keys and mouse drags. It flies with six degrees of freedom, walks with two, or orbits about
// a target, and can also make three well-known mistakes of such code. Pure: the same start, input and time give the
// same pose on any machine. Source: lecture, Camera Movement: Navigation. Read state/params.h next.
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
    glm::dvec2 look_deg{0.0};                   ///< mouse: yaw (left positive), pitch (up positive); immediate
    glm::dvec2 pan{0.0};  ///< fly, orbit: shift of the eye (in orbit, also of the target) right and up, world units;
                          ///< immediate
    double dolly = 0.0;   ///< fly, walk: distance forward, world units; immediate
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

/// The motion that continues between steps. In fly and walk it is along the camera's own axes (walk: along its heading
/// on the ground); in orbit, velocity.z moves toward the target.
struct Motion {
    glm::dvec3 velocity{0.0};       ///< right, up, forward, world units per second
    glm::dvec3 turn_rate_deg{0.0};  ///< pitch, yaw, roll (about x, y, z), degrees per second
    bool past_pole = false;         ///< with pole_flip: the orbit has passed the pole

    /// Returns whether all motion has stopped: without input, no further step changes anything.
    bool at_rest() const;
};

struct MotionTuning {
    double speed = 2.5;         ///< world units per second; in orbit, 2.5 divides the distance by e = 2.718 per second
    double turn_deg = 60.0;     ///< degrees per second
    double smoothing_s = 0.12;  ///< time constant of starting and stopping; 0 starts and stops immediately
};

/// Returns the pose after dt_s seconds; `motion` keeps the motion that continues. Stopped motion is exactly 0. Steps of
/// any length give the same path; a stall of more than a quarter of a second counts as a quarter, and a negative or NaN
/// dt_s counts as 0. Walk keeps height, pitch and roll to the last bit. Orbit keeps the eye's distance and the roll,
/// and its pitch within ±89.9°; the camera moves as if bolted to the target, whether or not it looks at it.
Pose step(const Pose& pose, Motion& motion, const MotionInput& input, Navigation mode, const MotionSlips& slips,
          const MotionTuning& tuning, double dt_s);

/// One indicator per degree of freedom.
struct MovingFreedoms {
    bool forward = false, strafe = false, lift = false, yaw = false, pitch = false, roll = false;
    bool operator==(const MovingFreedoms&) const = default;
};

/// Returns the freedoms of a mode: all six for fly, forward and yaw for walk, all but roll for orbit.
MovingFreedoms available_freedoms(Navigation mode);

/// Returns the available freedoms that are moving, from continuing motion or from this step's mouse motion.
MovingFreedoms moving_freedoms(const Motion& motion, const MotionInput& input, Navigation mode);

}  // namespace viewing
