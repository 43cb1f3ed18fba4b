// The JSON Schema (draft 2020-12) of suite files, for editors and scripts. An inline state has its own schema.
#pragma once

#include <string>

namespace viewing {

std::string suite_schema();

}  // namespace viewing
