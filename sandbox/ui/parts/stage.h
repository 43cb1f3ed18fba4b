// A lesson's temporary changes to the window that are not part of the state: covered parts, highlighted parts, and a
// marked place. Empty without a lesson, except for the aspect ratio. lesson/target_names.h defines the names.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

namespace viewing {

struct Stage {
    /// A place in the world, marked in the camera and observer views.
    struct Target {
        glm::dvec3 point_world{0.0};
        std::string label;
    };

    bool is_of_lesson = false;
    bool asks = false;  ///< the question is still open: also hide red sentences, advice, and formulas in tooltips
    std::vector<std::string> cover, highlight;
    std::optional<Target> target;
    /// A camera view narrower than this aspect ratio still shows as much width as at this ratio, since a view on stage
    /// may be narrower than the one that a step or a preset was written for. 0: always use the state's lens.
    double least_aspect = 0.0;
    static constexpr double written_for = 1.6;
};

}  // namespace viewing
