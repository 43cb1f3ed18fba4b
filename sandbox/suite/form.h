// The numeric limits and lists of names for suite files, shared by the reader and the JSON schema.
#pragma once

#include <array>
#include <cstddef>

#include "lesson/tree.h"
#include "state/file/json.h"

namespace viewing::suite_form {

inline constexpr std::size_t most_entries = 100'000, most_masks = 1'000, most_names = viewing::most_entries,
                             most_settings = max_object_keys;
inline constexpr int most_worst = 255, most_reach_px = 16, most_step = 1'000;
inline constexpr double most_tolerance = 1e9;
inline constexpr std::array measure_names{"fighting", "visibility", "mirror", "order"};
inline constexpr std::array each_names{"preset", "mended", "scene"};

}  // namespace viewing::suite_form
