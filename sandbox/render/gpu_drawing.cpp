#include "render/gpu_drawing.h"

#include <cstddef>
#include <vector>

namespace viewing {
namespace {

struct TexelFormat {
    GLint internal;
    GLenum format, type;
};
constexpr TexelFormat four_floats{GL_RGBA32F, GL_RGBA, GL_FLOAT}, one_float{GL_R32F, GL_RED, GL_FLOAT},
    four_bytes{GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE};

gl::Texture upload_texture(glm::ivec2 size_px, const TexelFormat& format, const void* texels) {
    gl::Texture texture = gl::make_texture();
    glBindTexture(GL_TEXTURE_2D, texture.name());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glTexImage2D(GL_TEXTURE_2D, 0, format.internal, size_px.x, size_px.y, 0, format.format, format.type, texels);
    glBindTexture(GL_TEXTURE_2D, 0);
    return texture;
}

GpuDrawing upload_triangles(const HiddenDrawing& drawing) {
    GpuDrawing made{gl::make_vertex_array(), gl::make_buffer(), {}};
    glBindVertexArray(made.vertex_array.name());
    glBindBuffer(GL_ARRAY_BUFFER, made.vertices.name());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(drawing.triangles.size() * sizeof(OrderedVertex)),
                 drawing.triangles.data(), GL_STATIC_DRAW);
    struct Attribute {
        GLint components;
        std::size_t offset;
    };
    static constexpr Attribute attributes[] = {{3, offsetof(OrderedVertex, position_relative)},
                                               {3, offsetof(OrderedVertex, normal_world)},
                                               {3, offsetof(OrderedVertex, color)},
                                               {2, offsetof(OrderedVertex, object)}};
    for (GLuint index = 0; index < std::size(attributes); ++index) {
        glEnableVertexAttribArray(index);
        glVertexAttribPointer(index, attributes[index].components, GL_FLOAT, GL_FALSE, sizeof(OrderedVertex),
                              reinterpret_cast<const void*>(attributes[index].offset));
    }
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    return made;
}

GpuDrawing upload_pixels(const HiddenDrawing& drawing) {
    GpuDrawing made;
    std::vector<glm::vec4> texels(drawing.pixels.size());
    static constexpr glm::vec4 SurfacePixel::*parts[] = {&SurfacePixel::position_relative, &SurfacePixel::normal_world,
                                                         &SurfacePixel::color};
    for (std::size_t part = 0; part < std::size(parts); ++part) {
        for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = drawing.pixels[i].*parts[part];
        made.surface[part] = upload_texture(drawing.size_px, four_floats, texels.data());
    }
    const std::vector<float> counts(drawing.overdraw.begin(), drawing.overdraw.end());
    made.surface[3] = upload_texture(drawing.size_px, one_float, counts.data());
    return made;
}

}  // namespace

void GpuDrawing::draw(int first_vertex, int vertex_count) const {
    glBindVertexArray(vertex_array.name());
    glDrawArrays(GL_TRIANGLES, first_vertex, vertex_count);
}

void GpuDrawing::bind_textures() const {
    for (std::size_t unit = 0; unit < surface.size(); ++unit) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        glBindTexture(GL_TEXTURE_2D, surface[unit].name());
    }
    glActiveTexture(GL_TEXTURE0);
}

const GpuDrawing& GpuDrawings::of(const std::shared_ptr<const HiddenDrawing>& drawing) {
    Drawing& entry = drawings_[drawing.get()];
    if (entry.source.lock() != drawing)  // a new drawing, possibly at the address of a freed one
        entry = {drawing, drawing->pixels.empty() ? upload_triangles(*drawing) : upload_pixels(*drawing)};
    return entry.uploaded;
}

GLuint GpuDrawings::texture_of(const std::shared_ptr<const DifferenceDrawing>& drawing) {
    Difference& entry = differences_[drawing.get()];
    if (entry.source.lock() != drawing)
        entry = {drawing, upload_texture(drawing->size_px, four_bytes, drawing->pixels.data())};
    return entry.texture.name();
}

void GpuDrawings::drop_unused() {
    const auto is_unused = [](const auto& item) { return item.second.source.expired(); };
    std::erase_if(drawings_, is_unused);
    std::erase_if(differences_, is_unused);
}

}  // namespace viewing
