#include "text/words.h"

#include <algorithm>
#include <array>

namespace viewing {

std::size_t character_count(std::string_view text) {
    return text.size() - static_cast<std::size_t>(std::count_if(text.begin(), text.end(), continues_character));
}

void remove_last_character(std::string& text) {
    while (!text.empty() && continues_character(text.back())) {
        text.pop_back();
    }
    if (!text.empty()) {
        text.pop_back();
    }
}

std::string one_line(std::string_view text) {
    std::size_t length = std::min<std::size_t>(text.size(), 200);
    while (length < text.size() && length > 0 && continues_character(text[length])) {
        --length;
    }
    std::string line(text.substr(0, length));
    std::replace_if(
        line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, '?');
    return line + (length < text.size() ? "…" : "");
}

std::string joined(std::span<const char* const> names) {
    std::string text;
    for (const char* name : names) {
        text += (text.empty() ? "" : ", ") + std::string(name);
    }
    return text;
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
    constexpr std::size_t longest = 64;
    a = a.substr(0, longest);
    b = b.substr(0, longest);
    std::array<std::array<std::size_t, longest + 1>, longest + 1> cost;
    for (std::size_t i = 0; i <= a.size(); ++i) {
        for (std::size_t j = 0; j <= b.size(); ++j) {
            if (i == 0 || j == 0) {
                cost[i][j] = i + j;
                continue;
            }
            const bool same = a[i - 1] == b[j - 1];
            cost[i][j] = std::min({cost[i - 1][j] + 1, cost[i][j - 1] + 1, cost[i - 1][j - 1] + (same ? 0 : 1)});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                cost[i][j] = std::min(cost[i][j], cost[i - 2][j - 2] + 1);
            }
        }
    }
    return cost[a.size()][b.size()];
}

bool is_near(std::size_t distance, std::size_t word_length) {
    return distance <= std::clamp<std::size_t>(word_length / 2, 1, 3);
}

std::optional<std::string> nearest_name(std::string_view word, std::span<const std::string> candidates) {
    const auto distance = [word](const std::string& candidate) { return edit_distance(word, candidate); };
    const auto best =
        std::min_element(candidates.begin(), candidates.end(),
                         [&](const std::string& a, const std::string& b) { return distance(a) < distance(b); });
    if (best == candidates.end() || !is_near(distance(*best), word.size())) {
        return std::nullopt;
    }
    return *best;
}

std::string suggestion(std::string_view word, std::span<const std::string> candidates) {
    const std::optional<std::string> nearest = nearest_name(word, candidates);
    return nearest ? "; did you mean " + *nearest + "?" : "";
}

}  // namespace viewing
