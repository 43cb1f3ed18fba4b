// The second picture of the camera's view (view.beside): in its own half, or to the right of a draggable line.
#pragma once

#include <string>

#include "frame/derive.h"
#include "session/session.h"
#include "ui/parts/layout.h"

namespace viewing {

/// What distinguishes the two pictures, as briefly as possible: "z-near 0.1" and "z-near 0.0001".
struct BesideTitles {
    std::string camera, beside;
};
/// `most`: how many differences to name; the rest are only counted.
BesideTitles beside_titles(const Params& params, std::size_t most = 2);
/// Draws one of the titles above its picture, in at most `width` pixels.
void draw_beside_title(const Rect& rect, float width, const Params& params, std::string BesideTitles::*side);

/// Draws the second picture with its title in its half of the view.
void draw_beside_picture(Session& session, const Rect& rect, ImTextureID picture);

/// Draws the second picture's legend if it shows the depth buffer.
void draw_beside_legend(const Session& session, const Derived& derived, const Rect& rect);

/// Draws the second picture to the right of a draggable line, over the first picture, which is already drawn. The names
/// of the two sides are at the top or, if there are sentences at the top, at the bottom.
void draw_beside_divider(Session& session, const Derived& derived, const Rect& rect, ImTextureID picture,
                         bool has_sentences);

}  // namespace viewing
