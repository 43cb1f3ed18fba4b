// How held keys and mouse drags move the camera: fly with six degrees of freedom, walk with two, orbit about a target,
// and three famous slips of such code. Pure: the same start, input and time give the same pose on any machine.
// Source: lecture, Camera Movement: Navigation. Read state/params.h next.
#pragma once

#include <glm/glm.hpp>

#include "geometry/camera.h"

namespace viewing {

/// Six degrees of freedom, two, or about a target.
enum class Navigation { fly, walk, orbit };

/// What is held, or was moved since the last step.
struct MotionInput {
    glm::dvec3 move{0.0};                       ///< held keys: right, up, forward, each −1 … 1
    double yaw = 0.0, pitch = 0.0, roll = 0.0;  ///< held keys: −1 … 1, positive turns left, looks up, leans left
    glm::dvec2 look_deg{0.0};                   ///< mouse: yaw (left positive), pitch (up positive); acts at once
    glm::dvec2 pan{0.0};  ///< fly, orbit: shift of the eye (orbit: and the target), view right and
                          ///< up, world units; acts at once
    double dolly = 0.0;   ///< fly, walk: way forward, world units; acts at once
    double zoom = 1.0;    ///< orbit: factor on the distance to the target, above 0
    bool slow = false;    ///< held keys act at a quarter of the speed

    /// Nothing is held and nothing was moved.
    bool idle() const;
};

/// The slips to show (facts: creeping roll, walking that slows down, the flip at the pole).
struct MotionSlips {
    bool walk_slows = false;     ///< walk along the view direction, then put the height back
    bool creeping_roll = false;  ///< in walk and orbit, yaw and pitch both about the camera's own axes
    bool pole_flip = false;      ///< orbit without a limit, by a look-at whose up is always world y
};

struct Pose {
    glm::dvec3 position{0.0};
    Angles angles;
    glm::dvec3 target{0.0};  ///< what orbit turns about
};

/// What goes on between steps. In fly and walk along the camera's own axes (walk: its heading on the ground); in orbit
/// velocity.z closes in on the target.
struct Motion {
    glm::dvec3 velocity{0.0};       ///< right, up, forward, world units a second
    glm::dvec3 turn_rate_deg{0.0};  ///< pitch, yaw, roll (about x, y, z), degrees a second
    bool past_pole = false;         ///< with the slip pole_flip: the orbit has gone over the top

    /// Nothing moves any more: no further step changes anything without input.
    bool at_rest() const;
};

struct MotionTuning {
    double speed = 2.5;         ///< world units a second; in orbit 2.5 brings the eye e times nearer in a second
    double turn_deg = 60.0;     ///< degrees a second
    double smoothing_s = 0.12;  ///< time constant of start and stop; 0 starts and stops at once
};

/// The pose after dt_s seconds, and in `motion` what is still going on then. What has come to rest rests exactly. Steps
/// of any length give the same path; a stall of more than a quarter of a second counts as that, a dt_s that is not
/// above 0 as 0. Walk keeps height, pitch and roll to the last bit. Orbit keeps the eye's distance and the roll, its
/// pitch within ±89.9°; it moves as if bolted to the target, whether or not it looks at it.
Pose step(const Pose& pose, Motion& motion, const MotionInput& input, Navigation mode, const MotionSlips& slips,
          const MotionTuning& tuning, double dt_s);

/// The degrees of freedom, as lamps.
struct MovingFreedoms {
    bool forward = false, strafe = false, lift = false, yaw = false, pitch = false, roll = false;
    bool operator==(const MovingFreedoms&) const = default;
};

/// What a mode can move: fly all six, walk forward and yaw, orbit all but roll.
MovingFreedoms available_freedoms(Navigation mode);

/// What moves now, of what is available: from what goes on and from this step's mouse.
MovingFreedoms moving_freedoms(const Motion& motion, const MotionInput& input, Navigation mode);

}  // namespace viewing
