// A state as a link: an address, a #, and behind it what differs from the defaults; or the name of a preset, or a step
// of a lesson. What follows # is parts with & between them: a state, which begins with its version, or KEY=VALUE. Read
// load_state() in presets.h for where links are taken, and lesson/linked_step.h for those that name a step.
#pragma once

#include <string>
#include <string_view>

#include "state/params.h"
#include "text/result.h"

namespace viewing {

/// What a link is put behind: $VIEWING_SANDBOX_LINK_BASE, else "viewing-sandbox.html".
std::string link_base();

/// "#1" and the fields that differ from the defaults as compact JSON, in zlib's form and base64url without padding. The
/// opening state's is short too. What the scene names is named as it stands there: a link carries no files.
std::string link_fragment(const Params& params);

/// "#lesson=ID&step=N"; `step` counts from 1.
std::string lesson_fragment(std::string_view id, std::size_t step);

/// Whether a text is meant as a link: it begins with #, http://, https:// or file://, or has a page's name
/// before its first #.
bool is_link(std::string_view text);

struct Link {
    enum class Kind { state, preset, lesson };
    Kind kind = Kind::state;
    std::string text;      ///< the state as JSON, the preset's name, or the lesson's
    std::size_t step = 1;  ///< of a lesson, counted from 1
};

/// Blanks at its end are left out. The error is one sentence: a key that is unknown or there twice, a value that cannot
/// be; of a state another version, cut off or damaged, larger than 16 MiB, or something behind its end. No more is
/// unpacked than that. The JSON is not looked at.
Result<Link> read_link(std::string_view text);

}  // namespace viewing
