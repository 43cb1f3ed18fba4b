// A state as a link: an address, a #, and the fields that differ from the defaults. A link can also name a preset or a
// step of a lesson. The # is followed by parts that are separated by &. Each part is KEY=VALUE or a state, which begins
// with its version. load_state() in presets.h accepts links; lesson/linked_step.h accepts those that name a step.
#pragma once

#include <string>
#include <string_view>

#include "state/params.h"
#include "text/result.h"

namespace viewing {

/// Returns the address in front of a link's #: $VIEWING_SANDBOX_LINK_BASE, else "viewing-sandbox.html".
std::string link_base();

/// Returns "#1", followed by the fields that differ from the defaults as compact JSON, compressed with zlib and encoded
/// as base64url without padding. The opening state also has a link, which is short. File names stay unchanged, because
/// a link carries no files.
std::string link_fragment(const Params& params);

/// Returns "#lesson=ID&step=N"; `step` counts from 1.
std::string lesson_fragment(std::string_view id, std::size_t step);

/// Returns whether a text looks like a link: whether it begins with #, http://, https:// or file://, or has the name of
/// a page (….html) before its first #.
bool is_link(std::string_view text);

struct Link {
    enum class Kind { state, preset, lesson };
    Kind kind = Kind::state;
    std::string text;      ///< the state as JSON, the preset's name, or the lesson's id
    std::size_t step = 1;  ///< the step of a lesson, counted from 1
};

/// Reads a link, ignoring white space at its end. The error is one sentence about an unknown or repeated key, an
/// impossible value, or a state that has another version, is truncated or damaged, exceeds 16 MiB, or is followed by
/// other bytes. Never decompresses more than 16 MiB. Does not check the JSON.
Result<Link> read_link(std::string_view text);

}  // namespace viewing
