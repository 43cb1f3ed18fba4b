// The presets in lecture order: the open one, its neighbors, and a list with search as you type. Beside the list are
// the marked preset's thumbnail and sentence.
#pragma once

#include <string>
#include <vector>

#include "session/session.h"
#include "state/presets.h"
#include "ui/views/views.h"

namespace viewing {

class PresetPicker {
public:
    const std::vector<NamedFile>& all() const { return all_; }
    /// Returns the open preset; null if there is none.
    const NamedFile* current(const Session& session) const { return at(session, 0); }
    /// Returns the preset that is `places` positions after the open one; null past either end.
    const NamedFile* at(const Session& session, int places) const;
    /// Opens that preset, if there is one.
    void turn(int places, Session& session) const {
        if (const NamedFile* preset = at(session, places)) session.open(preset->name);
    }

    bool is_open() const { return is_open_; }
    const std::string& search() const { return search_; }
    /// Whether the list is open and its search is empty. If so, undo and redo do not apply to the search text.
    bool has_empty_search() const { return is_open_ && search_.empty(); }

    /// Draws the closed list, which shows `shown`, and the open list below it while it is open. `current`: the open
    /// preset; may be null. Returns the chosen preset, or null.
    const NamedFile* draw(const NamedFile* current, const std::string& shown, float width,
                          const PresetPicture& picture);

    /// Returns the preset whose picture the list shows; "" while it is closed.
    const std::string& wanted_picture() const { return wanted_picture_; }

private:
    const NamedFile* draw_list(const std::vector<const NamedFile*>& found, const NamedFile* current, bool scroll);
    bool draw_search(const std::vector<const NamedFile*>& found);

    std::vector<NamedFile> all_ = presets();
    std::string search_;
    std::string marked_;  ///< the row that Enter chooses
    std::string wanted_picture_;
    bool is_open_ = false;
};

/// Returns whether the preset's title, sentence, name or topic contains every word of `search`, in English or in the
/// current language. Ignores case.
bool is_found(const NamedFile& preset, std::string_view search);

}  // namespace viewing
