// Numbers as JSON: shared by what reports to commands and lessons.
#pragma once

#include <string>
#include <vector>

#include "frame/problems.h"
#include "state/file/document.h"

namespace viewing {

Json as_json(const glm::ivec2& pair);
Json as_json(const glm::dvec3& vector);
Json as_json(const glm::dvec4& vector);

/// Four rows of the mathematical matrix, top row first; −0 is 0, what is not finite null.
Json as_json(const glm::dmat4& matrix);

/// "#rrggbb".
std::string as_text(const Color& color);

/// The sentences of the problems.
Json as_json(const std::vector<Problem>& problems);

/// Without what a clock has said, at any depth.
Json without_times(Json json);

/// The name of a state's scene, "inline" for one that is written out in it.
std::string scene_name(const Params& params);

/// A part of a report that may fail: its error ends the report. Thrown as Refusal, caught by guarded().
template <typename T>
T or_refuse(Result<T> result) {
    if (!result) throw Refusal(result.error());
    return *std::move(result);
}

}  // namespace viewing
