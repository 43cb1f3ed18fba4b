#include "render/buffer_read.h"

#include <array>
#include <bit>
#include <cmath>

#include "frame/depth/depth_counts.h"
#include "render/pass_state.h"

namespace viewing {
namespace {

std::size_t pixel_count(const PixelRect& rect) {
    return static_cast<std::size_t>(rect.size.x) * static_cast<std::size_t>(rect.size.y);
}

/// GL counts rows from the bottom: the lowest row of the rectangle.
glm::ivec2 lowest_left(const View& view, const PixelRect& rect) {
    return {rect.first_pixel.x, view.size_px().y - rect.first_pixel.y - rect.size.y};
}

void read_pixels(const View& view, const PixelRect& rect, GLenum format, GLenum type, void* values) {
    const glm::ivec2 at = lowest_left(view, rect);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glFinish();  // as in gl::read_pixels
    glReadPixels(at.x, at.y, rect.size.x, rect.size.y, format, type, values);
}

/// Where a pixel of the rectangle, the top row first, lies among rows from the bottom.
std::size_t from_the_bottom(std::size_t index, const PixelRect& rect) {
    const auto columns = static_cast<std::size_t>(rect.size.x), rows = static_cast<std::size_t>(rect.size.y);
    return (rows - 1 - index / columns) * columns + index % columns;
}

/// How the buffer of a target holds depths. Formats with fewer bits are kept exactly inside 24.
DepthPrecision precision_in(const gl::Target& target) {
    switch (target.spec().depth) {
        case gl::DepthKind::d16:
            return {.bits = 16, .is_float = false};
        case gl::DepthKind::d32f_s8:
            return {.bits = 24, .is_float = true};
        case gl::DepthKind::d24_s8:
            break;
    }
    return {.bits = 24, .is_float = false};
}

}  // namespace

Result<BufferReader> BufferReader::make(const gl::Capabilities& capabilities) {
    BufferReader reader(capabilities);
    if (capabilities.read_depth_stencil) return reader;
    if (Result<const ReadDepthProgram*> depths = reader.programs_.read_depth(); !depths) return Error{depths.error()};
    if (Result<const ConstantProgram*> constant = reader.programs_.constant(); !constant)
        return Error{constant.error()};
    return reader;
}

std::vector<Color> BufferReader::colors(const View& view, const PixelRect& rect) const {
    std::vector<glm::u8vec4> bytes(pixel_count(rect));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, view.target().single_framebuffer());
    read_pixels(view, rect, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    std::vector<Color> colors(bytes.size());
    for (std::size_t i = 0; i < colors.size(); ++i) {
        const glm::u8vec4& color = bytes[from_the_bottom(i, rect)];
        colors[i] = {color.r, color.g, color.b};
    }
    return colors;
}

std::vector<StoredPixel> BufferReader::stored(const View& view, DepthFormat format, const PixelRect& rect) {
    read_depths(view, rect);
    read_stencil(view, rect);
    const DepthPrecision in_buffer = precision_in(view.target()), asked = precision_of(format);
    std::vector<StoredPixel> pixels(pixel_count(rect));
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const std::size_t at = from_the_bottom(i, rect);
        pixels[i].stencil = stencils_[at];
        pixels[i].code = depths_[at];
        if (in_buffer.is_float) {
            pixels[i].window_depth = std::bit_cast<float>(depths_[at]);
        } else {
            const double levels = asked.greatest_code();
            pixels[i].code = static_cast<std::uint32_t>(std::lround(depths_[at] / in_buffer.greatest_code() * levels));
            pixels[i].window_depth = pixels[i].code / levels;
        }
    }
    return pixels;
}

DepthCounts BufferReader::count_depths(const View& view, const FramePlan& plan) {
    const bool can_be_read = view.target().spec().samples == 0;
    if (can_be_read)
        read_depths(view, {{0, 0}, view.size_px()});
    else
        depths_.clear();
    return viewing::count_depths(depths_, precision_in(view.target()), plan);
}

void BufferReader::read_depths(const View& view, const PixelRect& rect) {
    depths_.resize(pixel_count(rect));
    const DepthPrecision precision = precision_in(view.target());
    if (!capabilities_.read_depth_stencil) {
        draw_depths(view, rect);
        read_pixels(view, rect, GL_RGBA, GL_UNSIGNED_BYTE, depths_.data());
        for (std::uint32_t& depth : depths_) {
            const auto bytes = std::bit_cast<std::array<std::uint8_t, 4>>(depth);
            depth = bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8U |
                    static_cast<std::uint32_t>(bytes[2]) << 16U | static_cast<std::uint32_t>(bytes[3]) << 24U;
            if (!precision.is_float)
                depth =
                    static_cast<std::uint32_t>(std::lround(std::bit_cast<float>(depth) * precision.greatest_code()));
        }
        return;
    }
    glBindFramebuffer(GL_READ_FRAMEBUFFER, view.target().single_framebuffer());
    read_pixels(view, rect, GL_DEPTH_COMPONENT, precision.is_float ? GL_FLOAT : GL_UNSIGNED_INT, depths_.data());
    if (precision.is_float) return;
    for (std::uint32_t& depth : depths_) depth >>= static_cast<unsigned>(32 - precision.bits);
}

void BufferReader::read_stencil(const View& view, const PixelRect& rect) {
    stencils_.resize(pixel_count(rect));
    const bool has_mask = !view.target().has_stencil();
    if (!has_mask && capabilities_.read_depth_stencil) {
        glBindFramebuffer(GL_READ_FRAMEBUFFER, view.target().single_framebuffer());
        read_pixels(view, rect, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencils_.data());
        return;
    }
    if (has_mask)
        glBindFramebuffer(GL_READ_FRAMEBUFFER, view.target().mask().read_framebuffer());
    else
        draw_stencil(view, rect);
    std::vector<glm::u8vec4> bytes(stencils_.size());
    read_pixels(view, rect, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    for (std::size_t i = 0; i < bytes.size(); ++i) stencils_[i] = bytes[i].r;
}

/// Whatever is drawn next changes only the rectangle.
void BufferReader::begin_bytes(const View& view, const PixelRect& rect) {
    if (bytes_.size_px() != view.size_px()) bytes_ = gl::ColorTarget(view.size_px());
    const glm::ivec2 at = lowest_left(view, rect);
    restore_defaults(capabilities_);
    glViewport(0, 0, view.size_px().x, view.size_px().y);
    glEnable(GL_SCISSOR_TEST);
    glScissor(at.x, at.y, rect.size.x, rect.size.y);
}

void BufferReader::draw_depths(const View& view, const PixelRect& rect) {
    begin_bytes(view, rect);
    glBindFramebuffer(GL_FRAMEBUFFER, bytes_.framebuffer());
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, view.target().depth_texture());
    const ReadDepthProgram& program = **programs_.read_depth();
    program.use();
    program.depth_texture.set(Sampler{0});
    fullscreen_.draw(program);
    glDisable(GL_SCISSOR_TEST);
    restore_defaults(capabilities_);
}

void BufferReader::draw_stencil(const View& view, const PixelRect& rect) {
    begin_bytes(view, rect);
    const gl::Framebuffer both = gl::make_framebuffer();  // the bytes beside the view's stencil
    glBindFramebuffer(GL_FRAMEBUFFER, both.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, bytes_.texture(), 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D, view.target().depth_texture(),
                           0);
    gather_stencil(both.name(), **programs_.constant(), fullscreen_);
    glDisable(GL_SCISSOR_TEST);
    restore_defaults(capabilities_);
    glBindFramebuffer(GL_FRAMEBUFFER, bytes_.framebuffer());
}

}  // namespace viewing
