// Which characters of Korean the window shows: its fonts are built with these alone, since all 11,172 syllables would
// be an atlas of a hundred megabytes. Where nothing is Korean there are none, and Korean fonts are not touched.
#pragma once

#include <imgui.h>

#include <cstddef>
#include <set>
#include <span>
#include <string_view>
#include <vector>

namespace viewing {

class Syllables {
public:
    /// Takes the syllables, letters, brackets and wide signs of a text in UTF-8.
    void want(std::string_view text);
    void want(ImWchar character);

    bool has_any() const { return !characters_.empty(); }
    /// Whether one has come that the ranges had not.
    bool has_new() const { return characters_.size() != in_ranges_; }
    /// All that were wanted and that a font's file has an outline for, as ImGui's font atlas takes them, there until
    /// the next call; null where there are none. Fonts may map a syllable to an empty glyph, which would be shown as
    /// nothing. Null with no file, too.
    const ImWchar* ranges(std::span<const std::byte> font_file);

private:
    std::set<ImWchar> characters_;
    std::size_t in_ranges_ = 0;
    std::vector<ImWchar> ranges_;
};

}  // namespace viewing
