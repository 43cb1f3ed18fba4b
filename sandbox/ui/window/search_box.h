// The search over everything, drawn over the window: a text field and the best entries. Read search_entries.h first.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ui/window/search_entries.h"

namespace viewing {

class SearchBox {
public:
    void open() { requested_ = true; }
    bool is_open() const { return requested_ || is_open_; }

    /// Draws the box while it is open. Calls `offered` for the entries when the box opens. Returns what the user chose.
    std::optional<SearchChoice> draw(const std::function<std::vector<SearchEntry>()>& offered);

    /// Returns the typed text and all offered entries, for the fonts.
    const std::string& typed() const { return typed_; }
    const std::vector<SearchEntry>& entries() const { return entries_; }

private:
    std::string typed_;
    std::vector<SearchEntry> entries_, found_;
    int marked_ = 0;  ///< the row that Enter chooses
    bool requested_ = false, is_open_ = false, takes_focus_ = false;
    bool continues_ = false;  ///< the next letters follow the text in the field
};

}  // namespace viewing
