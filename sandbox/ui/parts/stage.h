// What a lesson wants of the window for a while, beside the state: what must not be read yet, what is pointed out, a
// place that is marked. Without a lesson there is nothing of it. Names as lesson/targets.h reads them.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

namespace viewing {

struct Stage {
    /// A place in the world, marked in the camera's and the observer's view.
    struct Target {
        glm::dvec3 point_world{0.0};
        std::string label;
    };

    bool has_lesson = false;
    bool asks = false;  ///< not answered yet: red sentences, advice and formulas of tooltips keep quiet as well
    std::vector<std::string> cover, highlight;
    std::optional<Target> target;
};

}  // namespace viewing
