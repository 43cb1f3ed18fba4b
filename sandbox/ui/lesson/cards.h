// A page of small pictures to choose from: the lessons of the lecture, or the steps of one.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ui/parts/layout.h"
#include "widgets/widgets.h"

namespace viewing {

struct Card {
    std::string key;    ///< its picture's name
    std::string title;  ///< shown whole, in as many lines as it takes
    std::string note;   ///< small, below: "7 steps · 15 min"
    bool is_done = false, is_current = false;
};

/// In rows that fill the width and scroll where they are too many; the chosen one is brought into view. `texture_of` of
/// a key: null while there is none. Returns the place of the card that was clicked, −1: none.
int draw_cards(const std::vector<Card>& cards, const std::function<ImTextureID(const std::string&)>& texture_of,
               int chosen);

/// From one edge of the window to the cards of a page, design pixels.
inline constexpr float page_margin = 30.0F;

/// How many stand beside each other on a page over the whole window, as wide as it is now.
int card_columns();

}  // namespace viewing
