// The state file: JSON in and out, and `--set`. Every message names the source, the field's path, what
// was wrong, what is allowed, and the nearest known name for a misspelt one.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "state/file/titles.h"
#include "state/params.h"
#include "text/result.h"

namespace viewing {

struct Flight;

/// Reads a whole state; left-out fields have their defaults. `source` opens every message ("state.json").
Result<Params> parse_state(std::string_view json, std::string_view source);

/// The same with what the file says about itself. A flight (flight.h) is its start.
struct StateDocument {
    Params params;
    Titles titles;
    std::shared_ptr<const Flight> flight = nullptr;
};
Result<StateDocument> parse_state_document(std::string_view json, std::string_view source);

/// Every field, in the order of the list, two spaces a level; reads back to the same Params exactly. Titles stand
/// before the fields, those that are not empty.
std::string write_state(const Params& params, const Titles& titles = {});

/// Applies PATH=VALUE in order. A PATH may name a leaf (projection.near), a group (camera={"yaw":3}: the
/// fields it names change), or an element (light.position[0]). VALUE is JSON, else a string. `source` opens every
/// message.
Result<Params> apply_settings(Params params, std::span<const std::string> settings,
                              const std::string& source = "--set ");

/// PATH=VALUE of every field in which `after` differs: applied to `before` they give `after` exactly.
std::vector<std::string> settings_to(Params before, Params after);

/// The setting that gives a field its default: "depth.func" → "depth.func=less".
std::string default_setting(std::string_view path);

/// Reads a scene ({"objects": [...]}).
Result<SceneDescription> parse_scene(std::string_view json, std::string_view source);

std::string write_scene(const SceneDescription& scene);

/// The `params` command: every field as JSON array or aligned text.
std::string params_as_json();
std::string params_as_text();

}  // namespace viewing
