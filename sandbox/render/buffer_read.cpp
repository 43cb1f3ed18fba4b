#include "render/buffer_read.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>

#include "frame/depth_counts.h"
#include "gl/dialect.h"
#include "render/pass_state.h"

namespace viewing {
namespace {

/// One pixel in the layout in which GL copies it into a buffer; only the first byte of the stencil matters.
struct CopiedPixel {
    glm::u8vec4 color{0};
    std::uint32_t depth = 0;
    std::array<std::uint8_t, 4> stencil{};
    glm::u8vec4 identity{0};
};

std::size_t pixel_count(const PixelRect& rect) {
    return static_cast<std::size_t>(rect.size.x) * static_cast<std::size_t>(rect.size.y);
}

/// Returns the lower left pixel of the rectangle, counting rows from the bottom like GL.
glm::ivec2 lowest_left(const View& view, const PixelRect& rect) {
    return {rect.first_pixel.x, view.size_px().y - rect.first_pixel.y - rect.size.y};
}

void read_pixels(const View& view, const PixelRect& rect, GLenum format, GLenum type, void* values) {
    const glm::ivec2 at = lowest_left(view, rect);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glFinish();  // see gl::read_pixels
    glReadPixels(at.x, at.y, rect.size.x, rect.size.y, format, type, values);
}

/// Converts a pixel's index in the rectangle from top-row-first to bottom-row-first order.
std::size_t from_the_bottom(std::size_t index, const PixelRect& rect) {
    const auto columns = static_cast<std::size_t>(rect.size.x), rows = static_cast<std::size_t>(rect.size.y);
    return (rows - 1 - index / columns) * columns + index % columns;
}

/// Converts a pixel to the precision `asked`. `depth` is a code or the bits of a float, as stored in the buffer.
StoredPixel stored_pixel(std::uint32_t depth, int stencil, const DepthPrecision& in_buffer,
                         const DepthPrecision& asked) {
    StoredPixel pixel{0.0, depth, stencil};
    if (in_buffer.is_float) {
        pixel.window_depth = std::bit_cast<float>(depth);
        return pixel;
    }
    const double levels = asked.greatest_code();
    pixel.code = static_cast<std::uint32_t>(std::lround(depth / in_buffer.greatest_code() * levels));
    pixel.window_depth = pixel.code / levels;
    return pixel;
}

/// Returns the precision with which a target's buffer stores depths. Formats with fewer bits are stored in 24 bits
/// without loss.
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
        pixels[i] = stored_pixel(depths_[at], stencils_[at], in_buffer, asked);
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

BufferReader::ReadFormat BufferReader::bind_depths(const View& view) const {
    const bool reads = capabilities_.read_depth_stencil;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, reads ? view.target().single_framebuffer() : depth_bytes_.framebuffer());
    if (!reads) return {GL_RGBA, GL_UNSIGNED_BYTE};
    return {GL_DEPTH_COMPONENT, static_cast<GLenum>(precision_in(view.target()).is_float ? GL_FLOAT : GL_UNSIGNED_INT)};
}

BufferReader::ReadFormat BufferReader::bind_stencil(const View& view) const {
    const bool has_mask = !view.target().has_stencil();
    if (has_mask) {
        glBindFramebuffer(GL_READ_FRAMEBUFFER, view.target().mask().read_framebuffer());
        return {GL_RGBA, GL_UNSIGNED_BYTE};
    }
    const bool reads = capabilities_.read_depth_stencil;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, reads ? view.target().single_framebuffer() : stencil_bytes_.framebuffer());
    return {static_cast<GLenum>(reads ? GL_STENCIL_INDEX : GL_RGBA), GL_UNSIGNED_BYTE};
}

std::uint32_t BufferReader::depth_of(std::uint32_t given, const DepthPrecision& in_buffer) const {
    if (capabilities_.read_depth_stencil)
        return in_buffer.is_float ? given : given >> static_cast<unsigned>(32 - in_buffer.bits);
    const auto bytes = std::bit_cast<std::array<std::uint8_t, 4>>(given);
    const std::uint32_t bits = bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8U |
                               static_cast<std::uint32_t>(bytes[2]) << 16U |
                               static_cast<std::uint32_t>(bytes[3]) << 24U;
    if (in_buffer.is_float) return bits;
    return static_cast<std::uint32_t>(std::lround(std::bit_cast<float>(bits) * in_buffer.greatest_code()));
}

void BufferReader::read_depths(const View& view, const PixelRect& rect) {
    depths_.resize(pixel_count(rect));
    draw_depths(view, rect);
    const ReadFormat as = bind_depths(view);
    read_pixels(view, rect, as.format, as.type, depths_.data());
    const DepthPrecision precision = precision_in(view.target());
    for (std::uint32_t& depth : depths_) depth = depth_of(depth, precision);
}

void BufferReader::read_stencil(const View& view, const PixelRect& rect) {
    stencils_.resize(pixel_count(rect));
    draw_stencil(view, rect);
    const ReadFormat as = bind_stencil(view);
    if (as.format != GL_RGBA) return read_pixels(view, rect, as.format, as.type, stencils_.data());
    std::vector<glm::u8vec4> bytes(stencils_.size());
    read_pixels(view, rect, as.format, as.type, bytes.data());
    for (std::size_t i = 0; i < bytes.size(); ++i) stencils_[i] = bytes[i].r;
}

void BufferReader::ask(const View& view, glm::ivec2 pixel) {
    const PixelRect only{pixel, {1, 1}};
    draw_depths(view, only);
    draw_stencil(view, only);
    asked_ = Asked{pixel, gl::Fence::after_all_so_far(), {}};
}

/// Starts copying color, depth, stencil and identity into `copied_`, one after another.
void BufferReader::copy(const View& view, const View& identities) {
    if (!copied_) copied_ = gl::make_buffer();
    glBindBuffer(GL_PIXEL_PACK_BUFFER, copied_.name());
    glBufferData(GL_PIXEL_PACK_BUFFER, sizeof(CopiedPixel), nullptr, GL_STREAM_READ);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    const glm::ivec2 at = lowest_left(view, {asked_->pixel, {1, 1}});
    const auto add = [at](const ReadFormat& as, std::size_t offset) {
        glReadPixels(at.x, at.y, 1, 1, as.format, as.type, reinterpret_cast<void*>(offset));
    };
    constexpr ReadFormat as_color{GL_RGBA, GL_UNSIGNED_BYTE};
    glBindFramebuffer(GL_READ_FRAMEBUFFER, view.target().single_framebuffer());
    add(as_color, offsetof(CopiedPixel, color));
    add(bind_depths(view), offsetof(CopiedPixel, depth));
    add(bind_stencil(view), offsetof(CopiedPixel, stencil));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, identities.target().single_framebuffer());
    add(as_color, offsetof(CopiedPixel, identity));
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    asked_->copied = gl::Fence::after_all_so_far();
}

std::optional<ReadPixel> BufferReader::take(const View& view, const View& identities, DepthFormat format) {
    if (!asked_) return std::nullopt;
    if (!asked_->copied) {
        if (!asked_->drawn.has_passed()) return std::nullopt;
        copy(view, identities);
    }
    if (!asked_->copied.has_passed()) return std::nullopt;
    asked_.reset();
    std::array<std::uint8_t, sizeof(CopiedPixel)> bytes{};
    glBindBuffer(GL_PIXEL_PACK_BUFFER, copied_.name());
    gl::copy_pixel_pack_buffer(bytes);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    const auto read = std::bit_cast<CopiedPixel>(bytes);
    const auto color_of = [](const glm::u8vec4& color) { return Color{color.r, color.g, color.b}; };
    const DepthPrecision in_buffer = precision_in(view.target());
    return ReadPixel{color_of(read.color), color_of(read.identity),
                     stored_pixel(depth_of(read.depth, in_buffer), read.stencil[0], in_buffer, precision_of(format))};
}

/// Restricts further drawing to the rectangle.
void BufferReader::begin_bytes(gl::ColorTarget& bytes, const View& view, const PixelRect& rect) {
    if (bytes.size_px() != view.size_px()) bytes = gl::ColorTarget(view.size_px());
    const glm::ivec2 at = lowest_left(view, rect);
    restore_defaults(capabilities_);
    glViewport(0, 0, view.size_px().x, view.size_px().y);
    glEnable(GL_SCISSOR_TEST);
    glScissor(at.x, at.y, rect.size.x, rect.size.y);
}

void BufferReader::draw_depths(const View& view, const PixelRect& rect) {
    if (capabilities_.read_depth_stencil) return;
    begin_bytes(depth_bytes_, view, rect);
    glBindFramebuffer(GL_FRAMEBUFFER, depth_bytes_.framebuffer());
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
    if (capabilities_.read_depth_stencil || !view.target().has_stencil()) return;
    begin_bytes(stencil_bytes_, view, rect);
    const gl::Framebuffer both = gl::make_framebuffer();  // writes the bytes, tests the view's stencil
    glBindFramebuffer(GL_FRAMEBUFFER, both.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, stencil_bytes_.texture(), 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D, view.target().depth_texture(),
                           0);
    gather_stencil(both.name(), **programs_.constant(), fullscreen_);
    glDisable(GL_SCISSOR_TEST);
    restore_defaults(capabilities_);
}

}  // namespace viewing
