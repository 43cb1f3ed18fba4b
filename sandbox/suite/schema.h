// The JSON Schema (draft 2020-12) of suite files, for editors and scripts. What a state that is written out may have is
// the state's own schema.
#pragma once

#include <string>

namespace viewing {

std::string suite_schema();

}  // namespace viewing
