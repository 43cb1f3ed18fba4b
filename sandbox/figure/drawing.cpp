#include "figure/drawing.h"

#include <algorithm>

#include "image/matte.h"

namespace viewing {
namespace {

Ink cut(const Ink& on_black, const Ink& on_white) {
    const std::uint8_t black[] = {on_black.r, on_black.g, on_black.b}, white[] = {on_white.r, on_white.g, on_white.b};
    std::uint8_t rgba[4];
    remove_ground(black, white, rgba);
    return {rgba[0], rgba[1], rgba[2], static_cast<std::uint8_t>(rgba[3] * on_black.a / 255)};
}

/// Removes the background from the first of two marks of the same kind.
struct Cutter {
    void operator()(Shape& shape, const Shape& on_white) const { shape.ink = cut(shape.ink, on_white.ink); }
    void operator()(Shade& shade, const Shade& on_white) const {
        shade.from = cut(shade.from, on_white.from);
        shade.to = cut(shade.to, on_white.to);
    }
    void operator()(Line& line, const Line& on_white) const { line.ink = cut(line.ink, on_white.ink); }
    void operator()(Inset& inset, const Inset& on_white) const {
        inset.image = std::make_shared<const Image>(without_ground(*inset.image, *on_white.image));
    }
    template <typename A, typename B>
    void operator()(A&, const B&) const {}
};

bool is_nothing(const Mark& mark) {
    if (const Shape* shape = std::get_if<Shape>(&mark.what)) return shape->ink.a == 0;
    if (const Line* line = std::get_if<Line>(&mark.what)) return line->ink.a == 0;
    if (const Shade* shade = std::get_if<Shade>(&mark.what)) return shade->from.a == 0 && shade->to.a == 0;
    return false;
}

}  // namespace

std::size_t letter_count(const Drawing& drawing) {
    std::size_t count = 0;
    for (const Mark& mark : drawing.marks)
        if (const Line* const line = std::get_if<Line>(&mark.what))
            count += line->characters.size() - std::count(line->characters.begin(), line->characters.end(), U' ');
    return count;
}

bool has_cut_text(const Drawing& drawing) {
    constexpr float tolerance_px = 1.0F;
    return std::any_of(drawing.marks.begin(), drawing.marks.end(), [&](const Mark& mark) {
        const Line* const line = std::get_if<Line>(&mark.what);
        if (!line || line->lefts_px.empty()) return false;
        const glm::vec2 min = glm::max(mark.clip.min, glm::vec2(0.0F)) - tolerance_px;
        const glm::vec2 max = glm::min(mark.clip.max, drawing.size_px) + tolerance_px;
        return line->lefts_px.front() < min.x || line->lefts_px.back() + 0.25F * line->em_px > max.x ||
               line->baseline_px - 0.65F * line->em_px < min.y || line->baseline_px > max.y;
    });
}

Result<Drawing> without_ground(const Drawing& on_black, const Drawing& on_white) {
    if (on_black.marks.size() != on_white.marks.size())
        return Error{"two drawings of the same content differ in more than their background"};
    Drawing left = on_black;
    for (std::size_t i = 0; i < left.marks.size(); ++i)
        std::visit(Cutter{}, left.marks[i].what, on_white.marks[i].what);
    std::erase_if(left.marks, is_nothing);
    return left;
}

}  // namespace viewing
