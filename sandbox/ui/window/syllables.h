// The Korean characters that the window shows. Fonts contain only these: all 11,172 syllables would need an atlas of a
// hundred megabytes. Without Korean text the set is empty, and the Korean fonts stay unused.
#pragma once

#include <imgui.h>

#include <cstddef>
#include <memory>
#include <set>
#include <span>
#include <string_view>
#include <vector>

#include "session/guide.h"

namespace viewing {

class Syllables {
public:
    /// Adds the syllables, letters, brackets and full-width signs of a UTF-8 text.
    void want(std::string_view text);
    void want(ImWchar character);

    bool has_any() const { return !characters_.empty(); }
    /// Returns whether there are characters that the last ranges() did not include.
    bool has_new() const { return characters_.size() != in_ranges_; }
    /// Returns the wanted characters for which the font file has an outline, as ranges for ImGui's font atlas; valid
    /// until the next call. Skips empty glyphs, which would be invisible. Null if there are no such characters or no
    /// file.
    const ImWchar* ranges(std::span<const std::byte> font_file);

private:
    std::set<ImWchar> characters_;
    std::size_t in_ranges_ = 0;
    std::vector<ImWchar> ranges_;
};

/// Collects the names of the scene's objects and the texts of the lesson, which are too many for every frame.
class LongTexts {
public:
    /// Collects the texts that have changed since the last call.
    void want(const Session& session, const Guide& guide, Syllables& korean);

private:
    int scene_version_ = -1;
    std::shared_ptr<const Lesson> lesson_;
    Language language_ = Language::en;
};

}  // namespace viewing
