// What is wrong or surprising in a state, as sentences with the place where their cause lies: of numbers that derive()
// has found and the frame that plan() has made of them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "frame/plan.h"

namespace viewing {

/// A sentence for a person, and the group of fields where its cause lies ("light", "plane", …): it is shown there.
struct Problem {
    std::string sentence;
    std::string_view group;
    bool breaks_picture = false;  ///< by a switch: said over the picture, too
    std::string mended_by = "";   ///< the setting that puts the switch right, as on the command line; "" if none
};

/// `frame` is the camera's: plan() of the same parameters and numbers.
std::vector<Problem> find_problems(const Params& params, const Derived& derived, const Scene& scene,
                                   const FramePlan& frame);

/// The part of it on pictures that show no object at all.
void find_view_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived,
                        const Scene& scene);

/// The parts of it on the depth buffer, on shadows and on mirrors: every switch that breaks a picture says why.
void find_depth_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived,
                         const Scene& scene);
void find_shadow_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived,
                          const Scene& scene);
void find_mirror_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived,
                          const Scene& scene, const FramePlan& frame);

}  // namespace viewing
