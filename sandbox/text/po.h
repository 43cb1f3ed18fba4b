// Translation catalogs in the format that translators' tools use: gettext's .po files. They are read without gettext,
// which may not be installed. See catalogue.h for their use.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "text/result.h"

namespace viewing {

/// One text: `english` is its id; `translation` is empty if there is none yet.
struct PoEntry {
    std::string english;
    std::string translation;
    bool is_fuzzy = false;   ///< a translator must review it; it counts as not translated
    int line = 0;            ///< where it begins, from 1
    std::string where = {};  ///< the files that use the text, as "#:" lists them
};

/// Returns the entries of a .po file in UTF-8, in order, without its header (the entry with an empty id). Refuses
/// contexts, plural forms, unknown keywords or escapes, and repeated ids, with one sentence that names the line. This
/// program gives each English text only one translation; the text for 1 and the text for other numbers are two entries.
Result<std::vector<PoEntry>> read_po(std::string_view content);

/// Returns the names of a template's placeholders, in alphabetical order, each once: "{count} of {all}" has "all" and
/// "count". "{{" and "}}" are literal braces. Fails if a brace has no partner.
Result<std::vector<std::string>> places_in(std::string_view text);

}  // namespace viewing
