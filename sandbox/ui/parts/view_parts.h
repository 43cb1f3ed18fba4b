// Shared parts of the views: header, picture, legend, the followed point.
#pragma once

#include "frame/derive.h"
#include "frame/ground.h"
#include "ui/parts/overlay.h"

namespace viewing {

/// Draws a picture; does nothing if `picture` is null.
void draw_picture(const Rect& rect, ImTextureID picture);

/// Draws the picture, filling its rectangle exactly, with an invisible button over it for the mouse.
void picture_item(const char* name, const Rect& rect, ImTextureID picture);

/// Draws the header above a view, in large type when presenting; more items may follow on its line. An empty title only
/// places the cursor.
void view_header(const Rect& rect, const char* title);

/// Draws a choice as words in a row, all muted except the chosen one; draws a list instead if the row would extend past
/// `right`. Each word's tooltip is the explanation with the same index.
bool words(const char* id, int& index, std::span<const char* const> names, std::span<const char* const> explanations,
           int default_index, float right);

/// Whether these words fit in a row between the cursor and `right`.
bool have_room(std::span<const char* const> names, float right);

/// Draws a note in muted text in the header, unless it would extend past `right`.
void header_note(const char* text, float right);

/// Draws a plate that keeps text legible over any picture. It extends beyond the rectangle by the margin on each side.
void draw_plate(ImDrawList* draw, const Rect& rect, ImVec2 margin_px);

/// A color of a view and its meaning.
struct LegendEntry {
    Color color;
    const char* meaning;
};
/// Draws a legend in the lower left corner of a view, in as many lines as it needs; returns the area it covers. A view
/// that is too small for it gets none.
Rect draw_legend(ImDrawList* draw, const Rect& rect, std::span<const LegendEntry> entries);

/// Draws a sentence at the lower edge of a picture: the whole one in one line if it fits, otherwise the brief one in as
/// many lines as needed. Returns the area it covers.
Rect sentence_over_picture(ImDrawList* draw, const Rect& rect, ImU32 color, const char* whole, const char* brief);

/// Whether the mirror image of the followed point is covered.
bool is_image_covered();

/// Draws the followed point p. If the state has shadows, also draws p's ray from the light and its shadow s; if the
/// state has mirrors, also p's foot on the plane and its mirror image.
void draw_followed(Overlay& overlay, const Params& params, const Derived& derived);

}  // namespace viewing
