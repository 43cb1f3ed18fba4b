// What a hidden-surface method found, for the renderer: triangles in order, or a picture of surface points to shade.
// Shading is the same as for the scene's own meshes. topics/hidden/numbers/hidden_drawing.h makes them.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "geometry/mesh.h"

namespace viewing {

/// A corner of a triangle, in coordinates along the world's axes. The members are named like the vertex attributes.
struct OrderedVertex {
    glm::vec3 position_relative;  ///< to HiddenDrawing::origin_world
    glm::vec3 normal_world;
    glm::vec3 color;         ///< linear
    float object = 0.0F;     ///< object ID, from 1
    float source_id = 0.0F;  ///< Polygon::source + 1
};

/// The surface point visible at a pixel. It consists of floats because each vector becomes a texel of its own texture.
struct SurfacePixel {
    glm::vec4 position_relative{0.0F};  ///< to HiddenDrawing::origin_world; w: window depth, or 2 if nothing is seen
    glm::vec4 normal_world{0.0F};       ///< toward the eye; w: 1 front face, 0 back face
    glm::vec4 color{0.0F};              ///< linear; w: the object ID, from 1
};

/// Either `triangles` or `pixels` is filled. Immutable once made: the renderer uploads it once.
struct HiddenDrawing {
    /// Consecutive triangles, either all decals or all non-decals: decals have their own depth offset.
    struct Run {
        int first_vertex, vertex_count;
        bool is_decal;
    };

    glm::dvec3 origin_world{0.0};  ///< the eye; float32 is too coarse for world positions far from the world's origin
    std::vector<OrderedVertex> triangles;  ///< three vertices per triangle, in drawing order
    std::vector<Run> runs;                 ///< the runs of all triangles, in order
    glm::ivec2 size_px{0};
    glm::dvec2 share{1.0};                ///< the fraction of the view that the picture fills: HiddenRequest::share
    std::vector<SurfacePixel> pixels;     ///< rows from the top
    std::vector<std::uint32_t> overdraw;  ///< per pixel; filled if `pixels` is
    bool is_cut = false;                  ///< canceled before the last triangle
};

/// A picture to lay over another: red where two pictures differ, and a dark veil elsewhere.
struct DifferenceDrawing {
    glm::ivec2 size_px{0};
    std::vector<glm::u8vec4> pixels;  ///< sRGB with alpha, rows from the top
    std::int64_t compared = 0, different = 0;
    glm::dvec2 share{1.0};  ///< the fraction of the view that the picture fills
};

/// The pictures of hidden-surface methods for a frame; none if GL draws the scene by itself.
struct HiddenPictures {
    std::shared_ptr<const HiddenDrawing> camera, mirrored;
    std::shared_ptr<const DifferenceDrawing> difference;
    Bounds bounds_world;  ///< of the scene
    bool operator==(const HiddenPictures&) const = default;
};

}  // namespace viewing
