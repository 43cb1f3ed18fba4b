// Cards with thumbnails to choose from: the lecture's lessons, the steps of one lesson, or the exercises.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ui/parts/layout.h"
#include "widgets/widgets.h"

namespace viewing {

struct Card {
    std::string key;    ///< identifies its picture
    std::string title;  ///< never cut off; wraps
    std::string note;   ///< small, below the title: "7 steps · 15 min"
    bool is_done = false, is_current = false;
};

/// Draws cards in rows that fill the width, and scrolls the chosen card into view. `texture_of` returns the picture for
/// a key, or null if there is none yet. Returns the index of the clicked card, or −1.
int draw_cards(const std::vector<Card>& cards, const std::function<ImTextureID(const std::string&)>& texture_of,
               int chosen);

/// The size of a card that has its picture at the left of its text.
struct FlatCard {
    float width = 0.0F, picture = 0.0F;  ///< pixels; `picture` is 0 for a card without a picture
    float height = 0.0F;
};
/// Returns the smallest height of such a card at which its text is not cut off.
float least_height(const Card& card, const FlatCard& size);
/// Draws such a card at the cursor; returns whether it was clicked. `name` is its ImGui id and its recorded label.
bool draw_flat_card(const Card& card, const char* name, const FlatCard& size, ImTextureID texture);

/// Margin between the window's edge and a page's cards, in design pixels.
inline constexpr float page_margin = 30.0F;

/// Returns the number of cards per row on a full-window page at the current width.
int card_columns();

}  // namespace viewing
