// JSON Schemas (draft 2020-12) of the files of this folder, for editors and scripts, generated from the list of fields
// and from the forms of files. They cover all rules for single values, and a few of those that relate several values;
// only the reader checks the others (near < far, a nonzero normal).
#pragma once

#include <string>

#include "state/fields.h"
#include "state/file/document.h"

namespace viewing {

std::string state_schema();
std::string scene_schema();
std::string flight_schema();

/// Return the schema of a state inside another file.
Json state_definition(Json& definitions);
Json state_without_titles(Json& definitions);
/// Returns the schema of a field's value.
Json value_schema(const Field& field);
/// Returns value_schema() with the field's help and default.
Json field_schema(const Field& field);

}  // namespace viewing
