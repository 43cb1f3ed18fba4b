// The list of presets: in the order of the lecture, searched while one types, with a small picture and the sentence
// beside it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "state/presets.h"
#include "ui/views/views.h"

namespace viewing {

class PresetPicker {
public:
    /// Opens it in the next frame, as a click on the closed list does.
    void open() { requested_ = true; }
    bool is_open() const { return is_open_; }
    const std::string& search() const { return search_; }
    /// Nothing is typed that a key could be meant for.
    bool has_empty_search() const { return is_open_ && search_.empty(); }

    /// The closed list, which shows `shown`, and the open one below it. `current`: the open preset, may be null.
    /// Returns the one that was chosen, else null.
    const NamedFile* draw(std::span<const NamedFile> presets, const NamedFile* current, const std::string& shown,
                          float width, const PresetPicture& picture);

    /// The preset whose picture stands beside the list; "" while it is closed.
    const std::string& wanted_picture() const { return wanted_picture_; }

private:
    const NamedFile* draw_list(const std::vector<const NamedFile*>& found, const NamedFile* current, bool scroll);
    bool draw_search(const std::vector<const NamedFile*>& found);

    std::string search_;
    std::string marked_;  ///< the row that Enter takes
    std::string wanted_picture_;
    bool requested_ = false, is_open_ = false;
};

/// Whether each word of `search` is found in the preset's title, sentence, name or topic, in English or in the language
/// spoken now; capitals do not matter.
bool is_found(const NamedFile& preset, std::string_view search);

}  // namespace viewing
