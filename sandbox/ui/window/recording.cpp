#include "ui/window/recording.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include "ui/window/fonts.h"

namespace viewing {
namespace {

glm::vec2 point(ImVec2 at) {
    return {at.x, at.y};
}

bool is_clear(ImU32 color) {
    return (color & IM_COL32_A_MASK) == 0;
}

// ---- glyphs --------------------------------------------------------------------------------------------------------

/// One character of the draw data.
struct DrawnGlyph {
    GlyphFace face;
    char32_t character = 0;
    float scale = 1.0F;  ///< relative to the font's own size
    glm::vec2 origin{0.0F};
    float advance = 0.0F, blank = 0.0F;  ///< distance to the next character, and width of a space; in pixels
};

/// Finds characters by their position in the font atlas.
class Glyphs {
public:
    Glyphs() {
        for (const ImFont* font : ImGui::GetIO().Fonts->Fonts)
            for (const ImFontGlyph& glyph : font->Glyphs)
                if (glyph.Visible) places_.try_emplace({glyph.U0, glyph.V0}, Place{font, &glyph});
    }

    /// Returns the character that a rectangle of two triangles draws. `corners`: its four corners, upper left first.
    std::optional<DrawnGlyph> at(const ImDrawVert* corners) const {
        const ImDrawVert &first = corners[0], &last = corners[2];
        const Place* const place = find(first.uv);
        if (!place) return std::nullopt;
        const ImFontGlyph& glyph = *place->glyph;
        // A clipped glyph has clipped texture coordinates, too, so these give its size and position before clipping.
        const float scale = (last.pos.y - first.pos.y) / (last.uv.y - first.uv.y) * (glyph.V1 - glyph.V0) /
                            std::max(glyph.Y1 - glyph.Y0, 1e-6F);
        const float left =
            first.pos.x - (first.uv.x - glyph.U0) / (glyph.U1 - glyph.U0) * (glyph.X1 - glyph.X0) * scale;
        const float top = first.pos.y - (first.uv.y - glyph.V0) / (glyph.V1 - glyph.V0) * (glyph.Y1 - glyph.Y0) * scale;
        DrawnGlyph drawn;
        drawn.face = place->face_once();
        drawn.character = glyph.Codepoint;
        drawn.scale = scale;
        drawn.origin = {left - glyph.X0 * scale, top + (std::round(place->font->Ascent) - glyph.Y0) * scale};
        drawn.advance = glyph.AdvanceX * scale;
        drawn.blank = place->font->GetCharAdvance(' ') * scale;
        return drawn;
    }

private:
    struct Place {
        const ImFont* font;
        const ImFontGlyph* glyph;
        mutable std::optional<GlyphFace> face = {};  ///< cached on first use

        const GlyphFace& face_once() const {
            if (!face) face = face_of(*font, static_cast<ImWchar>(glyph->Codepoint));
            return *face;
        }
    };

    const Place* find(ImVec2 uv) const {
        if (const auto exact = places_.find({uv.x, uv.y}); exact != places_.end()) return &exact->second;
        for (const auto& [corner, place] : places_)
            if (uv.x >= corner.first && uv.y >= corner.second && uv.x < place.glyph->U1 && uv.y < place.glyph->V1)
                return &place;
        return nullptr;
    }

    std::map<std::pair<float, float>, Place> places_;
};

// ---- triangles -----------------------------------------------------------------------------------------------------

using Edge = std::pair<ImDrawIdx, ImDrawIdx>;

/// Returns the outline of the area that triangles cover. All triangles get the same winding, so an edge shared by two
/// of them is traversed in both directions and cancels.
std::vector<Ring> outline(std::span<const ImDrawIdx> triangles, const std::map<ImDrawIdx, glm::vec2>& places) {
    std::map<Edge, int> edges;
    const auto add = [&edges](ImDrawIdx from, ImDrawIdx to) {
        const auto back = edges.find({to, from});
        if (back == edges.end()) {
            ++edges[{from, to}];
        } else if (--back->second == 0) {
            edges.erase(back);
        }
    };
    for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
        ImDrawIdx a = triangles[i], b = triangles[i + 1], c = triangles[i + 2];
        const glm::vec2 to_b = places.at(b) - places.at(a), to_c = places.at(c) - places.at(a);
        const float area = to_b.x * to_c.y - to_b.y * to_c.x;
        if (area == 0.0F) continue;
        if (area < 0.0F) std::swap(b, c);
        add(a, b);
        add(b, c);
        add(c, a);
    }
    std::vector<Ring> rings;
    while (!edges.empty()) {
        const ImDrawIdx begin = edges.begin()->first.first;
        ImDrawIdx at = begin;
        Ring ring;
        do {
            const auto next = edges.lower_bound({at, 0});
            if (next == edges.end() || next->first.first != at) break;
            ring.push_back(places.at(at));
            at = next->first.second;
            if (--next->second == 0) edges.erase(next);
        } while (at != begin);
        rings.push_back(std::move(ring));
    }
    return rings;
}

/// The vertices of a group of connected triangles, by index.
class Mesh {
public:
    Mesh(std::span<const ImDrawIdx> triangles, const ImDrawVert* vertices) : vertices_(vertices) {
        for (const ImDrawIdx index : triangles) places_.emplace(index, point(vertices[index].pos));
        move_fringe(triangles);
        for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
            const std::span<const ImDrawIdx> triangle = triangles.subspan(i, 3);
            // Omit triangles that have only fringe vertices: they have no visible corner.
            if (std::any_of(triangle.begin(), triangle.end(), [&](ImDrawIdx at) { return !is_clear(color(at)); }))
                triangles_.insert(triangles_.end(), triangle.begin(), triangle.end());
        }
    }

    bool empty() const { return triangles_.empty(); }
    std::vector<Ring> rings() const { return outline(triangles_, places_); }
    ImU32 color(ImDrawIdx index) const { return vertices_[index].col; }
    const std::map<ImDrawIdx, glm::vec2>& places() const { return places_; }

    /// Returns the color of the first visible corner.
    ImU32 color() const {
        for (const ImDrawIdx index : triangles_)
            if (!is_clear(color(index))) return color(index);
        return 0;
    }

    DrawingBox box() const {
        DrawingBox box{places_.begin()->second, places_.begin()->second};
        for (const auto& [index, place] : places_) box = {glm::min(box.min, place), glm::max(box.max, place)};
        return box;
    }

    /// Returns the gradient of a rectangle of two triangles, if each of two opposite sides has a single color.
    std::optional<Shade> shade() const {
        if (places_.size() != 4) return std::nullopt;
        const DrawingBox box = this->box();
        std::map<std::pair<bool, bool>, ImU32> corners;  // key: whether at the right, whether at the bottom
        for (const auto& [index, place] : places_) {
            if ((place.x != box.min.x && place.x != box.max.x) || (place.y != box.min.y && place.y != box.max.y))
                return std::nullopt;
            corners[{place.x == box.max.x, place.y == box.max.y}] = color(index);
        }
        if (corners.size() != 4) return std::nullopt;
        const ImU32 upper_left = corners[{false, false}], lower_left = corners[{false, true}];
        const ImU32 upper_right = corners[{true, false}], lower_right = corners[{true, true}];
        if (upper_left == upper_right && lower_left == lower_right && upper_left != lower_left)
            return Shade{box, true, ink_of(upper_left), ink_of(lower_left)};
        if (upper_left == lower_left && upper_right == lower_right && upper_left != upper_right)
            return Shade{box, false, ink_of(upper_left), ink_of(upper_right)};
        return std::nullopt;
    }

private:
    /// Moves the fringe's outer vertices to the middle of the fringe. The fringe fades out over one pixel, so the
    /// shape's outline runs along this middle.
    void move_fringe(std::span<const ImDrawIdx> triangles) {
        if (places_.size() == 4) return;  // a gradient rectangle has no fringe
        std::map<ImDrawIdx, ImDrawIdx> partners;
        for (std::size_t i = 0; i + 2 < triangles.size(); i += 3)
            for (const ImDrawIdx outer : triangles.subspan(i, 3))
                for (const ImDrawIdx inner : triangles.subspan(i, 3)) {
                    if (!is_clear(color(outer)) || is_clear(color(inner))) continue;
                    const auto known = partners.try_emplace(outer, inner).first;
                    const auto distance = [&](ImDrawIdx at) {
                        return glm::distance(point(vertices_[at].pos), point(vertices_[outer].pos));
                    };
                    if (distance(inner) < distance(known->second)) known->second = inner;
                }
        for (const auto& [outer, inner] : partners)
            places_[outer] = 0.5F * (point(vertices_[outer].pos) + point(vertices_[inner].pos));
    }

    const ImDrawVert* vertices_;
    std::map<ImDrawIdx, glm::vec2> places_;
    std::vector<ImDrawIdx> triangles_;
};

// ---- recorder ------------------------------------------------------------------------------------------------------

class Recorder {
public:
    Recorder(const ImDrawData& data, const ReadTexture& read) : read_(read) {
        drawing_.size_px = point(data.DisplaySize);
        for (int i = 0; i < data.CmdListsCount; ++i)  // an array; an ImVector since Dear ImGui 1.89.8
            for (const ImDrawCmd& command : data.CmdLists[i]->CmdBuffer) take(*data.CmdLists[i], command);
    }

    Drawing drawing() { return std::move(drawing_); }

private:
    void take(const ImDrawList& list, const ImDrawCmd& command) {
        if (command.UserCallback) return;
        clip_ = {{command.ClipRect.x, command.ClipRect.y}, {command.ClipRect.z, command.ClipRect.w}};
        line_ = nullptr;
        const std::span<const ImDrawIdx> indices(list.IdxBuffer.Data + command.IdxOffset, command.ElemCount);
        const ImDrawVert* const vertices = list.VtxBuffer.Data + command.VtxOffset;
        for (std::size_t begin = 0; begin < indices.size();) {
            const std::size_t end = end_of_piece(indices, begin);
            take_piece(indices.subspan(begin, end - begin), vertices, command.GetTexID());
            begin = end;
        }
    }

    /// Returns the end of the piece that starts at `begin`. Triangles belong together as long as each shares vertices
    /// with earlier ones. The vertices from one ImDrawList call have consecutive indices, so a new piece begins at a
    /// triangle whose indices are all above the earlier ones, or all below them. They can be below, because Dear ImGui
    /// draws a table column by column (ImDrawListSplitter) but creates its vertices row by row.
    static std::size_t end_of_piece(std::span<const ImDrawIdx> indices, std::size_t begin) {
        ImDrawIdx least = indices[begin], most = indices[begin];
        std::size_t end = begin;
        for (; end + 2 < indices.size(); end += 3) {
            const auto [low, high] = std::minmax({indices[end], indices[end + 1], indices[end + 2]});
            if (end > begin && (low > most || high < least)) break;
            least = std::min(least, low);
            most = std::max(most, high);
        }
        return end > begin ? end : indices.size();
    }

    void take_piece(std::span<const ImDrawIdx> triangles, const ImDrawVert* vertices, ImTextureID texture) {
        const ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
        const ImDrawVert& first = vertices[triangles[0]];
        const ImVec2 white = atlas.TexUvWhitePixel;
        const bool is_atlas = texture == atlas.TexID;
        if (!is_atlas) return take_picture(triangles, vertices, texture);
        if (first.uv.x == white.x && first.uv.y == white.y) return take_shape(triangles, vertices);
        if (triangles.size() == 6)
            if (const std::optional<DrawnGlyph> glyph = glyphs_.at(&first)) take_glyph(*glyph, first.col);
    }

    void take_shape(std::span<const ImDrawIdx> triangles, const ImDrawVert* vertices) {
        line_ = nullptr;
        const Mesh mesh(triangles, vertices);
        if (mesh.empty() || is_outside(mesh.box())) return;
        if (const std::optional<Shade> shade = mesh.shade())
            add(*shade);
        else
            add(Shape{mesh.rings(), ink_of(mesh.color())});
    }

    void take_picture(std::span<const ImDrawIdx> triangles, const ImDrawVert* vertices, ImTextureID texture) {
        line_ = nullptr;
        std::shared_ptr<const Image>& image = pictures_[texture];
        if (!image) image = read_(texture);
        if (!image) return;
        const Mesh mesh(triangles, vertices);
        const ImDrawVert *low = &vertices[triangles[0]], *high = low;
        for (const ImDrawIdx index : triangles) {
            const ImDrawVert& vertex = vertices[index];
            if (vertex.pos.x + vertex.pos.y < low->pos.x + low->pos.y) low = &vertex;
            if (vertex.pos.x + vertex.pos.y > high->pos.x + high->pos.y) high = &vertex;
        }
        const auto texel = [&image](ImVec2 uv) {
            // Texture rows start at the bottom.
            return glm::vec2(uv.x * static_cast<float>(image->width),
                             (1.0F - uv.y) * static_cast<float>(image->height));
        };
        Inset inset{
            image, {texel(low->uv), texel(high->uv)}, {point(low->pos), point(high->pos)}, {}, ink_of(mesh.color())};
        if (triangles.size() > 6) inset.rings = mesh.rings();
        add(std::move(inset));
    }

    void take_glyph(const DrawnGlyph& glyph, ImU32 color) {
        const float em_px = glyph.face.em_px * glyph.scale;
        const glm::vec2 most(1.5F * em_px);
        if (is_outside({glyph.origin - most, glyph.origin + most})) {
            line_ = nullptr;
            return;
        }
        const auto goes_on = [&] {
            if (!line_ || line_->ink != ink_of(color) || std::abs(line_->baseline_px - glyph.origin.y) > 0.25F)
                return false;
            const float gap = glyph.origin.x - pen_px_;
            return gap > -0.1F * em_px && gap < 2.5F * glyph.blank;
        };
        if (goes_on()) {
            // The draw data has no spaces: fill the gap with as many as fit.
            for (; glyph.origin.x - pen_px_ > 0.6F * glyph.blank; pen_px_ += glyph.blank) put(U' ', pen_px_);
            if (line_->face != glyph.face.file || std::abs(line_->em_px - em_px) > 1e-3F) line_ = nullptr;
        } else {
            line_ = nullptr;
        }
        if (!line_) {
            add(Line{glyph.face.file, em_px, glyph.origin.y, {}, {}, ink_of(color)});
            line_ = &std::get<Line>(drawing_.marks.back().what);
        }
        put(glyph.character, glyph.origin.x);
        pen_px_ = glyph.origin.x + glyph.advance;
    }

    void put(char32_t character, float left_px) {
        line_->characters.push_back(character);
        line_->lefts_px.push_back(left_px);
    }

    /// Whether no part of the box is visible.
    bool is_outside(const DrawingBox& box) const {
        const glm::vec2 min = glm::max(clip_.min, glm::vec2(0.0F)), max = glm::min(clip_.max, drawing_.size_px);
        return box.min.x >= max.x || box.min.y >= max.y || box.max.x <= min.x || box.max.y <= min.y;
    }

    template <typename What>
    void add(What what) {
        drawing_.marks.push_back({clip_, std::move(what)});
    }

    const ReadTexture& read_;
    Glyphs glyphs_;
    Drawing drawing_;
    DrawingBox clip_;
    Line* line_ = nullptr;  ///< the line that the next character may continue
    float pen_px_ = 0.0F;   ///< expected position of that character
    std::map<ImTextureID, std::shared_ptr<const Image>> pictures_;
};

}  // namespace

Ink ink_of(ImU32 color) {
    const auto channel = [color](int shift) { return static_cast<std::uint8_t>(color >> shift & 0xFFU); };
    return {channel(IM_COL32_R_SHIFT), channel(IM_COL32_G_SHIFT), channel(IM_COL32_B_SHIFT), channel(IM_COL32_A_SHIFT)};
}

Drawing recorded(const ImDrawData& data, const ReadTexture& read) {
    return Recorder(data, read).drawing();
}

}  // namespace viewing
