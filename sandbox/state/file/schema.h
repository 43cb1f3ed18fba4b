// JSON Schemas (draft 2020-12) of state and scene files, for editors and scripts, generated from the list of fields.
// They cover all rules for single values; only the reader checks the rules that relate several values (near < far, a
// nonzero normal).
#pragma once

#include <string>

namespace viewing {

std::string state_schema();
std::string scene_schema();

}  // namespace viewing
