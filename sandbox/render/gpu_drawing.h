// GPU copies of the results of hidden-surface methods: uploaded once and kept as long as a frame refers to them.
#pragma once

#include <array>
#include <memory>
#include <unordered_map>

#include "frame/plan/hidden_pictures.h"
#include "gl/objects.h"

namespace viewing {

struct GpuDrawing {
    gl::VertexArray vertex_array;
    gl::Buffer vertices;
    std::array<gl::Texture, 4> surface;  ///< positions, normals, colors, counts

    void draw(int first_vertex, int vertex_count) const;  ///< draws some of the triangles
    void bind_textures() const;                           ///< binds `surface` to texture units 0 … 3
};

class GpuDrawings {
public:
    const GpuDrawing& of(const std::shared_ptr<const HiddenDrawing>& drawing);
    GLuint texture_of(const std::shared_ptr<const DifferenceDrawing>& drawing);

    /// Frees drawings to which no frame refers anymore.
    void drop_unused();

private:
    struct Drawing {
        std::weak_ptr<const HiddenDrawing> source;
        GpuDrawing uploaded;
    };
    struct Difference {
        std::weak_ptr<const DifferenceDrawing> source;
        gl::Texture texture;
    };
    std::unordered_map<const HiddenDrawing*, Drawing> drawings_;
    std::unordered_map<const DifferenceDrawing*, Difference> differences_;
};

}  // namespace viewing
