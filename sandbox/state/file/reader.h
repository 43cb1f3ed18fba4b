// Converts between JSON trees and single values, fields, groups and scenes, for this folder, lesson/ and report/. All
// readers throw a Refusal that contains the whole message.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "state/fields.h"
#include "state/file/document.h"
#include "state/file/flight.h"
#include "state/file/titles.h"
#include "state/params.h"

namespace viewing {

// ---- single values (values.cpp) -----------------------------------------------------------------------------------

/// Refuses a value; `must_be` completes "must be" in the message.
[[noreturn]] void refuse_value(const Json& value, const Where& where, const std::string& must_be);

double read_number(const Json& value, const Where& where, const Range& range, bool may_be_infinite = false);
int read_whole(const Json& value, const Where& where, int min, int max);
bool read_bool(const Json& value, const Where& where);
Color read_color(const Json& value, const Where& where);
int read_choice(const Json& value, const Where& where, std::span<const char* const> names);
glm::dmat4 read_matrix(const Json& value, const Where& where, const Range& range);

/// Reads a name, which must not be empty, must be UTF-8 of at most 1024 bytes, and must not contain control characters.
std::string read_name(const Json& value, const Where& where);

/// Refuse a JSON value that is not an object or, respectively, not an array of at most `max_count` elements.
void require_object(const Json& value, const Where& where, const std::string& must_be);
void require_array(const Json& value, const Where& where, std::size_t max_count, const std::string& must_be);

/// Refuses a key that is not in `known`.
void require_known_key(std::string_view key, const Where& where, std::span<const std::string> known);
/// Refuses a value that is not an object, and any key that is not in `known`.
void require_keys(const Json& object, const Where& where, const std::vector<std::string>& known);

glm::dvec3 read_vec3(const Json& value, const Where& where, const Range& range, const std::string& must_be);

Json color_as_json(const Color& color);
Json vector_as_json(const glm::dvec3& vector);
Json vector_as_json(const glm::dvec4& vector);
Json matrix_as_json(const glm::dmat4& matrix);  ///< four rows, top row first

// ---- fields and groups (reader.cpp, writer.cpp) -------------------------------------------------------------------

bool is_group(std::string_view path);
void read_field(const Field& field, Params& params, const Json& value, const Where& where, std::size_t element = 0);
/// Changes the fields that the object names; the others keep their values.
void read_group(Params& params, const Json& object, const Where& where);
Json field_as_json(const Field& field, Params& params, std::size_t element = 0);
Json params_as_document(Params params);

// ---- camera.look_at (look_at_reader.cpp): read instead of position, yaw, pitch and roll, and never written ---------

inline constexpr std::string_view look_at_path = "camera.look_at";

/// Returns the four fields that camera.look_at replaces.
std::span<const std::string_view> fields_of_look_at();
Json look_at_as_json(const LookAt& look_at);
/// Reads {"eye", "center", "up"}; only up may be left out, and is then (0, 1, 0). Refuses degenerate vectors.
LookAt read_look_at(const Json& value, const Where& where);
/// Refuses a camera object that has both look_at and one of the fields that look_at replaces.
void require_one_camera(const Json& camera, const Where& where);

/// Refuses an unknown path or key, and names the nearest known one.
[[noreturn]] void refuse_unknown(const Where& where);

/// Checks the rules that involve several fields, and those that one setting may break and a later one restore: near <
/// far, a nonzero normal, a nonzero light, and planes and lights that exist.
void check_together(const Params& params, const std::string& prefix);

/// Checks the titles of a file, which are all optional, removes them from the tree, and returns them.
Titles take_titles(Json& document, const Where& where);

// ---- settings (settings.cpp) -------------------------------------------------------------------------------------

/// Converts {"projection.near": 0.1, …} to PATH=VALUE settings, and back.
std::vector<std::string> read_settings(const Json& object, const Where& where);
/// Applies settings like apply_settings(), but does not check the rules that involve several fields.
Params applied(Params params, std::span<const std::string> settings, const std::string& source);
Json settings_as_json(const std::vector<std::string>& settings);

// ---- flights (flight.cpp) -----------------------------------------------------------------------------------------

bool is_flight(const Json& document);
Flight read_flight(const Json& document, const Where& where);

// ---- scenes (scene_reader.cpp) ------------------------------------------------------------------------------------

SceneDescription read_scene(const Json& value, const Where& where);
Json scene_as_json(const SceneDescription& scene);

}  // namespace viewing
