// What the renderer draws of a hidden-surface method: triangles in order, or a picture of surface points to be shaded.
// Shading is the same as for the scene's own meshes. Read plan.h next.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "frame/hidden/hidden_surfaces.h"

namespace viewing {

/// A corner of a triangle, in world space; the names of the vertex attributes.
struct OrderedVertex {
    glm::vec3 position_world, normal_world;
    glm::vec3 color;         ///< linear
    float object = 0.0F;     ///< its number from 1 on
    float source_id = 0.0F;  ///< Polygon::source + 1
};

/// The surface point that a pixel sees. Floats, as four texels of a picture.
struct SurfacePixel {
    glm::vec4 position_world{0.0F};  ///< w: window depth; 2 where nothing is seen
    glm::vec4 normal_world{0.0F};    ///< towards the eye; w: 1 front face, 0 back face
    glm::vec4 color{0.0F};           ///< linear; w: the object's number from 1 on
};

/// One of the two is filled. Immutable once made: the renderer uploads it once.
struct HiddenDrawing {
    /// Triangles one after the other that are decals, or are not: decals have a depth offset of their own.
    struct Run {
        int first_vertex, vertex_count;
        bool is_decal;
    };

    std::vector<OrderedVertex> triangles;  ///< three a triangle, in drawing order
    std::vector<Run> runs;                 ///< all of them
    glm::ivec2 size_px{0};
    glm::dvec2 share{1.0};                ///< of the view that they fill: HiddenRequest::share
    std::vector<SurfacePixel> pixels;     ///< rows from the top
    std::vector<std::uint32_t> overdraw;  ///< of each pixel; with `pixels`
    bool is_cut = false;                  ///< cancelled before the last triangle
};

/// Of the polygons that the step has drawn, or of the picture at the step. Cancelled, it has at least the first 32,768
/// of the polygons: what is quickly made is whole.
HiddenDrawing hidden_drawing(const HiddenResult& result, const WorkProgress* progress = nullptr);

/// Red where two pictures differ, elsewhere a veil.
struct DifferenceDrawing {
    glm::ivec2 size_px{0};
    std::vector<glm::u8vec4> pixels;  ///< sRGB with alpha, rows from the top
    std::int64_t compared = 0, different = 0;
    glm::dvec2 share{1.0};  ///< of the view that they fill
};
/// `differs`: not 0 for each pixel that does, rows from the top.
DifferenceDrawing difference_drawing(std::span<const std::uint8_t> differs, glm::ivec2 size_px);
/// Of two pictures of polygon numbers of one size, away from edges.
DifferenceDrawing difference_drawing(const IdImage& reference, const IdImage& image);

/// What a frame shows of hidden-surface methods; none where GL draws the scene by itself.
struct HiddenPictures {
    std::shared_ptr<const HiddenDrawing> camera, mirrored;
    std::shared_ptr<const DifferenceDrawing> difference;
    Bounds bounds_world;  ///< of the scene
    bool operator==(const HiddenPictures&) const = default;
};

/// The linear value of an sRGB colour.
glm::vec3 linear_from_srgb(const Color& color);

}  // namespace viewing
