// What is drawn, as shapes, text and pictures in the order in which they cover each other: what vectors are written
// from. Lengths are pixels, y goes down, colours are sRGB. Pure.
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

/// Not premultiplied.
struct Ink {
    std::uint8_t r = 0, g = 0, b = 0, a = 255;
    bool operator==(const Ink&) const = default;
};

struct DrawingBox {
    glm::vec2 min{0.0F}, max{0.0F};
    bool operator==(const DrawingBox&) const = default;
};

using Ring = std::vector<glm::vec2>;  ///< closed by itself

/// What its rings go round, however often.
struct Shape {
    std::vector<Ring> rings;
    Ink ink;
};

/// A rectangle whose colour goes from one edge to the opposite one.
struct Shade {
    DrawingBox box;
    bool is_vertical = false;  ///< from the top to the bottom, else from left to right
    Ink from, to;
};

/// Characters of one face on one line, each in its own place.
struct Line {
    std::string face;    ///< file name of the font
    float em_px = 0.0F;  ///< size of its em
    float baseline_px = 0.0F;
    std::vector<float> lefts_px;  ///< of each character's origin
    std::u32string characters;
    Ink ink;
    Ink halo{0, 0, 0, 0};  ///< of a rim around the characters, which keeps them apart from what is behind
    float halo_px = 0.0F;  ///< its width
};

/// The part `from` of a picture, pixels from its upper left corner, stretched over `box`; where there are rings, only
/// what they go round.
struct Inset {
    std::shared_ptr<const Image> image;
    DrawingBox from, box;
    std::vector<Ring> rings;
    Ink tint;  ///< multiplies the picture
};

struct Mark {
    DrawingBox clip;  ///< nothing of it is seen outside
    std::variant<Shape, Shade, Line, Inset> what;
};

struct Drawing {
    glm::vec2 size_px{0.0F};
    std::vector<Mark> marks;
};

/// How many characters are written, blanks apart.
std::size_t letter_count(const Drawing& drawing);

/// Whether a part of a text lies outside what is seen of it: its capitals' height, from the first origin to the middle
/// of the last character.
bool has_cut_text(const Drawing& drawing);

/// What both drawings of the same on black and on white ground have, without the ground: what is black in one and white
/// in the other is left out, what shows some of it is so much less opaque. Both have the same marks in the same order;
/// the error says that they have not.
Result<Drawing> without_ground(const Drawing& on_black, const Drawing& on_white);

}  // namespace viewing
