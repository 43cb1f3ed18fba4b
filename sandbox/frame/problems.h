// What is wrong or surprising in a state, as sentences with the place where their cause lies.
#pragma once

#include "frame/derive.h"

namespace viewing {

/// Everything in `derived` but its problems must be there already.
std::vector<Problem> find_problems(const Params& params, const Derived& derived, const Scene& scene);

/// The parts of it on the depth buffer, on shadows and on mirrors: every switch that breaks a picture says why.
void find_depth_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived,
                         const Scene& scene);
void find_shadow_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived,
                          const Scene& scene);
void find_mirror_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived,
                          const Scene& scene);

}  // namespace viewing
