// Converts values to JSON, for the reports of commands and lessons.
#pragma once

#include <string>
#include <vector>

#include "frame/problems.h"
#include "state/file/document.h"

namespace viewing {

Json as_json(const glm::ivec2& pair);
Json as_json(const glm::dvec3& vector);
Json as_json(const glm::dvec4& vector);

/// Returns the four rows of a matrix, top row first; −0 becomes 0, non-finite numbers become null.
Json as_json(const glm::dmat4& matrix);

/// Returns "#rrggbb".
std::string as_text(const Color& color);

/// Returns the sentences that describe the problems.
Json as_json(const std::vector<Problem>& problems);

/// Returns an object for each problem: {"id", "kind": "wrong" | "note" | "window", "values", "say", "fix"}. Values that
/// are numbers in the sentence are JSON numbers; "fix" is null if there is none.
Json details_of(const std::vector<Problem>& problems);

/// Removes all measured times, at any nesting level.
Json without_times(Json json);

/// Returns the name of a state's scene; "inline" for a scene that is part of the state.
std::string scene_name(const Params& params);

/// Unwraps a result that a report needs. An error ends the report: it is thrown as a Refusal, which guarded() catches.
template <typename T>
T or_refuse(Result<T> result) {
    if (!result) throw Refusal(result.error());
    return *std::move(result);
}

}  // namespace viewing
