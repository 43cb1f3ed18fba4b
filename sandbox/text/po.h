// Catalogues of translations as translators' tools write them: gettext's .po files, read without gettext, since the
// program has to do it where there is none. Read catalogue.h for what is done with them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "text/result.h"

namespace viewing {

/// One text: `english` is its id, `translation` is empty where there is none yet.
struct PoEntry {
    std::string english;
    std::string translation;
    bool is_fuzzy = false;   ///< a translator has to look at it again: counts as not translated
    int line = 0;            ///< where it begins, from 1
    std::string where = {};  ///< the files that show it, as "#:" lists them
};

/// The entries of a .po file in UTF-8 in their order, without its header (the entry with an empty id). Refused with one
/// sentence that names the line: contexts and plural forms (an English text has one translation here, one for "1" and
/// one for the rest are two texts), an unknown keyword or escape, an id that is there twice.
Result<std::vector<PoEntry>> read_po(std::string_view content);

/// What stands in braces in a template, in order of the alphabet, each once: "{count} of {all}" has "all" and "count".
/// "{{" and "}}" are braces to show. Nothing where a brace is left open.
Result<std::vector<std::string>> places_in(std::string_view text);

}  // namespace viewing
