// The values of the names in a lesson's expressions: the state's fields, its matrices, and measurements of its pictures
// at fixed sizes, whatever the window's size, unless a sweep asks for its own. Read lesson/formulas/names.h for the
// list of names.
#pragma once

#include <memory>
#include <string>

#include "frame/derive.h"
#include "grading/measurer.h"
#include "lesson/formulas/expression.h"

namespace viewing {

class LessonNumbers {
public:
    /// `start` has the parameters at the start of the step. The references must outlive this object. Without a
    /// renderer, measurements of pictures are an error.
    LessonNumbers(const Params& now, const Params& start, const Scene& scene, const Measurer& measurer,
                  glm::ivec2 size_px = usual_size_px);

    /// Returns lookups that refer to this object.
    Surroundings surroundings();

    static constexpr glm::ivec2 usual_size_px{1280, 720};      ///< of the pictures that are measured
    static constexpr glm::ivec2 visibility_size_px{640, 360};  ///< for visibility_counts()
    static constexpr int most_counted_polygons = 20'000;       ///< limit for visibility_counts(): about a second
    static constexpr std::size_t most_measured = 64;           ///< limit on different measurements, up to a second each

private:
    Result<Json> look_up(const std::string& name, std::span<const double> arguments);
    Result<Json> measured(const std::string& name, std::span<const double> arguments);
    const Json& matrices();

    const Params& now_;
    const Params& start_;
    const Scene& scene_;
    Renderer* renderer_;
    glm::ivec2 size_px_;
    std::shared_ptr<Measurer::Values> known_;
    Derived derived_;
    Json state_, start_state_, matrices_;  ///< null until requested
};

}  // namespace viewing
