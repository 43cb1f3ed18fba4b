// What the views have in common: headline, picture, legend, the followed point.
#pragma once

#include "frame/derive.h"
#include "frame/ground.h"
#include "ui/parts/overlay.h"

namespace viewing {

/// Nothing without a picture.
void draw_picture(const Rect& rect, ImTextureID picture);

/// The picture fills its rectangle exactly, with an invisible button over it for the mouse.
void picture_item(const char* name, const Rect& rect, ImTextureID picture);

/// The headline above a view, in large type where a room sees it; further items go on its line. An empty title only
/// places the cursor.
void view_header(const Rect& rect, const char* title);

/// Words in a row of which one is chosen, quiet until it is; as a list where the row would go beyond `right`. Each
/// explains itself by the sentence of the same index.
bool words(const char* id, int& index, std::span<const char* const> names, std::span<const char* const> explanations,
           int default_index, float right);

/// Whether they have room from the cursor on to `right`, as words in a row.
bool have_room(std::span<const char* const> names, float right);

/// A quiet note on the headline; left out where it would go beyond `right`.
void header_note(const char* text, float right);

/// A ground on which text over any picture can be read, so much larger than this rectangle on each side.
void draw_plate(ImDrawList* draw, const Rect& rect, ImVec2 margin_px);

/// One colour of a view and what it stands for.
struct LegendEntry {
    Color color;
    const char* meaning;
};
/// In the lower left corner of a view; returns what it covers.
Rect draw_legend(ImDrawList* draw, const Rect& rect, std::span<const LegendEntry> entries);

/// At the lower edge of a picture: the whole sentence in one line where there is room, else the brief one in as many
/// lines as it takes. Returns what it covers.
Rect sentence_over_picture(ImDrawList* draw, const Rect& rect, ImU32 color, const char* whole, const char* brief);

/// Whether the mirror image of the followed point is not to be seen.
bool is_image_covered();

/// p with its ray from the light, s, the foot on the plane and the mirror image.
void draw_followed(Overlay& overlay, const Derived& derived);

}  // namespace viewing
