#include "render/probe.h"

#include <cmath>

#include "frame/plan/draw_calls.h"

namespace viewing {

Status PixelProbe::prepare(Renderer& renderer, FramePlan plan, const Scene& scene, const Derived& derived,
                           glm::ivec2 size_px) {
    plan.samples = 0;
    plan.shows = plan.shows == Shows::facing ? Shows::facing : Shows::color;
    if (!reader_) {
        Result<BufferReader> made = BufferReader::make(renderer.capabilities());
        if (!made) return Error{made.error()};
        reader_ = *std::move(made);
    }
    reader_->drop();  // drops requests for the previous picture
    asked_.reset();
    plan_ = std::move(plan);
    world_from_view_ = glm::inverse(derived.view_from_world);
    view_from_clip_ = glm::inverse(derived.clip_from_view);
    aspect_ = derived.aspect;
    if (Status drawn = renderer.draw(plan_, scene, size_px, colors_); !drawn) return drawn;
    return renderer.draw_identities(plan_, scene, size_px, identities_);
}

PixelReport PixelProbe::at(glm::ivec2 pixel, const Scene& scene) const {
    const PixelRect only{pixel, {1, 1}};
    return report(pixel,
                  {.color = reader_->colors(colors_, only).front(),
                   .identity = reader_->colors(identities_, only).front(),
                   .stored = reader_->stored(colors_, plan_.depth_format, only).front()},
                  scene);
}

void PixelProbe::ask(glm::ivec2 pixel) {
    reader_->ask(colors_, pixel);
    asked_ = pixel;
}

std::optional<PixelReport> PixelProbe::take(const Scene& scene) {
    if (!asked_) return std::nullopt;
    const std::optional<ReadPixel> read = reader_->take(colors_, identities_, plan_.depth_format);
    if (!read) return std::nullopt;
    return report(*std::exchange(asked_, std::nullopt), *read, scene);
}

glm::dvec3 PixelProbe::unprojected(const glm::dvec2& ndc, double window_depth) const {
    const glm::dvec4 start = view_from_clip_ * glm::dvec4(ndc, 0.0, 1.0), &along = view_from_clip_[2];
    double z = plan_.clip_zero_to_one ? window_depth : window_depth * 2.0 - 1.0;
    if (plan_.depth_mapping == DepthMapping::logarithmic) {  // stores the eye distance, not z ÷ w
        const double distance = distance_of_window_depth(plan_.lens, plan_.depth_mapping, window_depth);
        z = -(start.z + distance * start.w) / (along.z + distance * along.w);
    }
    const glm::dvec4 point = start + z * along;
    return glm::dvec3(point) / point.w;
}

/// Without near and far, only the inverse of P can locate a depth.
void PixelProbe::locate_without_lens(PixelReport& report, const glm::dvec2& ndc) const {
    const glm::dvec3 point = unprojected(ndc, report.window_depth);
    const double code = code_width(report.precision, report.window_depth);
    report.eye_z = point.z;
    report.step = std::abs(unprojected(ndc, report.window_depth - code).z - point.z);
    report.resolvable_step = report.step;
    const glm::dvec4 world = world_from_view_ * glm::dvec4(point, 1.0);
    report.world = glm::dvec3(world) / world.w;
    const bool is_known = std::isfinite(report.eye_z) && std::isfinite(report.step) &&
                          std::isfinite(glm::dot(report.world, report.world));
    if (!is_known) report.has_depth = false;
}

PixelReport PixelProbe::report(glm::ivec2 pixel, const ReadPixel& read, const Scene& scene) const {
    const glm::ivec2 size_px = colors_.size_px();
    const glm::ivec2 at(pixel.x, size_px.y - 1 - pixel.y);  // GL counts rows from the bottom
    PixelReport report;
    report.pixel = pixel;
    report.precision = precision_of(plan_.depth_format);

    report.color = read.color;
    report.window_depth = read.stored.window_depth;
    report.stored = read.stored.code;
    report.stencil = read.stored.stencil;
    report.ndc_z = plan_.clip_zero_to_one ? report.window_depth : report.window_depth * 2.0 - 1.0;

    const Color& bytes = read.identity;
    const int identity = bytes.r + 256 * bytes.g;
    report.written = identity != 0;
    report.front_facing = bytes.b != 0;
    if (identity >= Renderer::patch_identity)
        report.object = plane_name(static_cast<std::size_t>(identity - Renderer::patch_identity));
    else if (report.written)
        report.object = scene.objects.at(static_cast<std::size_t>(identity - 1)).description.name;
    report.has_depth = report.written && report.window_depth != plan_.clear_depth_value;
    if (!report.has_depth) return report;

    const glm::dvec2 ndc = (glm::dvec2(at) + 0.5) / glm::dvec2(size_px) * 2.0 - 1.0;
    if (!plan_.has_distances) {
        locate_without_lens(report, ndc);
        return report;
    }
    const Lens& lens = plan_.lens;
    const double distance = distance_of_window_depth(lens, plan_.depth_mapping, report.window_depth);
    report.eye_z = -distance;
    report.step = depth_step(lens, plan_.depth_mapping, report.precision, distance);
    report.resolvable_step = resolvable_depth_step(lens, plan_.depth_mapping, report.precision, distance);
    const glm::dvec2 at_view = lens.edges_at(distance, aspect_).at(ndc);
    report.world = glm::dvec3(world_from_view_ * glm::dvec4(at_view, -distance, 1.0));
    return report;
}

CellBlock PixelProbe::block(glm::ivec2 first_pixel, glm::ivec2 size) const {
    const glm::ivec2 first = glm::clamp(first_pixel, glm::ivec2(0), colors_.size_px());
    const glm::ivec2 end = glm::clamp(first_pixel + size, first, colors_.size_px());
    CellBlock block{first, end - first, {}};
    if (block.size.x == 0 || block.size.y == 0) return block;
    const PixelRect rect{block.first_pixel, block.size};
    const std::vector<Color> colors = reader_->colors(colors_, rect);
    const std::vector<StoredPixel> stored = reader_->stored(colors_, plan_.depth_format, rect);
    for (std::size_t i = 0; i < colors.size(); ++i)
        block.cells.push_back({colors[i], stored[i].code, stored[i].window_depth});
    return block;
}

DepthCounts PixelProbe::count_depths() const {
    return reader_ ? reader_->count_depths(colors_, plan_) : DepthCounts{};
}

}  // namespace viewing
