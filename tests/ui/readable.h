// Checks whether a drawn frame is readable: finds cut-off letters, shortened texts and overlapping letters in ImGui's
// draw data.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "desk.h"
#include "letters.h"

namespace viewing::test {

/// Returns whether a window may scroll, so that content may continue below. Child windows may always scroll: their
/// names only begin with the names listed here.
inline bool scrolls(const std::string& window) {
    return window != "top" && window != "status" && window != "views" && window != "lower views" &&
           window != "message" && window != "lesson";
}

/// Returns whether two lines overlap in the parts that remain visible after a scrolling window clips them.
inline bool overlap(const Line& a, const Line& b) {
    constexpr float touch = 1.5F;
    const float accents = 0.3F * std::min(a.line_height, b.line_height);  // accents reach into the line above
    const auto top = [](const Line& line) { return std::max(line.min.y, line.clip.y); };
    const auto bottom = [](const Line& line) { return std::min(line.max.y, line.clip.w); };
    return a.min.x + touch < b.max.x && b.min.x + touch < a.max.x && top(a) + accents < bottom(b) &&
           top(b) + accents < bottom(a);
}

/// Returns whether a text ends with an ellipsis that is not its own. An ellipsis is the text's own if it follows a
/// space or if the catalog has it. Texts of the pseudo-language, which begin with "[", may be shortened.
inline bool is_shortened(const std::string& text) {
    if (!text.ends_with("…") || text.ends_with(" …") || text.starts_with('[')) return false;
    static const std::vector<PoEntry> all = catalogue();
    return std::none_of(all.begin(), all.end(), [&text](const PoEntry& entry) {
        const std::string own = entry.english.ends_with("…") ? tr(entry.english.c_str()) : "";
        return !own.empty() && text.ends_with(own.substr(1));  // the first letter may be a capital
    });
}

/// Returns the places where letters are cut off, texts are shortened, or letters overlap.
inline std::vector<std::string> unreadable(const Desk& desk) {
    const widgets::Fonts& fonts = desk.workbench.widgets.fonts;
    const Page page{fonts.text, fonts.heading, fonts.note, fonts.number, fonts.small_number, fonts.caption};
    std::vector<std::string> found;
    const ImDrawData* data = ImGui::GetDrawData();
    for (int i = 0; i < data->CmdListsCount; ++i) {
        const std::string window = data->CmdLists[i]->_OwnerName;
        const std::vector<Line> lines = lines_of(page.letters(*data->CmdLists[i]));
        for (const std::string& text : cut_lines(lines, scrolls(window))) found.push_back(window + ": cut: " + text);
        for (const Line& line : lines)
            if (is_shortened(line.text)) found.push_back(window + ": shortened: " + line.text);
        for (std::size_t a = 0; a < lines.size(); ++a)
            for (std::size_t b = a + 1; b < lines.size(); ++b)
                if (overlap(lines[a], lines[b]))
                    found.push_back(window + ": over each other: " + lines[a].text + " | " + lines[b].text);
    }
    return found;
}

}  // namespace viewing::test
