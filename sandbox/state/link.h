// A state as a link: an address, a #, and behind it what differs from the defaults; or the name of a preset, or a step
// of a lesson. Read load_state() in presets.h for where links are taken.
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

/// Whether a text is meant as a link: it begins with #, http://, https:// or file://, or has a page's name before a #.
bool is_link(std::string_view text);

struct Link {
    enum class Kind { state, preset, lesson };
    Kind kind = Kind::state;
    std::string text;  ///< the state as JSON, the preset's name, or the lesson's
    std::string step;  ///< of a lesson, as digits; "" for its beginning
};

/// The error is one sentence: another version, cut off or damaged, larger than 16 MiB, or something behind its end. No
/// more is unpacked than that. The JSON is not looked at.
Result<Link> read_link(std::string_view text);

}  // namespace viewing
