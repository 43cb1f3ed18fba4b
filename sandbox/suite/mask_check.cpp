// Checks masks before anything is drawn: see suite.h.
#include <set>

#include "suite/suite.h"
#include "text/words.h"

namespace viewing {

Status check_masks(const Suite& suite) {
    std::set<std::string> known;  // masks checked so far; most entries share the masks of the defaults
    for (const SuiteEntry& entry : suite.entries) {
        if (!entry.checks_picture || entry.mask.is_empty()) continue;
        std::string key = std::to_string(entry.size_px.x) + "x" + std::to_string(entry.size_px.y);
        for (const MaskRect& rect : entry.mask.rects)
            for (const int side : {rect.x, rect.y, rect.width, rect.height}) key += " " + std::to_string(side);
        for (const std::filesystem::path& file : entry.mask.pictures) key += "\n" + file.string();
        if (!known.insert(std::move(key)).second) continue;
        if (const Result<Mask> mask = mask_of(entry.mask, entry.size_px.x, entry.size_px.y); !mask)
            return Error{one_line(suite.argument.string()) + ": the entry " + excerpt(entry.name) + ": " +
                         mask.error()};
    }
    return std::monostate{};
}

}  // namespace viewing
