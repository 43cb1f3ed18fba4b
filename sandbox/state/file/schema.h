// JSON Schemas (draft 2020-12) of state and scene files, for editors and scripts; made from the one list of fields.
// They say all that the reader says of single values; what ties values together (near < far, a normal that is not zero)
// only the reader knows.
#pragma once

#include <string>

namespace viewing {

std::string state_schema();
std::string scene_schema();

}  // namespace viewing
