// The state file: reads and writes JSON, and applies `--set`. Every message names the source, the field's path, the
// mistake, the allowed values and, for a misspelled name, the nearest known one.
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

/// Reads a whole state; missing fields get their defaults. `source` starts every message ("state.json").
Result<Params> parse_state(std::string_view json, std::string_view source);

/// A state and the titles of its file. For a flight (flight.h), `params` is its start.
struct StateDocument {
    Params params;
    Titles titles;
    std::shared_ptr<const Flight> flight = nullptr;
};
Result<StateDocument> parse_state_document(std::string_view json, std::string_view source);

/// Writes every field in the order of the list, indented by two spaces per level. Reading the text back gives exactly
/// the same Params. Titles that are not empty come first.
std::string write_state(const Params& params, const Titles& titles = {});

/// Applies PATH=VALUE settings in order. PATH is a field (projection.near), a group (camera={"yaw":3} changes only the
/// named fields) or an element (light.position[0]). VALUE is read as JSON; anything that is not JSON counts as a
/// string. `source` starts every message.
Result<Params> apply_settings(Params params, std::span<const std::string> settings,
                              const std::string& source = "--set ");

/// Returns PATH=VALUE for every field in which `after` differs from `before`. Applied to `before`, these settings give
/// exactly `after`.
std::vector<std::string> settings_to(Params before, Params after);

/// Returns the setting that gives a field its value in `params`: "depth.func" → "depth.func=less".
std::string setting_of(std::string_view path, const Params& params);
/// Returns the setting that gives a field its default.
std::string default_setting(std::string_view path);

/// Reads a scene: {"objects": [...]}.
Result<SceneDescription> parse_scene(std::string_view json, std::string_view source);

/// Lists every field for the `params` command, as a JSON array or as aligned text.
std::string params_as_json();
std::string params_as_text();

}  // namespace viewing
