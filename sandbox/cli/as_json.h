// Numbers as JSON: shared by the commands that print them.
#pragma once

#include <string>
#include <vector>

#include "frame/problems.h"
#include "state/document.h"

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

}  // namespace viewing
