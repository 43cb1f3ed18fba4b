// A drawing as shapes, text and pictures from back to front: the source of SVG and PDF. Lengths are in pixels, y points
// down, colors are sRGB. Pure functions.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "image/image.h"
#include "text/result.h"

namespace viewing {

/// A color, not premultiplied.
struct Ink {
    std::uint8_t r = 0, g = 0, b = 0, a = 255;
    bool operator==(const Ink&) const = default;
};

struct DrawingBox {
    glm::vec2 min{0.0F}, max{0.0F};
    bool operator==(const DrawingBox&) const = default;
};

using Ring = std::vector<glm::vec2>;  ///< closed implicitly

/// The area inside the rings, by the nonzero winding rule.
struct Shape {
    std::vector<Ring> rings;
    Ink ink;
};

/// A rectangle whose color changes from one edge to the opposite one.
struct Shade {
    DrawingBox box;
    bool is_vertical = false;  ///< from top to bottom, else from left to right
    Ink from, to;
};

/// Characters of one font on one line, each at its own position.
struct Line {
    std::string face;    ///< file name of the font
    float em_px = 0.0F;  ///< font size
    float baseline_px = 0.0F;
    std::vector<float> lefts_px;  ///< of each character's origin
    std::u32string characters;
    Ink ink;
};

/// The part `from` of a picture, in pixels from its upper left corner, stretched over `box`; if there are rings, only
/// the area inside them is drawn.
struct Inset {
    std::shared_ptr<const Image> image;
    DrawingBox from, box;
    std::vector<Ring> rings;
    Ink tint;  ///< only its alpha counts; it multiplies the picture's opacity
};

struct Mark {
    DrawingBox clip;  ///< nothing is visible outside it
    std::variant<Shape, Shade, Line, Inset> what;
};

struct Drawing {
    glm::vec2 size_px{0.0F};
    std::vector<Mark> marks;
};

/// Returns the number of characters, not counting spaces.
std::size_t letter_count(const Drawing& drawing);

/// Whether part of a text is outside its clip. Checks the cap height, and the width from the first character's origin
/// to the middle of the last character.
bool has_cut_text(const Drawing& drawing);

/// Removes the background from two drawings of the same content, one on black and one on white: omits marks that are
/// black in one and white in the other, and lowers the opacity of marks through which the background is visible. Both
/// drawings must have the same marks in the same order; fails if one has more marks than the other.
Result<Drawing> without_ground(const Drawing& on_black, const Drawing& on_white);

}  // namespace viewing
