#include "render/probe.h"

#include <bit>
#include <cmath>

namespace viewing {
namespace {

/// Depth and stencil of one pixel, as the buffer holds them.
struct StoredPixel {
    double window_depth;
    std::uint32_t code;
    int stencil;
};

StoredPixel read_stored(glm::ivec2 at, const DepthPrecision& precision) {
    if (precision.is_float) {
        struct {
            float depth;
            std::uint32_t stencil;
        } value{};
        glReadPixels(at.x, at.y, 1, 1, GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV, &value);
        return {value.depth, std::bit_cast<std::uint32_t>(value.depth), static_cast<int>(value.stencil & 0xFFU)};
    }
    std::uint32_t value = 0;
    glReadPixels(at.x, at.y, 1, 1, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, &value);
    // Formats with fewer bits are stored exactly inside the 24.
    const double levels = std::pow(2.0, precision.bits) - 1.0;
    const auto code = static_cast<std::uint32_t>(std::lround((value >> 8U) / 16777215.0 * levels));
    return {code / levels, code, static_cast<int>(value & 0xFFU)};
}

glm::u8vec4 read_color(glm::ivec2 at) {
    glm::u8vec4 color{0};
    glReadPixels(at.x, at.y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &color[0]);
    return color;
}

}  // namespace

Status PixelProbe::prepare(Renderer& renderer, FramePlan plan, const Scene& scene, const Derived& derived,
                           glm::ivec2 size_px) {
    plan.samples = 0;
    plan.shows = plan.shows == Shows::facing ? Shows::facing : Shows::color;
    plan_ = std::move(plan);
    world_from_view_ = glm::inverse(derived.view_from_world);
    aspect_ = derived.aspect;
    if (Status drawn = renderer.draw(plan_, scene, size_px, colors_); !drawn) return drawn;
    return renderer.draw_identities(plan_, scene, size_px, identities_);
}

PixelReport PixelProbe::at(glm::ivec2 pixel, const Scene& scene) const {
    const glm::ivec2 size_px = colors_.size_px();
    const glm::ivec2 at(pixel.x, size_px.y - 1 - pixel.y);  // GL counts rows from the bottom
    PixelReport report;
    report.pixel = pixel;
    report.precision = precision_of(plan_.depth_format);

    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, colors_.framebuffer());
    const glm::u8vec4 color = read_color(at);
    report.color = {color.r, color.g, color.b};
    const StoredPixel stored = read_stored(at, report.precision);
    report.window_depth = stored.window_depth;
    report.stored = stored.code;
    report.stencil = stored.stencil;
    report.ndc_z = plan_.clip_zero_to_one ? report.window_depth : report.window_depth * 2.0 - 1.0;

    glBindFramebuffer(GL_READ_FRAMEBUFFER, identities_.framebuffer());
    const glm::u8vec4 bytes = read_color(at);
    const int identity = bytes.r + 256 * bytes.g;
    report.written = identity != 0;
    report.front_facing = bytes.b != 0;
    if (identity == Renderer::patch_identity)
        report.object = "plane";
    else if (report.written)
        report.object = scene.objects.at(static_cast<std::size_t>(identity - 1)).description.name;
    report.has_depth = report.written && report.window_depth != plan_.clear_depth_value;
    if (!report.has_depth) return report;

    const Lens& lens = plan_.lens;
    const double distance = distance_of_window_depth(lens, plan_.depth_mapping, report.window_depth);
    report.eye_z = -distance;
    report.step = resolvable_depth_step(lens, plan_.depth_mapping, report.precision, distance);
    const glm::dvec2 ndc = (glm::dvec2(at) + 0.5) / glm::dvec2(size_px) * 2.0 - 1.0;
    const double half_height =
        lens.orthographic ? lens.height * 0.5 : std::tan(glm::radians(lens.fovy_deg) * 0.5) * distance;
    const glm::dvec2 offset = ndc * half_height * glm::dvec2(aspect_, 1.0);
    report.world = glm::dvec3(world_from_view_ * glm::dvec4(offset, -distance, 1.0));
    return report;
}

}  // namespace viewing
