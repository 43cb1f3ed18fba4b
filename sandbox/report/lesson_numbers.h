// What the names in a lesson's expressions stand for: the state's fields, its matrices, and what is measured in its
// pictures at one fixed size, whatever the window's is. Read lesson/names.h for the list.
#pragma once

#include <map>
#include <string>

#include "frame/derive.h"
#include "lesson/expression.h"
#include "render/renderer.h"

namespace viewing {

class LessonNumbers {
public:
    /// `start`: the parameters at the beginning of the step. The references must outlive this. Without a renderer what
    /// is measured in pictures is an error.
    LessonNumbers(const Params& now, const Params& start, const Scene& scene, Renderer* renderer);

    /// Refers to this object. What was measured once is kept.
    Surroundings surroundings();

    static constexpr glm::ivec2 size_px{1280, 720};            ///< of what is measured
    static constexpr glm::ivec2 visibility_size_px{640, 360};  ///< of visibility_counts()
    static constexpr int most_counted_polygons = 20'000;       ///< of a scene in visibility_counts(): about a second
    static constexpr std::size_t most_measured = 64;           ///< different ones, each of which may take a second

private:
    Result<Json> look_up(const std::string& name, std::span<const double> arguments);
    Result<Json> measured(const std::string& name, std::span<const double> arguments);
    const Json& matrices();

    const Params& now_;
    const Params& start_;
    const Scene& scene_;
    Renderer* renderer_;
    Derived derived_;
    Json state_, start_state_, matrices_;  ///< null until asked for
    std::map<std::string, Json> kept_;     ///< what was measured, by name and arguments
};

}  // namespace viewing
