// Finds problems and surprises in a state, as messages that say where each problem comes from. Uses derive()'s numbers
// and plan()'s frame.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "frame/plan/plan.h"
#include "topics/planes/numbers/image_reach.h"

namespace viewing {

/// The kinds of problem, worst first: the picture is wrong; the picture is right, but the user should know something;
/// or the window shows only a part of it.
enum class ProblemKind { wrong, worth_knowing, about_window };

/// A sentence for the user, and the group of fields that caused the problem ("light", "plane", …), with which the
/// sentence is shown.
struct Problem {
    Message sentence;
    std::string_view group;
    ProblemKind kind = ProblemKind::worth_knowing;
    std::string fixed_by = "";  ///< the setting that fixes it, as on the command line; "" if none
    std::string_view id = "";   ///< names the problem for scripts: "depth.test_off"; the same in every language
    bool operator==(const Problem&) const = default;
};

/// Returns all problems. `frame` is the camera's frame: plan() of the same parameters and numbers.
std::vector<Problem> find_problems(const Params& params, const Derived& derived, const Scene& scene,
                                   const FramePlan& frame);

/// Adds a problem if the picture shows no object, not even in a mirror; if a mesh is too small to see; if near or far
/// cuts off objects; or if far cuts off mirror images.
void find_view_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived,
                        const Scene& scene, const std::vector<SeenImage>& images);

/// Adds a problem if culling removes the sides that face the eye, or a BSP tree cuts too little.
void find_cull_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived,
                        const Scene& scene, const std::vector<SeenImage>& images);

/// Identifies a V and P entered by hand, and adds what is wrong with them.
void find_camera_by_hand_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived);

/// Identifies each S and R entered by hand, if possible: a transpose, or the correct matrix for something else.
void find_by_hand_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived);

/// Add the problems of the depth buffer, of shadows and of mirrors: the reason why each switch breaks the picture.
void find_depth_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived,
                         const Scene& scene, const FramePlan& frame, const std::vector<SeenImage>& images);
void find_coarse_depth_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived,
                                const Scene& scene, const std::vector<SeenImage>& images);
/// Returns whether part of a shadow may be in the picture, directly or in a mirror.
bool may_show_shadows(const Params& params, const Derived& derived, const Scene& scene, const FramePlan& frame);
void find_shadow_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived,
                          const Scene& scene, const FramePlan& frame);
void find_mirror_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived,
                          const Scene& scene, const FramePlan& frame, const std::vector<SeenImage>& images);

}  // namespace viewing
